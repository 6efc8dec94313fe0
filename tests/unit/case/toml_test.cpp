#include <gtest/gtest.h>

#include <cmath>
#include <sinew/core/node_text.hpp>
#include <sinew/core/number_text.hpp>
#include <sinew/io/read_toml.hpp>
#include <sinew/io/write_toml.hpp>

namespace sinew {
namespace {

TEST(ReadToml, KeepsPlacesAndOrder) {
  const Node root = read_toml_text("zeta = 1\n[beta]\n  two = \"x\"\n  one = [1.5, true]\n[[alpha]]\nname = 'a'\n", "f.toml");
  ASSERT_EQ(root.members.size(), 3u);
  EXPECT_EQ(root.members[0].key, "zeta");
  EXPECT_EQ(root.members[1].key, "beta");
  EXPECT_EQ(root.members[2].key, "alpha");
  const Node& beta = root.members[1].value;
  EXPECT_EQ(beta.members[0].key, "two");
  EXPECT_EQ(beta.members[0].place.text(), "f.toml:3:3");
  EXPECT_EQ(beta.members[0].value.place.text(), "f.toml:3:9");
  EXPECT_EQ(beta.members[1].value.items[1].place.text(), "f.toml:4:15");
  EXPECT_TRUE(beta.members[1].value.items[1].boolean);
  EXPECT_EQ(root.members[2].value.items[0].find("name")->text, "a");
}

TEST(ReadToml, ValuesOfOverrides) {
  const Place place{"--set x"};
  EXPECT_EQ(read_toml_value("16", place).integer, 16);
  EXPECT_EQ(read_toml_value("1.5", place).number, 1.5);
  EXPECT_EQ(read_toml_value("\"a\"", place).text, "a");
  EXPECT_EQ(read_toml_value("spiky", place).text, "spiky");
  EXPECT_EQ(read_toml_value("17 MPa", place).text, "17 MPa");
  EXPECT_EQ(read_toml_value("1/n", place).text, "1/n");
  EXPECT_TRUE(read_toml_value("true", place).boolean);
  const Node list = read_toml_value("[1, { a = 2 }]", place);
  EXPECT_EQ(list.items[1].members[0].place.text(), "--set x");
  EXPECT_EQ(list.items[1].members[0].value.place.text(), "--set x");
  EXPECT_EQ(read_toml_value("1\nother = 2", place).text, "1\nother = 2");
}

TEST(WriteToml, ReadsBackAsItWas) {
  const std::string text =
      "title = \"a \\\"b\\\" \\\\ \\u000A\"\n\n[section]\nempty = []\nnested = { a = 1, \"b.c\" = [1.0, 2.5, \"x\"] }\n\n"
      "[material.rubber]\ndensity = 1e-09\n\n[material.\"two words\"]\ndensity = 3.0\n\n[[body]]\nname = \"a\"\n\n[[body]]\nname "
      "= \"b\"\n";
  EXPECT_EQ(toml_text(read_toml_text(text, "")), text);
}

TEST(WriteToml, NumbersKeepTheirBits) {
  for (const double number : {0.1, 1.0 / 3.0, 17e6, 1e300, 5e-324, -0.0, 123456789012345680.0, 1e22}) {
    Node root = Node::make_table();
    root.members.push_back({"a", {}, Node::make_number(number)});
    const Node again = read_toml_text(toml_text(root), "");
    EXPECT_TRUE(again.find("a")->is(Node::Kind::number)) << number;
    EXPECT_EQ(again.find("a")->number, number);
    EXPECT_EQ(std::signbit(again.find("a")->number), std::signbit(number));
  }
}

TEST(NumberText, IsShortAndPlain) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(17e6), "17000000");
  EXPECT_EQ(number_text(-1100.0), "-1100");
  EXPECT_EQ(number_text(1e-9), "1e-09");
}

}  // namespace
}  // namespace sinew
