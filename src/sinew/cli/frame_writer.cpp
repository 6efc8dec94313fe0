#include <sinew/cli/frame_writer.hpp>

#include <utility>

namespace sinew {

FrameWriter::FrameWriter(const RunFolder& folder_, PvdSeries series_, VtkReal real_)
    : folder(folder_),
      real(real_),
      series(std::move(series_)),
      thread([this] { work(); }) {}

FrameWriter::~FrameWriter() {
  {
    const std::lock_guard lock(mutex);
    ending = true;
  }
  changed.notify_all();
  thread.join();
}

Snapshot FrameWriter::spent() {
  const std::lock_guard lock(mutex);
  if (written.empty()) return {};
  Snapshot snapshot = std::move(written.back());
  written.pop_back();
  return snapshot;
}

void FrameWriter::write(Snapshot snapshot) {
  std::unique_lock lock(mutex);
  changed.wait(lock, [this] { return !waiting || error; });
  throw_error();
  waiting = std::move(snapshot);
  changed.notify_all();
}

void FrameWriter::drain() {
  std::unique_lock lock(mutex);
  changed.wait(lock, [this] { return (!waiting && !busy) || error; });
  throw_error();
}

/// With the lock held.
void FrameWriter::throw_error() {
  if (!error) return;
  waiting.reset();
  std::rethrow_exception(std::exchange(error, nullptr));
}

void FrameWriter::work() {
  std::unique_lock lock(mutex);
  for (;;) {
    changed.wait(lock, [this] { return (waiting && !error) || ending; });
    if (!waiting || error) return;
    Snapshot snapshot = std::move(*waiting);
    waiting.reset();
    busy = true;
    changed.notify_all();
    lock.unlock();
    std::exception_ptr failure;
    try {
      write_now(snapshot);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    busy = false;
    error = failure;
    if (written.size() < 2) written.push_back(std::move(snapshot));
    changed.notify_all();
  }
}

void FrameWriter::write_now(const Snapshot& snapshot) {
  const long index = static_cast<long>(series.size());
  write_vtu(folder.frame(index), snapshot, real);
  series.add(snapshot.time, RunFolder::frame_name(index));
}

}  // namespace sinew
