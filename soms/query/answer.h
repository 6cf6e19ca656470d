/// \file
/// What every answer carries: how much of the question it covers, and what it cost.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>
#include <utility>

namespace soms {

/// A triangle of the first body and a triangle of the second.
using TrianglePair = std::pair<TriangleId, TriangleId>;

/// How much of the question an answer covers.
enum class Coverage {
  complete,  ///< everything was decided
  first,     ///< stopped at the first hit, as requested
  cut,       ///< a limit or a deadline ended it; there may be more
};

/// Work done: deterministic counts for a given tree, layout and traversal, the same on every
/// machine and, for complete answers, for any number of threads.
struct Cost {
  std::uint64_t node_tests = 0;      ///< boxes, or pairs of boxes, tested
  std::uint64_t triangle_tests = 0;  ///< triangles, or pairs of them, tested
  std::uint64_t exact_tests = 0;     ///< of these, those that needed exact arithmetic

  [[nodiscard]] bool operator==(const Cost&) const = default;

  Cost& operator+=(const Cost& other) {
    node_tests += other.node_tests;
    triangle_tests += other.triangle_tests;
    exact_tests += other.exact_tests;
    return *this;
  }
};

}  // namespace soms
