/// \file
/// A polygon with holes as one outline, which can be cut into triangles.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/geometry/orientation.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms {

/// Joins the holes of polygons to their outlines; keeps its memory from one polygon to the next.
///
/// Seen along the largest component of the outline's Newell normal, each hole is joined by a
/// bridge: from its corner that is farthest along the first axis of that plane, to the nearest
/// corner from which it is seen. The holes come by that corner, the farthest first. A hole that is
/// wound as the outline is turned around. The result goes along the outline, over each bridge,
/// around the hole, and back over the bridge, so two corners of it stand twice for each hole. A
/// hole with a corner at one of the outline needs no bridge. Signs are exact.
class HoleJoiner {
 public:
  /// The joined outline as numbers of corners; valid until the next call. n corners and h holes
  /// give n + 2 h, as PolygonTriangulator takes them; fewer where holes need no bridge or are left
  /// out.
  ///
  /// \shape   `corners`: the outline's, then those of each hole, in order around. `ends`: behind
  ///          the last corner of each of these; the first is that of the outline.
  /// \pre     Coordinates are finite and of magnitude at most 2^300; n below 2^32.
  /// \errors  ErrorKind::cancelled.
  /// \cost    O(n^2) for each hole at worst.
  [[nodiscard]] std::span<const std::uint32_t> join(std::span<const Vec3> corners,
                                                    std::span<const std::size_t> ends,
                                                    const Limits& limits = {});

  /// Holes of the last polygon that are left out: no corner of the outline sees them, as they lie
  /// outside of it or cross it; or they have fewer than three corners.
  [[nodiscard]] std::size_t left_out() const { return left_out_; }

 private:
  struct Hole {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::uint32_t corner = 0;  ///< that is farthest along the first axis
  };

  void choose_plane(std::span<const Vec3> outline);
  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  [[nodiscard]] bool same_place(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] std::uint32_t farthest(std::size_t begin, std::size_t end) const;
  [[nodiscard]] bool winds_with_normal(std::size_t begin, std::size_t end) const;
  [[nodiscard]] bool crosses(std::uint32_t from, std::uint32_t to, std::uint32_t a,
                             std::uint32_t b) const;
  [[nodiscard]] bool sees(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] bool in_wedge(std::size_t place, std::uint32_t corner) const;
  [[nodiscard]] std::size_t bridge_to(const Hole& hole) const;
  [[nodiscard]] bool join_at_shared_corner(Hole hole);
  void splice(const Hole& hole, std::size_t place, bool shared);

  std::span<const Vec3> corners_;
  std::size_t first_axis_ = 0;
  std::size_t second_axis_ = 1;
  Projection plane_ = Projection::xy;
  bool reversed_ = false;  ///< the normal points down its axis
  std::vector<Hole> holes_;
  std::size_t joined_ = 0;  ///< of `holes_`
  std::vector<std::uint32_t> ring_;
  std::vector<std::uint32_t> spliced_;
  std::size_t left_out_ = 0;
};

}  // namespace soms
