/// Everything that a case file may say is documented.

#include <gtest/gtest.h>

#include <set>
#include <sinew/model/case.hpp>
#include <sinew/model/read_case.hpp>

namespace sinew {
namespace {

void expect_documented(const std::string& owner, const std::vector<ParameterDoc>& docs) {
  std::set<std::string> names;
  for (const ParameterDoc& doc : docs) {
    const std::string where = owner + ": " + doc.name;
    EXPECT_TRUE(names.insert(doc.name).second) << where << " twice";
    EXPECT_FALSE(doc.type.empty()) << where;
    EXPECT_GT(doc.sentence.size(), 5u) << where;
    EXPECT_TRUE(doc.sentence.ends_with(".")) << where << ": " << doc.sentence;
    EXPECT_TRUE(doc.unit.empty() || doc.unit == "of the quantity" || parse_unit(doc.unit)) << where << ": " << doc.unit;
    EXPECT_FALSE(doc.required && !doc.default_text.empty()) << where;
  }
}

template <class Registry>
void expect_registry_documented() {
  Registry::for_each([]<class T>() { expect_documented(std::string(T::name), parameter_docs<T>()); });
}

TEST(Docs, EverySectionAndEveryModel) {
  for (const auto& [section, docs] : case_sections()) expect_documented(section, docs);
  expect_registry_documented<Materials>();
  expect_registry_documented<Kernels>();
  expect_registry_documented<Corrections>();
  expect_registry_documented<Stabilizations>();
  expect_registry_documented<Geometries>();
}

TEST(Docs, SectionsAreTheTopLevelKeys) {
  std::set<std::string> sections;
  for (const auto& [section, docs] : case_sections()) {
    const std::size_t begin = section.find_first_not_of('[');
    sections.insert(section.substr(begin, section.find_first_of(".]") - begin));
  }
  EXPECT_EQ(sections, std::set<std::string>(top_level_keys().begin(), top_level_keys().end()));
}

TEST(Docs, SayWhatTheDescriptionSays) {
  const std::vector<ParameterDoc> solver = parameter_docs<SolverCase>();
  EXPECT_EQ(solver[2].name, "cfl");
  EXPECT_EQ(solver[2].type, "number");
  EXPECT_EQ(solver[2].range, "greater than 0 and at most 1");
  EXPECT_EQ(solver[2].default_text, "0.3");
  EXPECT_FALSE(solver[2].required);
  EXPECT_EQ(solver[4].unit, "s");
  EXPECT_EQ(solver[4].default_text, "");
  const std::vector<ParameterDoc> hourglass = parameter_docs<HourglassStiffness>();
  EXPECT_EQ(hourglass[1].range, "conservative, half, printed");
  EXPECT_EQ(hourglass[1].default_text, "\"conservative\"");
  EXPECT_TRUE(parameter_docs<LinearElastic>()[0].required);
}

TEST(Docs, QuantitiesHaveUnitsAndAreUnique) {
  std::set<std::string> names;
  for (const auto* list : {&particle_quantities(), &total_quantities()})
    for (const QuantityInfo& quantity : *list) {
      EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
      EXPECT_TRUE(parse_unit(quantity.unit)) << quantity.name;
      EXPECT_EQ(find_quantity(quantity.name), &quantity);
    }
  EXPECT_EQ(find_quantity("nothing"), nullptr);
}

}  // namespace
}  // namespace sinew
