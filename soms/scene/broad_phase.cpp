#include "soms/scene/broad_phase.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/scene/detail/box_index.h"
#include "soms/scene/detail/column_sweep.h"
#include "soms/scene/detail/float_box.h"
#include "soms/scene/detail/kept_memory.h"
#include "soms/scene/detail/larger_box.h"
#include "soms/scene/detail/pair_filter.h"
#include "soms/scene/detail/pair_order.h"
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
/// More kept pairs a box than this, and the call starts from nothing.
constexpr std::size_t kMostKeptOfABox = 256;
/// Bytes that a call needs for each box, and for each kept pair, beside its grid.
constexpr std::size_t kBytesOfABox = 128;
constexpr std::size_t kBytesOfAPair = 32;
/// Of so many boxes or fewer all pairs are compared: that costs less than to keep anything.
constexpr std::size_t kFewBoxes = 20;
/// Calls of few boxes that share a map to floats.
constexpr std::uint32_t kCallsOfAMap = 64;
/// Boxes by which jumps are noticed.
constexpr std::size_t kMarks = 32;
/// How many pairs ahead a box is fetched.
constexpr std::size_t kFetchedPairs = 16;

/// Room for the pairs of boxes of which all pairs are compared.
std::size_t few_pairs(std::size_t boxes) {
  return boxes <= kFewBoxes ? boxes * boxes / 2 + 1 : 0;
}

std::uint32_t first_of(std::uint64_t pair) {
  return static_cast<std::uint32_t>((pair & ~detail::kOpenPair) >> 32);
}

std::uint32_t second_of(std::uint64_t pair) {
  return static_cast<std::uint32_t>(pair);
}

/// Adds pairs to others, both in order, from the last to the first, so that no more memory is
/// needed than for the answer.
void merge_into(std::vector<std::uint64_t>& pairs, const std::vector<std::uint64_t>& others) {
  std::size_t own = pairs.size();
  pairs.resize(own + others.size());
  std::size_t to = pairs.size();
  for (std::size_t other = others.size(); other > 0;) {
    const bool takes_own =
        own > 0 && (pairs[own - 1] & ~detail::kOpenPair) > (others[other - 1] & ~detail::kOpenPair);
    pairs[--to] = takes_own ? pairs[--own] : others[--other];
  }
}

}  // namespace

struct BroadPhase::State {
  detail::PairFilter filter;
  detail::FloatMap map;
  detail::ColumnSweep column_sweep;
  detail::BoxIndex index;
  detail::RebuildInterval interval;
  bool has_grid = false;
  bool used_columns = false;             ///< in this call
  bool is_enlarged = false;              ///< `large`, by motion
  std::uint32_t calls_without_grid = 0;  ///< in a row, to come
  std::uint32_t next_without_grid = 1;
  detail::Growth growth;  ///< of `large`

  std::uint32_t calls_of_few = 0;  ///< with this map
  std::size_t placed = 0;          ///< boxes of `now` that are those of this call
  std::vector<FloatBox> now;       ///< the boxes as floats
  std::vector<FloatBox> base;      ///< the boxes when all was rebuilt, by the same map
  std::vector<FloatBox> large;     ///< hold those of `now`
  std::vector<Vec3> marks;         ///< ends of some boxes in the last call
  std::vector<std::uint32_t> escaped;
  std::vector<std::uint8_t> is_escaped;
  std::vector<std::uint64_t> kept;   ///< pairs of `large`, or of the boxes themselves, in order
  std::vector<std::uint64_t> pairs;  ///< scratch
  std::vector<BoxPair> answer;

  [[nodiscard]] bool keep(std::span<const Box> boxes);
  [[nodiscard]] bool catch_escaped();
  void rebuild(std::span<const Box> boxes);
  std::span<const BoxPair> compare_few(std::span<const Box> boxes);
  void place(std::span<const Box> boxes);
  void set_marks(std::span<const Box> boxes);
  [[nodiscard]] double way_of_marks(std::span<const Box> boxes) const;
  void enlarge(std::span<const Box> boxes);
  void ask_index(std::span<const Box> boxes);
  std::span<const BoxPair> decide(std::span<const Box> boxes);
  std::size_t decide_kept(std::span<const Box> boxes);
  std::size_t decide_open(std::span<const Box> boxes);
  void give_back(std::size_t boxes);
};

