/// \file
/// A cell that many segments cut, halved until each box has few of them: then no cut is tried on a
/// cell far from it.
///
/// Boxes are of doubles, the lines between them whole numbers again. A segment is left out of a box
/// only if it surely has no point there. Its ends are known to half a unit in the last place, so
/// with M the largest of all coordinates the differences of two, at most 2 M, are off by less than
/// 4 u M, u = 2^-53; a product of two of them, at most 4 M^2, by less than 16 u M^2 + 16 u^2 M^2
/// + 4 u M^2 < 21 u M^2; and the difference of two products, at most 8 M^2, by less than 50 u M^2.
#pragma once

#include "soms/geometry/detail/parts/convex_cell.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// Refers to the cuts.
class CellBoxes {
 public:
  /// Coordinates are in units of 2^`exponent`.
  CellBoxes(std::span<const PlaneCut> cuts, int exponent);

  /// As `for_each_part` with all cuts, but that boxes cut, too: all parts that the cuts leave have
  /// a point visited, some more than one.
  /// \cost Where segments are short, or cross few others, O(n log n) to O(n^1.5) for n of them.
  bool for_each_part(const Cell& cell, const CellVisit& visit) const;

 private:
  struct Range {
    double lower;
    double upper;
  };

  using Rectangle = std::array<Range, 2>;

  /// A segment in doubles.
  struct Segment {
    std::array<double, 2> from;
    std::array<double, 2> to;
    Rectangle bounds;
  };

  /// A part of the cell in a box, and the cuts that may pass through it.
  struct Part {
    Rectangle box;
    Cell cell;
    std::vector<std::uint32_t> cuts;
    int depth;
    int patience;  // so many halvings may spare no cut
  };

  [[nodiscard]] std::array<double, 2> rounded(const PlanePoint& p) const;

  [[nodiscard]] Rectangle bounds_of(const Cell& cell) const;

  [[nodiscard]] bool may_meet(const Segment& segment, const Rectangle& box) const;

  /// The line on which coordinate `axis` is `at`.
  [[nodiscard]] PlaneForm line_at(std::size_t axis, double at) const;

  bool visit_parts(Part part, const CellVisit& visit) const;

  bool visit_halves(const Part& part, std::size_t axis, double at, const CellVisit& visit) const;

  [[nodiscard]] std::vector<std::uint32_t> cuts_in(const Part& part, const Rectangle& box) const;

  std::span<const PlaneCut> cuts_;
  int exponent_;
  std::vector<Segment> segments_;
  double largest_ = 0;  // of all coordinates
};

}  // namespace soms::detail
