#include "apps/soms/simulate/simulate_verify_near.h"

#include "soms/base/parallel.h"
#include "soms/query/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace soms::command {

namespace {

/// Movers with gaps, and any movers, that are checked in a frame.
constexpr std::size_t kNearAFrame = 2;
constexpr std::size_t kAnyAFrame = 2;

Triangle moved(const Body& body, TriangleId i) {
  const Triangle t = body.shape.mesh().triangle(i);
  return {body.pose.apply(t.a), body.pose.apply(t.b), body.pose.apply(t.c)};
}

Box box_of(const Body& body) {
  Box box;
  for (TriangleId i = 0; i < body.shape.mesh().triangles.size(); ++i) {
    box.grow(bounds(moved(body, i)));
  }
  return box;
}

/// True where the boxes are farther apart than `most` along an axis. The difference of two doubles
/// rounds to at most `most` where it is at most that, so none is lost.
bool apart(const Box& a, const Box& b, double most) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.lower[axis] - b.upper[axis] > most || b.lower[axis] - a.upper[axis] > most) {
      return true;
    }
  }
  return false;
}

/// The triangles of a body whose boxes are within `most` of `box`, at their places in the world.
struct Gathered {
  Mesh mesh;
  std::vector<TriangleId> triangles;

  Gathered(const Body& body, const Box& box, double most, const Limits& limits) {
    for (TriangleId i = 0; i < body.shape.mesh().triangles.size(); ++i) {
      if (i % (1U << 20) == 0) {
        check_stop(limits);
      }
      const Triangle t = moved(body, i);
      if (!apart(bounds(t), box, most)) {
        const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {t.a, t.b, t.c});
        mesh.triangles.push_back({next, next + 1, next + 2});
        triangles.push_back(i);
      }
    }
  }
};

/// A distance, and the triangles of the whole bodies.
struct Found {
  TrianglePair triangles;
  Bracket distance;

  [[nodiscard]] bool operator==(const Found&) const = default;
};

/// The distance of two bodies where it is at most the clearance and they do not touch.
std::optional<Found> gap_of(const Body& a, const Body& b, double clearance, const Limits& limits) {
  const Gathered from(a, box_of(b), clearance, limits);
  Box box;
  for (const Vec3& v : from.mesh.vertices) {
    box.grow(v);
  }
  const Gathered to(b, box, clearance, limits);
  if (from.triangles.empty() || to.triangles.empty()) {
    return std::nullopt;
  }
  const Distance answer = distance(Body(Shape(from.mesh)), Body(Shape(to.mesh)), {}, limits);
  if (answer.distance.upper == 0 || answer.distance.upper > clearance) {
    return std::nullopt;
  }
  return Found{{from.triangles[answer.triangles->a], to.triangles[answer.triangles->b]},
               answer.distance};
}

}  // namespace

GapVerifier::GapVerifier(const World& world, double clearance, std::uint64_t seed)
    : world_(world), clearance_(clearance), rng_(seed) {
}

Body GapVerifier::body(MoverId mover, const std::vector<Pose>& poses) const {
  return Body(world_.models[world_.routes[mover].model].shape, poses[mover]);
}

std::vector<MoverId> GapVerifier::choose(const StepReport& report, std::size_t movers) {
  std::vector<MoverId> chosen;
  const std::size_t with_city = report.environment_gaps.size();
  const std::size_t gaps = with_city + report.mover_gaps.size();
  for (std::size_t k = 0; k < kNearAFrame && gaps > 0; ++k) {
    const std::size_t at = rng_.below(gaps);
    chosen.push_back(at < with_city ? report.environment_gaps[at].mover
                                    : report.mover_gaps[at - with_city].a);
  }
  for (std::size_t k = 0; k < kAnyAFrame && movers > 0; ++k) {
    chosen.push_back(static_cast<MoverId>(rng_.below(movers)));
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

/// True if brute force finds the gaps of a mover that the report says, and no other.
bool GapVerifier::right(MoverId mover, const StepReport& report, const std::vector<Pose>& poses,
                        const Limits& limits) const {
  const auto said_with_city = [&](EnvironmentId part) -> std::optional<Found> {
    for (const EnvironmentGap& gap : report.environment_gaps) {
      if (gap.mover == mover && gap.part == part) {
        return Found{{gap.i, gap.j}, gap.distance};
      }
    }
    return std::nullopt;
  };
  const auto said_of_movers = [&](MoverId a, MoverId b) -> std::optional<Found> {
    for (const MoverGap& gap : report.mover_gaps) {
      if (gap.a == a && gap.b == b) {
        return Found{{gap.i, gap.j}, gap.distance};
      }
    }
    return std::nullopt;
  };
  const Body subject = body(mover, poses);
  for (EnvironmentId part = 0; part < world_.city.size(); ++part) {
    if (gap_of(subject, world_.city[part], clearance_, limits) != said_with_city(part)) {
      return false;
    }
  }
  const Box box = box_of(subject);
  for (MoverId other = 0; other < poses.size(); ++other) {
    if (other == mover) {
      continue;
    }
    const auto [a, b] = std::minmax(mover, other);
    const std::optional<Found> said = said_of_movers(a, b);
    std::optional<Found> seen;
    if (world_.filter.tests(a, b) && !apart(box, box_of(body(other, poses)), clearance_)) {
      seen = gap_of(body(a, poses), body(b, poses), clearance_, limits);
    }
    if (seen != said) {
      return false;
    }
  }
  return true;
}

VerifiedGaps GapVerifier::verify(const StepReport& report, const std::vector<Pose>& poses,
                                 const Limits& limits) {
  const std::vector<MoverId> chosen = choose(report, poses.size());
  std::vector<std::uint8_t> is_right(chosen.size());
  for_each_chunk(chosen.size(), 1, limits, [&](std::size_t k, std::size_t) {
    is_right[k] = right(chosen[k], report, poses, {.stop = limits.stop}) ? 1 : 0;
  });
  VerifiedGaps verified;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const MoverId mover = chosen[k];
    const bool near =
        std::any_of(report.environment_gaps.begin(), report.environment_gaps.end(),
                    [&](const EnvironmentGap& gap) { return gap.mover == mover; }) ||
        std::any_of(report.mover_gaps.begin(), report.mover_gaps.end(),
                    [&](const MoverGap& gap) { return gap.a == mover || gap.b == mover; });
    ++(near ? verified.near : verified.free);
    verified.wrong += is_right[k] != 0 ? 0U : 1U;
  }
  return verified;
}

}  // namespace soms::command
