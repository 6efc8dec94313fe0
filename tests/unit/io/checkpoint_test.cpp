#include <bit>
#include <cstdint>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <limits>
#include <random>
#include <sinew/core/error.hpp>
#include <sinew/io/checkpoint.hpp>
#include <unit/io/temporary_folder.hpp>
#include <zlib.h>

namespace sinew {
namespace {

using test::message_of;

std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> out;
  for (const double value : values) out.push_back(std::bit_cast<std::uint64_t>(value));
  return out;
}

Checkpoint example() {
  Checkpoint c;
  c.time = 0.1 + 0.2;
  c.step = 123'456'789'012;
  c.case_text = "[case]\nname = \"ä\"\n";
  c.numbers = {{"dt", 1e-320}, {"energy.strain", -0.0}, {"largest", std::numeric_limits<double>::max()}};
  std::mt19937_64 random(1);
  std::vector<double> any(200'000);
  for (double& value : any) value = std::bit_cast<double>(random());  // any bits: also NaN of all kinds, infinities, denormals
  c.arrays = {{"position", any}, {"body/0/state.%", {1.0, -0.0}}, {".", {3.0}}, {"", {4.0}}, {"empty", {}}};
  c.texts = {{"commit", "abc"}, {"nothing", ""}, {"zeros", std::string("a\0b\0", 4)}, {"case", "not the case"}};
  return c;
}

TEST(Checkpoint, ComesBackToTheLastBit) {
  const test::TemporaryFolder folder;
  const Checkpoint a = example();
  write_checkpoint(folder / "checkpoint.h5", a);
  const Checkpoint b = read_checkpoint(folder / "checkpoint.h5");
  EXPECT_EQ(bits({a.time}), bits({b.time}));
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.case_text, b.case_text);
  EXPECT_EQ(a.texts, b.texts);
  ASSERT_EQ(a.numbers.size(), b.numbers.size());
  for (const auto& [name, value] : a.numbers) EXPECT_EQ(bits({value}), bits({b.numbers.at(name)})) << name;
  ASSERT_EQ(a.arrays.size(), b.arrays.size());
  for (const auto& [name, values] : a.arrays) EXPECT_TRUE(bits(values) == bits(b.arrays.at(name))) << name;
  EXPECT_FALSE(std::filesystem::exists(folder / "checkpoint.h5.part"));
}

/// Rows of particles, and damage in them.
TEST(Checkpoint, FieldsComeBackAndTheirDamageIsSeen) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "c.h5";
  Checkpoint a;
  a.range = {0, 1000, 1000, true};
  for (int k = 0; k < 3000; ++k) a.fields["velocity"].rows.push_back(0.1 * k);
  a.fields["velocity"].width = 3;
  a.fields["a/b"].rows.assign(1000, -0.0);
  write_checkpoint(path, a);
  const Checkpoint b = read_checkpoint(path);
  EXPECT_EQ(b.range.count, 1000U);
  ASSERT_EQ(b.fields.size(), 2U);
  EXPECT_EQ(b.fields.at("velocity").width, 3);
  EXPECT_TRUE(bits(a.fields["velocity"].rows) == bits(b.fields.at("velocity").rows));
  EXPECT_TRUE(bits(a.fields["a/b"].rows) == bits(b.fields.at("a/b").rows));
  std::string changed = test::content(path);
  const double value = a.fields["velocity"].rows[1234];
  const std::size_t at = changed.find({reinterpret_cast<const char*>(&value), sizeof value});
  ASSERT_NE(at, std::string::npos);
  changed[at] = static_cast<char>(changed[at] ^ 1);
  test::put(path, changed);
  EXPECT_NE(message_of<CaseError>([&] { read_checkpoint(path); }).find("the checksum of \"velocity\" is not right"),
            std::string::npos);
}

/// Whatever HDF5 reads there: the file is HDF5 with plain datasets.
TEST(Checkpoint, FieldsAreDatasetsOfHdf5) {
  const test::TemporaryFolder folder;
  Checkpoint a;
  a.range = {0, 4, 4, true};
  a.fields["velocity"] = {2, {1, 2, 3, 4, 5, 6, 7, 8}};
  write_checkpoint(folder / "c.h5", a);
  const hid_t file = H5Fopen((folder / "c.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t data = H5Dopen2(file, "fields/velocity", H5P_DEFAULT);
  std::vector<double> values(8);
  ASSERT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Dclose(data);
  H5Fclose(file);
  EXPECT_EQ(values, a.fields["velocity"].rows);
}

TEST(Checkpoint, LargeTextOfManyNumbers) {
  const test::TemporaryFolder folder;
  Checkpoint a;
  for (int i = 0; i < 2000; ++i) a.numbers["number " + std::to_string(i)] = i;
  a.case_text.assign(300'000, 'x');
  write_checkpoint(folder / "c.h5", a);
  const Checkpoint b = read_checkpoint(folder / "c.h5");
  EXPECT_EQ(b.numbers, a.numbers);
  EXPECT_EQ(b.case_text, a.case_text);
}

TEST(Checkpoint, MissingFile) {
  EXPECT_EQ(message_of<CaseError>([] { read_checkpoint("/nonexistent/checkpoint.h5"); }),
            "no checkpoint at /nonexistent/checkpoint.h5: No such file or directory.");
}

TEST(Checkpoint, DamageIsSeen) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "c.h5";
  write_checkpoint(path, example());
  const std::string whole = test::content(path);
  const auto message = [&] { return message_of<CaseError>([&] { read_checkpoint(path); }); };
  test::put(path, whole.substr(0, whole.size() / 2));
  EXPECT_NE(message().find("damaged or not a checkpoint"), std::string::npos);
  for (const std::size_t at : {std::size_t{0}, whole.size() / 2, whole.size() - 3}) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 4);  // one bit
    test::put(path, changed);
    EXPECT_NE(message().find("damaged or not a checkpoint"), std::string::npos) << at;
  }
  for (const char* text : {"", "hello"}) {
    test::put(path, text);
    EXPECT_NE(message().find("damaged or not a checkpoint"), std::string::npos);
  }
}

TEST(Checkpoint, OtherFormatVersion) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "c.h5";
  write_checkpoint(path, {});
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t attribute = H5Aopen(file, "format_version", H5P_DEFAULT);
  const long long version = 7;
  ASSERT_GE(H5Awrite(attribute, H5T_NATIVE_LLONG, &version), 0);
  H5Aclose(attribute);
  H5Fclose(file);
  const std::string changed = test::content(path);  // HDF5 has cut off the checksum
  char line[32];
  std::snprintf(line, sizeof line, "\nsinew crc32 %08lx\n",
                crc32(0, reinterpret_cast<const Bytef*>(changed.data()), static_cast<uInt>(changed.size())));
  test::put(path, changed + line);
  EXPECT_NE(message_of<CaseError>([&] { read_checkpoint(path); }).find("has checkpoint format 7; this program reads format 2"),
            std::string::npos);
}

TEST(Checkpoint, FailedWriteKeepsTheLastOne) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "c.h5";
  Checkpoint last;
  last.step = 5;
  write_checkpoint(path, last);
  {
    const test::SmallFilesOnly limit(20'000);
    EXPECT_EQ(message_of<SimulationError>([&] { write_checkpoint(path, example()); }),
              "cannot write " + path + ": File too large");
  }
  EXPECT_EQ(read_checkpoint(path).step, 5);
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  EXPECT_EQ(message_of<SimulationError>([&] { write_checkpoint("/nonexistent/c.h5", last); }),
            "cannot write /nonexistent/c.h5: No such file or directory");
}

}  // namespace
}  // namespace sinew
