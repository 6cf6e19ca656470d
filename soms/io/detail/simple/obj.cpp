#include "soms/io/detail/simple/obj.h"

#include "soms/geometry/detail/counts.h"
#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

namespace {

constexpr TextStyle kStyle{.comments = true, .continued = true};

/// What a reader of triangles makes of a line.
enum class ObjLine : std::uint8_t {
  vertex,
  face,
  object,
  group,
  passed,     ///< nothing of the surface: normals, materials, how curves are to be drawn
  thin,       ///< lines and points
  free_form,  ///< curves and surfaces, those of the older form too
  called,     ///< what another file or program would give
  unknown,
};

struct ObjKeyword {
  std::string_view token;
  ObjLine line = ObjLine::unknown;
};

/// Words that begin lines, the frequent ones first.
constexpr auto kObjKeywords = std::to_array<ObjKeyword>(
    {{"v", ObjLine::vertex},         {"f", ObjLine::face},          {"vn", ObjLine::passed},
     {"vt", ObjLine::passed},        {"s", ObjLine::passed},        {"g", ObjLine::group},
     {"usemtl", ObjLine::passed},    {"o", ObjLine::object},        {"l", ObjLine::thin},
     {"p", ObjLine::thin},           {"fo", ObjLine::face},         {"mtllib", ObjLine::passed},
     {"vp", ObjLine::passed},        {"mg", ObjLine::passed},       {"bevel", ObjLine::passed},
     {"c_interp", ObjLine::passed},  {"d_interp", ObjLine::passed}, {"lod", ObjLine::passed},
     {"maplib", ObjLine::passed},    {"usemap", ObjLine::passed},   {"shadow_obj", ObjLine::passed},
     {"trace_obj", ObjLine::passed}, {"ctech", ObjLine::passed},    {"stech", ObjLine::passed},
     {"cstype", ObjLine::passed},    {"deg", ObjLine::passed},      {"bmat", ObjLine::passed},
     {"step", ObjLine::passed},      {"parm", ObjLine::passed},     {"trim", ObjLine::passed},
     {"hole", ObjLine::passed},      {"scrv", ObjLine::passed},     {"sp", ObjLine::passed},
     {"con", ObjLine::passed},       {"end", ObjLine::passed},      {"cdc", ObjLine::free_form},
     {"curv", ObjLine::free_form},   {"curv2", ObjLine::free_form}, {"surf", ObjLine::free_form},
     {"bsp", ObjLine::free_form},    {"bzp", ObjLine::free_form},   {"cdp", ObjLine::free_form},
     {"res", ObjLine::passed},       {"call", ObjLine::called},     {"csh", ObjLine::called}});

ObjLine obj_line_of(std::string_view token) {
  const auto* const found = std::find_if(kObjKeywords.begin(), kObjKeywords.end(),
                                         [&](const ObjKeyword& k) { return k.token == token; });
  return found == kObjKeywords.end() ? ObjLine::unknown : found->line;
}

/// Two passes: all vertices, then all faces, which may name any vertex.
class ObjReader {
 public:
  explicit ObjReader(Source& source) : source_(source), builder_(source) {}

  Mesh read();

 private:
  void read_vertices();
  void read_faces();
  void check_words();
  void read_vertex(TextScanner& scanner);
  void read_face(TextScanner& scanner, std::int64_t vertices_so_far);
  void leave_out(ObjLine kind, std::size_t begin, std::string_view token);

