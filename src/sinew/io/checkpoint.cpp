#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sinew/core/error.hpp>
#include <sinew/io/checkpoint.hpp>
#include <sinew/io/checksum.hpp>
#include <sinew/io/file.hpp>
#include <sinew/io/hdf5_text.hpp>
#include <sinew/parallel/user_order.hpp>

/// Layout, version 2:  /  attributes format_version, time, step; dataset format
///   numbers  one attribute a number      arrays  one dataset an array      texts  one string dataset a text ("case" is the case)
///   fields   one dataset {particles, width} a particle field, contiguous, with the attribute crc32
/// Behind the HDF5 data, which its readers ignore: a line with the CRC-32 of all bytes but those of the fields.
///
/// HDF5 makes the file with room for the fields; every rank then writes its rows there itself. So what HDF5 has in hand is small, and a disk that fills up is an
/// error of ours, which can be told: HDF5 cannot be trusted after a write of its own has failed.
namespace sinew {

namespace {

constexpr const char* format_name = "sinew checkpoint";
constexpr long long format_version = 2;
constexpr const char* case_key = "case";
constexpr const char* text_prefix = "text.";

/// Where the rows of a field are in the file.
struct StoredField {
  std::size_t begin = 0, particles = 0;
  int width = 1;
  std::uint32_t crc = 0;

  std::size_t bytes() const { return particles * width * sizeof(double); }
  std::size_t place_of(std::size_t particle) const { return begin + particle * width * sizeof(double); }
};
using StoredFields = std::map<std::string, StoredField>;

// ---- writing

template <class T>
void write_attribute(hid_t object, const std::string& name, hid_t type, const T& value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "make a data space");
  const Hdf5Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, "make " + name);
  hdf5_check(H5Awrite(attribute, type, &value), "write " + name);
}

/// Not compressed: that would take longer than many steps.
void write_array(hid_t group, const std::string& name, const std::vector<double>& values) {
  const hsize_t size = values.size();
  const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, "make a data space");
  const Hdf5Handle data(H5Dcreate2(group, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                        "make " + name);
  if (size > 0) hdf5_check(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "write " + name);
}

/// Makes room for the rows, and says where.
void make_field(hid_t group, const std::string& name, StoredField& field) {
  const hsize_t size[] = {field.particles, static_cast<hsize_t>(field.width)};
  const Hdf5Handle space(H5Screate_simple(2, size, nullptr), H5Sclose, "make a data space");
  const Hdf5Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a property list");
  hdf5_check(H5Pset_alloc_time(layout, H5D_ALLOC_TIME_EARLY), "make room for " + name);
  hdf5_check(H5Pset_fill_time(layout, H5D_FILL_TIME_NEVER), "leave room for " + name);
  const Hdf5Handle data(H5Dcreate2(group, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, layout, H5P_DEFAULT), H5Dclose,
                        "make " + name);
  write_attribute(data, "crc32", H5T_NATIVE_UINT32, field.crc);
  const haddr_t place = H5Dget_offset(data);
  if (field.bytes() > 0 && place == HADDR_UNDEF) throw Hdf5Error("cannot find the place of " + name);
  field.begin = field.bytes() > 0 ? place : 0;
}

Hdf5Handle make_group(hid_t file, const char* name) {
  return {H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, std::string("make ") + name};
}

void write_content(hid_t file, const Checkpoint& checkpoint, StoredFields& stored) {
  const long long step = checkpoint.step;
  write_attribute(file, "format_version", H5T_NATIVE_LLONG, format_version);
  write_attribute(file, "time", H5T_NATIVE_DOUBLE, checkpoint.time);
  write_attribute(file, "step", H5T_NATIVE_LLONG, step);
  const Hdf5Handle numbers = make_group(file, "numbers"), arrays = make_group(file, "arrays"), texts = make_group(file, "texts");
  const Hdf5Handle fields = make_group(file, "fields");
  write_text(texts, case_key, checkpoint.case_text);
  for (const auto& [name, text] : checkpoint.texts) write_text(texts, text_prefix + encoded(name), text);
  for (const auto& [name, value] : checkpoint.numbers) write_attribute(numbers, encoded(name), H5T_NATIVE_DOUBLE, value);
  for (const auto& [name, values] : checkpoint.arrays) write_array(arrays, encoded(name), values);
  for (auto& [name, field] : stored) make_field(fields, encoded(name), field);
  write_text(file, "format", format_name);
}

