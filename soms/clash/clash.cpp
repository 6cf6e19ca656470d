#include "soms/clash/clash.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/clash/detail/open_parts.h"
#include "soms/clash/detail/pair_of_parts.h"
#include "soms/motion/detail/widened.h"
#include "soms/scene/broad_phase.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace soms {

namespace {

/// Pairs are dealt out to threads in pieces of so many: one may take a microsecond or a second.
constexpr std::size_t kPairsOfAChunk = 8;

/// The boxes of parts, which grow by a margin, and how far each reaches: of the first part of an
/// open group, around all that the group may enclose.
class Reach {
 public:
  void add(std::span<const PartBody> parts, double margin) {
    for (const PartBody& part : parts) {
      parts_.push_back(&part);
      own_.push_back(detail::widened(part.box(), margin));
      const bool reaches_on = part.together.body && part.leads();
      boxes_.push_back(reaches_on ? detail::widened(part.together.body->box(), margin)
                                  : own_.back());
    }
  }

  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }

  /// Whether two whose boxes meet are to be compared: as parts, or as the bodies that they lead.
  [[nodiscard]] bool are_compared(std::uint32_t i, std::uint32_t j) const {
    const PartBody& a = *parts_[i];
    const PartBody& b = *parts_[j];
    return (!a.together.body && !b.together.body) || detail::lead_bodies(a, b) ||
           overlaps(own_[i], own_[j]);
  }

 private:
  std::vector<const PartBody*> parts_;
  std::vector<Box> own_;
  std::vector<Box> boxes_;
};

std::vector<PartNumbers> meeting(const Reach& reach, std::uint32_t first_of_b,
                                 BroadPhase& broad_phase, const ClashOptions& options) {
  std::vector<PartNumbers> pairs;
  for (const auto& [i, j] : broad_phase.find(reach.boxes())) {
    const PartNumbers pair{i, j - first_of_b};
    if (reach.are_compared(i, j) && (!options.wanted || options.wanted(pair.first, pair.second))) {
      pairs.push_back(pair);
    }
  }
  return pairs;
}

void check_numbers(std::span<const PartBody> a, std::span<const PartBody> b,
                   std::span<const PartNumbers> pairs) {
  for (const auto& [i, j] : pairs) {
    if (i >= a.size() || j >= b.size()) {
      throw Error(ErrorKind::out_of_range,
                  "parts " + std::to_string(i) + " and " + std::to_string(j) + " of " +
                      std::to_string(a.size()) + " and " + std::to_string(b.size()),
                  "give numbers of parts that exist");
    }
  }
}

}  // namespace

void check(const ClashOptions& options) {
  if (options.within && !(std::isfinite(*options.within) && *options.within >= 0)) {
    throw Error(ErrorKind::usage,
                "the distance within which parts are near is not a finite number of at least 0",
                "give a finite distance, or none");
  }
}

const PartBody& body_in(const Clash& clash, const PartBody& part, const PartBody& other) {
  const bool of_bodies = clash.kind == ClashKind::undecided && clash.triangle_pairs == 0 &&
                         detail::lead_bodies(part, other);
  return of_bodies ? detail::body_led_by(part) : part;
}

std::vector<PartNumbers> clash_candidates(std::span<const PartBody> a, std::span<const PartBody> b,
                                          const ClashOptions& options) {
  check(options);
  const PlainArithmetic plain;
  const double margin = options.within.value_or(0) / 2;
  Reach reach;
  reach.add(a, margin);
  reach.add(b, margin);
  std::vector<std::uint32_t> side(a.size(), 1);
  side.resize(reach.boxes().size(), 2);
  BroadPhase broad_phase;
  broad_phase.set_filter(std::move(side), {});
  return meeting(reach, static_cast<std::uint32_t>(a.size()), broad_phase, options);
}

std::vector<PartNumbers> clash_candidates(std::span<const PartBody> parts,
                                          const ClashOptions& options) {
  check(options);
  const PlainArithmetic plain;
  Reach reach;
  reach.add(parts, options.within.value_or(0) / 2);
  BroadPhase broad_phase;
  return meeting(reach, 0, broad_phase, options);
}

ClashList clashes_of(std::span<const PartBody> a, std::span<const PartBody> b,
                     std::span<const PartNumbers> pairs, const ClashOptions& options,
                     const Limits& limits) {
  check(options);
  check_numbers(a, b, pairs);
  std::vector<ClashList> pieces((pairs.size() + kPairsOfAChunk - 1) / kPairsOfAChunk);
  for_each_chunk(pairs.size(), kPairsOfAChunk, limits.without_deadline(),
                 [&](std::size_t begin, std::size_t end) {
                   const PlainArithmetic plain;
                   ClashList& piece = pieces[begin / kPairsOfAChunk];
                   detail::PairOfParts decider(options, limits);
                   for (std::size_t k = begin; k < end; ++k) {
                     std::optional<Clash> clash =
                         decider.decide(a[pairs[k].first], b[pairs[k].second]);
                     ++(decider.cut() ? piece.left_out : piece.compared);
                     if (clash && !decider.cut()) {
                       clash->a = pairs[k].first;
                       clash->b = pairs[k].second;
                       piece.clashes.push_back(*clash);
                     }
                   }
                   piece.cost = decider.cost();
                 });
  ClashList list;
  for (const ClashList& piece : pieces) {
    list.clashes.insert(list.clashes.end(), piece.clashes.begin(), piece.clashes.end());
    list.compared += piece.compared;
    list.left_out += piece.left_out;
    list.cost += piece.cost;
  }
  list.coverage = list.left_out == 0 ? Coverage::complete : Coverage::cut;
  return list;
}

ClashList clashes(std::span<const PartBody> a, std::span<const PartBody> b,
                  const ClashOptions& options, const Limits& limits) {
  return clashes_of(a, b, clash_candidates(a, b, options), options, limits);
}

ClashList clashes(std::span<const PartBody> parts, const ClashOptions& options,
                  const Limits& limits) {
  return clashes_of(parts, parts, clash_candidates(parts, options), options, limits);
}

}  // namespace soms
