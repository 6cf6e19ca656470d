#include "soms/io/detail/simple/off.h"

#include "soms/geometry/detail/counts.h"
#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/text.h"

#include <string>
#include <vector>

namespace soms::detail {

namespace {

constexpr TextStyle kOffStyle{.comments = true};

/// `[ST][C][N][4][n]OFF`: the letters say what stands behind x, y and z, which nobody needs here.
/// The first count may follow without a blank, as in the files of ModelNet40: OFF8 6 0. The word
/// without it; empty if `token` is no such word.
std::string_view magic_of(std::string_view token) {
  std::string_view rest = token;
  for (const std::string_view letters : {"ST", "C", "N", "4", "n"}) {
    if (rest.starts_with(letters)) {
      rest.remove_prefix(letters.size());
    }
  }
  constexpr std::string_view kWord = "OFF";
  if (!rest.starts_with(kWord)) {
    return {};
  }
  rest.remove_prefix(kWord.size());
  const bool is_count = rest.find_first_not_of("0123456789") == std::string_view::npos;
  return is_count ? token.substr(0, token.size() - rest.size()) : std::string_view();
}

class OffReader {
 public:
  explicit OffReader(Source& source)
      : source_(source), scanner_(source, 0, kOffStyle), builder_(source) {}

  Mesh read();

 private:
  void find_row(const char* what);
  void read_magic();
  std::uint64_t read_count(const char* what);
  void read_vertices(std::uint64_t count);
  void read_faces(std::uint64_t count);
  void read_face();
  std::size_t pass_words();
  void refuse_behind_counts();
  void refuse_more();

