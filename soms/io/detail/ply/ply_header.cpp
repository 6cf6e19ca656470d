#include "soms/io/detail/ply/ply_header.h"

#include "soms/io/detail/text.h"

#include <array>
#include <charconv>
#include <utility>

namespace soms::detail {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypeNames = {{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

/// Takes the header line by line.
class HeaderReader {
 public:
  explicit HeaderReader(const Source& source) : source_(source) {}

  PlyHeader read();

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const {
    source_.fail_line(line_begin_, ErrorKind::bad_file, what, remedy);
  }

  void find_line_ends();
  std::string_view next_line();
  void read_format(std::string_view line);
  void read_element(std::string_view line);
  void read_property(std::string_view line);
  [[nodiscard]] PlyType read_type(std::string_view token) const;
  void expect_end(std::string_view line) const;

  const Source& source_;
  std::size_t line_begin_ = 0;
  std::size_t at_ = 0;
  char line_end_ = '\n';
  bool has_format_ = false;
  PlyHeader header_;
};

/// The first line tells how lines end: a single CR behind the magic word means CR everywhere, so
/// that a body that begins with an LF byte keeps it.
void HeaderReader::find_line_ends() {
  const std::size_t end = source_.bytes.find_first_of("\r\n");
  const bool single = end != std::string_view::npos && source_.bytes[end] == '\r' &&
                      (end + 1 == source_.bytes.size() || source_.bytes[end + 1] != '\n');
  line_end_ = single ? '\r' : '\n';
}

std::string_view HeaderReader::next_line() {
  line_begin_ = at_;
  const std::size_t end = source_.bytes.find(line_end_, at_);
  if (end == std::string_view::npos) {
    fail("the header ends without end_header", "get the complete file");
  }
  std::string_view line = source_.bytes.substr(at_, end - at_);
  at_ = end + 1;
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  return line;
}

PlyType HeaderReader::read_type(std::string_view token) const {
  for (const auto& [name, type] : kTypeNames) {
    if (name == token) {
      return type;
    }
  }
  fail("property type " + in_quotes(token) + " is unknown",
       "use char, uchar, short, ushort, int, uint, float or double");
}

void HeaderReader::expect_end(std::string_view line) const {
  const std::string_view token = take_token(line);
  if (!token.empty()) {
    fail(in_quotes(token) + " follows the end of a header line", "repair the header");
  }
}

void HeaderReader::read_format(std::string_view line) {
  const std::string_view format = take_token(line);
  const std::string_view version = take_token(line);
  if (has_format_) {
    fail("a second format line", "repair the header");
  }
  if (format == "ascii") {
    header_.format = PlyFormat::ascii;
  } else if (format == "binary_little_endian") {
    header_.format = PlyFormat::little_endian;
  } else if (format == "binary_big_endian") {
    header_.format = PlyFormat::big_endian;
  } else {
    fail("format " + in_quotes(format) + " is unknown",
         "use ascii, binary_little_endian or binary_big_endian");
  }
  if (version != "1.0") {
    fail("version " + in_quotes(version) + " of PLY is unknown", "use version 1.0");
  }
  expect_end(line);
  has_format_ = true;
}

void HeaderReader::read_element(std::string_view line) {
  PlyElement element;
  element.name = take_token(line);
  const std::string_view count = take_token(line);
  const char* end = count.data() + count.size();
  const auto [stop, error] = std::from_chars(count.data(), end, element.count);
  if (count.empty() || error != std::errc() || stop != end) {
    fail("element " + in_quotes(element.name) + " has the count " + in_quotes(count),
         "give a whole number of at least 0");
  }
  expect_end(line);
  header_.elements.push_back(std::move(element));
}

void HeaderReader::read_property(std::string_view line) {
  if (header_.elements.empty()) {
    fail("a property before any element", "repair the header");
  }
  PlyProperty property;
  std::string_view token = take_token(line);
  if (token == "list") {
    property.is_list = true;
    property.count_type = read_type(take_token(line));
    if (is_floating(property.count_type)) {
      fail("the length of a list has a floating type", "use uchar, ushort, uint or int");
    }
    token = take_token(line);
  }
  property.type = read_type(token);
  property.name = take_token(line);
  if (property.name.empty()) {
    fail("a property without a name", "repair the header");
  }
  expect_end(line);
  header_.elements.back().properties.push_back(property);
}

PlyHeader HeaderReader::read() {
  find_line_ends();
  std::string_view magic = next_line();
  if (take_token(magic) != "ply") {
    fail("the file does not begin with the line \"ply\"", "give a PLY file");
  }
  expect_end(magic);
  while (true) {
    std::string_view line = next_line();
    if (line.find('\0') != std::string_view::npos) {
      fail("a zero byte in the header", "repair the header");
    }
    const std::string_view keyword = take_token(line);
    if (keyword == "element") {
      read_element(line);
    } else if (keyword == "property") {
      read_property(line);
    } else if (keyword == "format") {
      read_format(line);
    } else if (keyword == "end_header") {
      expect_end(line);
      break;
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
      fail("header line " + in_quotes(keyword) + " is unknown", "repair the header");
    }
  }
  if (!has_format_) {
    fail("the header has no format line", "add one, such as: format ascii 1.0");
  }
  header_.body = at_;
  return std::move(header_);
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

std::optional<std::size_t> PlyElement::find(const Source& source, std::string_view wanted) const {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == wanted) {
      if (found) {
        source.fail(
            ErrorKind::bad_file,
            "element " + in_quotes(name) + " has the property " + in_quotes(wanted) + " twice",
            "repair the header");
      }
      found = i;
    }
  }
  return found;
}

std::uint64_t PlyElement::least_row() const {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : properties) {
    bytes += size_of(property.is_list ? property.count_type : property.type);
  }
  return bytes;
}

bool PlyElement::has_lists() const {
  for (const PlyProperty& property : properties) {
    if (property.is_list) {
      return true;
    }
  }
  return false;
}

PlyHeader read_ply_header(const Source& source) {
  return HeaderReader(source).read();
}

}  // namespace soms::detail
