/// \file
/// How far apart are two posed meshes? For poses of near misses; it takes no part in any race.
#pragma once

#include "soms/base/box.h"

#include "bench/peers/libraries/library.h"

#include <cstdint>
#include <vector>

namespace soms::bench {

/// A plain tree of boxes over a mesh, for distances.
class GapTree {
 public:
  explicit GapTree(const FloatMesh& mesh);

  /// Distance of `mover` at `pose` from this body, or `enough` where it is not less; once it is
  /// known to be below `too_near`, any value below. Of meshes that do not touch.
  [[nodiscard]] double distance(const GapTree& mover, const Pose& pose, double enough,
                                double too_near = 0) const;

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0;
    std::uint32_t count = 0;  // 0: inner
    std::uint32_t right = 0;
  };

  void split(std::uint32_t id, std::vector<std::uint32_t>& pending);

  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
};

}  // namespace soms::bench
