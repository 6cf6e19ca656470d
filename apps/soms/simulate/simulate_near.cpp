#include "apps/soms/simulate/simulate_near.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>

namespace soms::command {

namespace {

auto pair_of(const NearEvent& event) {
  return std::tuple(event.mover, event.part, event.other);
}

bool before(const NearEvent& a, const NearEvent& b) {
  return pair_of(a) < pair_of(b);
}

}  // namespace

void NearLog::add(const StepReport& report, std::uint64_t frame) {
  now_.clear();
  const auto add = [&](const NearEvent& event) {
    now_.push_back(event);
    now_.back().begin = now_.back().end = now_.back().nearest = frame;
  };
  for (const EnvironmentGap& gap : report.environment_gaps) {
    add({.mover = gap.mover,
         .part = gap.part,
         .distance = gap.distance,
         .i = gap.i,
         .j = gap.j,
         .point_a = gap.point_a,
         .point_b = gap.point_b});
  }
  for (const EnvironmentContact& contact : report.environment) {
    if (now_.empty() || !now_.back().touches() ||
        pair_of(now_.back()) != std::tuple(contact.mover, contact.part, 0U)) {
      add({.mover = contact.mover, .part = contact.part, .i = contact.i, .j = contact.j});
    }
  }
  for (const MoverGap& gap : report.mover_gaps) {
    add({.mover = gap.a,
         .part = Contact::kMover,
         .other = gap.b,
         .distance = gap.distance,
         .i = gap.i,
         .j = gap.j,
         .point_a = gap.point_a,
         .point_b = gap.point_b});
  }
  for (const MoverContact& contact : report.movers) {
    if (now_.empty() || !now_.back().touches() ||
        pair_of(now_.back()) != std::tuple(contact.a, Contact::kMover, contact.b)) {
      add({.mover = contact.a,
           .part = Contact::kMover,
           .other = contact.b,
           .i = contact.i,
           .j = contact.j});
    }
  }
  std::sort(now_.begin(), now_.end(), before);
  follow();
}

/// Merges the pairs of this frame with those of the frame before: both are sorted.
void NearLog::follow() {
  auto last = lasting_.begin();
  for (NearEvent& event : now_) {
    while (last != lasting_.end() && before(*last, event)) {
      events_.push_back(*last++);
    }
    if (last == lasting_.end() || before(event, *last)) {
      continue;
    }
    // The brackets are neighbors or equal, so their upper ends order what they tell apart.
    if (event.distance.upper < last->distance.upper ||
        (event.distance.upper == last->distance.upper &&
         event.distance.lower < last->distance.lower)) {
      event.begin = last->begin;
    } else {
      const std::uint64_t end = event.end;
      event = *last;
      event.end = end;
    }
    ++last;
  }
  events_.insert(events_.end(), last, lasting_.end());
  lasting_.swap(now_);
}

void NearLog::finish() {
  events_.insert(events_.end(), lasting_.begin(), lasting_.end());
  lasting_.clear();
  std::sort(events_.begin(), events_.end(), [](const NearEvent& a, const NearEvent& b) {
    return a.begin != b.begin ? a.begin < b.begin : before(a, b);
  });
}

std::uint64_t NearLog::between_movers() const {
  return static_cast<std::uint64_t>(std::count_if(
      events_.begin(), events_.end(), [](const NearEvent& e) { return e.between_movers(); }));
}

std::uint64_t NearLog::without_touch() const {
  return static_cast<std::uint64_t>(std::count_if(events_.begin(), events_.end(),
                                                  [](const NearEvent& e) { return !e.touches(); }));
}

std::vector<std::size_t> NearLog::nearest(std::size_t n) const {
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < events_.size(); ++k) {
    if (!events_[k].touches()) {
      numbers.push_back(k);
    }
  }
  const std::size_t most = std::min(n, numbers.size());
  const auto key = [this](std::size_t k) {
    return std::tuple(events_[k].distance.upper, events_[k].distance.lower, k);
  };
  std::partial_sort(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(most),
                    numbers.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  numbers.resize(most);
  return numbers;
}

std::vector<std::size_t> NearLog::nearest_of_pairs() const {
  std::vector<std::size_t> numbers = nearest(events_.size());
  std::set<decltype(pair_of(NearEvent()))> seen;
  std::erase_if(numbers, [&](std::size_t k) { return !seen.insert(pair_of(events_[k])).second; });
  return numbers;
}

}  // namespace soms::command
