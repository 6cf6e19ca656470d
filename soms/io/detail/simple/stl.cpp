#include "soms/io/detail/simple/stl.h"

#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/numbers/little_endian.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <string>

namespace soms::detail {

namespace {

constexpr std::size_t kHeader = 84;  // 80 bytes of anything and the count
constexpr std::size_t kFacet = 50;   // normal, three corners, attribute

bool equals(std::string_view token, std::string_view lower) {
  return std::equal(token.begin(), token.end(), lower.begin(), lower.end(),
                    [](char c, char l) { return c == l || (c >= 'A' && c <= 'Z' && c + 32 == l); });
}

bool begins_with_solid(std::string_view bytes) {
  const std::size_t begin = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  const std::string_view token = bytes.substr(begin, 5);
  const std::size_t behind = begin + 5;
  return equals(token, "solid") &&
         (behind == bytes.size() || is_blank(bytes[behind]) || is_line_end(bytes[behind]));
}

/// The count's own size, without overflow: 2^32 facets are below 2^38 bytes.
std::uint64_t stated_size(std::string_view bytes) {
  return kHeader + kFacet * std::uint64_t{little_endian<std::uint32_t>(bytes, 80)};
}

bool is_binary_of_right_size(std::string_view bytes) {
  return bytes.size() >= kHeader && bytes.size() == stated_size(bytes);
}

/// True if each facet is followed by as many bytes as its attribute says, and the file ends so.
/// Attributes are no lengths, and a reader that takes facets of 50 bytes finds triangles that are
/// not there.
bool has_bytes_behind_facets(std::string_view bytes, std::uint64_t count) {
  std::size_t at = kHeader;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (bytes.size() - at < kFacet) {
      return false;
    }
    const std::size_t behind = little_endian<std::uint16_t>(bytes, at + kFacet - 2);
    at += kFacet;
    if (bytes.size() - at < behind) {
      return false;
    }
    at += behind;
  }
  return at == bytes.size();
}

Mesh read_binary(Source& source) {
  const std::string_view bytes = source.bytes;
  if (bytes.size() < kHeader) {
    source.fail(ErrorKind::bad_file,
                std::to_string(bytes.size()) + " bytes are too few for an STL file",
                "get the complete file");
  }
  const std::uint64_t count = little_endian<std::uint32_t>(bytes, 80);
  const std::uint64_t held = (bytes.size() - kHeader) / kFacet;
  if (bytes.size() != stated_size(bytes) && has_bytes_behind_facets(bytes, count)) {
    source.fail_byte(kHeader + kFacet - 2, ErrorKind::bad_file,
                     "each triangle is followed by as many bytes as its attribute says, but "
                     "attributes of STL are no lengths, and triangles have 50 bytes each",
                     "write the file again without bytes between the triangles");
  }
  // Fewer bytes than a facet behind the last may be padding; more would be triangles lost.
  if (count != held) {
    source.fail_byte(80, ErrorKind::bad_file,
                     "the header states " + std::to_string(count) +
                         " triangles, but the file has " + std::to_string(held),
                     "get the complete file, or correct its count");
  }
  MeshBuilder builder(source);
  builder.reserve_vertices(3 * count);
  builder.reserve_triangles(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::size_t facet = kHeader + kFacet * i;
    if (i % kRowsPerTick == 0) {
      source.tick(facet);
    }
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t at = facet + 12 * (corner + 1);
      const Vec3 v{little_endian<float>(bytes, at), little_endian<float>(bytes, at + 4),
                   little_endian<float>(bytes, at + 8)};
      if (!fit_for_mesh(v)) [[unlikely]] {
        const CoordinateFault fault = describe_fault(v);
        source.fail_byte(at, fault.kind, "triangle " + std::to_string(i) + ": " + fault.what,
                         fault.remedy);
      }
      builder.add_vertex(v);
    }
    const auto first = static_cast<std::uint32_t>(3 * i);
    builder.add_triangle(first, first + 1, first + 2);
  }
  const std::size_t behind = kHeader + kFacet * static_cast<std::size_t>(count);
  LeftOut surplus;
  surplus.add([&] { return "at " + source.byte_of(behind); }, bytes.size() - behind);
  builder.note(surplus, "surplus bytes after the last triangle");
  return builder.finish();
}