/// \returns whether `kept` still holds all pairs, after some work if need be.
bool BroadPhase::State::keep(std::span<const Box> boxes) {
  placed = 0;
  if (!has_grid || large.size() != boxes.size()) {
    return false;
  }
  interval.pass();
  is_enlarged = true;  // boxes may have moved inside
  const std::uint64_t most = kComparedForWork * column_sweep.work() / (boxes.size() + 1) + 1;
  escaped.clear();
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    now[k] = map(boxes[k]);
    // All boxes hold an empty one, and `kNoBox` holds none but that.
    if (!detail::holds(large[k], now[k])) {
      escaped.push_back(k);
      if (escaped.size() > most) {
        placed = k;
        return false;
      }
    }
  }
  placed = boxes.size();
  return escaped.empty() || catch_escaped();
}

/// Gives the escaped new large boxes, and `kept` their pairs. Should memory run short on the way,
/// the next call starts from nothing. \returns false if there would be too many pairs.
bool BroadPhase::State::catch_escaped() {
  has_grid = false;
  growth.known_calls = interval.age();
  for (const std::uint32_t k : escaped) {
    large[k] = detail::larger_box(base[k], now[k], growth);
    base[k] = base[k].lower[0] <= base[k].upper[0] ? base[k] : now[k];
    is_escaped[k] = 1;
  }
  const auto remaining = std::remove_if(kept.begin(), kept.end(), [&](std::uint64_t pair) {
    return (is_escaped[first_of(pair)] | is_escaped[second_of(pair)]) != 0;
  });
  kept.erase(remaining, kept.end());
  pairs.clear();
  for (const std::uint32_t a : escaped) {
    for (std::uint32_t b = 0; b < large.size(); ++b) {
      if (a != b && detail::meet(large[a], large[b]) && (a < b || is_escaped[b] == 0) &&
          !filter.leaves_out(std::min(a, b), std::max(a, b))) {
        pairs.push_back(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b));
      }
    }
    if (kept.size() + pairs.size() > kMostKeptOfABox * (large.size() + 64)) {
      return false;
    }
  }
  for (const std::uint32_t k : escaped) {
    is_escaped[k] = 0;
  }
  std::sort(pairs.begin(), pairs.end());
  merge_into(kept, pairs);
  has_grid = true;
  return true;
}

/// The boxes as floats, from the first on that is not there yet.
void BroadPhase::State::place(std::span<const Box> boxes) {
  now.resize(boxes.size());
  for (std::size_t k = placed; k < boxes.size(); ++k) {
    now[k] = map(boxes[k]);
  }
  placed = boxes.size();
}

void BroadPhase::State::set_marks(std::span<const Box> boxes) {
  marks.clear();
  for (std::size_t k = 0; k < boxes.size(); k += boxes.size() / kMarks + 1) {
    marks.push_back(boxes[k].lower);
  }
}

