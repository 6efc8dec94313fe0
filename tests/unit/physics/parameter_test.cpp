#include <gtest/gtest.h>

#include <set>
#include <sinew/corrections/registry.hpp>
#include <sinew/kernels/registry.hpp>
#include <sinew/materials/registry.hpp>
#include <sinew/stabilization/registry.hpp>

namespace sinew {
namespace {

/// What one parameter declares; checks that nothing is left out.
struct DeclarationCheck {
  std::set<std::string> names;
  std::string owner;

  template <class Member>
  void operator()(std::string_view name, Member&, std::string_view unit, std::string_view sentence, const Range& range,
                  Need = required) {
    EXPECT_TRUE(names.insert(std::string(name)).second) << owner << "." << name << " is declared twice";
    EXPECT_FALSE(unit.empty()) << owner << "." << name;
    EXPECT_FALSE(range.text.empty()) << owner << "." << name;
    EXPECT_TRUE(sentence.size() > 3 && sentence.back() == '.') << owner << "." << name << ": " << sentence;
  }
};

template <class List>
void check_declarations() {
  std::set<std::string_view> names;
  List::for_each([&]<class Model>() {
    EXPECT_TRUE(names.insert(Model::name).second) << Model::name << " is registered twice";
    EXPECT_FALSE(Model::summary.empty() || Model::source.empty()) << Model::name;
    Model model;
    Model::describe(DeclarationCheck{{}, std::string(Model::name)}, model);
  });
}

TEST(Parameters, EachHasANameAUnitASentenceAndARange) {
  check_declarations<Kernels>();
  check_declarations<Corrections>();
  check_declarations<Materials>();
  check_declarations<Stabilizations>();
}

}  // namespace
}  // namespace sinew
