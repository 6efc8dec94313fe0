#pragma once
/// A fixed-length array of plain values on whole cache lines, zeroed, with huge pages where the system offers them.

#include <sys/mman.h>

#include <cstdlib>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace sinew {

template <class T>
class AlignedArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  AlignedArray() = default;
  explicit AlignedArray(std::size_t size) : size_(size) {
    if (size == 0) return;
    const std::size_t page = bytes() >= huge_page ? huge_page : cache_line;
    const std::size_t rounded = (bytes() + page - 1) / page * page;
    data_ = static_cast<T*>(std::aligned_alloc(page, rounded));
    if (!data_) throw std::bad_alloc();
    if (page == huge_page) madvise(data_, rounded, MADV_HUGEPAGE);
    std::memset(static_cast<void*>(data_), 0, bytes());
  }
  AlignedArray(const AlignedArray& other) : AlignedArray(other.size_) {
    if (size_) std::memcpy(static_cast<void*>(data_), other.data_, bytes());
  }
  AlignedArray(AlignedArray&& other) noexcept { swap(other); }
  AlignedArray& operator=(AlignedArray other) noexcept {
    swap(other);
    return *this;
  }
  ~AlignedArray() { std::free(data_); }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(T); }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  std::span<const T> view() const { return {data_, size_}; }

 private:
  static constexpr std::size_t cache_line = 64, huge_page = std::size_t{1} << 21;

  void swap(AlignedArray& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace sinew
