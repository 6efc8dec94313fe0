#pragma once
/// Values as one line of TOML.

#include <sinew/core/node.hpp>
#include <string>

namespace sinew {

/// A basic TOML string with its quotes and escapes.
std::string quoted_text(const std::string& text);
/// A TOML key: bare where that is allowed, quoted otherwise.
std::string key_text(const std::string& key);
/// The value on one line: 1, 0.1, "a", [1, 2], { a = 1 }. Numbers read back to the same bits and stay numbers (3.0, not 3).
std::string value_text(const Node& value);

}  // namespace sinew
