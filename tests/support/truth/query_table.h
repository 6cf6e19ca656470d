/// \file
/// The questions that two bodies are queried for, a row each. What must hold for every question
/// (brute force, threads, layouts, exchanged bodies, batches, golden answers) is tested by a loop
/// over the rows. Questions about a body and a point or a ray: `tests/support/truth/probe_table.h`.
#pragma once

#include "soms/base/limits.h"

#include "tests/support/truth/answer_row.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::test {

/// What the twins say of two bodies: the facts that every answer is compared with.
struct PairTruth {
  Overlap overlap;
  Distance distance;  ///< no limit; [infinity, infinity] where a mesh is empty
};

[[nodiscard]] PairTruth truth_of(const Body& a, const Body& b);

/// A question about two bodies.
struct QueryRow : AnswerRow {
  Answer (*ask)(const Body& a, const Body& b, const RowOptions& options,
                const Limits& limits) = nullptr;
  BatchAnswer (*ask_batch)(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                           const RowOptions& options, const Limits& limits) = nullptr;

  /// What is wrong with an answer, in words; empty if nothing is. What is not promised (the witness
  /// of `within`, a lower bound) only has to be true. A cut answer must not say more than it knows.
  std::string (*fault)(const Answer& answer, const PairTruth& truth, const Body& a, const Body& b,
                       double length) = nullptr;

  /// The part of an answer that exchanging the bodies does not change, but for names: equal for the
  /// answer of (a, b), and that of (b, a) with `exchanged`.
  Answer (*symmetric)(const Answer& answer, bool exchanged) = nullptr;
};

/// All questions. One that is new gets a row here; those of closed bodies are the last ones.
[[nodiscard]] std::span<const QueryRow> query_table();

/// The questions that these two bodies may be queried for: all if both are closed.
[[nodiscard]] std::span<const QueryRow> query_table(const Body& a, const Body& b);

/// The row with this name. \pre There is one.
[[nodiscard]] const QueryRow& query_row(std::string_view name);

/// What is wrong with the answers about two bodies: each question at each of `lengths_around`,
/// about (a, b) and about (b, a), which must agree. Empty if nothing is.
[[nodiscard]] std::string first_fault(const Body& a, const Body& b);

/// The same of questions that take no length, whose twin is quick.
[[nodiscard]] std::string first_fault_of_overlap(const Body& a, const Body& b);

/// Lengths that `row` is to be tried with where the distance is `distance`: none, infinity, and the
/// distance with the doubles beside it. One length where the row takes none.
[[nodiscard]] std::vector<double> lengths_around(const QueryRow& row, const Bracket& distance);

}  // namespace soms::test
