#include <gtest/gtest.h>

#include <sinew/core/node_text.hpp>
#include <sinew/io/read_toml.hpp>
#include <sinew/model/case.hpp>

namespace sinew {
namespace {

std::string overridden(const std::string& path, const std::string& value) {
  Node root = read_toml_text(
      "[parameters]\nn = 1\n[[body]]\nname = \"a\"\nlow = [1, 2]\n[[body]]\nname = \"b\"\n[material.rubber]\ndensity = 1\n",
      "case.toml");
  override_value(root, path, read_toml_value(value, Place{"--set"}));
  return value_text(root);
}

TEST(OverrideValue, ReplacesAndAdds) {
  const std::string rest =
      ", body = [{ name = \"a\", low = [1, 2] }, { name = \"b\" }], material = { rubber = { density = 1 } } }";
  EXPECT_EQ(overridden("parameters.n", "16"), "{ parameters = { n = 16 }" + rest);
  const std::string start = "{ parameters = { n = 1 }, body = [{ name = \"a\", low = [1, 2] }, { name = \"b\"";
  EXPECT_EQ(overridden("body.b.x.y", "3"), start + ", x = { y = 3 } }], material = { rubber = { density = 1 } } }");
  EXPECT_EQ(overridden("body.1.x", "spiky"), start + ", x = \"spiky\" }], material = { rubber = { density = 1 } } }");
  EXPECT_EQ(overridden("material.rubber.density", "2.0"), start + " }], material = { rubber = { density = 2.0 } } }");
  EXPECT_EQ(overridden("solver.cfl", "0.1"), start + " }], material = { rubber = { density = 1 } }, solver = { cfl = 0.1 } }");
  EXPECT_EQ(overridden("body.a.low.1", "7"),
            "{ parameters = { n = 1 }, body = [{ name = \"a\", low = [1, 7] }, { name = \"b\" }], material = { rubber = { "
            "density = 1 } } }");
}

}  // namespace
}  // namespace sinew
