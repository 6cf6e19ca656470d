/// \file
/// Who is right? Decided without any tree, before a time counts.
#pragma once

#include "soms/base/box.h"

#include "bench/peers/core/distance_judge.h"
#include "bench/peers/core/pair_counter.h"
#include "bench/peers/core/probe_judge.h"
#include "bench/peers/core/solid_judge.h"
#include "bench/peers/libraries/library.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace soms::bench {

/// One library's answers to a set, from its first question on.
struct Answers {
  std::vector<double> values;
  Precision precision = Precision::exact;
};

/// What the judge found about one library's answers to a set.
struct Verdict {
  std::size_t checked = 0;  ///< of its answers, those that the judge decided
  std::size_t wrong = 0;    ///< of these, wrong ones
  /// Of all its answers, about this part is wrong. Where libraries contradict each other every
  /// answer is decided, elsewhere a sample, so that `wrong` of `checked` would be too many.
  double share = 0;
  std::vector<std::size_t> wrong_questions;
};

/// The right answers to a question: from `least` to `most`, both included.
struct Right {
  double least = 0;
  double most = 0;
};

/// How a job is judged.
struct Rules {
  /// The right answers to a question, by what a library computes in.
  std::function<Right(std::size_t question, Precision precision)> right;
  /// True if one of two answers to a question must be wrong, as far as that shows without `right`.
  std::function<bool(std::size_t question, const Answers& a, const Answers& b)> contradict;
  /// True for a question that is decided although no two answers contradict each other.
  std::function<bool(std::size_t question)> sampled;
};

/// Judges the answers of several libraries to one set: every question on which two contradict each
/// other, and the sampled ones. A library's list may be shorter than the others'.
[[nodiscard]] std::vector<Verdict> judge(std::span<const Answers> answers, const Rules& rules);

/// Of counts, which have to be right to the last one: `count` is called once a question, all of
/// them are decided.
[[nodiscard]] Rules rules_of_counts(const std::function<std::uint64_t(std::size_t)>& count);

/// Judges counts, which have to be right to the last one: every question on which two differ, and
/// as many others, evenly spread, as fit when `budget` triangles of the movers are looked at. There
/// is a counter for each mover of a question: one, or an arm's links.
[[nodiscard]] std::vector<Verdict> judge(std::span<const PairCounter> links,
                                         const Questions& questions,
                                         std::span<const Answers> answers, double budget);

/// The same of frames of boxes: the first frame, the last, the middle one and those on which two
/// differ, counted by a sweep.
[[nodiscard]] std::vector<Verdict> judge(std::span<const std::vector<FloatBox>> frames,
                                         std::span<const Answers> answers);

/// Judges distances of poses or, with `point_mesh` as the mover, of points, or flags of `within`. A
/// distance is right that rounding may have taken from
/// the true one; where a clearance is as near to the distance, both flags are right. Looked at as
/// with counts.
[[nodiscard]] std::vector<Verdict> judge(const DistanceJudge& measure, const Questions& questions,
                                         std::span<const Answers> answers, double budget);

/// Judges relations of solids. Where surfaces meet and no corner proves a crossing, every relation
/// of such is right; looked at as with counts.
[[nodiscard]] std::vector<Verdict> judge(const SolidJudge& solids, const Questions& questions,
                                         std::span<const Answers> answers, double budget);

/// Judges sides of points. Where rounding leaves the side open to the judge, inside and outside are
/// right.
[[nodiscard]] std::vector<Verdict> judge(const SideJudge& sides, const Questions& questions,
                                         std::span<const Answers> answers, double budget);

/// Judges hits of rays. A hit is right that rounding may have taken from a true one; where a ray
/// passes an edge as near, hit and miss are.
[[nodiscard]] std::vector<Verdict> judge(const RayJudge& rays, const Questions& questions,
                                         std::span<const Answers> answers, double budget);

}  // namespace soms::bench