/// Bytes that a checkpoint needs at most, about.
std::size_t room_for(const Checkpoint& checkpoint, const StoredFields& stored) {
  std::size_t bytes = 65536 + 2 * checkpoint.case_text.size() + 512 * checkpoint.numbers.size();
  for (const auto& [name, values] : checkpoint.arrays) bytes += 1024 + values.size() * sizeof(double);
  for (const auto& [name, text] : checkpoint.texts) bytes += 1024 + text.size();
  for (const auto& [name, field] : stored) bytes += 1024 + field.bytes();
  return bytes;
}

/// Everything but the rows of the fields; says where they go.
void make_file(const std::string& path, const Checkpoint& checkpoint, StoredFields& stored) {
  PartFile room(path);
  room.reserve(room_for(checkpoint, stored));
  const Hdf5Silence silence;
  Hdf5Handle file(H5Fcreate(PartFile::part_name(path).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
                  "make the file");
  write_content(file, checkpoint, stored);
  hdf5_check(H5Fflush(file, H5F_SCOPE_LOCAL), "complete the file");
  room.leave();
}

std::string_view bytes_of(const std::vector<double>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)};
}

void write_rows(const std::string& path, const Checkpoint& checkpoint, const StoredFields& stored) {
  PartFile file(path, PartFile::Writers::several);
  for (const auto& [name, field] : checkpoint.fields) {
    file.seek(stored.at(name).place_of(checkpoint.range.first));
    file.write(bytes_of(field.rows));
  }
  file.synchronize();
  file.leave();
}

void complete(const std::string& path, const StoredFields& stored) {
  std::vector<ByteRange> without;
  for (const auto& [name, field] : stored)
    if (field.bytes() > 0) without.push_back({field.begin, field.bytes()});
  std::sort(without.begin(), without.end(), [](const ByteRange& a, const ByteRange& b) { return a.begin < b.begin; });
  const std::string part = PartFile::part_name(path);
  PartFile file(path, PartFile::Writers::several);
  const std::size_t size = std::filesystem::file_size(part);
  file.seek(size);
  file.write(checksum_line(part, size, without));
  file.synchronize();
  file.commit();
}

/// Places of the fields, from the root to all.
void share_places(const Comm& comm, StoredFields& stored) {
  std::vector<double> places;
  for (const auto& [name, field] : stored) places.push_back(static_cast<double>(field.begin));
  comm.broadcast(places);
  auto place = places.begin();
  for (auto& [name, field] : stored) field.begin = static_cast<std::size_t>(*place++);
}

// ---- reading

template <class T>
T read_attribute(hid_t object, const std::string& name, hid_t type) {
  const Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "find " + name);
  T value{};
  hdf5_check(H5Aread(attribute, type, &value), "read " + name);
  return value;
}