/// How far the middle one of the marks moved in this call.
double BroadPhase::State::way_of_marks(std::span<const Box> boxes) const {
  std::array<double, kMarks> ways{};
  std::size_t count = 0;
  for (std::size_t k = 0; count < marks.size() && k < boxes.size();
       k += boxes.size() / kMarks + 1, ++count) {
    const Vec3 way = boxes[k].lower - marks[count];
    ways[count] = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
    ways[count] = std::isfinite(ways[count]) ? ways[count] : 0;
  }
  const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(ways.begin(), middle, ways.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

/// Larger boxes for all, each along the motion of its box since all was rebuilt.
void BroadPhase::State::enlarge(std::span<const Box> boxes) {
  growth = {std::max<std::uint64_t>(1, interval.age()), 0, {}};
  growth.usual = detail::usual_motion(base, now, growth.known_calls);
  if (base.size() == boxes.size() && interval.age() > 0) {
    growth.calls = interval.next({static_cast<double>(growth.usual.way),
                                  way_of_marks(boxes) * map.scale, growth.usual.growth});
  }
  is_enlarged = growth.calls > 0;
  if (is_enlarged) {
    detail::make_larger(base, now, growth, large);
  } else {
    large = now;
  }
}

void BroadPhase::State::rebuild(std::span<const Box> boxes) {
  has_grid = false;
  is_enlarged = false;
  if (calls_without_grid > 0) {
    --calls_without_grid;
    ask_index(boxes);
    return;
  }
  const detail::FloatMap best = detail::FloatMap::of(boxes);
  if (!map.serves(best)) {
    map = best;
    placed = 0;
    base.clear();
  }
  place(boxes);
  enlarge(boxes);
  is_escaped.assign(boxes.size(), 0);
  used_columns = true;
  auto found = column_sweep.find(large, filter);
  if (!found && is_enlarged) {
    interval.look_less_far();
    is_enlarged = false;
    large = now;
    found = column_sweep.find(large, filter);
  }
  if (is_enlarged) {
    base = now;
  } else {
    base.swap(now);  // open pairs are decided by the boxes
    now.resize(boxes.size());
  }
  if (found) {
    next_without_grid = 1;
    interval.start(column_sweep.work(), found->size());
    detail::sort_box_pairs(*found, boxes.size(), kept);
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
  detail::sort_box_pairs(pairs, boxes.size(), kept);
}

/// Pairs of larger boxes: by the boxes as floats, and where ends coincide by the boxes.
std::size_t BroadPhase::State::decide_kept(std::span<const Box> boxes) {
  std::size_t found = 0;
  const std::size_t last = kept.empty() ? 0 : kept.size() - 1;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    __builtin_prefetch(&now[second_of(kept[std::min(k + kFetchedPairs, last)])]);
    const BoxPair pair{first_of(kept[k]), second_of(kept[k])};
    const detail::FloatVerdict verdict = detail::compare(now[pair.first], now[pair.second]);
    bool meet = verdict.sure;
    if (verdict.meet != verdict.sure) {
      meet = overlaps(boxes[pair.first], boxes[pair.second]);
    }
    answer[found] = pair;
    found += meet ? 1U : 0U;
  }
  return found;
}

/// Pairs of the boxes themselves, of which few are open.
std::size_t BroadPhase::State::decide_open(std::span<const Box> boxes) {
  std::size_t found = 0;
  for (const std::uint64_t pair : kept) {
    const BoxPair names{first_of(pair), second_of(pair)};
    answer[found] = names;
    if ((pair & detail::kOpenPair) == 0 || overlaps(boxes[names.first], boxes[names.second])) {
      ++found;
    }
  }
  return found;
}

/// Those pairs of `kept` that do meet.
std::span<const BoxPair> BroadPhase::State::decide(std::span<const Box> boxes) {
  if (answer.size() <= kept.size()) {
    answer.resize(kept.size() + 1);
  }
  const std::size_t found = is_enlarged ? decide_kept(boxes) : decide_open(boxes);
  interval.find(found);
  set_marks(boxes);
  give_back(boxes.size());
  return std::span(answer).first(found);
}

/// All pairs of a few boxes. Any map is right, and a good one leaves few pairs open.
std::span<const BoxPair> BroadPhase::State::compare_few(std::span<const Box> boxes) {
  has_grid = false;
  base.clear();
  kept.clear();
  if (now.size() != boxes.size() || calls_of_few++ % kCallsOfAMap == 0) {
    map = detail::FloatMap::of(boxes);
  }
  placed = 0;
  place(boxes);
  answer.resize(std::max(answer.size(), few_pairs(boxes.size())));
  std::size_t found = 0;
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
      const detail::FloatVerdict verdict = detail::compare(now[a], now[b]);
      bool meet = verdict.sure;
      if (verdict.meet != verdict.sure) {
        meet = overlaps(boxes[a], boxes[b]);
      }
      answer[found] = {a, b};
      found += meet ? 1U : 0U;
    }
  }
  if (!filter.empty()) {
    const auto end = answer.begin() + static_cast<std::ptrdiff_t>(found);
    const auto left = std::remove_if(answer.begin(), end, [&](const BoxPair& pair) {
      return filter.leaves_out(pair.first, pair.second);
    });
    found = static_cast<std::size_t>(left - answer.begin());
  }
  give_back(boxes.size());
  return std::span(answer).first(found);
}

/// What earlier calls needed and this one, of so many boxes, does not.
void BroadPhase::State::give_back(std::size_t boxes) {
  const std::size_t needed = kBytesOfABox * boxes + kBytesOfAPair * kept.size();
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
  detail::give_back(kept);
  detail::give_back(now);
  detail::give_back(base);
  detail::give_back(large);
  detail::give_back(escaped);
  detail::give_back(is_escaped);
  detail::give_back(answer, std::max(kept.size() + 1, few_pairs(boxes)));
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
  if (boxes.size() <= kFewBoxes) {
    return state_->compare_few(boxes);
  }
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
         state.index.memory() + detail::bytes(state.kept) + detail::bytes(state.now) +
         detail::bytes(state.base) + detail::bytes(state.large) + detail::bytes(state.marks) +
         detail::bytes(state.escaped) + detail::bytes(state.is_escaped) +
         detail::bytes(state.pairs) + detail::bytes(state.answer);
}

}  // namespace soms
