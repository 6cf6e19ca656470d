#include "tests/support/query_table.h"

#include "soms/base/text.h"
#include "soms/query/reference/distance.h"
#include "soms/query/reference/overlap.h"

#include "tests/support/overlap_rows.h"
#include "tests/support/query_row_parts.h"
#include "tests/support/shortest_segment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace soms::test {

namespace {

using detail::add;
using detail::answers_of;
using detail::deadline_of;
using detail::finished;
using detail::kInfinity;
using detail::Line;
using detail::overlap_row;
using detail::write_pair;

/// The least distance is at most `length`: no double is between the ends of the bracket.
bool holds_within(const PairTruth& truth, double length) {
  return truth.distance.distance.upper <= length;
}

bool is_empty(const PairTruth& truth) {
  return truth.distance.distance.lower == kInfinity;
}

// distance

Answer ask_distance(const Body& a, const Body& b, const RowOptions& options,
                    const Parallel& parallel) {
  return distance(a, b, {.at_most = options.length, .deadline = deadline_of(options)}, parallel);
}

BatchAnswer ask_distance_batch(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                               const RowOptions& options, const Parallel& parallel) {
  return answers_of(distance(mover, poses, fixed,
                             {.at_most = options.length, .deadline = deadline_of(options)},
                             parallel));
}

/// What was proved before the end came encloses the truth; the pair named is as near as it says.
std::string cut_distance_fault(const Distance& answer, const PairTruth& truth, const Body& a,
                               const Body& b) {
  const Bracket& d = truth.distance.distance;
  if (!(answer.distance.lower <= d.lower && answer.distance.upper >= d.upper)) {
    return "the bracket of a cut answer does not hold the distance";
  }
  return answer.triangles && distance_of_pair(a, b, *answer.triangles).upper > answer.distance.upper
             ? "the pair of a cut answer is farther than it says"
             : "";
}

std::string distance_fault(const Answer& any_answer, const PairTruth& truth, const Body& a,
                           const Body& b, double length) {
  const auto& answer = std::get<Distance>(any_answer);
  const Bracket& d = truth.distance.distance;
  if (answer.coverage == Coverage::cut) {
    return cut_distance_fault(answer, truth, a, b);
  }
  if (is_empty(truth)) {
    return answer.distance == d && !answer.triangles ? "" : "an empty mesh is near something";
  }
  if (answer.farther != !holds_within(truth, length)) {
    return answer.farther ? "farther, and it is not" : "not farther, and it is";
  }
  if (answer.farther) {
    const Bracket& bound = answer.distance;
    return !answer.triangles && bound.upper == kInfinity && bound.lower >= length &&
                   bound.lower <= d.lower
               ? ""
               : "a wrong bound";
  }
  if (answer.distance != d) {
    return "another distance than the twin's";
  }
  if (answer.triangles != truth.distance.triangles) {
    return "another pair than the twin's";
  }
  return fault_of_points(a, b, *answer.triangles, answer.point_a, answer.point_b, d);
}

Answer distance_promised(const Answer& answer) {
  auto copy = std::get<Distance>(answer);
  copy.cost = {};
  return copy;
}

Answer distance_symmetric(const Answer& answer, bool) {
  const auto& whole = std::get<Distance>(answer);
  return Distance{.distance = whole.distance, .farther = whole.farther, .coverage = whole.coverage};
}

void add_distance(Fnv1a& hash, const Answer& any_answer) {
  const auto& answer = std::get<Distance>(any_answer);
  hash.add(answer.distance.lower);
  hash.add(answer.distance.upper);
  add(hash, answer.triangles.has_value());
  const TrianglePair pair = answer.triangles.value_or(TrianglePair{});
  hash.add(static_cast<std::uint64_t>(pair.first));
  hash.add(static_cast<std::uint64_t>(pair.second));
  add(hash, answer.point_a);
  add(hash, answer.point_b);
  add(hash, answer.farther);
  add(hash, answer.coverage);
}

std::string distance_text(const Answer& any_answer) {
  const auto& answer = std::get<Distance>(any_answer);
  Line line;
  line << "{\"lower\":" << shortest(answer.distance.lower)
       << ",\"upper\":" << shortest(answer.distance.upper);
  write_pair(line, answer);
  line << (answer.farther ? ",\"farther\":true" : "");
  return finished(line, answer.coverage, answer.cost);
}

// within

Answer ask_within(const Body& a, const Body& b, const RowOptions& options,
                  const Parallel& parallel) {
  return within(a, b, options.length, {.deadline = deadline_of(options)}, parallel);
}

BatchAnswer ask_within_batch(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                             const RowOptions& options, const Parallel& parallel) {
  return answers_of(
      within(mover, poses, fixed, options.length, {.deadline = deadline_of(options)}, parallel));
}

std::string within_fault(const Answer& any_answer, const PairTruth& truth, const Body& a,
                         const Body& b, double length) {
  const auto& answer = std::get<Within>(any_answer);
  const bool cut = answer.coverage == Coverage::cut;
  if (cut ? answer.within
          : !(is_empty(truth) && length == kInfinity) &&
                answer.within != holds_within(truth, length)) {
    return answer.within ? "within, and it is not" : "not within, and it is";
  }
  if (!answer.within) {
    return !answer.triangles && answer.at_least <= truth.distance.distance.lower &&
                   (cut || answer.at_least >= length)
               ? ""
               : "a wrong bound";
  }
  if (is_empty(truth)) {
    return answer.triangles ? "a witness of an empty mesh" : "";
  }
  if (!answer.triangles || answer.at_least != 0) {
    return "no witness";
  }
  const Bracket near = distance_of_pair(a, b, *answer.triangles);
  return near.upper <= length
             ? fault_of_points(a, b, *answer.triangles, answer.point_a, answer.point_b, near)
             : "a witness that is farther";
}

Answer within_promised(const Answer& answer) {
  const auto& whole = std::get<Within>(answer);
  return Within{.within = whole.within, .coverage = whole.coverage};
}

Answer within_symmetric(const Answer& answer, bool) {
  return within_promised(answer);
}

void add_within(Fnv1a& hash, const Answer& any_answer) {
  const auto& answer = std::get<Within>(any_answer);
  add(hash, answer.within);
  hash.add(answer.at_least);
  add(hash, answer.coverage);
}

std::string within_text(const Answer& any_answer) {
  const auto& answer = std::get<Within>(any_answer);
  Line line;
  line << "{\"within\":" << (answer.within ? "true" : "false")
       << ",\"at_least\":" << shortest(answer.at_least);
  write_pair(line, answer);
  return finished(line, answer.coverage, answer.cost);
}

constexpr std::array<QueryRow, 5> kRows{{
    overlap_row<OverlapMode::all>("overlap"),
    overlap_row<OverlapMode::any>("overlap any"),
    overlap_row<OverlapMode::first>("overlap first"),
    {"distance", true, ask_distance, ask_distance_batch, distance_fault, distance_promised,
     distance_symmetric, add_distance, distance_text},
    {"within", true, ask_within, ask_within_batch, within_fault, within_promised, within_symmetric,
     add_within, within_text},
}};

Overlap overlap_by_brute_force(const Body& a, const Body& b) {
  return reference::overlap(a.shape.mesh(), a.pose, b.shape.mesh(), b.pose);
}

/// What is wrong with the answers to a question about (a, b) and about (b, a).
std::string fault_of_row(const QueryRow& row, double length, const Body& a, const Body& b,
                         const PairTruth& truth, const PairTruth& exchanged) {
  const Answer answer = row.ask(a, b, {.length = length}, {});
  const Answer other = row.ask(b, a, {.length = length}, {});
  std::string fault = row.fault(answer, truth, a, b, length);
  if (fault.empty()) {
    fault = row.fault(other, exchanged, b, a, length);
  }
  if (fault.empty() && !(row.symmetric(answer, false) == row.symmetric(other, true))) {
    fault = "another answer where the bodies are exchanged";
  }
  return fault.empty() ? ""
                       : std::string(row.name) + " at " + shortest(length) + ": " + fault + ": " +
                             row.text(answer) + ", exchanged " + row.text(other);
}

}  // namespace