class StlTextReader {
 public:
  explicit StlTextReader(Source& source) : source_(source), scanner_(source, 0), builder_(source) {}

  Mesh read();

 private:
  void expect(std::string_view wanted);
  void read_facet();
  [[nodiscard]] std::string_view read_name();
  [[noreturn]] void fail_token(std::string_view found, std::string_view wanted) const;

  Source& source_;
  TextScanner scanner_;
  MeshBuilder builder_;
};

void StlTextReader::fail_token(std::string_view found, std::string_view wanted) const {
  scanner_.fail(ErrorKind::bad_file,
                "expected " + std::string(wanted) + ", but " +
                    (found.empty() ? std::string("the file ends") : "found " + in_quotes(found)),
                "get the complete file, or repair it");
}

void StlTextReader::expect(std::string_view wanted) {
  const std::string_view found = scanner_.token();
  if (!equals(found, wanted)) {
    fail_token(found, wanted);
  }
}

/// Behind the word facet. The normal is passed unread: some programs write "nan" there.
void StlTextReader::read_facet() {
  constexpr int kMostTokens = 5;
  std::string_view token = scanner_.token();
  for (int i = 0; i < kMostTokens && !equals(token, "outer"); ++i) {
    token = scanner_.token();
  }
  if (!equals(token, "outer")) {
    fail_token(token, "outer loop");
  }
  expect("loop");
  const auto first = static_cast<std::uint32_t>(builder_.vertices().size());
  for (int corner = 0; corner < 3; ++corner) {
    expect("vertex");
    builder_.add_vertex(scanner_.vertex(Precision::as_double));
  }
  expect("endloop");
  expect("endfacet");
  builder_.add_triangle(first, first + 1, first + 2);
}

/// The name behind the word solid or endsolid: the rest of the line. It may be any words, but no
/// whole facet, which would be lost.
std::string_view StlTextReader::read_name() {
  bool facet = false;
  for (TextScanner tokens = scanner_; !tokens.at_line_end();) {
    const std::string_view token = tokens.token_in_line();
    if (facet && equals(token, "endfacet")) {
      scanner_.fail(ErrorKind::bad_file, "a facet follows the name of a solid on the same line",
                    "put each facet on its own lines");
    }
    facet = facet || equals(token, "facet");
  }
  return scanner_.rest_of_line();
}

Mesh StlTextReader::read() {
  bool in_solid = false;
  std::uint64_t facets = 0;
  while (true) {
    const std::string_view token = scanner_.token();
    if (token.empty() && !in_solid) {
      return builder_.finish();
    }
    if (in_solid && equals(token, "facet")) {
      if (facets++ % kRowsPerTick == 0) {
        source_.tick(scanner_.position());
        source_.forget(scanner_.position());
      }
      read_facet();
    } else if (in_solid && equals(token, "endsolid")) {
      static_cast<void>(read_name());
      in_solid = false;
    } else if (!in_solid && equals(token, "solid")) {
      builder_.begin_part(read_name());
      in_solid = true;
    } else {
      fail_token(token, in_solid ? "facet or endsolid" : "solid");
    }
  }
}

}  // namespace

bool is_stl(std::string_view bytes) {
  return (is_binary_of_right_size(bytes) && bytes.size() > kHeader) || begins_with_solid(bytes);
}

Mesh read_stl(Source& source) {
  // A binary file may begin with "solid" too; no text holds a zero byte in its first lines.
  constexpr std::size_t kFirstBytes = 512;
  const bool text = begins_with_solid(source.bytes) &&
                    source.bytes.substr(0, kFirstBytes).find('\0') == std::string_view::npos;
  if (is_binary_of_right_size(source.bytes) || !text) {
    return read_binary(source);
  }
  return StlTextReader(source).read();
}

}  // namespace soms::detail
