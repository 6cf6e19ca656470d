#include "soms/scene/detail/column_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace soms::detail {

namespace {

using Floats [[gnu::vector_size(16)]] = float;
using Masks [[gnu::vector_size(16)]] = std::int32_t;

[[nodiscard]] Floats four(float x) {
  return Floats{x, x, x, x};
}

[[nodiscard]] Floats load(const float* from) {
  Floats v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

/// Bit k is set where lane k is.
[[nodiscard]] std::uint32_t bits_of(Masks masks) {
#if defined(__SSE2__)
  __m128 lanes;
  std::memcpy(&lanes, &masks, sizeof lanes);
  return static_cast<std::uint32_t>(_mm_movemask_ps(lanes));
#else
  std::uint32_t bits = 0;
  for (unsigned k = 0; k < 4; ++k) {
    bits |= static_cast<std::uint32_t>(masks[k] != 0) << k;
  }
  return bits;
#endif
}

constexpr std::size_t kSample = 128;
constexpr double kMostCells = 512;  // along one axis
constexpr double kMostColumns = 1 << 14;
constexpr std::uint32_t kSteps = 1U << 16;
constexpr unsigned kDigit = 11;
constexpr std::uint32_t kNames = (1U << 30) - 1;
/// Bytes of an entry in what the sweep reads: key, last key, name, four ends, group.
constexpr std::size_t kSweepBytes = 8 * sizeof(float);

// Costs that choose the width of columns, in nanoseconds: an entry, and a comparison.
constexpr double kEntryCost = 15;
constexpr double kCompareCost = 0.6;

/// More comparisons or pairs a box than this, and the boxes do not suit a grid.
constexpr std::uint64_t kMostComparedOfABox = 256;
constexpr std::uint64_t kMostEnteredOfABox = 16;
constexpr std::uint64_t kMostPairsOfABox = 128;

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
  FloatBox all = kNoBox;
  for (const FloatBox& box : boxes) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      all.lower[lane] = std::min(all.lower[lane], box.lower[lane]);
      all.upper[lane] = std::max(all.upper[lane], box.upper[lane]);
    }
  }
  for (std::size_t axis = 0; axis < 3 && !lower[0].empty(); ++axis) {
    spreads[axis] = spread_of(lower[axis], upper[axis], static_cast<double>(all.lower[axis]),
                              static_cast<double>(all.upper[axis]));
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

std::uint32_t ColumnSweep::Cells::at(float value) const {
  const float position = (value - origin) * scale;
  return position > 0
             ? static_cast<std::uint32_t>(std::min(position, static_cast<float>(count - 1)))
             : 0;
}

/// Chooses the grid. \returns false if there is no finite one.
bool ColumnSweep::lay_grid(std::span<const FloatBox> boxes) {
  std::array<Spread, 3> spreads;
  if (!measure(boxes, spreads)) {
    return false;
  }
  // The sweep runs where most boxes lie side by side.
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
    return spreads[a].boxes() > spreads[b].boxes();
  });
  spreads = {spreads[axes[0]], spreads[axes[1]], spreads[axes[2]]};
  const auto cells = [&](std::size_t k, double number) {
    const double scale = spreads[k].length > 0 ? number / spreads[k].length : 0;
    const double most = static_cast<double>(std::numeric_limits<float>::max());
    return Cells{axes[k], static_cast<float>(spreads[k].lower),
                 static_cast<float>(std::min(scale, most)), static_cast<std::uint32_t>(number)};
  };
  const auto [y, z] = best_cells(spreads, static_cast<double>(boxes.size()));
  along_ = cells(0, kSteps);
  across_ = cells(1, y);
  upward_ = cells(2, z);
  return true;
}

