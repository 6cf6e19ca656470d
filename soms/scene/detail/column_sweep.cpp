#include "soms/scene/detail/column_sweep.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace soms::detail {

namespace {

constexpr unsigned kDigit = 11;
/// Fewer entries than this are sorted by comparing.
constexpr std::size_t kLeastByDigits = 512;
/// Bytes of an entry in what the sweep reads: key, last key, name, four ends, group.
constexpr std::size_t kSweepBytes = 8 * sizeof(float);

/// More comparisons or pairs a box than this, and the boxes do not suit a grid.
constexpr std::uint64_t kMostComparedOfABox = 256;
constexpr std::uint64_t kMostEnteredOfABox = 16;
constexpr std::uint64_t kMostPairsOfABox = 128;

/// How many entries ahead their boxes are fetched.
constexpr std::size_t kFetched = 16;

}  // namespace

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
    const auto lower = grid_.at(box.lower);
    const auto upper = grid_.at(box.upper);
    const std::uint32_t y0 = lower[grid_.across];
    const std::uint32_t y1 = upper[grid_.across];
    const std::uint32_t z0 = lower[grid_.upward];
    const std::uint32_t z1 = upper[grid_.upward];
    const std::size_t columns = std::size_t{y1 - y0 + 1} * (z1 - z0 + 1);
    if (columns > most_of_a_box) {
      wide_.push_back(k);
      continue;
    }
    if (size + columns > entries_.size()) {
      entries_.resize(2 * (size + columns) + boxes.size());
    }
    const std::uint32_t start = lower[grid_.along];
    for (std::uint32_t z = z0; z <= z1; ++z) {
      const std::uint32_t row = static_cast<std::uint32_t>(z == z0) << 31 | k;
      for (std::uint32_t y = y0; y <= y1; ++y) {
        const std::uint32_t key = (z * grid_.columns_across + y) << 16 | start;
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
  if (entered_ < kLeastByDigits) {
    std::sort(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(entered_));
    return;
  }
  const std::uint32_t most = grid_.columns << 16;
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
  const std::size_t size = entered_ + kSweepLanes;
  if (keys_.size() < size) {
    last_keys_.resize(size);
    names_.resize(size);
    for (std::vector<float>& end : ends_) {
      end.resize(size);
    }
    keys_.resize(size);  // last: its size tells the others', also where memory runs short
  }
  for (std::size_t k = 0; k < entered_; ++k) {
    __builtin_prefetch(&boxes[entries_[std::min(k + kFetched, entered_ - 1)] & kNames]);
    const auto key = static_cast<std::uint32_t>(entries_[k] >> 32);
    names_[k] = static_cast<std::uint32_t>(entries_[k]);
    const FloatBox& box = boxes[names_[k] & kNames];
    keys_[k] = static_cast<std::int32_t>(key);
    last_keys_[k] = static_cast<std::int32_t>((key & ~(ColumnGrid::kSteps - 1)) |
                                              grid_.at(box.upper)[grid_.along]);
    ends_[0][k] = box.lower[grid_.across];
    ends_[1][k] = box.upper[grid_.across];
    ends_[2][k] = box.lower[grid_.upward];
    ends_[3][k] = box.upper[grid_.upward];
  }
  std::fill_n(keys_.begin() + static_cast<std::ptrdiff_t>(entered_), kSweepLanes,
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

/// Takes out of the pairs from `begin` on those that `filter` names. \returns how many remain.
std::size_t ColumnSweep::without_ignored(std::size_t begin, std::size_t end,
                                         const PairFilter& filter) {
  std::size_t remaining = begin;
  for (std::size_t k = begin; k < end; ++k) {
    const std::uint64_t pair = pairs_[k] & ~kOpenPair;
    pairs_[remaining] = pairs_[k];
    remaining +=
        filter.ignores(static_cast<std::uint32_t>(pair >> 32), static_cast<std::uint32_t>(pair))
            ? 0U
            : 1U;
  }
  return remaining;
}

bool ColumnSweep::sweep(const PairFilter& filter) {
  const std::uint64_t most_pairs = kMostPairsOfABox * most_compared_ / kMostComparedOfABox;
  const SweepEntries entries{keys_.data(),
                             last_keys_.data(),
                             names_.data(),
                             {ends_[0].data(), ends_[1].data(), ends_[2].data(), ends_[3].data()},
                             filter.groups().empty() ? nullptr : groups_.data(),
                             entered_};
  const SweepKernel kernel = kernel_ != nullptr ? kernel_ : sweep_kernel();
  SweepPlace place;
  while (place.entry < entered_) {
    if (pairs_.size() - place.found < kSweepLanes) {
      pairs_.resize(2 * pairs_.size() + 1024);
    }
    const std::size_t before = place.found;
    kernel(entries, pairs_.data(), pairs_.size(), most_compared_, place);
    if (filter.ignores_any()) {
      place.found = without_ignored(before, place.found, filter);
    }
    compared_ = place.compared;
    found_ = place.found;
    if (compared_ > most_compared_ || found_ > most_pairs) {
      return false;
    }
  }
  return true;
}

inline void ColumnSweep::report(std::uint32_t a, std::uint32_t b) {
  if (found_ == pairs_.size()) {
    pairs_.resize(2 * pairs_.size() + 1024);
  }
  pairs_[found_++] = kOpenPair | std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
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

std::optional<std::span<std::uint64_t>> ColumnSweep::find(std::span<const FloatBox> boxes,
                                                          const PairFilter& filter) {
  entered_ = 0;
  compared_ = 0;
  found_ = 0;
  most_compared_ = kMostComparedOfABox * (boxes.size() + 64);
  if (boxes.size() < 2) {
    return std::span<std::uint64_t>();
  }
  const auto grid = ColumnGrid::of(boxes);
  if (!grid) {
    return std::nullopt;
  }
  grid_ = *grid;
  if (!enter(boxes)) {
    return std::nullopt;
  }
  sort();
  arrange(boxes);
  if (!filter.groups().empty()) {
    arrange_groups(filter);
  }
  if (!sweep(filter) || !compare_wide(boxes, filter)) {
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
  if (is_far_above(memory_of_sweep(), (entered_ + kSweepLanes) * kSweepBytes)) {
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
