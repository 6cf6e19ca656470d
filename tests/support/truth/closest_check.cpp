#include "tests/support/truth/closest_check.h"

#include "soms/base/text.h"
#include "soms/query/closest.h"
#include "soms/query/print.h"
#include "soms/query/reference/closest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace soms::test {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

std::string text(const Closest& answer) {
  std::ostringstream out;
  out.precision(17);
  out << answer;
  return out.str();
}

Closest without_cost(Closest answer) {
  answer.cost = {};
  return answer;
}

std::string fault_at(const Body& body, const Vec3& point, const Closest& truth, double at_most) {
  const ClosestOptions options{.at_most = at_most};
  const Closest answer = closest(body, point, options);
  const std::array points{point, Vec3{1, 2, 3}, point};
  const ClosestBatch batch = closest(body, points, options, {.threads = 2});
  if (batch.at(0) != answer || batch.at(2) != answer) {
    return "another answer or cost in a batch";
  }
  const bool farther = truth.triangle && truth.distance.upper > at_most;
  Closest expected = without_cost(truth);
  if (farther) {
    expected = {.distance = {at_most, kFar}, .farther = true};
  }
  return without_cost(answer) == expected
             ? ""
             : "another answer than the twin's " + text(expected) + ": " + text(answer);
}

std::string fault_of_row(const std::string& name, const NearTriangles& found,
                         const std::vector<reference::RankedTriangle>& truth, std::size_t count) {
  const std::size_t expected = std::min(count, truth.size());
  if (found.offsets.size() != 2 || found.offsets[1] != expected ||
      found.triangle.size() != expected) {
    return name + ": another number of triangles";
  }
  for (std::size_t i = 0; i < expected; ++i) {
    if (found.triangle[i] != truth[i].triangle ||
        Bracket{found.lower[i], found.upper[i]} != truth[i].distance) {
      return name + ": another triangle or distance at place " + std::to_string(i);
    }
  }
  return found.coverage[0] == Coverage::complete && found.cost == found.costs[0]
             ? ""
             : name + ": a wrong coverage or cost";
}

std::string fault_of_lists(const Body& body, const Vec3& point, const Closest& truth) {
  const std::array points{point};
  const auto all = reference::triangles_by_brute_force(body, point, kFar);
  for (const std::size_t count : {std::size_t{1}, std::size_t{3}, all.size() / 2, all.size() + 1}) {
    std::string fault = fault_of_row("nearest " + std::to_string(count),
                                     nearest_triangles(body, points, count), all, count);
    if (!fault.empty()) {
      return fault;
    }
  }
  if (!truth.triangle) {
    return {};
  }
  const Bracket& middle = all[all.size() / 2].distance;
  for (const double radius : {0.0, truth.distance.lower, truth.distance.upper, middle.lower,
                              middle.upper, 2 * middle.upper, kFar}) {
    const auto within = reference::triangles_by_brute_force(body, point, radius);
    std::string fault = fault_of_row("within " + shortest(radius),
                                     near_triangles(body, points, radius), within, within.size());
    if (!fault.empty()) {
      return fault;
    }
  }
  return {};
}

}  // namespace

std::string first_fault_of_point(const Body& body, const Vec3& point) {
  const Closest truth = reference::closest_by_brute_force(body, point);
  std::vector<double> limits{kFar, 0};
  if (truth.triangle) {
    const Bracket& d = truth.distance;
    limits.insert(limits.end(), {std::max(0.0, std::nextafter(d.lower, -kFar)), d.lower, d.upper,
                                 std::nextafter(d.upper, kFar)});
  }
  for (const double at_most : limits) {
    std::string fault = fault_at(body, point, truth, at_most);
    if (!fault.empty()) {
      return "closest at most " + shortest(at_most) + ": " + fault;
    }
  }
  return fault_of_lists(body, point, truth);
}

}  // namespace soms::test
