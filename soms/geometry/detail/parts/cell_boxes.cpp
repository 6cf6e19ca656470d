#include "soms/geometry/detail/parts/cell_boxes.h"

#include "soms/base/double_limits.h"
#include "soms/geometry/detail/exact/exact_point.h"
#include "soms/geometry/detail/parts/odd.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace soms::detail {

namespace {

/// So few cuts are tried all on all cells of a box.
constexpr std::size_t kEnoughHalving = 8;

constexpr int kMaxDepth = 64;
constexpr int kPatience = 3;

/// Middles of boxes have so many bits below the box's size.
constexpr int kBitsOfMiddle = 4;

// Of the proof in cell_boxes.h, and room for underflow.
constexpr double kBound = 64 * 0x1p-53;
constexpr double kUnderflowOfArea = 0x1p-1060;

double above(double x) {
  return std::nextafter(x, kInfinity);
}

double below(double x) {
  return std::nextafter(x, -kInfinity);
}

/// A number of few bits near the middle of a range, where there is one; else any, or none where the
/// unit underflows: that is in no range.
double middle_of(double lower, double upper) {
  const double unit = std::ldexp(1.0, std::ilogb(upper - lower) - kBitsOfMiddle);
  return std::round((lower + (upper - lower) / 2) / unit) * unit;
}

/// Puts cuts in an order that has nothing to do with their places: the parts that each leaves have
/// about the same number of others, as far as these are apart.
void mix(std::vector<std::uint32_t>& cuts) {
  constexpr std::uint32_t kOdd = 2654435769U;
  std::sort(cuts.begin(), cuts.end(),
            [](std::uint32_t i, std::uint32_t j) { return i * kOdd < j * kOdd; });
}

}  // namespace

CellBoxes::CellBoxes(std::span<const PlaneCut> cuts, int exponent)
    : cuts_(cuts), exponent_(exponent) {
  segments_.reserve(cuts.size());
  for (const PlaneCut& cut : cuts) {
    Segment segment{rounded(cut.from), rounded(cut.to), {}};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [lower, upper] = std::minmax(segment.from[k], segment.to[k]);
      segment.bounds[k] = {below(lower), above(upper)};
      largest_ = std::max({largest_, -segment.bounds[k].lower, segment.bounds[k].upper});
    }
    segments_.push_back(segment);
  }
}

bool CellBoxes::for_each_part(const Cell& cell, const CellVisit& visit) const {
  std::vector<std::uint32_t> all(cuts_.size());
  std::iota(all.begin(), all.end(), 0U);
  return visit_parts({bounds_of(cell), cell, std::move(all), 0, kPatience}, visit);
}

std::array<double, 2> CellBoxes::rounded(const PlanePoint& p) const {
  return {nearest_double(p.u, p.w, exponent_), nearest_double(p.v, p.w, exponent_)};
}

CellBoxes::Rectangle CellBoxes::bounds_of(const Cell& cell) const {
  Rectangle box{Range{kInfinity, -kInfinity}, Range{kInfinity, -kInfinity}};
  for (const CellCorner& corner : cell) {
    const std::array<double, 2> p = rounded(corner.at);
    for (std::size_t k = 0; k < 2; ++k) {
      box[k] = {std::min(box[k].lower, below(p[k])), std::max(box[k].upper, above(p[k]))};
    }
  }
  return box;
}

bool CellBoxes::may_meet(const Segment& segment, const Rectangle& box) const {
  for (std::size_t k = 0; k < 2; ++k) {
    if (segment.bounds[k].upper < box[k].lower || segment.bounds[k].lower > box[k].upper) {
      return false;
    }
  }
  // Corners of the box on both sides of the line: the two farthest from it suffice.
  const double du = segment.to[0] - segment.from[0];
  const double dv = segment.to[1] - segment.from[1];
  const auto side = [&](double u, double v) {
    return du * (v - segment.from[1]) - dv * (u - segment.from[0]);
  };
  const double least =
      side(dv > 0 ? box[0].upper : box[0].lower, du > 0 ? box[1].lower : box[1].upper);
  const double most =
      side(dv > 0 ? box[0].lower : box[0].upper, du > 0 ? box[1].upper : box[1].lower);
  const double largest =
      std::max({largest_, -box[0].lower, box[0].upper, -box[1].lower, box[1].upper});
  const double bound = kBound * largest * largest + kUnderflowOfArea;
  return least <= bound && most >= -bound;
}

PlaneForm CellBoxes::line_at(std::size_t axis, double at) const {
  const Odd place(at);
  const int shift = place.number == 0 ? 0 : place.exponent - exponent_;
  PlaneForm line;
  (axis == 0 ? line.u : line.v) = Integer(1, static_cast<std::size_t>(std::max(-shift, 0)));
  line.w = Integer(-place.number, static_cast<std::size_t>(std::max(shift, 0)));
  return line;
}

std::vector<std::uint32_t> CellBoxes::cuts_in(const Part& part, const Rectangle& box) const {
  std::vector<std::uint32_t> inside;
  for (const std::uint32_t cut : part.cuts) {
    if (may_meet(segments_[cut], box)) {
      inside.push_back(cut);
    }
  }
  return inside;
}

bool CellBoxes::visit_parts(Part part, const CellVisit& visit) const {
  Rectangle extent{Range{kInfinity, -kInfinity}, Range{kInfinity, -kInfinity}};
  for (const std::uint32_t cut : part.cuts) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Range& of_cut = segments_[cut].bounds[k];
      extent[k].lower = std::min(extent[k].lower, std::max(of_cut.lower, part.box[k].lower));
      extent[k].upper = std::max(extent[k].upper, std::min(of_cut.upper, part.box[k].upper));
    }
  }
  const auto size = [&](std::size_t axis) { return extent[axis].upper - extent[axis].lower; };
  const std::size_t axis = size(0) >= size(1) ? 0 : 1;
  if (part.cuts.size() > kEnoughHalving && part.depth < kMaxDepth && part.patience > 0 &&
      size(axis) > 0) {
    const double at = middle_of(extent[axis].lower, extent[axis].upper);
    if (part.box[axis].lower < at && at < part.box[axis].upper) {
      return visit_halves(part, axis, at, visit);
    }
  }
  mix(part.cuts);
  return detail::for_each_part(std::move(part.cell), cuts_, std::move(part.cuts), visit);
}

bool CellBoxes::visit_halves(const Part& part, std::size_t axis, double at,
                             const CellVisit& visit) const {
  const PlaneForm line = line_at(axis, at);
  const CornerSigns signs = signs_at_corners(line, part.cell);
  std::array<Part, 2> halves;
  for (std::size_t i = 0; i < 2; ++i) {
    Part& half = halves[i];
    half.box = part.box;
    (i == 0 ? half.box[axis].upper : half.box[axis].lower) = at;
    if (i == 0 ? signs.below : signs.above) {
      half.cell = part_of(part.cell, signs.signs, line, i == 0 ? -1 : 1);
      half.cuts = cuts_in(part, half.box);
    }
  }
  const std::size_t count = part.cuts.size();
  const std::size_t together = halves[0].cuts.size() + halves[1].cuts.size();
  for (Part& half : halves) {
    const bool spared = 4 * together < 5 * count || 8 * half.cuts.size() < 7 * count;
    half.depth = part.depth + 1;
    half.patience = part.patience - (spared ? 0 : 1);
    if (!half.cell.empty() && !visit_parts(std::move(half), visit)) {
      return false;
    }
  }
  return true;
}

}  // namespace soms::detail
