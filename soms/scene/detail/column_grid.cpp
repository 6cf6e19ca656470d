#include "soms/scene/detail/column_grid.h"

#include "soms/base/lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

constexpr std::size_t kSample = 128;
constexpr double kMostCells = 512;  // along one axis
constexpr double kMostColumns = 1 << 14;

// Costs that choose the width of columns, in nanoseconds: an entry, and a comparison.
constexpr double kEntryCost = 15;
constexpr double kCompareCost = 0.6;

/// How the boxes lie along one axis.
struct Spread {
  double lower = 0;
  double length = 0;
  double size = 0;  ///< of a usual box

  /// Boxes that lie side by side.
  [[nodiscard]] double boxes() const { return length > 0 ? length / usual() : 0; }

  [[nodiscard]] double usual() const { return std::max(size, length / 4096); }
};

/// Strays, at most a sixteenth of a sample at either side, do not widen the range, nor does the
/// largest sixteenth of the boxes count for the usual size.
Spread spread_of(std::vector<double>& lower, std::vector<double>& upper, double least,
                 double most) {
  const std::size_t count = lower.size();
  std::vector<double> sizes(count);
  for (std::size_t k = 0; k < count; ++k) {
    // Boxes beyond the range of floats have both ends there, and no size.
    sizes[k] = upper[k] > lower[k] ? upper[k] - lower[k] : 0;
  }
  const auto nth = [&](std::vector<double>& values, std::size_t n) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n), values.end());
    return values[n];
  };
  Spread spread;
  const std::size_t usual = count - count / 16;
  static_cast<void>(nth(sizes, usual - 1));
  for (std::size_t k = 0; k < usual; ++k) {
    spread.size += sizes[k] / static_cast<double>(usual);
  }
  const double from = nth(lower, count / 16);
  const double to = nth(upper, usual - 1);
  const double middle = to - from;
  if (most - least <= 2 * middle) {
    spread.lower = least;
    spread.length = most - least;
  } else {
    spread.lower = from - middle / 2;
    spread.length = 2 * middle;
  }
  return spread;
}

/// Counts of cells for columns of about `width` usual boxes.
std::pair<double, double> cells_of(const Spread& across, const Spread& upward, double width,
                                   double boxes) {
  const auto cells = [&](const Spread& spread) {
    return std::clamp(std::floor(spread.boxes() / width), 1.0, kMostCells);
  };
  double y = cells(across);
  double z = cells(upward);
  while (y * z > std::min(boxes, kMostColumns)) {
    double& larger = y > z ? y : z;
    larger = std::floor((larger + 1) / 2);
  }
  return {y, z};
}

/// Expected cost of such columns.
double cost_of(const std::array<Spread, 3>& spreads, double y, double z, double boxes) {
  const auto copies = [](const Spread& spread, double cells) {
    return spread.length > 0 ? 1 + spread.size * cells / spread.length : 1;
  };
  const double entries = boxes * copies(spreads[1], y) * copies(spreads[2], z);
  const double stretch =
      spreads[0].length > 0 ? std::min(1.0, spreads[0].size / spreads[0].length) : 1;
  return entries * (kEntryCost + kCompareCost * stretch * entries / (y * z));
}

/// How the boxes lie along each axis, by a sample. \returns false if that has no finite answer.
bool measure(std::span<const FloatBox> boxes, std::array<Spread, 3>& spreads) {
  std::array<std::vector<double>, 3> lower;
  std::array<std::vector<double>, 3> upper;
  const std::size_t stride = boxes.size() / kSample + 1;
  for (std::size_t k = 0; k < boxes.size(); k += stride) {
    for (std::size_t axis = 0; axis < 3 && boxes[k].lower[0] <= boxes[k].upper[0]; ++axis) {
      lower[axis].push_back(static_cast<double>(boxes[k].lower[axis]));
      upper[axis].push_back(static_cast<double>(boxes[k].upper[axis]));
    }
  }
  lanes::F4 least = load(kNoBox.lower);
  lanes::F4 most = load(kNoBox.upper);
  for (const FloatBox& box : boxes) {
    least = lanes::min(load(box.lower), least);
    most = lanes::max(load(box.upper), most);
  }
  for (std::size_t axis = 0; axis < 3 && !lower[0].empty(); ++axis) {
    spreads[axis] = spread_of(lower[axis], upper[axis], static_cast<double>(least[axis]),
                              static_cast<double>(most[axis]));
    if (!std::isfinite(spreads[axis].lower) || !std::isfinite(spreads[axis].length)) {
      return false;
    }
  }
  return !lower[0].empty();
}

/// The counts of cells that are expected to cost least.
std::pair<double, double> best_cells(const std::array<Spread, 3>& spreads, double boxes) {
  std::pair<double, double> best{1, 1};
  double least = cost_of(spreads, 1, 1, boxes);
  for (const double width : {1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0}) {
    const auto cells = cells_of(spreads[1], spreads[2], width, boxes);
    const double cost = cost_of(spreads, cells.first, cells.second, boxes);
    if (cost < least) {
      least = cost;
      best = cells;
    }
  }
  return best;
}

}  // namespace

std::optional<ColumnGrid> ColumnGrid::of(std::span<const FloatBox> boxes) {
  std::array<Spread, 3> spreads;
  if (!measure(boxes, spreads)) {
    return std::nullopt;
  }
  // The sweep runs where most boxes lie side by side.
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
    return spreads[a].boxes() > spreads[b].boxes();
  });
  spreads = {spreads[axes[0]], spreads[axes[1]], spreads[axes[2]]};
  const auto [y, z] = best_cells(spreads, static_cast<double>(boxes.size()));
  ColumnGrid grid;
  grid.along = axes[0];
  grid.across = axes[1];
  grid.upward = axes[2];
  const std::array<double, 3> counts{kSteps, y, z};
  for (std::size_t k = 0; k < 3; ++k) {
    const double scale = spreads[k].length > 0 ? counts[k] / spreads[k].length : 0;
    const double most = static_cast<double>(std::numeric_limits<float>::max());
    grid.origin[axes[k]] = static_cast<float>(spreads[k].lower);
    grid.scale[axes[k]] = static_cast<float>(std::min(scale, most));
    grid.last[axes[k]] = static_cast<float>(counts[k] - 1);
  }
  grid.columns_across = static_cast<std::uint32_t>(y);
  grid.columns = static_cast<std::uint32_t>(y * z);
  return grid;
}

}  // namespace soms::detail
