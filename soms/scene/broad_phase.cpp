#include "soms/scene/broad_phase.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/scene/detail/box_index.h"
#include "soms/scene/detail/column_sweep.h"
#include "soms/scene/detail/float_box.h"
#include "soms/scene/detail/kept_memory.h"
#include "soms/scene/detail/pair_filter.h"
#include "soms/scene/detail/pair_rows.h"
#include "soms/scene/detail/rebuild_interval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace soms {

namespace {

using detail::FloatBox;

/// Boxes that left their larger boxes are compared one by one with all others as long as that costs
/// less than a part of rebuilding.
constexpr std::uint64_t kComparedForWork = 8;
/// Calls without a grid once the boxes did not suit one, at most.
constexpr std::uint32_t kMostCallsWithoutGrid = 64;
/// A larger box grows by no more than this many boxes.
constexpr float kMostGrowth = 2;
/// Sides above this, in widths of the set, do not count.
constexpr float kLongest = 1e30F;
/// More kept pairs a box than this, and the call starts from nothing.
constexpr std::size_t kMostKeptOfABox = 256;
/// Bytes that a call needs for each box, and for each kept pair, beside its grid.
constexpr std::size_t kBytesOfABox = 128;
constexpr std::size_t kBytesOfAPair = 32;
/// Growth to all sides, as a part of the way ahead.
constexpr float kAside = 0.25F;

/// As `overlaps`, without a branch: whether pairs that are near meet cannot be predicted.
bool meeting(const Box& a, const Box& b) {
  const auto at_most = [](double x, double y) { return static_cast<unsigned>(x <= y); };
  return (at_most(a.lower.x, b.upper.x) & at_most(b.lower.x, a.upper.x) &
          at_most(a.lower.y, b.upper.y) & at_most(b.lower.y, a.upper.y) &
          at_most(a.lower.z, b.upper.z) & at_most(b.lower.z, a.upper.z)) != 0;
}

/// Motion of both ends of a box in one call.
struct Motion {
  std::array<float, 3> lower{};
  std::array<float, 3> upper{};
  float farthest = 0;
};

Motion motion_of(const Box& from, const Box& to, double scale) {
  Motion motion;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    motion.lower[axis] = static_cast<float>((to.lower[axis] - from.lower[axis]) * scale);
    motion.upper[axis] = static_cast<float>((to.upper[axis] - from.upper[axis]) * scale);
    motion.farthest =
        std::max({motion.farthest, std::abs(motion.lower[axis]), std::abs(motion.upper[axis])});
  }
  return motion;
}

/// Nothing for a box beyond the range of floats, so that no sum of growth overflows.
float longest_side(const FloatBox& box) {
  const float side = std::max(
      {box.upper[0] - box.lower[0], box.upper[1] - box.lower[1], box.upper[2] - box.lower[2]});
  return side < kLongest ? side : 0;
}

/// `box` made larger for `calls` more calls of such ways, by at most `most`.
FloatBox grown(const FloatBox& box, const Motion& motion, float calls, float aside, float most) {
  // A way beyond the range of floats is endless, and no call of it is no number: no growth.
  const auto bounded = [most](float side) { return side > 0 ? std::min(side, most) : 0.0F; };
  FloatBox large = box;
  const float margin = aside * bounded(calls * motion.farthest);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    large.lower[axis] -= bounded(-calls * motion.lower[axis]) + margin;
    large.upper[axis] += bounded(calls * motion.upper[axis]) + margin;
  }
  return large;
}

}  // namespace

struct BroadPhase::State {
  detail::PairFilter filter;
  detail::FloatMap map;
  detail::ColumnSweep column_sweep;
  detail::BoxIndex index;
  detail::PairRows rows;  ///< pairs of `large`, or without a grid of the boxes themselves
  detail::RebuildInterval interval;
  bool has_grid = false;
  bool used_columns = false;             ///< in this call
  std::uint32_t calls_without_grid = 0;  ///< in a row, to come
  std::uint32_t next_without_grid = 1;
  float usual_side = 0;

  std::vector<Box> base;        ///< the boxes when all was rebuilt
  std::vector<FloatBox> large;  ///< hold their boxes as floats
  std::vector<std::uint32_t> escaped;
  std::vector<std::uint8_t> is_escaped;
  std::vector<std::uint64_t> pairs;  ///< scratch
  std::vector<BoxPair> answer;

  [[nodiscard]] bool keep(std::span<const Box> boxes);
  [[nodiscard]] bool catch_escaped(std::span<const Box> boxes);
  void rebuild(std::span<const Box> boxes);
  void take_as_they_are(std::span<const Box> boxes);
  bool enlarge(std::span<const Box> boxes);
  void ask_index(std::span<const Box> boxes);
  std::span<const BoxPair> decide(std::span<const Box> boxes);
  void give_back(std::size_t boxes);
};

