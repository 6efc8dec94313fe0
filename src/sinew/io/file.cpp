#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sinew/core/error.hpp>
#include <sinew/io/file.hpp>
#include <unistd.h>

namespace sinew {

std::string write_error_text(const std::string& path, int error_number) {
  return "cannot write " + path + ": " + std::strerror(error_number);
}

PartFile::PartFile(const std::string& path, Writers writers)
    : path_(path),
      file_(::open(part_name(path).c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | (writers == Writers::one ? O_TRUNC : 0), 0666)) {
  if (file_ < 0) fail();
}

PartFile::~PartFile() {
  if (file_ < 0) return;
  ::close(file_);
  std::remove(part_name(path_).c_str());
}

void PartFile::fail() const { throw SimulationError(write_error_text(path_, errno)); }

void PartFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::pwrite(file_, text.data(), text.size(), static_cast<off_t>(place_));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    place_ += static_cast<std::size_t>(written);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

namespace {
/// 0 once the call has not been interrupted by a signal.
template <class Call>
int insist(Call&& call) {
  int result = 0;
  do result = call();
  while (result != 0 && errno == EINTR);
  return result;
}
}  // namespace

void PartFile::reserve(std::size_t bytes) {
  if (bytes == 0 || insist([&] { return ::fallocate(file_, 0, 0, static_cast<off_t>(bytes)); }) == 0) return;
  if (errno != EOPNOTSUPP && errno != ENOSYS) fail();
}

void PartFile::cut(std::size_t bytes) {
  if (insist([&] { return ::ftruncate(file_, static_cast<off_t>(bytes)); }) != 0) fail();
}

void PartFile::synchronize() {
  if (insist([&] { return ::fsync(file_); }) != 0) fail();
}

void PartFile::leave() {
  const int closed = ::close(file_);
  file_ = -1;
  if (closed == 0) return;
  const int reason = errno;
  std::remove(part_name(path_).c_str());
  throw SimulationError(write_error_text(path_, reason));
}

void PartFile::appear(const std::string& path) {
  if (std::rename(part_name(path).c_str(), path.c_str()) != 0) throw SimulationError(write_error_text(path, errno));
}

void PartFile::commit() {
  leave();
  appear(path_);
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
