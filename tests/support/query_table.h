/// \file
/// The questions that two bodies are queried for, a row each. What must hold for every question
/// (brute force, threads, layouts, exchanged bodies, batches, golden answers) is tested by a loop
/// over the rows.
#pragma once

#include "soms/base/hash.h"
#include "soms/base/parallel.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/within.h"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace soms::test {

/// An answer to one of the questions.
using Answer = std::variant<Overlap, Distance, Within>;

/// Answers of a batch, and its total cost.
struct BatchAnswer {
  std::vector<Answer> answers;
  Cost cost;
};

/// What the twins say of two bodies: the facts that every answer is compared with.
struct PairTruth {
  Overlap overlap;
  Distance distance;  ///< no limit; [infinity, infinity] where a mesh is empty
};

[[nodiscard]] PairTruth truth_of(const Body& a, const Body& b);

/// What a question may be given beside the bodies.
struct RowOptions {
  /// A limit of distance, or a clearance; rows that take none ignore it.
  double length = std::numeric_limits<double>::infinity();
  /// The deadline is past already.
  bool late = false;
};

/// A question.
struct QueryRow {
  std::string_view name = {};
  bool takes_length = false;

  Answer (*ask)(const Body& a, const Body& b, const RowOptions& options,
                const Parallel& parallel) = nullptr;
  BatchAnswer (*ask_batch)(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                           const RowOptions& options, const Parallel& parallel) = nullptr;

  /// What is wrong with an answer, in words; empty if nothing is. What is not promised (the witness
  /// of `within`, a lower bound) only has to be true. A cut answer must not say more than it knows.
  std::string (*fault)(const Answer& answer, const PairTruth& truth, const Body& a, const Body& b,
                       double length) = nullptr;

  /// The part of an answer that no tree, layout, instruction set or number of threads changes; the
  /// rest is cleared.
  Answer (*promised)(const Answer& answer) = nullptr;

  /// The part of an answer that exchanging the bodies does not change, but for names: equal for the
  /// answer of (a, b), and that of (b, a) with `exchanged`.
  Answer (*symmetric)(const Answer& answer, bool exchanged) = nullptr;

  /// Adds what golden rows keep of an answer, which no compiler or processor changes: all that is
  /// promised, and no cost.
  void (*add_to)(Fnv1a& hash, const Answer& answer) = nullptr;

  /// One line of JSON, for messages.
  std::string (*text)(const Answer& answer) = nullptr;
};

/// All questions. One that is new gets a row here.
[[nodiscard]] std::span<const QueryRow> query_table();

/// The row with this name. \pre There is one.
[[nodiscard]] const QueryRow& query_row(std::string_view name);

/// What is wrong with the answers about two bodies: each question at each of `lengths_around`,
/// about (a, b) and about (b, a), which must agree. Empty if nothing is.
[[nodiscard]] std::string first_fault(const Body& a, const Body& b);

/// The same of questions that take no length, whose twin is quick.
[[nodiscard]] std::string first_fault_of_overlap(const Body& a, const Body& b);

/// Coverage and cost of an answer.
[[nodiscard]] Coverage coverage_of(const Answer& answer);
[[nodiscard]] const Cost& cost_of(const Answer& answer);

/// Lengths that `row` is to be tried with where the distance is `distance`: none, infinity, and the
/// distance with the doubles beside it. One length where the row takes none.
[[nodiscard]] std::vector<double> lengths_around(const QueryRow& row, const Bracket& distance);

}  // namespace soms::test
