#pragma once
/// Arrays as the XML formats of VTK hold them.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace sinew {

/// RFC 4648, with padding.
std::string base64(std::span<const std::byte> data);

/// What compresses an array best: numbers that were computed are noise in their last digits, numbers of particles are not.
enum class ArrayContent { computed, regular };

/// The text of a binary inline <DataArray> with vtkZLibDataCompressor and header_type UInt32: base64 of
/// [blocks, block size, size of a last partial block, compressed size of each block], then base64 of all compressed blocks.
std::string encode_vtk_array(std::span<const std::byte> data, ArrayContent content = ArrayContent::regular);

/// The text with & < > " replaced by entities, and back.
std::string xml_escape(std::string_view text);
std::string xml_unescape(std::string_view text);

}  // namespace sinew
