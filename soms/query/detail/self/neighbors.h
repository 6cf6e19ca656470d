/// \file
/// Two triangles of one mesh that have corners in common.
#pragma once

#include "soms/base/vector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace soms::detail {

/// A triangle's corners, by the vertices that stand for them.
using CornerNames = std::array<std::uint32_t, 3>;

/// Which corners are common: bit 3 i + k for corner i of `a` and corner k of `b`.
[[nodiscard]] inline std::uint32_t common_corners(const CornerNames& a, const CornerNames& b) {
  std::uint32_t common = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      common |= static_cast<std::uint32_t>(a[i] == b[k]) << (3 * i + k);
    }
  }
  return common;
}

/// What two triangles have in common, and where that stands in each.
struct CommonPlace {
  enum class Kind : std::uint8_t {
    nothing,
    corner,     ///< one, the corner `a` of the first and the corner `b` of the second
    edge,       ///< two, all but the corner `a` of the first and the corner `b` of the second
    duplicate,  ///< all three
    unclear,    ///< a triangle names a corner twice
  };

  Kind kind = Kind::nothing;
  std::uint8_t a = 0;
  std::uint8_t b = 0;
};

/// By what `common_corners` gives.
[[nodiscard]] const CommonPlace& common_place(std::uint32_t common);

/// Which corners two triangles have in common, and which each has beside them. A corner that a
/// triangle names twice counts once.
class Neighbors {
 public:
  Neighbors(const CornerNames& a, const CornerNames& b);

  /// The triangles have the same corners.
  [[nodiscard]] bool duplicate() const { return own_a_.count == 0 && own_b_.count == 0; }

  /// Whether they share a point outside the convex hull of their common corners, by exact signs.
  /// \pre They have a corner in common. As for `beyond_corner`.
  [[nodiscard]] bool share_more(std::span<const Vec3> vertices) const;

 private:
  struct Set {
    CornerNames names = {};
    std::uint32_t count = 0;

    explicit Set(const CornerNames& corners);
    Set() = default;

    [[nodiscard]] bool has(std::uint32_t name) const;

    void add(std::uint32_t name) { names[count++] = name; }

    [[nodiscard]] std::uint32_t last() const { return names[count - 1]; }
  };

  Set common_;
  Set own_a_;
  Set own_b_;
};

}  // namespace soms::detail
