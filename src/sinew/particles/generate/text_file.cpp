#include <sinew/particles/generate/text_file.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace sinew {

namespace {

constexpr std::string_view blanks = " \t\r\f\v";

/// Whether all of `text` is a number of that type. A leading + is allowed.
template <class Number>
bool parse(std::string_view text, Number& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

/// A number whose exponent is written with D, as Fortran does.
bool parse_fortran(std::string_view text, double& value) {
  std::string copy(text);
  const std::size_t exponent = copy.find_first_of("dD");
  if (exponent == std::string::npos) return false;
  copy[exponent] = 'e';
  if (copy.size() > exponent + 1 && copy[exponent + 1] == '+') copy.erase(exponent + 1, 1);
  return parse(copy, value);
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string_view::npos ? text.substr(0, 0) : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

TextFile::TextFile(const std::string& name, const GenerateOptions& options) : path_name(options.path_of(name)) {
  if (name.empty()) options.fail("\"file\" is empty; it must name a file.");
  std::ifstream stream(path_name, std::ios::binary);
  if (!stream || !std::filesystem::is_regular_file(path_name)) options.fail("cannot read the file \"" + path_name + "\".");
  text.assign(std::istreambuf_iterator<char>(stream), {});
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // the byte order mark that some programs write
}

bool TextFile::next() {
  if (next_begin >= text.size()) return false;
  const std::size_t end = std::min(text.find('\n', next_begin), text.size());
  whole_line = std::string_view(text).substr(next_begin, end - next_begin);
  current = trimmed(whole_line);
  next_begin = end + 1;
  ++number_of_line;
  return true;
}

const std::vector<std::string_view>& TextFile::words() {
  parts.clear();
  for (std::size_t begin = 0; (begin = current.find_first_not_of(blanks, begin)) != std::string_view::npos;) {
    const std::size_t end = std::min(current.find_first_of(blanks, begin), current.size());
    parts.push_back(current.substr(begin, end - begin));
    begin = end;
  }
  return parts;
}

const std::vector<std::string_view>& TextFile::fields(char separator) {
  parts.clear();
  for (std::size_t begin = 0; begin <= current.size();) {
    const std::size_t end = std::min(current.find(separator, begin), current.size());
    parts.push_back(trimmed(current.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

double TextFile::number(std::string_view part, const char* what) const {
  double value = 0.0;
  if ((!parse(part, value) && !parse_fortran(part, value)) || !std::isfinite(value))
    fail(part, "\"" + std::string(part) + "\" is not a finite number; expected " + what + ".");
  return value;
}

long long TextFile::integer(std::string_view part, const char* what) const {
  long long value = 0;
  if (!parse(part, value)) fail(part, "\"" + std::string(part) + "\" is not an integer; expected " + what + ".");
  return value;
}

void TextFile::fail(std::string_view part, const std::string& message) const {
  const int column = part.data() == nullptr ? 1 : static_cast<int>(part.data() - whole_line.data()) + 1;
  throw CaseError(Place{path_name, number_of_line, column}, message);
}

}  // namespace sinew
