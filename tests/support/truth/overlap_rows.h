/// \file
/// The rows of `overlap` in the query table, one for each of its modes.
#pragma once

#include "tests/support/truth/query_row_parts.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace soms::test::detail {

template <OverlapMode mode>
Answer ask_overlap(const Body& a, const Body& b, const RowOptions& options, const Limits& limits) {
  return overlap(a, b, {.mode = mode}, limits_of(options, limits));
}

template <OverlapMode mode>
BatchAnswer ask_overlap_batch(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                              const RowOptions& options, const Limits& limits) {
  const OverlapBatch batch =
      overlap(mover, poses, fixed, {.mode = mode}, limits_of(options, limits));
  BatchAnswer result;
  for (std::size_t k = 0; k < batch.size(); ++k) {
    const auto pairs = batch.pairs_of(k);
    result.answers.emplace_back(Overlap{
        batch.any[k] != 0, {pairs.begin(), pairs.end()}, batch.coverage[k], batch.costs[k]});
  }
  result.cost = batch.cost;
  return result;
}

/// What is wrong with the pairs of an answer that is not cut.
template <OverlapMode mode>
std::string fault_of_pairs(const Overlap& answer, const std::vector<TrianglePair>& pairs) {
  if (mode == OverlapMode::all) {
    return answer.pairs == pairs ? "" : "other pairs than the twin's";
  }
  if (answer.any == pairs.empty()) {
    return answer.any ? "overlap, and there is none" : "no overlap, and there is one";
  }
  if (answer.pairs.size() > 1) {
    return "more than one pair";
  }
  return mode == OverlapMode::any || !answer.any || answer.pairs.front() == pairs.front()
             ? ""
             : "another pair than the least";
}

template <OverlapMode mode>
std::string overlap_fault(const Answer& any_answer, const PairTruth& truth, const Body&,
                          const Body&, double) {
  const auto& answer = std::get<Overlap>(any_answer);
  const std::vector<TrianglePair>& pairs = truth.overlap.pairs;
  if (answer.any != !answer.pairs.empty()) {
    return "any and the pairs disagree";
  }
  if (!std::includes(pairs.begin(), pairs.end(), answer.pairs.begin(), answer.pairs.end())) {
    return "a pair that does not overlap";
  }
  if (answer.coverage == Coverage::cut) {
    return "";
  }
  const bool stopped = mode != OverlapMode::all && answer.any;
  return answer.coverage == (stopped ? Coverage::first : Coverage::complete)
             ? fault_of_pairs<mode>(answer, pairs)
             : "a wrong coverage";
}

template <OverlapMode mode>
Answer overlap_promised(const Answer& answer) {
  auto copy = std::get<Overlap>(answer);
  copy.cost = {};
  if (mode == OverlapMode::any) {
    copy.pairs.clear();
  }
  return copy;
}

template <OverlapMode mode>
Answer overlap_symmetric(const Answer& answer, bool exchanged) {
  auto copy = std::get<Overlap>(overlap_promised<mode>(answer));
  if (mode == OverlapMode::first) {
    copy.pairs.clear();  // the least by the triangles of another body
  }
  if (exchanged) {
    for (TrianglePair& pair : copy.pairs) {
      std::swap(pair.a, pair.b);
    }
    std::sort(copy.pairs.begin(), copy.pairs.end());
  }
  return copy;
}

template <OverlapMode mode>
void add_overlap(Fnv1a& hash, const Answer& any_answer) {
  const auto answer = std::get<Overlap>(overlap_promised<mode>(any_answer));
  add(hash, answer.any);
  hash.add(answer.hash());
  add(hash, answer.coverage);
}

inline std::string overlap_text(const Answer& any_answer) {
  const auto& answer = std::get<Overlap>(any_answer);
  Line line;
  line << "{\"pairs\":[";
  for (std::size_t k = 0; k < answer.pairs.size(); ++k) {
    line << (k == 0 ? "" : ",");
    write(line, answer.pairs[k]);
  }
  line << ']';
  return finished(line, answer.coverage, answer.cost);
}

template <OverlapMode mode>
constexpr QueryRow overlap_row(std::string_view name) {
  return {{.name = name,
           .promised = overlap_promised<mode>,
           .add_to = add_overlap<mode>,
           .text = overlap_text},
          ask_overlap<mode>,
          ask_overlap_batch<mode>,
          overlap_fault<mode>,
          overlap_symmetric<mode>};
}

}  // namespace soms::test::detail
