/// \file
/// Answers to any question, and what every table of questions says of them.
#pragma once

#include "soms/base/hash.h"
#include "soms/query/closest.h"
#include "soms/query/contains.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/ray.h"
#include "soms/query/signed_closest.h"
#include "soms/query/solid.h"
#include "soms/query/within.h"

#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace soms::test {

/// An answer to one of the questions. Of `AllHits`, the row of one ray.
using Answer = std::variant<Overlap, Distance, Within, Solid, Closest, SignedClosest, Contains,
                            ClosestHit, AnyHit, AllHits>;

/// Answers of a batch, and its total cost.
struct BatchAnswer {
  std::vector<Answer> answers;
  Cost cost;
};

/// What a question may be given beside what it is about.
struct RowOptions {
  /// A limit of distance, or a clearance; rows that take none ignore it.
  double length = std::numeric_limits<double>::infinity();
  /// The deadline is past already.
  bool late = false;
};

/// A question, whatever it is about.
struct AnswerRow {
  std::string_view name = {};
  bool takes_length = false;
  bool of_closed_bodies = false;  ///< others are refused

  /// The part of an answer that no tree, layout, instruction set or number of threads changes; the
  /// rest is cleared.
  Answer (*promised)(const Answer& answer) = nullptr;

  /// Adds what golden rows keep of an answer, which no compiler or processor changes: all that is
  /// promised, and no cost.
  void (*add_to)(Fnv1a& hash, const Answer& answer) = nullptr;

  /// One line, for messages.
  std::string (*text)(const Answer& answer) = nullptr;
};

/// Coverage and cost of an answer.
[[nodiscard]] Coverage coverage_of(const Answer& answer);
[[nodiscard]] const Cost& cost_of(const Answer& answer);

/// True if the surface is closed where its pose moves it.
[[nodiscard]] bool is_closed(const Body& body);

}  // namespace soms::test
