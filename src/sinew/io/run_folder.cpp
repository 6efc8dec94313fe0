#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <sinew/core/error.hpp>
#include <sinew/io/run_folder.hpp>
#include <string_view>
#include <vector>

namespace sinew {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> file_names{"case.resolved.toml", "run.log",       "summary.json", "history.csv",
                                                     "particles.pvd",      "checkpoint.h5", "report.html"};
constexpr const char* frame_folder = "particles";

bool holds_a_run(const fs::path& folder) {
  return fs::exists(folder / "case.resolved.toml") || fs::exists(folder / "summary.json");
}

bool is_frame(const std::string& name) {
  return name.starts_with("frame_") && (name.ends_with(".vtu") || name.ends_with(".pvtu") || name.ends_with(".part"));
}

/// Removes the files that a run writes, and the folder of frames if nothing else is in it.
void remove_run(const fs::path& folder) {
  for (const std::string_view name : file_names) {
    fs::remove(folder / name);
    fs::remove(folder / (std::string(name) + ".part"));
  }
  const fs::path frames = folder / frame_folder;
  if (!fs::is_directory(fs::symlink_status(frames))) return;
  std::vector<fs::path> old;
  for (const fs::directory_entry& entry : fs::directory_iterator(frames))
    if (is_frame(entry.path().filename().string())) old.push_back(entry.path());
  for (const fs::path& path : old) fs::remove(path);
  if (fs::is_empty(frames)) fs::remove(frames);
}

/// The sure way to know that files can be made there, also for root, on read-only and on full disks.
void try_to_write(const std::string& folder) {
  const std::string name = folder + "/.sinew_write_test";
  std::FILE* file = std::fopen(name.c_str(), "wb");
  if (!file) throw CaseError("cannot write into " + folder + ": " + std::strerror(errno) + ". Choose another folder with -o.");
  std::fclose(file);
  std::remove(name.c_str());
}

void make_empty(const std::string& path, bool force) {
  if (fs::exists(path) && !fs::is_directory(path))
    throw CaseError(path + " is a file, not a folder. Choose another folder with -o.");
  if (fs::exists(path) && !fs::is_empty(path)) {
    if (!force)
      throw CaseError("the folder " + path +
                      " is not empty. Choose another with -o, or pass --force to overwrite the run in it.");
    if (!holds_a_run(path))
      throw CaseError(
          "the folder " + path +
          " is not empty and does not hold a run (no case.resolved.toml, no summary.json), so --force removes nothing "
          "from it. Choose another with -o.");
    remove_run(path);
  }
  fs::create_directories(fs::path(path) / frame_folder);
}

}  // namespace

RunFolder RunFolder::create(const std::string& path, bool force) {
  if (path.empty()) throw CaseError("the name of the run folder is empty. Choose one with -o.");
  try {
    make_empty(path, force);
  } catch (const fs::filesystem_error& error) {
    throw CaseError("cannot make the folder " + path + ": " + error.code().message() + ". Choose another with -o.");
  }
  try_to_write(path);
  return RunFolder(path);
}

RunFolder RunFolder::open(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) throw CaseError("there is no run folder " + path + ".");
  if (!fs::exists(fs::path(path) / "case.resolved.toml", ignored))
    throw CaseError("the folder " + path + " does not hold a run (no case.resolved.toml in it).");
  return RunFolder(path);
}

std::string RunFolder::frame_name(long index) { return fmt::format("{}/frame_{:06d}.vtu", frame_folder, index); }

}  // namespace sinew
