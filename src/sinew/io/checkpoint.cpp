#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <sinew/core/error.hpp>
#include <sinew/io/checkpoint.hpp>
#include <sinew/io/file.hpp>
#include <sinew/io/hdf5_handle.hpp>
#include <zlib.h>

/// Layout, version 1:  /  attributes format, format_version, time, step
///   numbers  one attribute a number      arrays  one dataset an array      texts  one string dataset a text ("case" is the case)
/// Behind the HDF5 data, which its readers ignore: the CRC-32 of all bytes before it.
namespace sinew {

namespace {

constexpr const char* format_name = "sinew checkpoint";
constexpr long long format_version = 1;
constexpr std::size_t crc_piece = std::size_t{1} << 30;         // zlib counts in 32 bits
constexpr std::size_t memory_increment = std::size_t{1} << 24;  // bytes
constexpr const char* case_key = "case";
constexpr const char* text_prefix = "text.";

/// HDF5 takes '/' in a name for a path and a lone '.' for the group itself: the link is called "NAME" with those two (and '%') encoded.
std::string encoded(const std::string& name) {
  std::string out;
  for (const char c : name) out += c == '%' ? "%25" : c == '/' ? "%2F" : c == '.' ? "%2E" : std::string(1, c);
  return out.empty() ? "%" : out;
}

std::string decoded(const std::string& link) {
  std::string out;
  for (std::size_t i = 0; i < link.size(); ++i) {
    if (link[i] != '%')
      out += link[i];
    else if (i + 2 < link.size())
      out += static_cast<char>(std::stoi(link.substr(i + 1, 2), nullptr, 16)), i += 2;
  }
  return out;
}

/// The line that ends a file of these bytes.
std::string checksum_line(std::string_view image) {
  uLong sum = crc32(0, nullptr, 0);
  for (std::size_t begin = 0; begin < image.size(); begin += crc_piece) {
    const std::string_view piece = image.substr(begin, crc_piece);
    sum = crc32(sum, reinterpret_cast<const Bytef*>(piece.data()), static_cast<uInt>(piece.size()));
  }
  return fmt::format("\nsinew crc32 {:08x}\n", sum);
}

/// Access to an HDF5 file that is not on disk.
Hdf5Handle in_memory() {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a property list");
  hdf5_check(H5Pset_fapl_core(access, memory_increment, false), "choose a file in memory");
  return access;
}

// ---- writing

template <class T>
void write_attribute(hid_t object, const std::string& name, hid_t type, const T& value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "make a data space");
  const Hdf5Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, "make " + name);
  hdf5_check(H5Awrite(attribute, type, &value), "write " + name);
}

/// As a string of fixed size with a closing zero, so that any text, also an empty one, keeps its length.
void write_text(hid_t group, const std::string& name, const std::string& text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a string type");
  hdf5_check(H5Tset_size(type, text.size() + 1), "set the length of " + name);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "make a data space");
  const Hdf5Handle data(H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                        "make " + name);
  hdf5_check(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), "write " + name);
}

/// Not compressed: that would take longer than many steps.
void write_array(hid_t group, const std::string& name, const std::vector<double>& values) {
  const hsize_t size = values.size();
  const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, "make a data space");
  const Hdf5Handle data(H5Dcreate2(group, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                        "make " + name);
  if (size > 0) hdf5_check(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "write " + name);
}

Hdf5Handle make_group(hid_t file, const char* name) {
  return {H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, std::string("make ") + name};
}

void write_content(hid_t file, const Checkpoint& checkpoint) {
  const long long step = checkpoint.step;
  write_attribute(file, "format_version", H5T_NATIVE_LLONG, format_version);
  write_attribute(file, "time", H5T_NATIVE_DOUBLE, checkpoint.time);
  write_attribute(file, "step", H5T_NATIVE_LLONG, step);
  const Hdf5Handle numbers = make_group(file, "numbers"), arrays = make_group(file, "arrays"), texts = make_group(file, "texts");
  write_text(texts, case_key, checkpoint.case_text);
  for (const auto& [name, text] : checkpoint.texts) write_text(texts, text_prefix + encoded(name), text);
  for (const auto& [name, value] : checkpoint.numbers) write_attribute(numbers, encoded(name), H5T_NATIVE_DOUBLE, value);
  for (const auto& [name, values] : checkpoint.arrays) write_array(arrays, encoded(name), values);
  write_text(file, "format", format_name);
}

