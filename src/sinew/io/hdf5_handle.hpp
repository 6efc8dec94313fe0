#pragma once
/// What the C interface of HDF5 lacks: handles that close themselves and errors that cannot be overlooked.

#include <hdf5.h>
#include <stdexcept>
#include <string>
#include <utility>

namespace sinew {

struct Hdf5Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws Hdf5Error("cannot WHAT") if an HDF5 call says that it failed.
template <class Result>
Result hdf5_check(Result result, const std::string& what) {
  if (result < 0) throw Hdf5Error("cannot " + what);
  return result;
}

/// Owns one identifier.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle(hid_t id_, Close close_, const std::string& what) : id(hdf5_check(id_, what)), close_id(close_) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id(std::exchange(other.id, H5I_INVALID_HID)), close_id(other.close_id) {}
  ~Hdf5Handle() {
    if (id >= 0) close_id(id);
  }
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  operator hid_t() const { return id; }

 private:
  hid_t id;
  Close close_id;
};

/// While it lives, HDF5 does not print its error stack; our messages say what a user needs.
class Hdf5Silence {
 public:
  Hdf5Silence() {
    H5Eget_auto2(H5E_DEFAULT, &function, &data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, function, data); }
  Hdf5Silence(const Hdf5Silence&) = delete;
  Hdf5Silence& operator=(const Hdf5Silence&) = delete;

 private:
  H5E_auto2_t function = nullptr;
  void* data = nullptr;
};

}  // namespace sinew