std::vector<double> read_array(hid_t group, const std::string& name) {
  const Hdf5Handle data(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "find " + name);
  const Hdf5Handle space(H5Dget_space(data), H5Sclose, "read the shape of " + name);
  std::vector<double> values(
      static_cast<std::size_t>(hdf5_check(H5Sget_simple_extent_npoints(space), "read the length of " + name)));
  if (!values.empty()) hdf5_check(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read " + name);
  return values;
}

StoredField find_field(hid_t group, const std::string& name) {
  const Hdf5Handle data(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "find " + name);
  const Hdf5Handle space(H5Dget_space(data), H5Sclose, "read the shape of " + name);
  hsize_t size[2] = {};
  if (H5Sget_simple_extent_ndims(space) != 2) throw Hdf5Error("cannot read " + name + " as a field");
  hdf5_check(H5Sget_simple_extent_dims(space, size, nullptr), "read the length of " + name);
  const haddr_t place = H5Dget_offset(data);
  return {place == HADDR_UNDEF ? 0 : place, size[0], static_cast<int>(size[1]),
          read_attribute<std::uint32_t>(data, "crc32", H5T_NATIVE_UINT32)};
}

Hdf5Handle open_group(hid_t file, const char* name) {
  return {H5Gopen2(file, name, H5P_DEFAULT), H5Gclose, std::string("find ") + name};
}

Checkpoint read_content(hid_t file, StoredFields& stored) {
  Checkpoint checkpoint;
  checkpoint.time = read_attribute<double>(file, "time", H5T_NATIVE_DOUBLE);
  checkpoint.step = static_cast<long>(read_attribute<long long>(file, "step", H5T_NATIVE_LLONG));
  const Hdf5Handle numbers = open_group(file, "numbers"), arrays = open_group(file, "arrays"), texts = open_group(file, "texts");
  const Hdf5Handle fields = open_group(file, "fields");
  for (const std::string& link : attribute_names(numbers))
    checkpoint.numbers[decoded(link)] = read_attribute<double>(numbers, link, H5T_NATIVE_DOUBLE);
  for (const std::string& link : link_names(arrays)) checkpoint.arrays[decoded(link)] = read_array(arrays, link);
  for (const std::string& link : link_names(texts))
    if (link.starts_with(text_prefix))
      checkpoint.texts[decoded(link.substr(std::strlen(text_prefix)))] = read_text_dataset(texts, link);
  for (const std::string& link : link_names(fields)) stored[decoded(link)] = find_field(fields, link);
  checkpoint.case_text = read_text_dataset(texts, case_key);
  return checkpoint;
}

void check_version(const std::string& path, hid_t file) {
  if (read_text_dataset(file, "format") != format_name) throw Hdf5Error("cannot find \"sinew checkpoint\" in it");
  const auto version = read_attribute<long long>(file, "format_version", H5T_NATIVE_LLONG);
  if (version != format_version)
    throw CaseError(path + " has checkpoint format " + std::to_string(version) + "; this program reads format " +
                    std::to_string(format_version) + ". Resume it with the version of sinew that wrote it.");
}

Checkpoint::Field read_rows(const std::string& path, const StoredField& stored, const UserRange& range) {
  Checkpoint::Field field{stored.width, std::vector<double>(range.count * stored.width)};
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(stored.place_of(range.first)));
  file.read(reinterpret_cast<char*>(field.rows.data()), static_cast<std::streamsize>(field.rows.size() * sizeof(double)));
  if (!file) throw Hdf5Error("cannot read the rows of a field");
  return field;
}

std::string damaged(const std::string& path, const std::string& what) {
  return path + " is damaged or not a checkpoint of sinew: " + what + ".";
}

/// All but the rows of the fields.
Checkpoint read_head(const std::string& path, StoredFields& stored) {
  try {
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open it as HDF5");
    check_version(path, file);
    return read_content(file, stored);
  } catch (const Hdf5Error& error) {
    throw CaseError(damaged(path, error.what()));
  }
}

void check_file(const std::string& path) {
  std::error_code missing;
  if (!std::filesystem::is_regular_file(path, missing))
    throw CaseError("no checkpoint at " + path + (missing ? ": " + missing.message() : ": not a file") + ".");
  if (!has_right_checksum(path)) throw CaseError(damaged(path, "its checksum is not right"));
}

}  // namespace

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint, const Comm& comm) {
  StoredFields stored;
  for (const auto& [name, field] : checkpoint.fields)
    stored[name] = {0, checkpoint.range.total, field.width, crc32_of_all(comm, field.rows)};
  comm.on_root([&] { make_file(path, checkpoint, stored); });
  share_places(comm, stored);
  comm.together([&] { write_rows(path, checkpoint, stored); });
  comm.on_root([&] { complete(path, stored); });
}

Checkpoint read_checkpoint(const std::string& path, const Comm& comm) {
  const Hdf5Silence silence;
  comm.on_root([&] { check_file(path); });
  StoredFields stored;
  Checkpoint checkpoint;
  comm.together([&] {
    checkpoint = read_head(path, stored);
    for (const auto& [name, field] : stored) {
      checkpoint.range = user_range(field.particles, comm.rank(), comm.size());
      checkpoint.fields[name] = read_rows(path, field, checkpoint.range);
    }
  });
  std::string wrong;
  for (const auto& [name, field] : checkpoint.fields)
    if (crc32_of_all(comm, field.rows) != stored.at(name).crc) wrong = name;
  comm.together([&] {
    if (!wrong.empty()) throw CaseError(damaged(path, "the checksum of \"" + wrong + "\" is not right"));
  });
  return checkpoint;
}

}  // namespace sinew
