#include "soms/query/detail/near/point_goal.h"

#include "soms/query/detail/leaf_pairs.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace soms::detail {

namespace {

// In the tests that `Limit` counts.
constexpr std::uint64_t kWorkOfComparison = 1;
constexpr std::uint64_t kWorkOfExact = 200;

/// Ends a sort.
struct OutOfTime {};

std::tuple<double, double, TriangleId> by_bounds(const NearTriangle& near) {
  const Bracket bounds = near.pair.bounds();
  return {bounds.lower, bounds.upper, near.id};
}

/// The order of two distances, with the exact tests that it took counted.
std::strong_ordering compare(PointToTriangle& a, PointToTriangle& b, Cost& cost) {
  const std::uint64_t before = a.exact_tests() + b.exact_tests();
  const std::strong_ordering order = a.compare(b);
  cost.exact_tests += a.exact_tests() + b.exact_tests() - before;
  return order;
}

/// At most `distance` away.
bool is_within(PointToTriangle& pair, double distance, Cost& cost) {
  const std::uint64_t before = pair.exact_tests();
  const bool within = pair.compare(distance) <= 0;
  cost.exact_tests += pair.exact_tests() - before;
  return within;
}

}  // namespace

PointToTriangle PointGoal::measure(TriangleId id) const {
  return {point_, moved(frame_->body(), id)};
}

void ClosestGoal::offer(TriangleId id, Cost& cost) {
  NearTriangle here{id, measure(id)};
  if (here.pair.bounds().lower > upper_) {
    return;
  }
  bool nearer = true;
  if (found_) {
    const std::strong_ordering order = compare(here.pair, found_->pair, cost);
    nearer = order < 0 || (order == 0 && id < found_->id);
  } else {
    nearer = is_within(here.pair, at_most_, cost);
  }
  if (nearer) {
    upper_ = std::min(upper_, here.pair.bounds().upper);
    found_ = std::move(here);
  }
}

bool SeveralGoal::is_before(NearTriangle& a, NearTriangle& b, Cost& cost) {
  const std::strong_ordering order = compare(a.pair, b.pair, cost);
  return order < 0 || (order == 0 && a.id < b.id);
}

void SeveralGoal::offer(TriangleId id, Cost& cost) {
  NearTriangle here{id, measure(id)};
  if (here.pair.bounds().lower > upper_ || !is_within(here.pair, at_most_, cost)) {
    return;
  }
  const auto before = [&](std::size_t i, std::size_t j) {
    return is_before(found_[i], found_[j], cost);
  };
  if (found_.size() < count_) {
    found_.push_back(std::move(here));
    if (found_.size() == count_) {
      for (std::size_t i = 0; i < count_; ++i) {
        heap_.push_back(i);
      }
      std::make_heap(heap_.begin(), heap_.end(), before);
      narrow();
    }
    return;
  }
  if (is_before(here, found_[heap_.front()], cost)) {
    std::pop_heap(heap_.begin(), heap_.end(), before);
    found_[heap_.back()] = std::move(here);
    std::push_heap(heap_.begin(), heap_.end(), before);
    narrow();
  }
}

void SeveralGoal::narrow() {
  upper_ = std::min(upper_, found_[heap_.front()].pair.bounds().upper);
}

void SeveralGoal::number_all() {
  heap_.resize(found_.size());
  std::iota(heap_.begin(), heap_.end(), std::size_t{0});
}

const std::vector<std::size_t>& SeveralGoal::sorted(Limit& limit, Cost& cost) {
  number_all();
  try {
    std::sort(heap_.begin(), heap_.end(), [&](std::size_t i, std::size_t j) {
      const std::uint64_t before = cost.exact_tests;
      const bool less = i != j && is_before(found_[i], found_[j], cost);
      if (limit.spend(kWorkOfComparison + kWorkOfExact * (cost.exact_tests - before))) {
        throw OutOfTime();
      }
      return less;
    });
  } catch (const OutOfTime&) {
    number_all();
    std::sort(heap_.begin(), heap_.end(), [&](std::size_t i, std::size_t j) {
      return by_bounds(found_[i]) < by_bounds(found_[j]);
    });
  }
  return heap_;
}

}  // namespace soms::detail
