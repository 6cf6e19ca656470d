/// \file
/// Where two bodies touch, by the triangles that do.
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"

#include <cstddef>
#include <span>
#include <utility>

namespace soms::detail {

struct ContactPlace {
  std::size_t pair = 0;  ///< that has `point` in common
  Vec3 point = {};       ///< middle of what the triangles of that pair have in common
  Box box = {};          ///< around the common boxes of all pairs
};

/// A place in the midst of a contact: of the pair whose common box has its middle nearest to the
/// middle of them all. Of equally near pairs it is the first.
/// \pre   There are pairs, and each pair of triangles touches.
/// \cost  O(n), and one `crossing`.
[[nodiscard]] ContactPlace contact_place(std::span<const std::pair<Triangle, Triangle>> pairs);

}  // namespace soms::detail
