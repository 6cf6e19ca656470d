#include "tests/support/truth/query_table.h"

#include "soms/base/text.h"
#include "soms/query/print.h"
#include "soms/query/reference/distance.h"
#include "soms/query/reference/overlap.h"
#include "soms/query/reference/solid.h"

#include "tests/support/shortest_segment.h"
#include "tests/support/truth/overlap_rows.h"
#include "tests/support/truth/query_row_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace soms::test {

namespace {

using detail::add;
using detail::answers_of;
using detail::finished;
using detail::kInfinity;
using detail::limits_of;
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

Answer ask_distance(const Body& a, const Body& b, const RowOptions& options, const Limits& limits) {
  return distance(a, b, {.at_most = options.length}, limits_of(options, limits));
}

BatchAnswer ask_distance_batch(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                               const RowOptions& options, const Limits& limits) {
  return answers_of(
      distance(mover, poses, fixed, {.at_most = options.length}, limits_of(options, limits)));
}

/// What was proved before the end came encloses the truth; the pair named is as near as it says.
std::string cut_distance_fault(const Distance& answer, const PairTruth& truth, const Body& a,
                               const Body& b) {
  const Bracket& d = truth.distance.distance;
  if (!(answer.distance.lower <= d.lower && answer.distance.upper >= d.upper)) {
    return "the bracket of a cut answer does not hold the distance";
  }
  return answer.triangles &&
                 !(distance_of_pair(a, b, *answer.triangles).upper <= answer.distance.upper)
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
  hash.add(static_cast<std::uint64_t>(pair.a));
  hash.add(static_cast<std::uint64_t>(pair.b));
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

Answer ask_within(const Body& a, const Body& b, const RowOptions& options, const Limits& limits) {
  return within(a, b, options.length, limits_of(options, limits));
}

BatchAnswer ask_within_batch(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                             const RowOptions& options, const Limits& limits) {
  return answers_of(within(mover, poses, fixed, options.length, limits_of(options, limits)));
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

// solid

Answer ask_solid(const Body& a, const Body& b, const RowOptions& options, const Limits& limits) {
  return solid(a, b, limits_of(options, limits));
}

BatchAnswer ask_solid_batch(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                            const RowOptions& options, const Limits& limits) {
  return answers_of(solid(mover, poses, fixed, limits_of(options, limits)));
}

std::string solid_fault(const Answer& any_answer, const PairTruth&, const Body& a, const Body& b,
                        double) {
  const auto& answer = std::get<Solid>(any_answer);
  if (answer.coverage == Coverage::cut) {
    return answer.relation == Relation::undecided && answer.why == Undecided::deadline
               ? ""
               : "a cut answer that is decided";
  }
  const Solid truth = reference::solid_by_brute_force(a, b);
  if (answer.relation != truth.relation) {
    return "another relation than the twin's";
  }
  return answer.surfaces_meet == truth.surfaces_meet && answer.why == Undecided::none
             ? ""
             : "surfaces that meet, or do not, otherwise than the twin's";
}

Answer solid_promised(const Answer& answer) {
  auto copy = std::get<Solid>(answer);
  copy.cost = {};
  return copy;
}

Answer solid_symmetric(const Answer& answer, bool exchanged) {
  auto copy = std::get<Solid>(solid_promised(answer));
  if (exchanged && copy.relation == Relation::a_in_b) {
    copy.relation = Relation::b_in_a;
  } else if (exchanged && copy.relation == Relation::b_in_a) {
    copy.relation = Relation::a_in_b;
  }
  return copy;
}

void add_solid(Fnv1a& hash, const Answer& any_answer) {
  const auto& answer = std::get<Solid>(any_answer);
  hash.add(static_cast<std::uint64_t>(answer.relation));
  add(hash, answer.surfaces_meet);
  hash.add(static_cast<std::uint64_t>(answer.why));
  add(hash, answer.coverage);
}

std::string solid_text(const Answer& answer) {
  Line line;
  line << std::get<Solid>(answer);
  return line.str();
}

constexpr std::array<QueryRow, 6> kRows{{
    overlap_row<OverlapMode::all>("overlap"),
    overlap_row<OverlapMode::any>("overlap any"),
    overlap_row<OverlapMode::first>("overlap first"),
    {{.name = "distance",
      .takes_length = true,
      .promised = distance_promised,
      .add_to = add_distance,
      .text = distance_text},
     ask_distance,
     ask_distance_batch,
     distance_fault,
     distance_symmetric},
    {{.name = "within",
      .takes_length = true,
      .promised = within_promised,
      .add_to = add_within,
      .text = within_text},
     ask_within,
     ask_within_batch,
     within_fault,
     within_symmetric},
    {{.name = "solid",
      .of_closed_bodies = true,
      .promised = solid_promised,
      .add_to = add_solid,
      .text = solid_text},
     ask_solid,
     ask_solid_batch,
     solid_fault,
     solid_symmetric},
}};

constexpr std::size_t kOfAnyBodies = kRows.size() - 1;
static_assert(!kRows[kOfAnyBodies - 1].of_closed_bodies && kRows[kOfAnyBodies].of_closed_bodies);

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
  for (const QueryRow& row : query_table(a, b)) {
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
  for (const QueryRow& row : query_table(a, b)) {
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

std::span<const QueryRow> query_table(const Body& a, const Body& b) {
  return std::span(kRows).first(is_closed(a) && is_closed(b) ? kRows.size() : kOfAnyBodies);
}

const QueryRow& query_row(std::string_view name) {
  const auto found = std::find_if(kRows.begin(), kRows.end(),
                                  [&](const QueryRow& row) { return row.name == name; });
  if (found == kRows.end()) {
    throw std::runtime_error("no question is named " + std::string(name));
  }
  return *found;
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