/// \returns whether `rows` still hold all pairs, after some work if need be.
bool BroadPhase::State::keep(std::span<const Box> boxes) {
  if (!has_grid || base.size() != boxes.size()) {
    return false;
  }
  interval.pass();
  const std::uint64_t most = kComparedForWork * column_sweep.work() / (boxes.size() + 1) + 1;
  escaped.clear();
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    // All boxes hold an empty one, and `kNoBox` holds none but that.
    if (!detail::holds(large[k], map(boxes[k]))) {
      escaped.push_back(k);
      if (escaped.size() > most) {
        return false;
      }
    }
  }
  return escaped.empty() || catch_escaped(boxes);
}

/// Gives the escaped new large boxes, and `rows` their pairs. Should memory run short on the way,
/// the next call starts from nothing. \returns false if there would be too many pairs.
bool BroadPhase::State::catch_escaped(std::span<const Box> boxes) {
  has_grid = false;
  const auto age = static_cast<double>(interval.age());
  for (const std::uint32_t k : escaped) {
    const FloatBox now = map(boxes[k]);
    const Motion motion =
        motion_of(base[k].empty() ? boxes[k] : base[k], boxes[k], map.scale / age);
    large[k] = grown(now, motion, static_cast<float>(interval.calls()), 1,
                     kMostGrowth * (usual_side + longest_side(now)));
    base[k] = base[k].empty() ? boxes[k] : base[k];
    is_escaped[k] = 1;
  }
  pairs.clear();
  for (std::uint32_t a = 0; a < rows.rows(); ++a) {
    const auto row = rows.row(a);
    if (row.empty() || is_escaped[a] != 0) {
      continue;
    }
    for (const std::uint32_t b : row) {
      if (is_escaped[b] == 0) {
        pairs.push_back(std::uint64_t{a} << 32 | b);
      }
    }
  }
  for (const std::uint32_t a : escaped) {
    for (std::uint32_t b = 0; b < large.size(); ++b) {
      if (a != b && detail::meet(large[a], large[b]) && (a < b || is_escaped[b] == 0) &&
          !filter.leaves_out(std::min(a, b), std::max(a, b))) {
        pairs.push_back(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b));
      }
    }
    if (pairs.size() > kMostKeptOfABox * (boxes.size() + 64)) {
      return false;
    }
  }
  for (const std::uint32_t k : escaped) {
    is_escaped[k] = 0;
  }
  rows.assign(boxes.size(), pairs);
  interval.spend(escaped.size() * boxes.size() / 25 + rows.size() / 5);
  has_grid = true;
  return true;
}

void BroadPhase::State::take_as_they_are(std::span<const Box> boxes) {
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    large[k] = boxes[k].empty() ? detail::kNoBox : map(boxes[k]);
  }
}

/// Larger boxes for all, each along the motion of its box since all was rebuilt. \returns
/// false if all are as they are.
bool BroadPhase::State::enlarge(std::span<const Box> boxes) {
  const bool knows_motions = base.size() == boxes.size() && interval.age() > 0;
  const double scale = map.scale / static_cast<double>(std::max<std::uint64_t>(1, interval.age()));
  large.resize(boxes.size());
  is_escaped.assign(boxes.size(), 0);
  take_as_they_are(boxes);
  double sides = 0;
  double speeds = 0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (!boxes[k].empty()) {
      sides += static_cast<double>(longest_side(large[k]));
      if (knows_motions && !base[k].empty()) {
        speeds += static_cast<double>(motion_of(base[k], boxes[k], scale).farthest);
      }
    }
  }
  const double count = std::max(1.0, static_cast<double>(boxes.size()));
  usual_side = static_cast<float>(sides / count);
  const std::uint32_t calls = knows_motions ? interval.next(speeds / count) : 0;
  for (std::size_t k = 0; k < boxes.size() && calls > 0; ++k) {
    if (!boxes[k].empty() && !base[k].empty()) {
      large[k] = grown(large[k], motion_of(base[k], boxes[k], scale), static_cast<float>(calls),
                       kAside, kMostGrowth * (usual_side + longest_side(large[k])));
    }
  }
  return calls > 0;
}

