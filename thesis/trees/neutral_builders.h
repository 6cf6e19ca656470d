/// \file
/// Builders of spatial median and of SOMS in which neither rule has an advantage of implementation:
/// one machine code serves both; they differ in the box that is divided and in nothing else.
#pragma once

#include "soms/tree/build_options.h"
#include "soms/tree/tree.h"

#include <array>
#include <cstdint>
#include <vector>

namespace soms::reproduce {

/// How a neutral builder works.
enum class NeutralWay {
  /// As the captions of the thesis have it: top down; a loop over a node's triangles gives its
  /// outer box when it is made, for SOMS one more loop its inner box; the lists of left and right
  /// triangles are stored for each node, in arrays that stay from build to build.
  /// \source thesis, figures 4.8, 4.19, 4.20 and 4.24 to 4.28.
  thesis_like,
  /// One array, divided in place. Of the two boxes only that which the rule needs is grown, while
  /// the parent is divided; SOMS gets the outer boxes from the leaves up.
  in_place,
};

/// What a build did, in steps that each look at one triangle; the same on every machine.
struct BuildWork {
  std::uint64_t compared = 0;  ///< midpoints compared with a plane, planes that failed included
  std::uint64_t outer = 0;     ///< triangles that an outer box took in
  std::uint64_t inner = 0;     ///< midpoints that an inner box took in
  std::uint64_t merged = 0;    ///< outer boxes put together from those of two children

  [[nodiscard]] bool operator==(const BuildWork&) const = default;

  /// Boxes grown: all but `compared`.
  [[nodiscard]] std::uint64_t grown() const { return outer + inner + merged; }
};

/// Makes the nodes that `soms::build` makes with the same options, to the last bit; only the order
/// of the triangles within a leaf differs.
class NeutralBuilder {
 public:
  /// \pre `options` are `thesis_options` of spatial_median or soms at a level above 0, but for
  ///      `empty_side`, which may be any. \errors std::logic_error for others.
  NeutralBuilder(NeutralWay way, const BuildOptions& options);

  /// From the triangles in memory to the finished tree, boxes and midpoints of triangles included.
  /// Buffers stay for the next build, as the fixed arrays of the thesis do.
  [[nodiscard]] Tree build(const Mesh& mesh);

  /// What the last build did.
  [[nodiscard]] const BuildWork& work() const { return work_; }

  /// A triangle as the builder in place sees it.
  struct Item {
    std::array<double, 3> lower = {};     ///< of its box
    std::array<double, 3> upper = {};     ///< of its box
    std::array<double, 3> midpoint = {};  ///< of the thesis
    TriangleId id = 0;
  };

  /// A triangle as the lists of the thesis hold it.
  struct ListItem {
    std::array<std::array<double, 3>, 3> corners = {};
    std::array<double, 3> midpoint = {};
    TriangleId id = 0;
  };

 private:
  NeutralWay way_;
  BuildOptions options_;
  BuildWork work_;
  std::vector<Item> items_;
  /// By depth, each with a place for every triangle: a node's list is the run [first, first +
  /// count) of its depth.
  std::vector<std::vector<ListItem>> lists_;
};

}  // namespace soms::reproduce
