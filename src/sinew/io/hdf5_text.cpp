#include <sinew/io/hdf5_text.hpp>

namespace sinew {

namespace {

herr_t collect_link(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}
herr_t collect_attribute(hid_t, const char* name, const H5A_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

}  // namespace

std::string encoded(const std::string& name) {
  std::string out;
  for (const char c : name) out += c == '%' ? "%25" : c == '/' ? "%2F" : c == '.' ? "%2E" : std::string(1, c);
  return out.empty() ? "%" : out;
}

std::string decoded(const std::string& link) {
  std::string out;
  for (std::size_t i = 0; i < link.size(); ++i) {
    if (link[i] != '%')
      out += link[i];
    else if (i + 2 < link.size())
      out += static_cast<char>(std::stoi(link.substr(i + 1, 2), nullptr, 16)), i += 2;
  }
  return out;
}

void write_text(hid_t group, const std::string& name, const std::string& text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a string type");
  hdf5_check(H5Tset_size(type, text.size() + 1), "set the length of " + name);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "make a data space");
  const Hdf5Handle data(H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                        "make " + name);
  hdf5_check(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), "write " + name);
}

std::string read_text_dataset(hid_t group, const std::string& name) {
  const Hdf5Handle data(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "find " + name);
  const Hdf5Handle stored(H5Dget_type(data), H5Tclose, "read the type of " + name);
  if (H5Tget_class(stored) != H5T_STRING || H5Tget_size(stored) == 0) throw Hdf5Error("cannot read " + name + " as a text");
  std::string text(H5Tget_size(stored), '\0');
  hdf5_check(H5Dread(data, stored, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "read " + name);
  text.pop_back();
  return text;
}

std::vector<std::string> link_names(hid_t group) {
  std::vector<std::string> names;
  hdf5_check(H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect_link, &names), "list a group");
  return names;
}

std::vector<std::string> attribute_names(hid_t group) {
  std::vector<std::string> names;
  hdf5_check(H5Aiterate2(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect_attribute, &names), "list the numbers");
  return names;
}

}  // namespace sinew