/// \returns false if there would be too many entries.
bool ColumnSweep::enter(std::span<const FloatBox> boxes) {
  const std::size_t most_of_a_box = std::max<std::size_t>(16, boxes.size() / 32);
  const std::size_t most = kMostEnteredOfABox * boxes.size();
  std::size_t size = 0;
  wide_.clear();
  for (std::uint32_t k = 0; k < boxes.size() && size <= most; ++k) {
    const FloatBox& box = boxes[k];
    if (!(box.lower[0] <= box.upper[0])) {
      continue;
    }
    const std::uint32_t y0 = across_.at(box.lower[across_.axis]);
    const std::uint32_t y1 = across_.at(box.upper[across_.axis]);
    const std::uint32_t z0 = upward_.at(box.lower[upward_.axis]);
    const std::uint32_t z1 = upward_.at(box.upper[upward_.axis]);
    const std::size_t columns = std::size_t{y1 - y0 + 1} * (z1 - z0 + 1);
    if (columns > most_of_a_box) {
      wide_.push_back(k);
      continue;
    }
    if (size + columns > entries_.size()) {
      entries_.resize(2 * (size + columns) + boxes.size());
    }
    const std::uint32_t start = along_.at(box.lower[along_.axis]);
    for (std::uint32_t z = z0; z <= z1; ++z) {
      const std::uint32_t row = static_cast<std::uint32_t>(z == z0) << 31 | k;
      for (std::uint32_t y = y0; y <= y1; ++y) {
        const std::uint32_t key = (z * across_.count + y) << 16 | start;
        entries_[size++] =
            std::uint64_t{key} << 32 | row | static_cast<std::uint32_t>(y == y0) << 30;
      }
    }
  }
  entered_ = size;
  return size <= most;
}

/// By key, from the least digit to the greatest; all digits are counted in one go.
void ColumnSweep::sort() {
  const std::uint32_t most = (across_.count * upward_.count) << 16;
  unsigned digits = 1;
  while (digits < 3 && (most >> (digits * kDigit)) != 0) {
    ++digits;
  }
  const auto digit_of = [](std::uint64_t entry, unsigned digit) {
    return (entry >> (32 + digit * kDigit)) & ((1U << kDigit) - 1);
  };
  std::array<std::array<std::uint32_t, std::size_t{1} << kDigit>, 3> places{};
  for (std::size_t k = 0; k < entered_; ++k) {
    for (unsigned digit = 0; digit < digits; ++digit) {
      ++places[digit][digit_of(entries_[k], digit)];
    }
  }
  if (scratch_.size() < entries_.size()) {
    scratch_.resize(entries_.size());
  }
  for (unsigned digit = 0; digit < digits; ++digit) {
    std::uint32_t place = 0;
    for (std::uint32_t& count : places[digit]) {
      place += std::exchange(count, place);
    }
    for (std::size_t k = 0; k < entered_; ++k) {
      scratch_[places[digit][digit_of(entries_[k], digit)]++] = entries_[k];
    }
    std::swap(entries_, scratch_);
  }
}

/// Lays out what the sweep reads, in its order; a block behind the end stops it.
void ColumnSweep::arrange(std::span<const FloatBox> boxes) {
  const std::size_t size = entered_ + 4;
  if (keys_.size() < size) {
    last_keys_.resize(size);
    names_.resize(size);
    for (std::vector<float>& end : ends_) {
      end.resize(size);
    }
    keys_.resize(size);  // last: its size tells the others', also where memory runs short
  }
  for (std::size_t k = 0; k < entered_; ++k) {
    const auto key = static_cast<std::uint32_t>(entries_[k] >> 32);
    names_[k] = static_cast<std::uint32_t>(entries_[k]);
    const FloatBox& box = boxes[names_[k] & kNames];
    keys_[k] = static_cast<std::int32_t>(key);
    last_keys_[k] =
        static_cast<std::int32_t>((key & ~(kSteps - 1)) | along_.at(box.upper[along_.axis]));
    ends_[0][k] = box.lower[across_.axis];
    ends_[1][k] = box.upper[across_.axis];
    ends_[2][k] = box.lower[upward_.axis];
    ends_[3][k] = box.upper[upward_.axis];
  }
  std::fill_n(keys_.begin() + static_cast<std::ptrdiff_t>(entered_), 4,
              std::numeric_limits<std::int32_t>::max());
}

/// The groups of the entries, in the order of the sweep.
void ColumnSweep::arrange_groups(const PairFilter& filter) {
  if (groups_.size() < keys_.size()) {
    groups_.resize(keys_.size());
  }
  for (std::size_t k = 0; k < entered_; ++k) {
    groups_[k] = static_cast<std::int32_t>(filter.group(names_[k] & kNames));
  }
}

