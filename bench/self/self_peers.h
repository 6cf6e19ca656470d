/// \file
/// A mesh and itself as CGAL answers it.
#pragma once

#include "soms/base/vector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace soms::bench {

/// A mesh in CGAL's hands.
class SelfPeer {
 public:
  virtual ~SelfPeer() = default;

  /// Triangles that CGAL's surface does not take, as more than two would meet in an edge.
  [[nodiscard]] virtual std::size_t left_out() const = 0;

  /// Pairs that `self_intersections` finds with predicates that are exact.
  [[nodiscard]] virtual std::size_t find() const = 0;
};

}  // namespace soms::bench

/// Nothing where CGAL was not found when this was built.
extern "C" soms::bench::SelfPeer* soms_bench_self_peer(
    std::span<const soms::Vec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles);
