#include <sinew/cli/frame_writer.hpp>

#include <sinew/io/file.hpp>
#include <utility>

namespace sinew {

FrameWriter::FrameWriter(const RunFolder& folder_, PvdSeries series_, VtkReal real_, const Comm& comm_)
    : folder(folder_),
      real(real_),
      series(std::move(series_)),
      comm(comm_),
      next(static_cast<long>(series.size())),
      listed(next),
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

template <class Action>
void FrameWriter::together(Action&& action) {
  try {
    comm.together(action);
  } catch (...) {
    broken = !comm.alone();
    throw;
  }
}

void FrameWriter::write(Snapshot snapshot) {
  if (broken) return;
  together([&] {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return !waiting || error; });
    throw_error();
    waiting = std::move(snapshot);
    changed.notify_all();
  });
  list_complete();
}

void FrameWriter::drain() {
  if (broken) return;
  together([&] {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return (!waiting && !busy) || error; });
    throw_error();
  });
  list_complete();
}

/// Lets those frames appear that all ranks have written.
void FrameWriter::list_complete() {
  if (comm.alone()) return;
  const std::vector<double> here = [this] {
    const std::lock_guard lock(mutex);
    return times;
  }();
  const auto everywhere = static_cast<long>(-comm.maximum(-static_cast<double>(here.size())));
  together([&] {
    for (long k = 0; comm.root() && k < everywhere; ++k) {
      PartFile::appear(folder.frame(listed + k));
      series.add(here[k], RunFolder::frame_name(listed + k));
    }
  });
  listed += everywhere;
  const std::lock_guard lock(mutex);
  times.erase(times.begin(), times.begin() + everywhere);
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
    if (!failure && !comm.alone()) times.push_back(snapshot.time);
    if (written.size() < 2) written.push_back(std::move(snapshot));
    changed.notify_all();
  }
}

void FrameWriter::write_now(const Snapshot& snapshot) {
  write_vtu(folder.frame(next), snapshot, real);
  if (comm.alone()) series.add(snapshot.time, RunFolder::frame_name(next));
  ++next;
}

}  // namespace sinew
