#include "soms/scene/detail/moving_pairs.h"

#include <algorithm>
#include <array>

namespace soms::detail {

namespace {

constexpr std::uint32_t kSteps = 1U << 16;
constexpr std::uint32_t kMostColumns = 1U << 15;
/// A column is this many mean boxes wide: narrower ones repeat boxes, wider ones test strangers.
constexpr double kBoxesPerColumn = 4;
/// A box that meets more columns than this is wide.
constexpr std::uint32_t kMostColumnsOfABox = 8;

/// Cell of `value` among `cells`, growing with it, so that order is never lost by rounding.
std::uint32_t cell(double value, double origin, double scale, std::uint32_t cells) {
  const double position = (value - origin) * scale;
  return position > 0 ? static_cast<std::uint32_t>(std::min(position, double(cells - 1))) : 0;
}

}  // namespace

std::uint32_t MovingPairs::Grid::column(double value) const {
  return cell(value, column_origin, column_scale, columns);
}

std::uint32_t MovingPairs::Grid::step(double value) const {
  return cell(value, sweep_origin, sweep_scale, kSteps);
}

MovingPairs::Grid MovingPairs::choose_grid(std::span<const Box> boxes) {
  Box all;
  Vec3 sizes;
  double count = 0;
  for (const Box& box : boxes) {
    if (!box.empty()) {
      all.grow(box);
      sizes += box.extent();
      count += 1;
    }
  }
  Grid grid;
  if (count == 0) {
    return grid;
  }
  // The two axes along which the boxes are most scattered, measured in boxes.
  std::array<double, 3> spread{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double extent = all.upper[axis] - all.lower[axis];
    spread[axis] = extent > 0 ? extent / std::max(sizes[axis] / count, extent / kMostColumns) : 0;
  }
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](std::size_t a, std::size_t b) { return spread[a] > spread[b]; });
  grid.along = axes[0];
  grid.across = axes[1];
  const double width = all.upper[grid.across] - all.lower[grid.across];
  const double length = all.upper[grid.along] - all.lower[grid.along];
  // More columns than boxes would be empty ones.
  const double columns = std::clamp(spread[grid.across] / kBoxesPerColumn, 1.0,
                                    std::min(count, static_cast<double>(kMostColumns)));
  grid.columns = static_cast<std::uint32_t>(columns);
  grid.column_origin = all.lower[grid.across];
  grid.column_scale = width > 0 ? grid.columns / width : 0;
  grid.sweep_origin = all.lower[grid.along];
  grid.sweep_scale = length > 0 ? kSteps / length : 0;
  return grid;
}

void MovingPairs::enter(std::span<const Box> boxes, const Grid& grid) {
  ranges_.assign(boxes.size(), {});
  is_wide_.assign(boxes.size(), 0);
  entries_.clear();
  wide_.clear();
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    const Box& box = boxes[k];
    if (box.empty()) {
      continue;
    }
    const Range range{grid.column(box.lower[grid.across]), grid.column(box.upper[grid.across]),
                      grid.step(box.upper[grid.along])};
    ranges_[k] = range;
    if (range.last_column - range.first_column >= kMostColumnsOfABox) {
      is_wide_[k] = 1;
      wide_.push_back(k);
      continue;
    }
    const std::uint64_t first_step = grid.step(box.lower[grid.along]);
    for (std::uint64_t column = range.first_column; column <= range.last_column; ++column) {
      entries_.push_back((column << 48) | (first_step << 32) | k);
    }
  }
  std::sort(entries_.begin(), entries_.end());
}

void MovingPairs::sweep(std::span<const Box> boxes) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto a = static_cast<std::uint32_t>(entries_[i]);
    const auto column = static_cast<std::uint32_t>(entries_[i] >> 48);
    const Range& range = ranges_[a];
    const std::uint64_t last = (std::uint64_t{column} << 16) | range.last_step;
    for (std::size_t j = i + 1; j < entries_.size() && (entries_[j] >> 32) <= last; ++j) {
      const auto b = static_cast<std::uint32_t>(entries_[j]);
      if (std::max(range.first_column, ranges_[b].first_column) == column &&
          overlaps(boxes[a], boxes[b])) {
        pairs_.emplace_back(std::min(a, b), std::max(a, b));
      }
    }
  }
}

void MovingPairs::ask_for_wide(std::span<const Box> boxes) {
  if (wide_.empty()) {
    return;
  }
  index_.build(boxes);
  for (const std::uint32_t a : wide_) {
    index_.query(boxes[a], [&](std::uint32_t b) {
      // Two wide boxes find each other: the lower one reports.
      if (is_wide_[b] == 0 || a < b) {
        pairs_.emplace_back(std::min(a, b), std::max(a, b));
      }
    });
  }
}

std::span<const std::pair<std::uint32_t, std::uint32_t>> MovingPairs::find(
    std::span<const Box> boxes) {
  pairs_.clear();
  enter(boxes, choose_grid(boxes));
  sweep(boxes);
  ask_for_wide(boxes);
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

}  // namespace soms::detail
