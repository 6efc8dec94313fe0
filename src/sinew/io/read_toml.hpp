#pragma once
/// TOML text to nodes. Every key and value keeps its line and column, tables keep the order of the text.

#include <sinew/core/node.hpp>
#include <string>

namespace sinew {

/// Reads a file. CaseError if it cannot be opened or is not TOML 1.0.
Node read_toml_file(const std::string& path);
/// Reads a text; `name` stands for the file in messages.
Node read_toml_text(const std::string& text, const std::string& name);
/// Reads the value of an override. A text that is no TOML value is a string, so that quotes may be left out: spiky, 1/n, 17 MPa.
/// Everything in it gets `place`.
Node read_toml_value(const std::string& text, const Place& place);

}  // namespace sinew
