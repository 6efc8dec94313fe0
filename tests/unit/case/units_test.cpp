#include <gtest/gtest.h>

#include <numbers>
#include <sinew/core/units.hpp>
#include <string>

namespace sinew {
namespace {

Unit unit(const std::string& text) {
  const std::optional<Unit> parsed = parse_unit(text);
  EXPECT_TRUE(parsed.has_value()) << text;
  return parsed.value_or(Unit{});
}

UnitSystem millimeters_kilograms_milliseconds() { return {"mm", "kg", "ms", 1e-3, 1.0, 1e-3}; }

TEST(Units, FactorsToSi) {
  EXPECT_DOUBLE_EQ(unit("MPa").factor, 1e6);
  EXPECT_DOUBLE_EQ(unit("mm").factor, 1e-3);
  EXPECT_DOUBLE_EQ(unit("\u00b5s").factor, 1e-6);
  EXPECT_DOUBLE_EQ(unit("g/cm^3").factor, 1e3);
  EXPECT_DOUBLE_EQ(unit("kN/mm^2").factor, 1e9);
  EXPECT_DOUBLE_EQ(unit("km/h").factor, 1.0 / 3.6);
  EXPECT_DOUBLE_EQ(unit("deg").factor, std::numbers::pi / 180.0);
  EXPECT_DOUBLE_EQ(unit("t").factor, 1e3);
  EXPECT_DOUBLE_EQ(unit("min").factor, 60.0);
  EXPECT_EQ(unit("mm/ms").factor, 1.0);  // exactly
}

TEST(Units, Dimensions) {
  EXPECT_EQ(unit("Pa").dimensions, (Dimensions{-1, 1, -2}));
  EXPECT_EQ(unit("N m").dimensions, unit("J").dimensions);
  EXPECT_EQ(unit("kg/(m s^2)").dimensions, unit("Pa").dimensions);
  EXPECT_EQ(unit("J/m^3").dimensions, unit("Pa").dimensions);
  EXPECT_EQ(unit("1/s").dimensions, unit("Hz").dimensions);
  EXPECT_EQ(unit("s^-1").dimensions, unit("Hz").dimensions);
  EXPECT_EQ(unit("rad/s").dimensions, (Dimensions{0, 0, -1}));
  EXPECT_EQ(unit("1").dimensions, Dimensions{});
}

TEST(Units, UnknownTextIsNothing) {
  for (const std::string text : {"", "foo", "m^", "m^x", "kg//m", "(m", "m)", "m/", "2", "mmm", "m^100"})
    EXPECT_FALSE(parse_unit(text).has_value()) << text;
}

TEST(Units, FactorOfASystem) {
  const UnitSystem system = millimeters_kilograms_milliseconds();
  EXPECT_DOUBLE_EQ(system.factor({-1, 1, -2}), 1e9);  // GPa
  EXPECT_DOUBLE_EQ(system.factor({1, 1, -2}), 1e3);   // kN
  EXPECT_EQ(UnitSystem{}.factor({-1, 1, -2}), 1.0);
}

TEST(Units, NamesInASystem) {
  const UnitSystem system = millimeters_kilograms_milliseconds();
  EXPECT_EQ(system.name_of("Pa"), "GPa");
  EXPECT_EQ(system.name_of("N"), "kN");
  EXPECT_EQ(system.name_of("J"), "J");
  EXPECT_EQ(system.name_of("kg/m^3"), "kg/mm^3");
  EXPECT_EQ(system.name_of("m/s"), "mm/ms");
  EXPECT_EQ(system.name_of("1"), "1");
  EXPECT_EQ(UnitSystem{}.name_of("kg/m^3"), "kg/m^3");
  const UnitSystem tonnes{"mm", "t", "s", 1e-3, 1e3, 1.0};
  EXPECT_EQ(tonnes.name_of("Pa"), "MPa");
  const UnitSystem odd{"cm", "g", "s", 1e-2, 1e-3, 1.0};
  EXPECT_EQ(odd.name_of("Pa"), "g/(cm s^2)");
}

}  // namespace
}  // namespace sinew