void BroadPhase::State::rebuild(std::span<const Box> boxes) {
  has_grid = false;
  if (calls_without_grid > 0) {
    --calls_without_grid;
    ask_index(boxes);
    return;
  }
  map = detail::FloatMap::of(boxes);
  const bool enlarged = enlarge(boxes);
  used_columns = true;
  auto found = column_sweep.find(large, filter);
  if (!found && enlarged) {
    interval.look_less_far();
    take_as_they_are(boxes);
    found = column_sweep.find(large, filter);
  }
  base.assign(boxes.begin(), boxes.end());
  if (found) {
    next_without_grid = 1;
    rows.assign(boxes.size(), *found);
    interval.start(column_sweep.work(), rows.size());
    has_grid = true;
    return;
  }
  calls_without_grid = next_without_grid;
  next_without_grid = std::min(2 * next_without_grid, kMostCallsWithoutGrid);
  interval = {};
  ask_index(boxes);
}

/// The pairs of the boxes themselves, wherever they lie and however large they are.
void BroadPhase::State::ask_index(std::span<const Box> boxes) {
  index.build(boxes, filter.groups());
  pairs.clear();
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    if (boxes[a].empty()) {
      continue;
    }
    const auto found = [&](std::uint32_t b) {
      if (a < b && !filter.ignores(a, b)) {
        pairs.push_back(std::uint64_t{a} << 32 | b);
      }
    };
    if (filter.groups().empty()) {
      index.query(boxes[a], found);
    } else {
      index.query(boxes[a], filter.group(a), found);
    }
  }
  rows.assign(boxes.size(), pairs);
}

/// Those pairs of `rows` that do meet.
std::span<const BoxPair> BroadPhase::State::decide(std::span<const Box> boxes) {
  if (answer.size() <= rows.size()) {
    answer.resize(rows.size() + 1);
  }
  std::size_t found = 0;
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    const Box& box = boxes[a];
    for (const std::uint32_t b : rows.row(a)) {
      answer[found] = {a, b};
      found += meeting(box, boxes[b]) ? 1U : 0U;
    }
  }
  give_back(boxes.size());
  return std::span(answer).first(found);
}

/// What earlier calls needed and this one, of so many boxes, does not.
void BroadPhase::State::give_back(std::size_t boxes) {
  const std::size_t needed = kBytesOfABox * boxes + kBytesOfAPair * rows.size();
  if (used_columns) {
    column_sweep.give_back();
  } else if (detail::is_far_above(column_sweep.memory(), needed)) {
    column_sweep = {};
  }
  if (detail::is_far_above(index.memory(), needed)) {
    index = {};
  }
  if (detail::is_far_above(detail::bytes(pairs), needed)) {
    detail::release(pairs);
  }
  rows.give_back();
  detail::give_back(base);
  detail::give_back(large);
  detail::give_back(escaped);
  detail::give_back(is_escaped);
  detail::give_back(answer, rows.size() + 1);
}

BroadPhase::BroadPhase() : state_(std::make_unique<State>()) {
}

BroadPhase::~BroadPhase() = default;
BroadPhase::BroadPhase(BroadPhase&&) noexcept = default;
BroadPhase& BroadPhase::operator=(BroadPhase&&) noexcept = default;

std::span<const BoxPair> BroadPhase::find(std::span<const Box> boxes) {
  const PlainArithmetic plain;
  if (boxes.size() > detail::ColumnSweep::kMostBoxes) {
    throw Error(ErrorKind::out_of_range,
                "broad phase: " + std::to_string(boxes.size()) + " boxes are above 2^27",
                "use fewer boxes at a time");
  }
  state_->used_columns = false;
  if (!state_->keep(boxes)) {
    state_->rebuild(boxes);
  }
  return state_->decide(boxes);
}

void BroadPhase::set_filter(std::vector<std::uint32_t> groups, std::span<const BoxPair> ignored) {
  for (const auto& [a, b] : ignored) {
    if (std::max(a, b) >= detail::ColumnSweep::kMostBoxes) {
      throw Error(ErrorKind::out_of_range,
                  "broad phase: ignored pair (" + std::to_string(a) + ", " + std::to_string(b) +
                      ") names a box of 2^27 or more",
                  "name boxes by their place among those that are passed to find");
    }
  }
  state_->filter = detail::PairFilter(std::move(groups), ignored);
  state_->has_grid = false;
}

void BroadPhase::forget() {
  state_->has_grid = false;
  state_->base.clear();
}

std::size_t BroadPhase::memory() const {
  const State& state = *state_;
  return sizeof(State) + state.filter.memory() + state.column_sweep.memory() +
         state.index.memory() + state.rows.memory() + detail::bytes(state.base) +
         detail::bytes(state.large) + detail::bytes(state.escaped) +
         detail::bytes(state.is_escaped) + detail::bytes(state.pairs) + detail::bytes(state.answer);
}

}  // namespace soms
