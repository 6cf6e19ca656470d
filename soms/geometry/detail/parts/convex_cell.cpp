#include "soms/geometry/detail/parts/convex_cell.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace soms::detail {

namespace {

/// Where two lines meet. \pre They are not parallel.
PlanePoint meeting(const PlaneForm& a, const PlaneForm& b) {
  PlanePoint p{a.v * b.w - a.w * b.v, a.w * b.u - a.u * b.w, a.u * b.v - a.v * b.u};
  return p.w.sign() < 0 ? PlanePoint{-p.u, -p.v, -p.w} : p;
}

/// True if an edge of the cell has the segment on its outer side.
bool is_beside(const PlaneCut& cut, const Cell& cell) {
  return std::any_of(cell.begin(), cell.end(), [&](const CellCorner& corner) {
    return corner.line->sign(cut.from) * corner.inner <= 0 &&
           corner.line->sign(cut.to) * corner.inner <= 0;
  });
}

/// Signs of a cell's corners if the cut's segment passes through its interior, else none.
std::vector<int> signs_if_parted(const PlaneCut& cut, const Cell& cell) {
  CornerSigns at = signs_at_corners(cut.line, cell);
  // A convex set and a segment are apart if an edge of either parts them.
  return at.below && at.above && !is_beside(cut, cell) ? std::move(at.signs) : std::vector<int>();
}

/// A cell that may still be cut, and by which of the cuts.
struct OpenCell {
  Cell cell;
  std::vector<std::uint32_t> cuts;
};

PlanePoint inside_of(const Cell& cell) {
  const PlanePoint& a = cell[0].at;
  const PlanePoint& b = cell[1].at;
  const PlanePoint& c = cell[2].at;
  return {a.u + b.u + c.u, a.v + b.v + c.v, a.w + b.w + c.w};
}

/// Cuts a cell in two, if a cut does, and keeps the first part; nothing left to cut: nothing.
std::optional<OpenCell> cut_off(OpenCell& open, std::span<const PlaneCut> cuts) {
  while (!open.cuts.empty()) {
    const PlaneCut& cut = cuts[open.cuts.back()];
    open.cuts.pop_back();
    const std::vector<int> signs = signs_if_parted(cut, open.cell);
    if (!signs.empty()) {
      OpenCell other{part_of(open.cell, signs, cut.line, -1), open.cuts};
      open.cell = part_of(open.cell, signs, cut.line, 1);
      return other;
    }
  }
  return std::nullopt;
}

}  // namespace

CornerSigns signs_at_corners(const PlaneForm& line, const Cell& cell) {
  CornerSigns at;
  for (const CellCorner& corner : cell) {
    at.signs.push_back(line.sign(corner.at));
    at.below = at.below || at.signs.back() < 0;
    at.above = at.above || at.signs.back() > 0;
  }
  return at;
}

Cell part_of(const Cell& cell, const std::vector<int>& signs, const PlaneForm& line, int side) {
  Cell part;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const int here = signs[i] * side;
    const int next = signs[(i + 1) % cell.size()] * side;
    if (here >= 0) {
      part.push_back(cell[i]);
      if (here == 0 && next < 0) {
        part.back().line = &line;
        part.back().inner = side;
      }
    }
    if (here > 0 && next < 0) {
      part.push_back({meeting(*cell[i].line, line), &line, side});
    } else if (here < 0 && next > 0) {
      part.push_back({meeting(*cell[i].line, line), cell[i].line, cell[i].inner});
    }
  }
  return part;
}

bool for_each_part(Cell cell, std::span<const PlaneCut> cuts, std::vector<std::uint32_t> some,
                   const CellVisit& visit) {
  std::vector<OpenCell> stack;
  stack.push_back({std::move(cell), std::move(some)});
  while (!stack.empty()) {
    OpenCell open = std::move(stack.back());
    stack.pop_back();
    while (std::optional<OpenCell> other = cut_off(open, cuts)) {
      stack.push_back(std::move(*other));
    }
    if (!visit(inside_of(open.cell))) {
      return false;
    }
  }
  return true;
}

}  // namespace soms::detail
