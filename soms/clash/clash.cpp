#include "soms/clash/clash.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/clash/detail/pair_of_parts.h"
#include "soms/scene/broad_phase.h"
#include "soms/scene/detail/widened.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace soms {

namespace {

/// Pairs are dealt out to threads in pieces of so many: one may take a microsecond or a second.
constexpr std::size_t kPairsOfAChunk = 8;

void add_boxes(std::span<const PartBody> parts, double margin, std::vector<Box>& boxes) {
  for (const PartBody& part : parts) {
    boxes.push_back(detail::widened(part.box(), margin));
  }
}

std::vector<PartNumbers> meeting(const std::vector<Box>& boxes, std::uint32_t first_of_b,
                                 BroadPhase& broad_phase, const ClashOptions& options) {
  std::vector<PartNumbers> pairs;
  for (const auto& [i, j] : broad_phase.find(boxes)) {
    const PartNumbers pair{i, j - first_of_b};
    if (!options.wanted || options.wanted(pair.first, pair.second)) {
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

std::vector<PartNumbers> clash_candidates(std::span<const PartBody> a, std::span<const PartBody> b,
                                          const ClashOptions& options) {
  check(options);
  const PlainArithmetic plain;
  const double margin = options.within.value_or(0) / 2;
  std::vector<Box> boxes;
  boxes.reserve(a.size() + b.size());
  add_boxes(a, margin, boxes);
  add_boxes(b, margin, boxes);
  std::vector<std::uint32_t> side(a.size(), 1);
  side.resize(boxes.size(), 2);
  BroadPhase broad_phase;
  broad_phase.set_filter(std::move(side), {});
  return meeting(boxes, static_cast<std::uint32_t>(a.size()), broad_phase, options);
}

std::vector<PartNumbers> clash_candidates(std::span<const PartBody> parts,
                                          const ClashOptions& options) {
  check(options);
  const PlainArithmetic plain;
  std::vector<Box> boxes;
  boxes.reserve(parts.size());
  add_boxes(parts, options.within.value_or(0) / 2, boxes);
  BroadPhase broad_phase;
  return meeting(boxes, 0, broad_phase, options);
}

ClashList clashes_of(std::span<const PartBody> a, std::span<const PartBody> b,
                     std::span<const PartNumbers> pairs, const ClashOptions& options,
                     const Parallel& parallel) {
  check(options);
  check_numbers(a, b, pairs);
  std::vector<ClashList> pieces((pairs.size() + kPairsOfAChunk - 1) / kPairsOfAChunk);
  for_each_chunk(pairs.size(), kPairsOfAChunk, parallel, [&](std::size_t begin, std::size_t end) {
    const PlainArithmetic plain;
    ClashList& piece = pieces[begin / kPairsOfAChunk];
    detail::PairOfParts decider(options, parallel);
    for (std::size_t k = begin; k < end; ++k) {
      std::optional<Clash> clash = decider.decide(a[pairs[k].first], b[pairs[k].second]);
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
                  const ClashOptions& options, const Parallel& parallel) {
  return clashes_of(a, b, clash_candidates(a, b, options), options, parallel);
}

ClashList clashes(std::span<const PartBody> parts, const ClashOptions& options,
                  const Parallel& parallel) {
  return clashes_of(parts, parts, clash_candidates(parts, options), options, parallel);
}

}  // namespace soms