/// A complete HDF5 file in memory: HDF5 cannot be trusted after a write to a full disk has failed in its hands.
Hdf5Handle file_in_memory(const Checkpoint& checkpoint) {
  const Hdf5Handle access = in_memory();
  Hdf5Handle file(H5Fcreate("checkpoint", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "make the file");
  write_content(file, checkpoint);
  hdf5_check(H5Fflush(file, H5F_SCOPE_LOCAL), "complete the file");
  return file;
}

/// Its bytes, as long as it is open.
std::string_view bytes_of(hid_t file) {
  const ssize_t size = hdf5_check(H5Fget_file_image(file, nullptr, 0), "read the size of the file");
  void* place_of_bytes = nullptr;
  hdf5_check(H5Fget_vfd_handle(file, H5P_DEFAULT, &place_of_bytes), "find the file");
  return {*static_cast<const char**>(place_of_bytes), static_cast<std::size_t>(size)};
}

// ---- reading

void check_and_remove_checksum(std::string& image) {
  const std::size_t length = checksum_line({}).size();
  const std::string line = image.substr(image.size() - std::min(length, image.size()));
  image.resize(image.size() - line.size());
  if (line != checksum_line(image)) throw Hdf5Error("its checksum is not right");
}

template <class T>
T read_attribute(hid_t object, const std::string& name, hid_t type) {
  const Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "find " + name);
  T value{};
  hdf5_check(H5Aread(attribute, type, &value), "read " + name);
  return value;
}

std::string read_text_dataset(hid_t group, const std::string& name) {
  const Hdf5Handle data(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "find " + name);
  const Hdf5Handle stored(H5Dget_type(data), H5Tclose, "read the type of " + name);
  if (H5Tget_class(stored) != H5T_STRING || H5Tget_size(stored) == 0) throw Hdf5Error("cannot read " + name + " as a text");
  std::string text(H5Tget_size(stored), '\0');
  hdf5_check(H5Dread(data, stored, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "read " + name);
  text.pop_back();
  return text;
}

std::vector<double> read_array(hid_t group, const std::string& name) {
  const Hdf5Handle data(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "find " + name);
  const Hdf5Handle space(H5Dget_space(data), H5Sclose, "read the shape of " + name);
  std::vector<double> values(
      static_cast<std::size_t>(hdf5_check(H5Sget_simple_extent_npoints(space), "read the length of " + name)));
  if (!values.empty()) hdf5_check(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read " + name);
  return values;
}

Hdf5Handle open_group(hid_t file, const char* name) {
  return {H5Gopen2(file, name, H5P_DEFAULT), H5Gclose, std::string("find ") + name};
}

herr_t collect_link(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}
herr_t collect_attribute(hid_t, const char* name, const H5A_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

std::vector<std::string> link_names(hid_t group) {
  std::vector<std::string> names;
  hdf5_check(H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect_link, &names), "list a group");
  return names;
}
std::vector<std::string> attribute_names(hid_t group) {
  std::vector<std::string> names;
  hdf5_check(H5Aiterate2(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect_attribute, &names), "list the numbers");
  return names;
}

Checkpoint read_content(hid_t file) {
  Checkpoint checkpoint;
  checkpoint.time = read_attribute<double>(file, "time", H5T_NATIVE_DOUBLE);
  checkpoint.step = static_cast<long>(read_attribute<long long>(file, "step", H5T_NATIVE_LLONG));
  const Hdf5Handle numbers = open_group(file, "numbers"), arrays = open_group(file, "arrays"), texts = open_group(file, "texts");
  for (const std::string& link : attribute_names(numbers))
    checkpoint.numbers[decoded(link)] = read_attribute<double>(numbers, link, H5T_NATIVE_DOUBLE);
  for (const std::string& link : link_names(arrays)) checkpoint.arrays[decoded(link)] = read_array(arrays, link);
  for (const std::string& link : link_names(texts))
    if (link.starts_with(text_prefix))
      checkpoint.texts[decoded(link.substr(std::strlen(text_prefix)))] = read_text_dataset(texts, link);
  checkpoint.case_text = read_text_dataset(texts, case_key);
  return checkpoint;
}

}  // namespace

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint) {
  const Hdf5Silence silence;
  const Hdf5Handle in_memory_file = file_in_memory(checkpoint);
  const std::string_view image = bytes_of(in_memory_file);
  PartFile file(path);
  file.write(image);
  file.write(checksum_line(image));
  file.synchronize();
  file.commit();
}

Checkpoint read_checkpoint(const std::string& path) {
  const Hdf5Silence silence;
  std::error_code missing;
  if (!std::filesystem::is_regular_file(path, missing))
    throw CaseError("no checkpoint at " + path + (missing ? ": " + missing.message() : ": not a file") + ".");
  try {
    std::string image = read_text(path);
    check_and_remove_checksum(image);
    const Hdf5Handle access = in_memory();
    hdf5_check(H5Pset_file_image(access, image.data(), image.size()), "take the file into memory");
    const Hdf5Handle file(H5Fopen("checkpoint", H5F_ACC_RDONLY, access), H5Fclose, "open it as HDF5");
    if (read_text_dataset(file, "format") != format_name) throw Hdf5Error("cannot find \"sinew checkpoint\" in it");
    const auto version = read_attribute<long long>(file, "format_version", H5T_NATIVE_LLONG);
    if (version != format_version)
      throw CaseError(path + " has checkpoint format " + std::to_string(version) + "; this program reads format " +
                      std::to_string(format_version) + ". Resume it with the version of sinew that wrote it.");
    return read_content(file);
  } catch (const Hdf5Error& error) {
    throw CaseError(path + " is damaged or not a checkpoint of sinew: " + error.what() + ".");
  }
}

}  // namespace sinew
