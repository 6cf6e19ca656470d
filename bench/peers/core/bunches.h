/// \file
/// A mesh cut into bunches of triangles that lie near each other: all the order that judges have.
#pragma once

#include "soms/base/box.h"

#include "bench/peers/libraries/library.h"

#include <cstddef>
#include <span>
#include <vector>

namespace soms::bench {

// What rounding may come to, as parts of the largest coordinate. A judge in doubles loses more than
// a unit on slivers; a library in floats has rounded the pose and moved every corner in several
// steps.
inline constexpr double kSlackOfDoubles = 0x1p-36;
inline constexpr double kSlackOfFloats = 0x1p-18;

/// Triangles `first` to `first + count` - 1 of their list.
struct Bunch {
  Box box;
  std::size_t first = 0;
  std::size_t count = 0;
};

/// The triangles of a mesh in the order of its bunches, as many bunches as triangles in each.
struct Bunches {
  std::vector<Triangle> triangles;
  std::vector<Bunch> list;

  [[nodiscard]] std::span<const Triangle> of(const Bunch& bunch) const {
    return std::span(triangles).subspan(bunch.first, bunch.count);
  }
};

[[nodiscard]] Bunches bunches_of(const FloatMesh& mesh);

/// The same triangles at a pose.
[[nodiscard]] Bunches placed(const Bunches& mesh, const Pose& pose);

[[nodiscard]] Box bounds_of(const Bunches& mesh);

/// The largest coordinate, without its sign.
[[nodiscard]] double reach(const Box& box);

}  // namespace soms::bench
