#include "soms/io/detail/obj.h"

#include "soms/geometry/counts.h"
#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace soms::detail {

namespace {

constexpr TextStyle kStyle{.comments = true, .continued = true};

/// Words that a file without vertices may begin lines with, if it is OBJ at all.
constexpr auto kWords = std::to_array<std::string_view>(
    {"vt",     "vn",     "vp",     "f",      "fo",  "l",    "p",   "g",      "o",   "s",  "mg",
     "mtllib", "usemtl", "maplib", "usemap", "lod", "call", "csh", "cstype", "deg", "end"});

/// Two passes: all vertices, then all faces, which may name any vertex.
class ObjReader {
 public:
  explicit ObjReader(Source& source) : source_(source), builder_(source) {}

  Mesh read();

 private:
  void read_vertices();
  void read_faces();
  void check_words();
  void read_face(TextScanner& scanner, std::int64_t vertices_so_far);

  Source& source_;
  MeshBuilder builder_;
  std::vector<std::uint32_t> corners_;
};

/// OBJ counts from 1, and from the vertex before the face where numbers are negative.
std::string describe_index_fault(std::int64_t number, std::int64_t so_far, std::int64_t all) {
  const std::string index = "vertex " + std::to_string(number);
  if (number < 0) {
    return index + ", but " + std::to_string(so_far) +
           (so_far == 1 ? " vertex stands" : " vertices stand") + " before this line";
  }
  return index + (all == 0   ? ", but there are no vertices"
                  : all == 1 ? ", but the only one is 1"
                             : ", but vertices are 1 to " + std::to_string(all));
}

void ObjReader::read_vertices() {
  TextScanner scanner(source_, 0, kStyle);
  for (std::uint64_t line = 0; scanner.find_line(); ++line) {
    if (line % kRowsPerTick == 0) {
      source_.tick(scanner.position() / 2);
    }
    if (scanner.word_in_line() == "v") {
      builder_.add_vertex(scanner.vertex(Precision::as_double));
    }
    scanner.skip_line();
  }
}

void ObjReader::read_face(TextScanner& scanner, std::int64_t vertices_so_far) {
  const auto vertices = static_cast<std::int64_t>(builder_.vertices().size());
  corners_.clear();
  while (!scanner.at_line_end()) {
    const std::int64_t number = scanner.slashed_integer("a corner");
    const std::int64_t corner = number < 0 ? vertices_so_far + number : number - 1;
    if (corner < 0 || corner >= vertices) {
      scanner.fail(ErrorKind::bad_file, describe_index_fault(number, vertices_so_far, vertices),
                   number == 0 ? "count vertices from 1" : "repair or drop the face");
    }
    corners_.push_back(static_cast<std::uint32_t>(corner));
  }
  builder_.add_face(corners_);
}

void ObjReader::read_faces() {
  TextScanner scanner(source_, 0, kStyle);
  std::int64_t vertices_so_far = 0;
  std::uint64_t curves = 0;
  std::uint64_t surfaces = 0;
  for (std::uint64_t line = 0; scanner.find_line(); ++line) {
    if (line % kRowsPerTick == 0) {
      source_.tick((source_.bytes.size() + scanner.position()) / 2);
      source_.forget(scanner.position());
    }
    const std::string_view keyword = scanner.word_in_line();
    if (keyword == "v") {
      ++vertices_so_far;
    } else if (keyword == "f" || keyword == "fo") {
      read_face(scanner, vertices_so_far);
    } else if (keyword == "g" || keyword == "o") {
      TextScanner name = scanner;  // what ends the line is for skip_line, as in the first pass
      builder_.begin_part(name.rest_of_line());
    } else if (keyword == "l" || keyword == "p") {
      ++curves;
    } else if (keyword == "curv" || keyword == "curv2" || keyword == "surf") {
      ++surfaces;
    }
    scanner.skip_line();
  }
  if (curves > 0) {
    builder_.note("lines and points, which are not triangles: " + std::to_string(curves));
  }
  if (surfaces > 0) {
    builder_.note("free-form curves and surfaces, which are not read: " + std::to_string(surfaces));
  }
}

/// Of a file without vertices: throws where no line begins with a word of the format.
void ObjReader::check_words() {
  TextScanner scanner(source_, 0, kStyle);
  std::uint64_t lines = 0;
  for (; scanner.find_line(); ++lines) {
    if (lines % kRowsPerTick == 0) {
      check_stop(source_.parallel);
    }
    const std::string_view word = scanner.word_in_line();
    if (std::find(kWords.begin(), kWords.end(), word) != kWords.end()) {
      return;
    }
    scanner.skip_line();
  }
  if (lines > 0) {
    source_.fail(ErrorKind::bad_file, "no line begins with a word of OBJ",
                 "give the file itself, or let its name end as its format does");
  }
}

Mesh ObjReader::read() {
  read_vertices();
  if (builder_.vertices().empty()) {
    check_words();
  }
  read_faces();
  return builder_.finish();
}

}  // namespace

bool is_obj(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size());
    std::string_view line = bytes.substr(0, end);
    const std::string_view word = take_word(line);
    if (!word.empty() && word[0] != '#') {
      return word == "v" || word == "vn" || word == "vt" || word == "o" || word == "g" ||
             word == "mtllib";
    }
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  return false;
}

Mesh read_obj(Source& source) {
  return ObjReader(source).read();
}

}  // namespace soms::detail