PairTruth truth_of(const Body& a, const Body& b) {
  return {overlap_by_brute_force(a, b), reference::distance_by_brute_force(a, b)};
}

std::string first_fault(const Body& a, const Body& b) {
  const PairTruth truth = truth_of(a, b);
  const PairTruth exchanged = truth_of(b, a);
  for (const QueryRow& row : kRows) {
    for (const double length : lengths_around(row, truth.distance.distance)) {
      std::string fault = fault_of_row(row, length, a, b, truth, exchanged);
      if (!fault.empty()) {
        return fault;
      }
    }
  }
  return {};
}

std::string first_fault_of_overlap(const Body& a, const Body& b) {
  const PairTruth truth{overlap_by_brute_force(a, b), {}};
  const PairTruth exchanged{overlap_by_brute_force(b, a), {}};
  for (const QueryRow& row : kRows) {
    std::string fault =
        row.takes_length ? "" : fault_of_row(row, kInfinity, a, b, truth, exchanged);
    if (!fault.empty()) {
      return fault;
    }
  }
  return {};
}

std::span<const QueryRow> query_table() {
  return kRows;
}

const QueryRow& query_row(std::string_view name) {
  const auto found = std::find_if(kRows.begin(), kRows.end(),
                                  [&](const QueryRow& row) { return row.name == name; });
  if (found == kRows.end()) {
    throw std::runtime_error("no question is named " + std::string(name));
  }
  return *found;
}

Coverage coverage_of(const Answer& answer) {
  return std::visit([](const auto& one) { return one.coverage; }, answer);
}

const Cost& cost_of(const Answer& answer) {
  return std::visit([](const auto& one) -> const Cost& { return one.cost; }, answer);
}

std::vector<double> lengths_around(const QueryRow& row, const Bracket& distance) {
  if (!row.takes_length) {
    return {kInfinity};
  }
  std::vector<double> lengths{0, kInfinity};
  if (distance.lower < kInfinity) {
    const double below = std::max(0.0, std::nextafter(distance.lower, -kInfinity));
    const double above = std::nextafter(distance.upper, kInfinity);
    lengths.insert(lengths.end(), {below, distance.lower, distance.upper, above});
  } else {
    lengths.push_back(1);
  }
  return lengths;
}

}  // namespace soms::test
