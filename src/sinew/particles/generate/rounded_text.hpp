#pragma once

#include <cstdio>
#include <string>

namespace sinew {

/// A number as a message shows it: six significant digits.
inline std::string rounded_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace sinew