  Source& source_;
  MeshBuilder builder_;
  std::vector<std::uint32_t> corners_;
  LeftOut long_vertices_;
  LeftOut thin_;
  LeftOut free_form_;
  LeftOut called_;
  LeftOut unknown_;
};

/// OBJ counts from 1, and from the vertex before the face where numbers are negative.
std::string describe_index_fault(std::int64_t number, std::int64_t so_far, std::int64_t all) {
  const std::string index = "vertex " + std::to_string(number);
  if (number < 0) {
    return index + ", but " + std::to_string(so_far) +
           (so_far == 1 ? " vertex is" : " vertices are") + " defined before this line";
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
    if (scanner.token_in_line() == "v") {
      read_vertex(scanner);
    }
    scanner.skip_line();
  }
}

/// Behind z a weight or a color may stand, or both, with or without opacity.
void ObjReader::read_vertex(TextScanner& scanner) {
  constexpr std::size_t kMostBehind = 5;
  constexpr std::size_t kNeither = 2;
  builder_.add_vertex(scanner.vertex(Precision::as_double));
  const std::size_t begin = scanner.position();
  std::size_t tokens = 0;
  for (; !scanner.at_line_end(); ++tokens) {
    static_cast<void>(scanner.token_in_line());
  }
  if (tokens == kNeither || tokens > kMostBehind) {
    long_vertices_.add([&] { return "in " + source_.line_of(begin); });
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
                   number == 0 ? "vertices are numbered from 1" : "repair or drop the face");
    }
    corners_.push_back(static_cast<std::uint32_t>(corner));
  }
  builder_.add_face(corners_);
}

void ObjReader::read_faces() {
  TextScanner scanner(source_, 0, kStyle);
  std::int64_t vertices_so_far = 0;
  for (std::uint64_t line = 0; scanner.find_line(); ++line) {
    if (line % kRowsPerTick == 0) {
      source_.tick((source_.bytes.size() + scanner.position()) / 2);
      source_.forget(scanner.position());
    }
    const std::size_t begin = scanner.position();
    const std::string_view keyword = scanner.token_in_line();
    const ObjLine kind = obj_line_of(keyword);
    if (kind == ObjLine::vertex) {
      ++vertices_so_far;
    } else if (kind == ObjLine::face) {
      read_face(scanner, vertices_so_far);
    } else if (kind == ObjLine::object || kind == ObjLine::group) {
      TextScanner name = scanner;  // what ends the line is for skip_line, as in the first pass
      if (kind == ObjLine::object) {
        builder_.begin_object(name.rest_of_line());
      } else {
        builder_.begin_group(name.rest_of_line());
      }
    } else if (kind != ObjLine::passed) {
      leave_out(kind, begin, keyword);
    }
    scanner.skip_line();
  }
  builder_.note(long_vertices_,
                "vertices with values after z that are neither a weight nor a color");
  builder_.note(thin_, "lines and points, which are not triangles");
  builder_.note(free_form_, "free-form curves and surfaces, not read");
  builder_.note(called_, "calls of other files or programs, not followed");
  builder_.note(unknown_, "lines that start with an unknown keyword, not read");
}

void ObjReader::leave_out(ObjLine kind, std::size_t begin, std::string_view token) {
  LeftOut& left_out = kind == ObjLine::thin        ? thin_
                      : kind == ObjLine::free_form ? free_form_
                      : kind == ObjLine::called    ? called_
                                                   : unknown_;
  left_out.add([&] {
    const std::string line = "in " + source_.line_of(begin);
    return kind == ObjLine::thin || kind == ObjLine::free_form ? line
                                                               : line + ": " + in_quotes(token);
  });
}

/// Of a file without vertices: throws where no line begins with a keyword of the format.
void ObjReader::check_words() {
  TextScanner scanner(source_, 0, kStyle);
  std::uint64_t lines = 0;
  for (; scanner.find_line(); ++lines) {
    if (lines % kRowsPerTick == 0) {
      check(source_.limits);
    }
    if (obj_line_of(scanner.token_in_line()) != ObjLine::unknown) {
      return;
    }
    scanner.skip_line();
  }
  if (lines > 0) {
    source_.fail(ErrorKind::bad_file, "no line begins with an OBJ keyword",
                 "give the model file, or rename it with the extension of its format");
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
    const std::string_view token = take_token(line);
    if (!token.empty() && token[0] != '#') {
      return token == "v" || token == "vn" || token == "vt" || token == "o" || token == "g" ||
             token == "mtllib";
    }
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  return false;
}

Mesh read_obj(Source& source) {
  return ObjReader(source).read();
}

}  // namespace soms::detail
