#pragma once
/// What a section of the case file may say about a key besides its range and whether it has to be given.

#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// The value is one of these names.
struct OneOf {
  std::vector<std::string> names;
};

/// How the reference calls the type of the value, where the type of the member does not say it.
struct TypeText {
  std::string text;
};

/// Instead of a unit: a number of any dimension, in the units of the case.
inline constexpr std::string_view any_unit = "any";
/// Instead of a unit: the value is no number.
inline constexpr std::string_view no_unit = "1";

}  // namespace sinew
