#include "soms/base/arithmetic.h"
#include "soms/generate/detail/circle.h"
#include "soms/generate/detail/ground.h"
#include "soms/generate/routes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace soms {

namespace {

constexpr double kWalkBelow = 3;       ///< meters a second: slower movers keep to the sidewalk
constexpr std::uint64_t kLongest = 5;  ///< blocks along a side of a loop
constexpr std::size_t kArc = 8;        ///< lines of a quarter turn

/// A crossing of a loop by the numbers of its street lines.
struct StreetCrossing {
  std::int64_t i = 0;
  std::int64_t j = 0;
};

/// A step of one block along x or y.
enum class Step { x, y };

/// Steps from a corner of the loop's square to the opposite one: `first`, any order, `last`.
std::vector<Step> stairs(Step first, std::uint64_t x, std::uint64_t y, Step last, Rng& rng) {
  std::vector<Step> inner(x - 1, Step::x);
  inner.insert(inner.end(), y - 1, Step::y);
  for (std::size_t i = inner.size(); i > 1; --i) {
    std::swap(inner[i - 1], inner[rng.below(i)]);
  }
  inner.insert(inner.begin(), first);
  inner.push_back(last);
  return inner;
}

/// A closed walk over crossings, one block a step, that never turns back: stairs up to the opposite
/// corner and other stairs home, turned over at random.
std::vector<StreetCrossing> draw_loop(const City& city, Rng& rng) {
  const std::uint64_t blocks = city.street_lines.size() - 1;
  const std::uint64_t most = std::min(blocks, kLongest);
  const std::uint64_t x = 1 + rng.below(most);
  const std::uint64_t y = 1 + rng.below(most);
  const auto i = static_cast<std::int64_t>(rng.below(blocks - x + 1));
  const auto j = static_cast<std::int64_t>(rng.below(blocks - y + 1));
  const bool mirrored = rng.unit() < 0.5;
  std::vector<StreetCrossing> loop;
  StreetCrossing at;
  const auto walk = [&](const std::vector<Step>& steps, std::int64_t sign) {
    for (const Step step : steps) {
      const std::int64_t u = mirrored ? static_cast<std::int64_t>(x) - at.i : at.i;
      loop.push_back({i + u, j + at.j});
      (step == Step::x ? at.i : at.j) += sign;
    }
  };
  walk(stairs(Step::x, x, y, Step::y, rng), 1);
  walk(stairs(Step::x, x, y, Step::y, rng), -1);
  return loop;
}

/// How a mover keeps to its side of the street.
struct Lane {
  double offset = 0;      ///< to the right of the center line
  double right_turn = 0;  ///< radius
  double left_turn = 0;   ///< radius
  double level = 0;       ///< half the length over which it stays level at a crossing
};

Vec3 direction(const StreetCrossing& from, const StreetCrossing& to) {
  return {static_cast<double>(to.i - from.i), static_cast<double>(to.j - from.j), 0};
}

Vec3 right_of(const Vec3& d) {
  return {d.y, -d.x, 0};
}

/// Points of a lane through a crossing at `center`: straight on or a quarter circle.
void add_crossing(std::vector<Vec3>& points, const Vec3& center, const Vec3& in, const Vec3& out,
                  const Lane& lane) {
  if (in == out) {
    const Vec3 middle = center + lane.offset * right_of(in);
    points.push_back(middle - lane.level * in);
    points.push_back(middle + lane.level * in);
    return;
  }
  const bool right = right_of(in) == out;
  const double radius = right ? lane.right_turn : lane.left_turn;
  const Vec3 corner = center + lane.offset * (right_of(in) + right_of(out));
  const Vec3 pivot = corner + radius * (out - in);
  const double before = dot(corner - center, in) + lane.level;
  if (before > radius + 1e-6) {
    points.push_back(corner - before * in);
  }
  for (std::size_t k = 0; k <= kArc; ++k) {
    const detail::OnCircle p = detail::on_circle(k, 4 * kArc);
    points.push_back(pivot + radius * (p.sine * in - p.cosine * out));
  }
  const double after = dot(center - corner, out) + lane.level;
  if (after > radius + 1e-6) {
    points.push_back(corner + after * out);
  }
}

/// The loop's polyline; `lift` gives the height above ground at each crossing.
template <class Lift>
Route follow(const City& city, const std::vector<StreetCrossing>& loop, const Lane& lane,
             Lift&& lift, std::size_t first, double past) {
  Route route;
  route.closed = true;
  std::size_t marked = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const StreetCrossing& here = loop[k];
    const StreetCrossing& before = loop[k == 0 ? loop.size() - 1 : k - 1];
    const StreetCrossing& after = loop[k + 1 == loop.size() ? 0 : k + 1];
    const auto i = static_cast<std::size_t>(here.i);
    const auto j = static_cast<std::size_t>(here.j);
    const Vec3 center{city.street_lines[i], city.street_lines[j],
                      detail::crossing_height(city, i, j) + lift(k)};
    marked = k == first ? route.points.size() : marked;
    add_crossing(route.points, center, direction(before, here), direction(here, after), lane);
  }
  route.measure();
  route.start = route.marks[marked] + past;
  return route;
}

}  // namespace

Route street_route(const City& city, std::uint64_t seed, double speed, double clearance) {
  const PlainArithmetic plain;
  Rng rng(seed);
  const auto loop = draw_loop(city, rng);
  const double half = 0.5 * city.street_width;
  const bool walks = speed < kWalkBelow;
  Lane lane;
  lane.offset = walks ? rng.uniform(7.5, 9.4) : rng.uniform(2.2, 4.6);
  // Arcs end within the level crossing.
  lane.right_turn = std::min(5.0, 0.95 * (half - lane.offset));
  lane.left_turn = walks ? lane.right_turn : lane.offset + 3;
  lane.level = half;
  const std::size_t first = rng.below(loop.size());
  // Up to 6 m before the level crossing and after it there is no furniture.
  Route route = follow(
      city, loop, lane, [&](std::size_t) { return clearance; }, first,
      rng.uniform(-3, walks ? 3 : half));
  route.speed = speed;
  route.base = walks ? 0.5 : 2.7;
  return route;
}

Route flight_route(const City& city, std::uint64_t seed, double speed, double lowest,
                   double highest) {
  const PlainArithmetic plain;
  Rng rng(seed);
  const auto loop = draw_loop(city, rng);
  std::vector<double> heights(loop.size());
  for (double& h : heights) {
    h = rng.uniform(lowest, highest);
  }
  Lane lane;
  lane.offset = rng.uniform(-12, 12);
  lane.right_turn = rng.uniform(4, 22);
  lane.left_turn = rng.uniform(4, 22);
  lane.level = 0.5 * city.street_width;
  const std::size_t first = rng.below(loop.size());
  Route route = follow(
      city, loop, lane, [&](std::size_t k) { return heights[k]; }, first, rng.uniform(0, 10));
  route.speed = speed;
  route.base = 1;
  return route;
}

}  // namespace soms
