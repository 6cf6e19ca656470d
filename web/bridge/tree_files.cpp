// Tree files: shapes as bytes, and back.
#include "soms/tree/file/shape_bytes.h"

#include "web/bridge/answer.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

using soms::web::Answer;
using soms::web::guarded;
using soms::web::HeldShape;

/// The shape in a tree file's bytes, which are copied; `check` is the number of a TreeCheck.
SOMS_EXPORT(soms_open_shape)

HeldShape* soms_open_shape(const std::byte* bytes, std::uint32_t size, std::uint32_t check) {
  return guarded([&] {
    const soms::OpenOptions options{.check = static_cast<soms::TreeCheck>(check)};
    return new HeldShape(soms::open_shape(std::span(bytes, size), "model.somst", options));
  });
}

/// Column: the bytes of a shape's tree file, u8.
SOMS_EXPORT(soms_save_shape) Answer* soms_save_shape(const HeldShape* held) {
  return guarded([&] {
    // The arrays, and what fills the pages of the head and of each section: a vector that grows
    // would hold the file twice.
    constexpr std::size_t kPages = std::size_t{16} * 4096;
    std::vector<std::uint8_t> file;
    file.reserve(held->shape().memory() + kPages);
    write_tree_file(held->shape(), [&file](std::span<const std::byte> bytes) {
      const auto* const begin = reinterpret_cast<const std::uint8_t*>(bytes.data());
      file.insert(file.end(), begin, begin + bytes.size());
    });
    return soms::web::answer_of(std::move(file));
  });
}
