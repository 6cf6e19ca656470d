#include "soms/io/detail/off.h"

#include "soms/geometry/counts.h"
#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/text.h"

#include <string>
#include <vector>

namespace soms::detail {

namespace {

/// `[ST][C][N][4][n]OFF`: the letters say what stands behind x, y and z, which nobody needs here.
bool is_magic(std::string_view word) {
  for (const std::string_view letters : {"ST", "C", "N", "4", "n"}) {
    if (word.starts_with(letters)) {
      word.remove_prefix(letters.size());
    }
  }
  return word == "OFF";
}

class OffReader {
 public:
  explicit OffReader(Source& source)
      : source_(source), scanner_(source, 0, {.comments = true}), builder_(source) {}

  Mesh read();

 private:
  void find_row(const char* what);
  void read_magic();
  std::uint64_t read_count(const char* what);
  void read_vertices(std::uint64_t count);
  void read_faces(std::uint64_t count);
  void read_face();

  Source& source_;
  TextScanner scanner_;
  MeshBuilder builder_;
  std::vector<std::uint32_t> corners_;
};

void OffReader::find_row(const char* what) {
  if (!scanner_.find_line()) {
    scanner_.fail(ErrorKind::bad_file, std::string("the file ends where ") + what + " should be",
                  "get the file whole; each vertex and each face is a line of its own");
  }
}

void OffReader::read_magic() {
  find_row("the word OFF");
  const TextScanner before = scanner_;
  const std::string_view magic = scanner_.word_in_line();
  if (!is_magic(magic)) {
    // Geomview lets the word be left out; then the counts come first.
    scanner_ = before;
    if (magic[0] < '0' || magic[0] > '9') {
      scanner_.fail(ErrorKind::bad_file, "the file begins with " + in_quotes(magic) + ", not OFF",
                    "give an OFF file");
    }
    return;
  }
  if (magic.find_first_of("4n") != std::string_view::npos) {
    before.fail(ErrorKind::unsupported, in_quotes(magic) + " has more than three dimensions",
                "give a file with x, y and z");
  }
  const TextScanner behind = scanner_;
  if (!scanner_.at_line_end() && scanner_.word_in_line() == "BINARY") {
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
                "get the file whole, or repair it");
  }
  return static_cast<std::uint64_t>(count);
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
    builder_.add_vertex(scanner_.vertex(Precision::as_double));
    scanner_.skip_line();
  }
}

void OffReader::read_face() {
  const TextScanner before = scanner_;
  const std::int64_t length = scanner_.integer("the number of corners");
  if (length < 0 || static_cast<std::uint64_t>(length) > (scanner_.left() + 1) / 2) {
    before.fail(ErrorKind::bad_file, "a face of " + std::to_string(length) + " corners",
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

Mesh OffReader::read() {
  read_magic();
  find_row("the counts");
  const std::uint64_t vertices = read_count("the number of vertices");
  const std::uint64_t faces = read_count("the number of faces");
  scanner_.skip_line();
  read_vertices(vertices);
  read_faces(faces);
  return builder_.finish();
}

}  // namespace

bool is_off(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size());
    std::string_view line = bytes.substr(0, end);
    const std::string_view word = take_word(line);
    if (!word.empty() && word[0] != '#') {
      return is_magic(word);
    }
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  return false;
}

Mesh read_off(Source& source) {
  return OffReader(source).read();
}

}  // namespace soms::detail
