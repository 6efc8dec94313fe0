#pragma once

#include <sinew/core/node.hpp>
#include <string>

namespace sinew {

/// The root table as TOML: plain values first, then [tables] and [[lists of tables]]. A table of tables is written as [a.b].
/// Reading the text again gives equal nodes (but for their places), numbers to the last bit.
std::string toml_text(const Node& root);

}  // namespace sinew
