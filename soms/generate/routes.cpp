#include "soms/generate/routes.h"

#include "soms/base/arithmetic.h"
#include "soms/generate/detail/circle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms {

namespace {

double distance(const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  return std::sqrt(dot(d, d));
}

std::vector<double> marks_of(const Route& route) {
  std::vector<double> marks;
  double sum = 0;
  for (std::size_t i = 0; i < route.points.size(); ++i) {
    sum += i == 0 ? 0 : distance(route.points[i - 1], route.points[i]);
    marks.push_back(sum);
  }
  if (route.closed && !route.points.empty()) {
    marks.push_back(sum + distance(route.points.back(), route.points.front()));
  }
  return marks;
}

/// A place on a route and the direction of the line it lies on (not of unit length).
struct OnRoute {
  Vec3 point;
  Vec3 direction;
};

/// Lines that are tried before all are searched.
constexpr std::size_t kTried = 4;

/// The last line that begins at `meters` or before; `near` and those after it are tried first.
std::size_t line_at(const std::vector<double>& marks, double meters, std::size_t near) {
  const std::size_t last = marks.size() - 2;
  for (std::size_t i = near; i <= last && i - near < kTried; ++i) {
    if ((i == 0 || marks[i] <= meters) && (i == last || meters < marks[i + 1])) {
      return i;
    }
  }
  const auto after = std::upper_bound(marks.begin() + 1, marks.end() - 1, meters);
  return static_cast<std::size_t>(after - marks.begin()) - 1;
}

OnRoute place(const Route& route, const std::vector<double>& marks, double meters,
              std::size_t& line) {
  const std::size_t i = line_at(marks, meters, line);
  line = i;
  const Vec3& from = route.points[i];
  const Vec3& to = route.points[i + 1 == route.points.size() ? 0 : i + 1];
  const double length = marks[i + 1] - marks[i];
  const double share = length > 0 ? (meters - marks[i]) / length : 0;
  return {from + share * (to - from), to - from};
}

double wrapped(double meters, double length) {
  const double rest = meters - length * std::floor(meters / length);
  return rest < length ? rest : 0;
}

Pose heading(const Vec3& point, const Vec3& direction) {
  const double flat = std::sqrt(direction.x * direction.x + direction.y * direction.y);
  const double length = std::sqrt(dot(direction, direction));
  if (!(flat > 1e-9 * length)) {
    return Pose::translation(point.x, point.y, point.z);
  }
  const Vec3 x = (1 / length) * direction;
  const Vec3 y{-direction.y / flat, direction.x / flat, 0};
  const Vec3 z = cross(x, y);
  Pose pose;
  pose.m = {x.x, y.x, z.x, point.x, x.y, y.y, z.y, point.y, x.z, y.z, z.z, point.z};
  return pose;
}

}  // namespace

void Route::measure() {
  const PlainArithmetic plain;
  marks = marks_of(*this);
}

double Route::length() const {
  const PlainArithmetic plain;
  const std::vector<double> found = marks.empty() ? marks_of(*this) : std::vector<double>{};
  const std::vector<double>& all = marks.empty() ? found : marks;
  return settled(all.empty() ? 0 : all.back());
}

Pose Route::at(double seconds) const {
  std::size_t line = 0;
  return at(seconds, line);
}

Pose Route::at(double seconds, std::size_t& line) const {
  const PlainArithmetic plain;
  if (points.empty()) {
    return {};
  }
  const std::vector<double> found = marks.empty() ? marks_of(*this) : std::vector<double>{};
  const std::vector<double>& all = marks.empty() ? found : marks;
  const double total = all.back();
  if (!(total > 0)) {
    return Pose::translation(points.front().x, points.front().y, points.front().z);
  }
  double meters = start + speed * seconds;
  bool back = false;
  if (closed) {
    meters = wrapped(meters, total);
  } else {
    meters = wrapped(meters, 2 * total);
    back = meters > total;
    meters = back ? 2 * total - meters : meters;
  }
  double half = 0.5 * base;
  if (!closed) {
    half = std::min({half, meters, total - meters});
  }
  if (!(half > 0)) {
    const OnRoute here = place(*this, all, meters, line);
    return heading(here.point, back ? -here.direction : here.direction);
  }
  const auto on = [&](double m, std::size_t& on_line) {
    return place(*this, all, closed ? wrapped(m, total) : m, on_line).point;
  };
  const Vec3 rear = on(meters - half, line);
  std::size_t front_line = line;
  const Vec3 front = on(meters + half, front_line);
  return heading(0.5 * (rear + front), back ? rear - front : front - rear);
}

Route straight_route(const Box& scene, const Vec3& start, std::uint64_t seed, double speed) {
  const PlainArithmetic plain;
  Rng rng(seed);
  const detail::OnCircle turn = detail::on_circle(rng.unit());
  Route route;
  route.speed = speed;
  // How far the line can go on and back before it leaves the box.
  double on = std::numeric_limits<double>::infinity();
  double back = on;
  const auto limit = [&](double from, double lower, double upper, double along) {
    const double to_upper = std::max(0.0, upper - from) / std::abs(along);
    const double to_lower = std::max(0.0, from - lower) / std::abs(along);
    on = std::min(on, along > 0 ? to_upper : to_lower);
    back = std::min(back, along > 0 ? to_lower : to_upper);
  };
  limit(start.x, scene.lower.x, scene.upper.x, turn.cosine);
  limit(start.y, scene.lower.y, scene.upper.y, turn.sine);
  if (!std::isfinite(on) || !std::isfinite(back) || scene.empty()) {
    route.points = {start};
  } else {
    const Vec3 direction{turn.cosine, turn.sine, 0};
    route.points = {start - back * direction, start + on * direction};
    route.start = back;
  }
  route.measure();
  return route;
}

}  // namespace soms
