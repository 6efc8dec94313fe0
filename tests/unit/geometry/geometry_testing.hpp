#pragma once
/// Small helpers of the tests of geometries.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numeric>
#include <sinew/particles/generate/registry.hpp>
#include <string>

namespace sinew::testing {

inline const GenerateOptions plane{2, ""};
inline const GenerateOptions space{3, ""};

inline LatticeParams lattice(double spacing, const char* name = "auto", double jitter = 0.0, int seed = 1) {
  LatticeParams params;
  params.spacing = spacing;
  params.lattice.value = name;
  params.jitter = jitter;
  params.seed = seed;
  return params;
}

inline double total_volume(const PointSet& points) { return std::accumulate(points.volume.begin(), points.volume.end(), 0.0); }

/// The volume-weighted mean position.
inline Point center_of_mass(const PointSet& points) {
  Point sum;
  for (std::size_t i = 0; i < points.size(); ++i) sum += points.volume[i] * points.position[i];
  return (1.0 / total_volume(points)) * sum;
}

inline double nearest_distance(const PointSet& points) {
  double least = 1e300;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, norm(points.position[i] - points.position[j]));
  return least;
}

/// The message of the CaseError that `generate` of the shape throws; empty if it throws none.
template <class Shape>
std::string error_of(const Shape& shape, const GenerateOptions& options) {
  try {
    shape.generate(options);
  } catch (const CaseError& error) {
    return error.what();
  }
  return "";
}

/// A file with the given text in a folder of its own, gone at the end of the test.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text) {
    const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_path = std::filesystem::path(::testing::TempDir()) / (std::string("sinew_geometry_") + test->name());
    std::filesystem::create_directories(folder_path);
    file_name = name;
    std::ofstream(folder_path / name, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove_all(folder_path); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& name() const { return file_name; }
  std::string folder() const { return folder_path.string(); }
  GenerateOptions options(int dimension) const { return {dimension, folder()}; }
  /// The error of reading this file as a `Shape`, without the folder in front.
  template <class Shape>
  std::string error(int dimension) const {
    Shape shape;
    shape.file = file_name;
    std::string message = error_of(shape, options(dimension));
    const std::string prefix = folder() + "/";
    for (std::size_t at; (at = message.find(prefix)) != std::string::npos;) message.erase(at, prefix.size());
    return message;
  }

 private:
  std::filesystem::path folder_path;
  std::string file_name;
};

}  // namespace sinew::testing
