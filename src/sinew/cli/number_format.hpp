#pragma once
/// Numbers for people.

#include <string>

namespace sinew {

std::string count_text(long count);                                ///< 1234567 -> "1 234 567"
std::string bytes_text(double bytes);                              ///< "1.5 GB"
std::string duration_text(double seconds);                         ///< "0.42 s", "12.3 s", "3 min 5 s", "2 h 10 min"
std::string quantity_text(double value, const std::string& unit);  ///< "1.234 m"; the bare number for "1" and ""

}  // namespace sinew
