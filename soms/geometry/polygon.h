/// \file
/// Cutting a polygon into triangles, the same way on every machine.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/geometry/orientation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms {

/// Cuts polygons into triangles; keeps its memory from one polygon to the next.
///
/// The polygon is projected along the largest component of its Newell normal (z, then x, then y
/// where they are equal). If the signed areas of the fan from corner 0 share one sign there (zeros
/// allowed), the result is that fan. Otherwise ears are clipped: a corner is an ear if it turns the
/// way of the normal and no other corner lies in its closed triangle (those at the position of one
/// of its three do not count, but for one at the ear's with a side that leads into its angle).
/// Corners are tried round and round, beginning behind the one that was clipped last. Where there
/// is no ear, a corner without turn is clipped; where there is none either (an outline that crosses
/// itself), the rest becomes a fan from its first corner.
class PolygonTriangulator {
 public:
  /// The triangles, as numbers of corners, each wound as the polygon is; valid until the next call.
  /// n corners give n-2 triangles; fewer than three give none.
  ///
  /// \shape   corners: n points in order around the polygon.
  /// \pre     Coordinates are finite and of magnitude at most 2^300; n below 2^32.
  /// \errors  ErrorKind::cancelled. Signs of areas and turns are exact.
  /// \cost    Linear for a fan, at most quadratic for ears.
  /// \threads One at a time for each object.
  [[nodiscard]] std::span<const std::array<std::uint32_t, 3>> triangulate(
      std::span<const Vec3> corners, const Limits& limits = {});

 private:
  /// A corner of the ring that is left while ears are clipped.
  struct Link {
    std::uint32_t previous = 0;
    std::uint32_t next = 0;
    std::uint32_t cursor = 0;  ///< corners before this place of `order_` do not block
    Sign turn = Sign::zero;
    bool clipped = false;
  };

  void choose_plane();
  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  [[nodiscard]] bool is_fan() const;
  [[nodiscard]] bool same_place(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] bool leads_into(std::uint32_t corner, std::uint32_t ear) const;
  [[nodiscard]] bool blocks(std::uint32_t corner, std::uint32_t ear) const;
  void measure(std::uint32_t ear);
  [[nodiscard]] bool is_ear(std::uint32_t corner);
  void clip(std::uint32_t ear);
  void clip_ears(const Limits& limits);
  [[nodiscard]] std::uint32_t find_ear(std::uint32_t start, const Limits& limits);
  [[nodiscard]] std::uint32_t find_straight(std::uint32_t start) const;

  std::span<const Vec3> corners_;
  std::size_t first_axis_ = 0;  ///< axes of the plane, first and second
  std::size_t second_axis_ = 1;
  Projection plane_ = Projection::xy;
  bool reversed_ = false;  ///< the normal points down its axis
  std::vector<Link> ring_;
  std::vector<std::uint32_t> order_;  ///< corners by their first coordinate in the plane
  std::uint32_t left_ = 0;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace soms
