#include "tests/support/query_table.h"

#include "soms/base/text.h"
#include "soms/query/reference/distance.h"
#include "soms/query/reference/overlap.h"

#include "tests/support/shortest_segment.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace soms::test {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The least distance is at most `length`: no double is between the ends of the bracket.
bool holds_within(const PairTruth& truth, double length) {
  return truth.distance.distance.upper <= length;
}

bool is_empty(const PairTruth& truth) {
  return truth.distance.distance.lower == kInfinity;
}

void add(Fnv1a& hash, Coverage coverage) {
  hash.add(static_cast<std::uint64_t>(coverage));
}

void add(Fnv1a& hash, bool flag) {
  hash.add(static_cast<std::uint64_t>(flag));
}

void add(Fnv1a& hash, const Vec3& v) {
  hash.add(v.x);
  hash.add(v.y);
  hash.add(v.z);
}

/// One line of JSON. Numbers of a triangle and coordinates are written by the functions below.
using Line = std::ostringstream;

void write(Line& line, const TrianglePair& pair) {
  line << '[' << pair.first << ',' << pair.second << ']';
}

void write(Line& line, const Vec3& v) {
  line << '[' << shortest(v.x) << ',' << shortest(v.y) << ',' << shortest(v.z) << ']';
}

/// A pair with its points, as `distance` and `within` name them.
template <class Named>
void write_pair(Line& line, const Named& answer) {
  if (answer.triangles) {
    line << ",\"triangles\":";
    write(line, *answer.triangles);
    line << ",\"points\":[";
    write(line, answer.point_a);
    line << ',';
    write(line, answer.point_b);
    line << ']';
  }
}

/// What every line ends with.
std::string finished(Line& line, Coverage coverage, const Cost& cost) {
  constexpr std::array<std::string_view, 3> kNames{"complete", "first", "cut"};
  line << ",\"coverage\":\"" << kNames[static_cast<std::size_t>(coverage)]
       << "\",\"cost\":{\"node_tests\":" << cost.node_tests
       << ",\"triangle_tests\":" << cost.triangle_tests << ",\"exact_tests\":" << cost.exact_tests
       << "}}";
  return line.str();
}

/// Columns of a batch as answers.
template <class Batch>
BatchAnswer answers_of(const Batch& batch) {
  BatchAnswer result;
  for (std::size_t k = 0; k < batch.size(); ++k) {
    result.answers.emplace_back(batch.at(k));
  }
  result.cost = batch.cost;
  return result;
}

std::optional<std::chrono::steady_clock::time_point> deadline_of(const RowOptions& options) {
  return options.late ? std::optional(std::chrono::steady_clock::now() - std::chrono::seconds(1))
                      : std::nullopt;
}

// overlap

Answer ask_overlap(const Body& a, const Body& b, const RowOptions& options,
                   const Parallel& parallel) {
  return overlap(a, b, {.deadline = deadline_of(options)}, parallel);
}

BatchAnswer ask_overlap_batch(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                              const RowOptions& options, const Parallel& parallel) {
  const OverlapBatch batch =
      overlap(mover, poses, fixed, {.deadline = deadline_of(options)}, parallel);
  BatchAnswer result;
  for (std::size_t k = 0; k < batch.size(); ++k) {
    const auto pairs = batch.pairs_of(k);
    result.answers.emplace_back(Overlap{
        batch.any[k] != 0, {pairs.begin(), pairs.end()}, batch.coverage[k], batch.costs[k]});
  }
  result.cost = batch.cost;
  return result;
}

std::string overlap_fault(const Answer& any_answer, const PairTruth& truth, const Body&,
                          const Body&, double) {
  const auto& answer = std::get<Overlap>(any_answer);
  const std::vector<TrianglePair>& pairs = truth.overlap.pairs;
  if (answer.any != !answer.pairs.empty()) {
    return "any and the pairs disagree";
  }
  if (answer.coverage == Coverage::cut) {
    return std::includes(pairs.begin(), pairs.end(), answer.pairs.begin(), answer.pairs.end())
               ? ""
               : "a pair that does not overlap";
  }
  return answer.pairs == pairs ? "" : "other pairs than the twin's";
}

Answer overlap_promised(const Answer& answer) {
  auto copy = std::get<Overlap>(answer);
  copy.cost = {};
  return copy;
}

Answer overlap_symmetric(const Answer& answer, bool exchanged) {
  auto copy = std::get<Overlap>(overlap_promised(answer));
  if (exchanged) {
    for (TrianglePair& pair : copy.pairs) {
      std::swap(pair.first, pair.second);
    }
    std::sort(copy.pairs.begin(), copy.pairs.end());
  }
  return copy;
}

void add_overlap(Fnv1a& hash, const Answer& any_answer) {
  const auto& answer = std::get<Overlap>(any_answer);
  add(hash, answer.any);
  hash.add(answer.hash());
  add(hash, answer.coverage);
}

std::string overlap_text(const Answer& any_answer) {
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

constexpr std::array<QueryRow, 3> kRows{{
    {"overlap", false, ask_overlap, ask_overlap_batch, overlap_fault, overlap_promised,
     overlap_symmetric, add_overlap, overlap_text},
    {"distance", true, ask_distance, ask_distance_batch, distance_fault, distance_promised,
     distance_symmetric, add_distance, distance_text},
    {"within", true, ask_within, ask_within_batch, within_fault, within_promised, within_symmetric,
     add_within, within_text},
}};

}  // namespace

PairTruth truth_of(const Body& a, const Body& b) {
  return {reference::overlap(a.shape.mesh(), a.pose, b.shape.mesh(), b.pose),
          reference::distance_by_brute_force(a, b)};
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