inline void ColumnSweep::report(std::uint32_t a, std::uint32_t b) {
  if (found_ == pairs_.size()) {
    pairs_.resize(2 * pairs_.size() + 1024);
  }
  pairs_[found_++] = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

template <bool kFiltered>
bool ColumnSweep::sweep(const PairFilter& filter) {
  const std::uint64_t most_pairs = kMostPairsOfABox * most_compared_ / kMostComparedOfABox;
  for (std::size_t k = 0; k < entered_; ++k) {
    const std::int32_t last = last_keys_[k];
    if (keys_[k + 1] > last) {
      continue;
    }
    const Masks lasts{last, last, last, last};
    const Floats lower_across = four(ends_[0][k]);
    const Floats upper_across = four(ends_[1][k]);
    const Floats lower_upward = four(ends_[2][k]);
    const Floats upper_upward = four(ends_[3][k]);
    const std::uint32_t name = names_[k];
    const std::int32_t group = kFiltered ? groups_[k] : 0;
    const Masks groups{group, group, group, group};
    std::size_t j = k + 1;
    for (; keys_[j] <= last; j += 4) {
      Masks keys;
      std::memcpy(&keys, &keys_[j], sizeof keys);
      Masks meeting = (keys <= lasts) & (load(&ends_[0][j]) <= upper_across) &
                      (lower_across <= load(&ends_[1][j])) & (load(&ends_[2][j]) <= upper_upward) &
                      (lower_upward <= load(&ends_[3][j]));
      if (kFiltered && group != 0) {
        Masks others;
        std::memcpy(&others, &groups_[j], sizeof others);
        meeting &= others != groups;
      }
      for (std::uint32_t lanes = bits_of(meeting); lanes != 0; lanes &= lanes - 1) {
        const std::uint32_t other = names_[j + static_cast<std::uint32_t>(__builtin_ctz(lanes))];
        // The overlap begins in this column if one of the two begins here, along either axis.
        if (((name | other) >> 30) == 3) {
          const std::uint32_t a = name & kNames;
          const std::uint32_t b = other & kNames;
          if (!kFiltered || !filter.ignores(std::min(a, b), std::max(a, b))) {
            report(a, b);
          }
        }
      }
    }
    compared_ += j - k;
    if (compared_ > most_compared_ || found_ > most_pairs) {
      return false;
    }
  }
  return true;
}

bool ColumnSweep::compare_wide(std::span<const FloatBox> boxes, const PairFilter& filter) {
  compared_ += wide_.size() * boxes.size();
  if (compared_ > most_compared_) {
    return false;
  }
  for (const std::uint32_t a : wide_) {
    auto next = wide_.begin();
    for (std::uint32_t b = 0; b < boxes.size(); ++b) {
      const bool both = next != wide_.end() && *next == b;
      next += both ? 1 : 0;
      // Two wide boxes find each other: the lower one reports.
      if ((!both || a < b) && meet(boxes[a], boxes[b]) &&
          !filter.leaves_out(std::min(a, b), std::max(a, b))) {
        report(a, b);
      }
    }
  }
  return true;
}

std::optional<std::span<const std::uint64_t>> ColumnSweep::find(std::span<const FloatBox> boxes,
                                                                const PairFilter& filter) {
  entered_ = 0;
  compared_ = 0;
  found_ = 0;
  most_compared_ = kMostComparedOfABox * (boxes.size() + 64);
  if (boxes.size() < 2) {
    return std::span<const std::uint64_t>();
  }
  if (!lay_grid(boxes) || !enter(boxes)) {
    return std::nullopt;
  }
  sort();
  arrange(boxes);
  if (!filter.empty()) {
    arrange_groups(filter);
  }
  if (!(filter.empty() ? sweep<false>(filter) : sweep<true>(filter)) ||
      !compare_wide(boxes, filter)) {
    found_ = 0;
    return std::nullopt;
  }
  return std::span(pairs_).first(found_);
}

void ColumnSweep::give_back() {
  detail::give_back(entries_, std::min(entered_, entries_.size()));
  detail::give_back(scratch_, std::min(entered_, scratch_.size()));
  detail::give_back(wide_);
  detail::give_back(pairs_, found_);
  // These have one size, which tells how many entries there is room for.
  if (is_far_above(memory_of_sweep(), (entered_ + 4) * kSweepBytes)) {
    release(keys_);
    release(last_keys_);
    release(names_);
    release(groups_);
    for (std::vector<float>& end : ends_) {
      release(end);
    }
  }
}

std::size_t ColumnSweep::memory() const {
  return bytes(entries_) + bytes(scratch_) + bytes(wide_) + bytes(pairs_) + memory_of_sweep();
}

std::size_t ColumnSweep::memory_of_sweep() const {
  std::size_t size = bytes(keys_) + bytes(last_keys_) + bytes(names_) + bytes(groups_);
  for (const std::vector<float>& end : ends_) {
    size += bytes(end);
  }
  return size;
}

}  // namespace soms::detail