  Source& source_;
  TextScanner scanner_;
  MeshBuilder builder_;
  std::vector<std::uint32_t> corners_;
  std::size_t most_behind_vertex_ =
      0;  ///< words behind z that the first word of the file announces
  LeftOut long_vertices_;
  LeftOut long_faces_;
  LeftOut color_indices_;
};

/// Numbers behind x, y and z: a normal, a color with or without opacity, two texture coordinates.
std::size_t most_behind_vertex(std::string_view magic) {
  const auto has = [&](char letter) { return magic.find(letter) != std::string_view::npos; };
  return (has('N') ? 3U : 0U) + (has('C') ? 4U : 0U) + (has('S') ? 2U : 0U);
}

void OffReader::find_row(const char* what) {
  if (!scanner_.find_line()) {
    scanner_.fail(ErrorKind::bad_file, std::string("the file ends, but ") + what + " is missing",
                  "get the complete file; each vertex and each face is on its own line");
  }
}

void OffReader::read_magic() {
  find_row("the keyword OFF");
  const TextScanner before = scanner_;
  const std::string_view token = scanner_.token_in_line();
  const std::string_view magic = magic_of(token);
  if (magic.empty()) {
    // Geomview lets the word be left out; then the counts come first.
    scanner_ = before;
    if (token[0] < '0' || token[0] > '9') {
      scanner_.fail(ErrorKind::bad_file, "the file begins with " + in_quotes(token) + ", not OFF",
                    "give an OFF file");
    }
    return;
  }
  if (magic.size() < token.size()) {
    scanner_ = TextScanner(source_, scanner_.position() - (token.size() - magic.size()), kOffStyle);
  }
  if (magic.find_first_of("4n") != std::string_view::npos) {
    before.fail(ErrorKind::unsupported, in_quotes(magic) + " has more than three dimensions",
                "give a file with x, y and z");
  }
  most_behind_vertex_ = most_behind_vertex(magic);
  const TextScanner behind = scanner_;
  if (!scanner_.at_line_end() && scanner_.token_in_line() == "BINARY") {
    before.fail(ErrorKind::unsupported, "binary OFF is not read", "convert it to text or to PLY");
  }
  scanner_ = behind;
}

std::uint64_t OffReader::read_count(const char* what) {
  const TextScanner before = scanner_;
  const std::int64_t count = scanner_.integer(what);
  // A row takes at least a digit and a line end, which the last may lack.
  if (count < 0 || static_cast<std::uint64_t>(count) > (scanner_.left() + 1) / 2) {
    before.fail(ErrorKind::bad_file,
                std::string(what) + " is " + std::to_string(count) + ", but " +
                    std::to_string(scanner_.left()) + " bytes are left",
                "get the complete file, or repair it");
  }
  return static_cast<std::uint64_t>(count);
}

/// Passes the words up to the end of the line or a comment; how many there are.
std::size_t OffReader::pass_words() {
  std::size_t tokens = 0;
  for (; !scanner_.at_line_end(); ++tokens) {
    static_cast<void>(scanner_.token_in_line());
  }
  return tokens;
}

void OffReader::read_vertices(std::uint64_t count) {
  // "0 0 0" and a line end.
  builder_.reserve_vertices(std::min<std::uint64_t>(count, scanner_.left() / 6 + 1));
  for (std::uint64_t row = 0; row < count; ++row) {
    if (row % kRowsPerTick == 0) {
      source_.tick(scanner_.position());
      source_.forget(scanner_.position());
    }
    find_row("a vertex");
    const std::size_t begin = scanner_.position();
    builder_.add_vertex(scanner_.vertex(Precision::as_double));
    if (pass_words() > most_behind_vertex_) {
      long_vertices_.add([&] { return "in " + source_.line_of(begin); });
    }
    scanner_.skip_line();
  }
}

/// A row of a face. Behind its corners a color may stand: three or four numbers, or one, the place
/// of the color in a list that nobody has, which a corner too many looks like.
void OffReader::read_face() {
  constexpr std::size_t kMostOfColor = 4;
  const TextScanner before = scanner_;
  const std::int64_t length = scanner_.integer("the number of corners");
  if (length < 0 || static_cast<std::uint64_t>(length) > (scanner_.left() + 1) / 2) {
    before.fail(ErrorKind::bad_file, "a face has " + std::to_string(length) + " corners",
                "repair or drop the face");
  }
  const auto vertices = static_cast<std::int64_t>(builder_.vertices().size());
  corners_.clear();
  for (std::int64_t i = 0; i < length; ++i) {
    const std::int64_t corner = scanner_.integer("a vertex number");
    if (corner < 0 || corner >= vertices) {
      scanner_.fail(
          ErrorKind::bad_file,
          index_fault("vertex " + std::to_string(corner), "vertices", builder_.vertices().size()),
          "repair or drop the face");
    }
    corners_.push_back(static_cast<std::uint32_t>(corner));
  }
  builder_.add_face(corners_);
  const std::size_t tokens = pass_words();
  const auto place = [&] { return "in " + source_.line_of(before.position()); };
  if (tokens == 1) {
    color_indices_.add(place);
  } else if (tokens == 2 || tokens > kMostOfColor) {
    long_faces_.add(place);
  }
}

void OffReader::read_faces(std::uint64_t count) {
  // "3 0 0 0" and a line end.
  builder_.reserve_triangles(std::min<std::uint64_t>(count, scanner_.left() / 8 + 1));
  for (std::uint64_t row = 0; row < count; ++row) {
    if (row % kRowsPerTick == 0) {
      source_.tick(scanner_.position());
      source_.forget(scanner_.position());
    }
    find_row("a face");
    read_face();
    scanner_.skip_line();
  }
}

/// Behind the counts of vertices and faces that of edges may stand, which nobody needs.
void OffReader::refuse_behind_counts() {
  if (!scanner_.at_line_end()) {
    static_cast<void>(scanner_.token_in_line());
  }
  if (!scanner_.at_line_end()) {
    scanner_.fail_surplus("the counts", "put the first vertex on its own line");
  }
}

/// Rows behind those that were counted contradict the counts.
void OffReader::refuse_more() {
  if (scanner_.find_line()) {
    scanner_.fail_surplus("the last declared face", "correct the counts, or delete the surplus");
  }
}

Mesh OffReader::read() {
  read_magic();
  find_row("the row of counts");
  const std::uint64_t vertices = read_count("the number of vertices");
  const std::uint64_t faces = read_count("the number of faces");
  refuse_behind_counts();
  scanner_.skip_line();
  read_vertices(vertices);
  read_faces(faces);
  refuse_more();
  builder_.note(long_vertices_,
                "vertex rows with more values after z than the keyword of the file declares");
  builder_.note(color_indices_,
                "face rows with one value after their corners, assumed to be a color");
  builder_.note(long_faces_, "face rows with values after their corners that are no color");
  return builder_.finish();
}

}  // namespace

bool is_off(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size());
    std::string_view line = bytes.substr(0, end);
    const std::string_view token = take_token(line);
    if (!token.empty() && token[0] != '#') {
      return !magic_of(token).empty();
    }
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  return false;
}

Mesh read_off(Source& source) {
  return OffReader(source).read();
}

}  // namespace soms::detail
