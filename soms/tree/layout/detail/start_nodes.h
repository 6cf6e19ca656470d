/// \file
/// Where a small box begins its descent of the tree of a flat mesh: below the root's levels, at
/// nodes near the place where it is.
#pragma once

#include "soms/tree/layout/detail/ground_plan.h"
#include "soms/tree/layout/detail/stored.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms {

struct WideNode;

namespace layout {

/// Lists of nodes for the cells of a ground plan, and for coarser ones, each of which is four of
/// the cells below. A list has the nodes that a descent from the root reaches with all that lies
/// above the cell, before it meets a leaf, a node with axes of its own, or a box no larger than the
/// cell.
///
/// Proof. A point of a triangle in a column of the cell lies in the boxes of all nodes above it. It
/// is between the cell's ends but for four roundings of the mesh's size S at most, of finding its
/// column and the ends: the cell is widened by 2^-45 S. What floats add to that is relative to the
/// node and the cell's distance from it, and added again. So no box of the point is left out. Where
/// a node has all that a list asks of it, its children take its place.
class StartNodes {
 public:
  /// None: every descent begins at the root.
  StartNodes() = default;

  /// \param scale turns the units of nodes' origins into those of the plan
  /// \cost O(n) time, mostly 1 to 4 bytes a triangle
  StartNodes(std::span<const WideNode> nodes, const GroundPlan& plan, double scale);

  /// Lists that something else holds.
  /// \pre `ends` are `count_lists(plan)` and one more; they ascend from 0 to the number of `nodes`.
  StartNodes(const GroundPlan& plan, std::span<const std::uint32_t> ends,
             std::span<const std::uint32_t> nodes);

  /// How many lists the cells of a plan have. \pre `MinMaxGrid::is_fit(plan)`
  [[nodiscard]] static std::size_t count_lists(const GroundPlan& plan);

  /// Nodes below which everything is that a box of the plan may meet.
  [[nodiscard]] std::span<const std::uint32_t> of(const PlanBox& box) const;

  /// The nodes of list i are those from `ends()[i]` to `ends()[i + 1]`.
  [[nodiscard]] std::span<const std::uint32_t> ends() const { return ends_; }

  [[nodiscard]] std::span<const std::uint32_t> nodes() const { return nodes_; }

  [[nodiscard]] bool operator==(const StartNodes&) const = default;

  [[nodiscard]] std::size_t memory() const { return nodes_.memory() + ends_.memory(); }

 private:
  /// The cells of one size.
  struct Level {
    std::size_t first = 0;  ///< of its lists in `ends_`
    std::uint32_t width = 0;
    std::uint32_t height = 0;

    [[nodiscard]] bool operator==(const Level&) const = default;
  };

  [[nodiscard]] std::span<const std::uint32_t> list(std::size_t cell) const {
    return nodes().subspan(ends_[cell], ends_[cell + 1] - ends_[cell]);
  }

  /// Divides the plan into cells of each size.
  void lay_levels(const GroundPlan& plan);

  std::vector<Level> levels_;    ///< finest first
  Stored<std::uint32_t> ends_;   ///< list i begins at ends_[i] and ends at ends_[i + 1]
  Stored<std::uint32_t> nodes_;  ///< those of coarser cells first
};

}  // namespace layout
}  // namespace soms
