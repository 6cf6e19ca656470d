#include "soms/io/detail/simple/three_ds.h"

#include "soms/base/decimal.h"
#include "soms/geometry/detail/counts.h"
#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/numbers/little_endian.h"
#include "soms/io/detail/simple/three_ds_chunks.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>

namespace soms::detail {

namespace {

/// A chunk's name, and its bytes without the header.
struct Chunk {
  std::uint16_t name = 0;
  std::size_t begin = 0;
  std::size_t end = 0;

  [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// Chunks nest, but what is wanted stands at four known depths: one function for each, no
/// recursion, whatever the file nests.
class ThreeDsReader {
 public:
  explicit ThreeDsReader(Source& source) : source_(source), builder_(source) {}

  Mesh read();

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& what) const {
    source_.fail_byte(at, ErrorKind::bad_file, what, "get the complete file, or repair it");
  }

  [[nodiscard]] Chunk chunk_at(std::size_t at, std::size_t end) const;

  /// Calls `use` for each chunk in `[at, end)`.
  template <class Use>
  void for_each(std::size_t at, std::size_t end, const Use& use) const {
    while (at != end) {
      const Chunk chunk = chunk_at(at, end);
      use(chunk);
      at = chunk.end;
    }
  }

  /// The same for chunks of `expected`. Others are passed, and noted unless they add no shape.
  template <class Use>
  void for_each_expected(std::size_t at, std::size_t end,
                         std::initializer_list<std::uint16_t> expected, const Use& use) {
    for_each(at, end, [&](const Chunk& chunk) {
      if (std::find(expected.begin(), expected.end(), chunk.name) != expected.end()) {
        use(chunk);
      } else if (three_ds::holds_geometry(chunk.name)) {
        misplaced_.add([&] { return at_chunk(chunk); });
      } else if (!three_ds::adds_no_shape(chunk.name)) {
        unknown_.add([&] { return at_chunk(chunk); });
      }
    });
  }

  [[nodiscard]] std::string at_byte(std::size_t at) const { return "at " + source_.byte_of(at); }

  [[nodiscard]] std::string at_chunk(const Chunk& chunk) const {
    return at_byte(chunk.begin - three_ds::kChunkHeader);
  }

  void leave_out(std::size_t begin, std::size_t end) {
    surplus_.add([&] { return at_byte(begin); }, end - begin);
  }

  [[nodiscard]] std::uint16_t count_of(const Chunk& chunk, std::size_t item,
                                       const char* what) const;
  void read_master_scale(const Chunk& chunk);
  void read_editor(const Chunk& editor);
  void read_object(const Chunk& object);
  void read_triangles(const Chunk& triangles, std::string_view name);
  std::uint32_t read_vertices(const Chunk& chunk);
  void read_faces(const Chunk& chunk, std::uint32_t first, std::uint32_t vertices);
  void check_behind_faces(std::size_t at, std::size_t end);
  void check_behind_main(std::size_t at);

  Source& source_;
  MeshBuilder builder_;
  LeftOut surplus_;    ///< bytes behind the list of a chunk
  LeftOut misplaced_;  ///< chunks of geometry
  LeftOut unknown_;    ///< chunks that 3DS does not have
  LeftOut scales_;     ///< master scales other than 1
  LeftOut keyframes_;
};

Chunk ThreeDsReader::chunk_at(std::size_t at, std::size_t end) const {
  if (end - at < three_ds::kChunkHeader) {
    fail(at, "the header of a chunk is cut off");
  }
  const auto name = little_endian<std::uint16_t>(source_.bytes, at);
  const auto length = little_endian<std::uint32_t>(source_.bytes, at + 2);
  if (length < three_ds::kChunkHeader || length > end - at) {
    fail(at, "a chunk of length " + std::to_string(length) + " does not fit into the remaining " +
                 std::to_string(end - at) + " bytes");
  }
  return {name, at + three_ds::kChunkHeader, at + length};
}

/// The 16-bit count at the front of a chunk, checked against its size.
std::uint16_t ThreeDsReader::count_of(const Chunk& chunk, std::size_t item,
                                      const char* what) const {
  if (chunk.size() < 2) {
    fail(chunk.begin, std::string("the number of ") + what + " is cut off");
  }
  const auto count = little_endian<std::uint16_t>(source_.bytes, chunk.begin);
  if (count * item > chunk.size() - 2) {
    fail(chunk.begin, std::to_string(count) + " " + what + " in a chunk of " +
                          std::to_string(chunk.size()) + " bytes");
  }
  return count;
}

void ThreeDsReader::read_master_scale(const Chunk& chunk) {
  if (chunk.size() < sizeof(float)) {
    fail(chunk.begin, "the master scale is cut off");
  }
  const auto scale = little_endian<float>(source_.bytes, chunk.begin);
  if (scale != 1) {
    scales_.add([&] {
      std::array<char, 32> text{};
      const auto end = write_shortest(text.data(), text.data() + text.size(), scale);
      return at_chunk(chunk) + ": " + std::string(text.data(), end);
    });
  }
}

std::uint32_t ThreeDsReader::read_vertices(const Chunk& chunk) {
  const std::uint16_t count = count_of(chunk, 12, "vertices");
  for (std::uint16_t i = 0; i < count; ++i) {
    const std::size_t at = chunk.begin + 2 + std::size_t{12} * i;
    const Vec3 v{little_endian<float>(source_.bytes, at),
                 little_endian<float>(source_.bytes, at + 4),
                 little_endian<float>(source_.bytes, at + 8)};
    if (!fit_for_mesh(v)) {
      const CoordinateFault fault = describe_fault(v);
      source_.fail_byte(at, fault.kind, fault.what, fault.remedy);
    }
    builder_.add_vertex(v);
  }
  leave_out(chunk.begin + 2 + std::size_t{12} * count, chunk.end);
  return count;
}

void ThreeDsReader::read_faces(const Chunk& chunk, std::uint32_t first, std::uint32_t vertices) {
  const std::uint16_t count = count_of(chunk, 8, "faces");
  for (std::uint16_t i = 0; i < count; ++i) {
    const std::size_t at = chunk.begin + 2 + std::size_t{8} * i;
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = little_endian<std::uint16_t>(source_.bytes, at + 2 * k);
      if (corners[k] >= vertices) {
        fail(at + 2 * k, index_fault("vertex " + std::to_string(corners[k]), "vertices", vertices));
      }
    }
    builder_.add_triangle(first + corners[0], first + corners[1], first + corners[2]);
  }
  check_behind_faces(chunk.begin + 2 + std::size_t{8} * count, chunk.end);
}

/// Behind its faces a list has chunks of its own (materials, smoothing groups); what does not look
/// like one may be faces that were not counted.
void ThreeDsReader::check_behind_faces(std::size_t at, std::size_t end) {
  while (at != end) {
    const std::size_t left = end - at;
    const bool is_chunk =
        left >= three_ds::kChunkHeader &&
        three_ds::belongs_to_faces(little_endian<std::uint16_t>(source_.bytes, at));
    const std::uint32_t length =
        is_chunk ? little_endian<std::uint32_t>(source_.bytes, at + 2) : std::uint32_t{0};
    if (length < three_ds::kChunkHeader || length > left) {
      leave_out(at, end);
      return;
    }
    at += length;
  }
}

void ThreeDsReader::read_triangles(const Chunk& triangles, std::string_view name) {
  std::optional<Chunk> vertex_list;
  std::optional<Chunk> face_list;
  for_each_expected(triangles.begin, triangles.end, {three_ds::kVertexList, three_ds::kFaceList},
                    [&](const Chunk& chunk) {
                      auto& list = chunk.name == three_ds::kVertexList ? vertex_list : face_list;
                      if (list) {
                        fail(chunk.begin,
                             "a second list of vertices or faces in object " + in_quotes(name));
                      }
                      list = chunk;
                    });
  builder_.begin_part(name);
  const auto first = static_cast<std::uint32_t>(builder_.vertices().size());
  const std::uint32_t vertices = vertex_list ? read_vertices(*vertex_list) : 0;
  if (face_list) {
    read_faces(*face_list, first, vertices);
  }
}

void ThreeDsReader::read_object(const Chunk& object) {
  const std::string_view body = source_.bytes.substr(object.begin, object.size());
  const std::size_t length = body.find('\0');
  if (length == std::string_view::npos) {
    fail(object.begin, "the name of an object is not terminated");
  }
  const std::string_view name = body.substr(0, length);
  for_each_expected(object.begin + length + 1, object.end, {three_ds::kTriangles},
                    [&](const Chunk& chunk) { read_triangles(chunk, name); });
}

void ThreeDsReader::read_editor(const Chunk& editor) {
  for_each_expected(editor.begin, editor.end, {three_ds::kObject, three_ds::kMasterScale},
                    [&](const Chunk& chunk) {
                      source_.tick(chunk.begin);
                      if (chunk.name == three_ds::kObject) {
                        read_object(chunk);
                      } else {
                        read_master_scale(chunk);
                      }
                    });
}

void ThreeDsReader::check_behind_main(std::size_t at) {
  const std::size_t left = source_.bytes.size() - at;
  const bool second = left >= three_ds::kChunkHeader &&
                      little_endian<std::uint16_t>(source_.bytes, at) == three_ds::kMain;
  LeftOut behind;
  behind.add([&] { return at_byte(at); }, left);
  builder_.note(behind, second ? "bytes after the main chunk, which begin a second one, not read"
                               : "bytes after the main chunk, not read");
}

Mesh ThreeDsReader::read() {
  const Chunk main = chunk_at(0, source_.bytes.size());
  if (main.name != three_ds::kMain) {
    fail(0, "the file does not begin with the main chunk of 3DS");
  }
  for_each_expected(main.begin, main.end, {three_ds::kEditor, three_ds::kKeyframes},
                    [&](const Chunk& part) {
                      if (part.name == three_ds::kKeyframes) {
                        keyframes_.add([&] { return at_chunk(part); });
                      } else {
                        read_editor(part);
                      }
                    });
  builder_.note(scales_, "master scales other than 1, not applied");
  builder_.note(keyframes_, "keyframes, not applied");
  builder_.note(surplus_, "surplus bytes after the vertices or faces that a list counts");
  builder_.note(misplaced_, "misplaced mesh chunks, not read");
  builder_.note(unknown_, "unknown chunks, not read");
  check_behind_main(main.end);
  return builder_.finish();
}

}  // namespace

bool is_three_ds(std::string_view bytes) {
  return bytes.size() >= three_ds::kChunkHeader &&
         little_endian<std::uint16_t>(bytes, 0) == three_ds::kMain &&
         little_endian<std::uint32_t>(bytes, 2) == bytes.size();
}

Mesh read_three_ds(Source& source) {
  return ThreeDsReader(source).read();
}

}  // namespace soms::detail
