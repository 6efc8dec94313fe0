#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sinew/core/error.hpp>
#include <sinew/io/file.hpp>
#include <unistd.h>

namespace sinew {

std::string write_error_text(const std::string& path, int error_number) {
  return "cannot write " + path + ": " + std::strerror(error_number);
}

namespace {
std::string part_name(const std::string& path) { return path + ".part"; }
}  // namespace

PartFile::PartFile(const std::string& path_) : path(path_), file(std::fopen(part_name(path_).c_str(), "wb")) {
  if (!file) throw SimulationError(write_error_text(path, errno));
}

PartFile::~PartFile() {
  if (!file) return;
  std::fclose(file);
  std::remove(part_name(path).c_str());
}

void PartFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file) != text.size()) throw SimulationError(write_error_text(path, errno));
}

void PartFile::synchronize() {
  if (std::fflush(file) != 0 || ::fsync(::fileno(file)) != 0) throw SimulationError(write_error_text(path, errno));
}

void PartFile::commit() {
  if (std::fflush(file) != 0) throw SimulationError(write_error_text(path, errno));
  const int closed = std::fclose(file);
  file = nullptr;
  if (closed != 0) {
    const int reason = errno;
    std::remove(part_name(path).c_str());
    throw SimulationError(write_error_text(path, reason));
  }
  if (std::rename(part_name(path).c_str(), path.c_str()) != 0) throw SimulationError(write_error_text(path, errno));
}

void write_atomically(const std::string& path, std::string_view content) {
  PartFile file(path);
  file.write(content);
  file.commit();
}

std::string read_text(const std::string& path) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream.is_open() || stream.bad()) throw CaseError("cannot read " + path + ": " + std::strerror(errno ? errno : EIO));
  return text;
}

}  // namespace sinew
