#pragma once
/// Names and texts in HDF5 files.

#include <sinew/io/hdf5_handle.hpp>
#include <string>
#include <vector>

namespace sinew {

/// HDF5 takes '/' in a name for a path and a lone '.' for the group itself: the link is called NAME with those two (and '%') encoded.
std::string encoded(const std::string& name);
std::string decoded(const std::string& link);

/// As a string of fixed size with a closing zero, so that any text, also an empty one, keeps its length.
void write_text(hid_t group, const std::string& name, const std::string& text);
std::string read_text_dataset(hid_t group, const std::string& name);

std::vector<std::string> link_names(hid_t group);
std::vector<std::string> attribute_names(hid_t group);

}  // namespace sinew
