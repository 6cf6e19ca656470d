/// \file
/// Corners of glTF primitives in the order in which they make triangles.
#pragma once

#include "soms/io/detail/gltf/gltf_meshes.h"

#include <cstdint>
#include <optional>

namespace soms::detail {

/// Corners of a primitive, one after the other, as numbers of vertices. \invariant The primitive
/// outlives this.
class GltfCorners {
 public:
  /// `count`: of the primitive's positions, the first of which is vertex `first`.
  GltfCorners(const GltfPrimitive& primitive, std::uint64_t count, std::uint32_t first);

  /// \errors ErrorKind::bad_file: an index beyond the positions. \pre One is left.
  [[nodiscard]] std::uint32_t next() {
    const std::uint64_t number = number_++;
    if (!cursor_) {
      return first_ + static_cast<std::uint32_t>(number);
    }
    const std::uint32_t index = gltf_index(cursor_->next(), primitive_.indices->elements.type);
    if (index >= count_ || index == restart_) [[unlikely]] {
      fail(number, index);
    }
    return first_ + index;
  }

 private:
  [[noreturn]] void fail(std::uint64_t number, std::uint32_t index) const;

  const GltfPrimitive& primitive_;
  std::uint64_t count_;
  std::uint32_t first_;
  std::optional<GltfCursor> cursor_;
  std::uint64_t number_ = 0;
  std::uint64_t restart_ = 0;
};

}  // namespace soms::detail
