#include "tests/support/truth/probe_table.h"

#include "soms/base/pose.h"
#include "soms/query/print.h"
#include "soms/query/reference/closest.h"
#include "soms/query/reference/contains.h"
#include "soms/query/reference/ray.h"

#include "tests/support/truth/query_row_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace soms::test {

namespace {

using detail::add;
using detail::answers_of;
using detail::kInfinity;
using detail::limits_of;

void clear_cost(Closest& answer) {
  answer.cost = {};
}

void clear_cost(SignedClosest& answer) {
  answer.closest.cost = {};
}

void clear_cost(Contains& answer) {
  answer.cost = {};
}

void clear_cost(ClosestHit& answer) {
  answer.cost = {};
}

void clear_cost(AnyHit& answer) {
  answer.cost = {};
}

void clear_cost(AllHits& answer) {
  answer.cost = {};
  answer.costs.assign(answer.size(), {});
}

void hash_id(Fnv1a& hash, const std::optional<TriangleId>& triangle) {
  add(hash, triangle.has_value());
  hash.add(static_cast<std::uint64_t>(triangle.value_or(0)));
}

void hash_bracket(Fnv1a& hash, const Bracket& bracket) {
  hash.add(bracket.lower);
  hash.add(bracket.upper);
}

void hash_answer(Fnv1a& hash, const Closest& answer) {
  hash_bracket(hash, answer.distance);
  hash_id(hash, answer.triangle);
  add(hash, answer.point);
  hash.add(static_cast<std::uint64_t>(answer.feature));
  add(hash, answer.farther);
  add(hash, answer.coverage);
}

void hash_answer(Fnv1a& hash, const SignedClosest& answer) {
  hash_answer(hash, answer.closest);
  hash.add(static_cast<std::uint64_t>(answer.side));
}

void hash_answer(Fnv1a& hash, const Contains& answer) {
  hash.add(static_cast<std::uint64_t>(answer.side));
  add(hash, answer.coverage);
}

void hash_answer(Fnv1a& hash, const ClosestHit& answer) {
  hash_bracket(hash, answer.t);
  hash_id(hash, answer.triangle);
  add(hash, answer.point);
  add(hash, answer.front);
  add(hash, answer.coverage);
}

void hash_answer(Fnv1a& hash, const AnyHit& answer) {
  add(hash, answer.hit);
  add(hash, answer.coverage);
}

void hash_answer(Fnv1a& hash, const AllHits& answer) {
  for (std::size_t i = 0; i < answer.kind.size(); ++i) {
    hash_bracket(hash, {answer.lower[i], answer.upper[i]});
    hash.add(static_cast<std::uint64_t>(answer.kind[i]));
    hash.add(answer.triangle_offsets[i + 1]);
  }
  for (const TriangleId triangle : answer.triangle) {
    hash.add(static_cast<std::uint64_t>(triangle));
  }
  add(hash, answer.coverage.front());
}

/// The lines of a row that its type of answer decides.
template <class One>
constexpr AnswerRow row_of(std::string_view name, bool takes_length, bool of_closed_bodies) {
  return {
      .name = name,
      .takes_length = takes_length,
      .of_closed_bodies = of_closed_bodies,
      .promised = [](const Answer& answer) -> Answer {
        auto copy = std::get<One>(answer);
        clear_cost(copy);
        return copy;
      },
      .add_to = [](Fnv1a& hash, const Answer& answer) { hash_answer(hash, std::get<One>(answer)); },
      .text =
          [](const Answer& answer) {
            detail::Line line;
            line.precision(17);
            line << std::get<One>(answer);
            return line.str();
          }};
}

/// A bracket that holds another.
bool holds(const Bracket& outer, const Bracket& inner) {
  return outer.lower <= inner.lower && inner.upper <= outer.upper;
}

// closest

ClosestOptions closest_options(const RowOptions& options) {
  return {.at_most = options.length};
}

/// What `closest` says where a limit is given.
Closest limited(Closest truth, double at_most) {
  truth.cost = {};
  return truth.triangle && truth.distance.upper > at_most
             ? Closest{.distance = {at_most, kInfinity}, .farther = true}
             : truth;
}

constexpr ProbeRow<Vec3> kClosest{
    row_of<Closest>("closest", true, false),
    [](const Body& body, const Vec3& point, const RowOptions& options) -> Answer {
      return closest(body, point, closest_options(options), limits_of(options));
    },
    [](const Body& body, std::span<const Vec3> points, const RowOptions& options,
       const Limits& limits) {
      return answers_of(
          closest(body, points, closest_options(options), limits_of(options, limits)));
    },
    [](const Body& body, const Vec3& point, const RowOptions& options) -> Answer {
      return limited(reference::closest_by_brute_force(body, point), options.length);
    },
    [](const Answer& cut, const Answer& truth) {
      return holds(std::get<Closest>(cut).distance, std::get<Closest>(truth).distance);
    }};

constexpr ProbeRow<Vec3> kSignedClosest{
    row_of<SignedClosest>("signed closest", true, true),
    [](const Body& body, const Vec3& point, const RowOptions& options) -> Answer {
      return closest(ClosedBody(body), point, closest_options(options), limits_of(options));
    },
    [](const Body& body, std::span<const Vec3> points, const RowOptions& options,
       const Limits& limits) {
      const SignedClosestBatch batch =
          closest(ClosedBody(body), points, closest_options(options), limits_of(options, limits));
      BatchAnswer result;
      result.cost = batch.closest.cost;
      for (std::size_t k = 0; k < batch.size(); ++k) {
        result.answers.emplace_back(batch.at(k));
      }
      return result;
    },
    [](const Body& body, const Vec3& point, const RowOptions& options) -> Answer {
      const SignedClosest truth = reference::closest_by_brute_force(ClosedBody(body), point);
      return SignedClosest{limited(truth.closest, options.length), truth.side};
    },
    [](const Answer& cut, const Answer& truth) {
      const auto& said = std::get<SignedClosest>(cut);
      const auto& known = std::get<SignedClosest>(truth);
      return holds(said.distance(), known.distance()) &&
             (said.side == Side::undecided || said.side == known.side);
    }};

// contains

constexpr ProbeRow<Vec3> kContains{
    row_of<Contains>("contains", false, true),
    [](const Body& body, const Vec3& point, const RowOptions& options) -> Answer {
      return contains(ClosedBody(body), point, limits_of(options));
    },
    [](const Body& body, std::span<const Vec3> points, const RowOptions& options,
       const Limits& limits) {
      return answers_of(contains(body, points, limits_of(options, limits)));
    },
    [](const Body& body, const Vec3& point, const RowOptions&) -> Answer {
      return Contains{.side = reference::contains_by_brute_force(body, point)};
    },
    [](const Answer& cut, const Answer&) {
      return std::get<Contains>(cut).side == Side::undecided;
    }};

// closest_hit, any_hit, all_hits

constexpr ProbeRow<Ray> kClosestHit{
    row_of<ClosestHit>("closest_hit", false, false),
    [](const Body& body, const Ray& ray, const RowOptions& options) -> Answer {
      return closest_hit(body, ray, {}, limits_of(options));
    },
    [](const Body& body, std::span<const Ray> rays, const RowOptions& options,
       const Limits& limits) {
      return answers_of(closest_hit(body, rays, {}, limits_of(options, limits)));
    },
    [](const Body& body, const Ray& ray, const RowOptions&) -> Answer {
      ClosestHit truth = reference::closest_hit_by_brute_force(body, ray);
      truth.cost = {};
      return truth;
    },
    [](const Answer& cut, const Answer& truth) {
      return std::get<ClosestHit>(cut).t.upper >= std::get<ClosestHit>(truth).t.upper;
    }};

constexpr ProbeRow<Ray> kAnyHit{
    row_of<AnyHit>("any_hit", false, false),
    [](const Body& body, const Ray& ray, const RowOptions& options) -> Answer {
      return any_hit(body, ray, {}, limits_of(options));
    },
    [](const Body& body, std::span<const Ray> rays, const RowOptions& options,
       const Limits& limits) {
      return answers_of(any_hit(body, rays, {}, limits_of(options, limits)));
    },
    [](const Body& body, const Ray& ray, const RowOptions&) -> Answer {
      return AnyHit{.hit = reference::closest_hit_by_brute_force(body, ray).triangle.has_value()};
    },
    [](const Answer& cut, const Answer& truth) {
      return !std::get<AnyHit>(cut).hit || std::get<AnyHit>(truth).hit;
    }};

/// One row of `hits`, by itself.
AllHits row_at(const AllHits& hits, std::size_t ray) {
  AllHits row;
  row.coverage = {hits.coverage[ray]};
  row.costs = {hits.costs[ray]};
  row.cost = hits.costs[ray];
  for (std::uint64_t i = hits.offsets[ray]; i < hits.offsets[ray + 1]; ++i) {
    row.lower.push_back(hits.lower[i]);
    row.upper.push_back(hits.upper[i]);
    row.kind.push_back(hits.kind[i]);
    for (std::uint64_t k = hits.triangle_offsets[i]; k < hits.triangle_offsets[i + 1]; ++k) {
      row.triangle.push_back(hits.triangle[k]);
    }
    row.triangle_offsets.push_back(row.triangle.size());
  }
  row.offsets.push_back(row.kind.size());
  return row;
}

constexpr ProbeRow<Ray> kAllHits{
    row_of<AllHits>("all_hits", false, false),
    [](const Body& body, const Ray& ray, const RowOptions& options) -> Answer {
      return all_hits(body, std::array{ray}, {}, limits_of(options));
    },
    [](const Body& body, std::span<const Ray> rays, const RowOptions& options,
       const Limits& limits) {
      const AllHits hits = all_hits(body, rays, {}, limits_of(options, limits));
      BatchAnswer result;
      result.cost = hits.cost;
      for (std::size_t k = 0; k < hits.size(); ++k) {
        result.answers.emplace_back(row_at(hits, k));
      }
      return result;
    },
    [](const Body& body, const Ray& ray, const RowOptions&) -> Answer {
      AllHits truth = reference::all_hits_by_brute_force(body, ray);
      clear_cost(truth);
      return truth;
    },
    [](const Answer& cut, const Answer& truth) {
      const auto& found = std::get<AllHits>(cut).triangle;
      const auto& all = std::get<AllHits>(truth).triangle;
      return std::all_of(found.begin(), found.end(), [&](TriangleId triangle) {
        return std::find(all.begin(), all.end(), triangle) != all.end();
      });
    }};

constexpr std::array kPointRows{kClosest, kSignedClosest, kContains};
constexpr std::array kRayRows{kClosestHit, kAnyHit, kAllHits};

/// What is between two points.
Vec3 between(const Vec3& a, const Vec3& b) {
  return {a.x + 0.5 * (b.x - a.x), a.y + 0.5 * (b.y - a.y), a.z + 0.5 * (b.z - a.z)};
}

void add_points(const Triangle& triangle, std::vector<Vec3>& points) {
  const Vec3& corner = triangle.a;
  const Vec3 edge = between(triangle.b, triangle.c);
  points.insert(points.end(), {corner, edge, between(corner, edge),
                               Vec3{std::nextafter(corner.x, kInfinity), corner.y, corner.z}});
}

bool is_allowed(const Vec3& point) {
  return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) <= kMaxCoordinate;
}

/// A direction may be tiny, but not zero.
void add_ray(const Vec3& from, const Vec3& to, double length, std::vector<Ray>& rays) {
  const Ray ray{from, to - from, length};
  if (ray.direction != Vec3{} && is_allowed(from)) {
    rays.push_back(ray);
  }
}

}  // namespace

template <>
std::span<const ProbeRow<Vec3>> probe_table<Vec3>() {
  return kPointRows;
}

template <>
std::span<const ProbeRow<Ray>> probe_table<Ray>() {
  return kRayRows;
}

Probes probes_of(const Body& body, std::size_t count) {
  const MeshView& mesh = body.shape.mesh();
  Box box;
  for (const Vec3& v : mesh.vertices) {
    box.grow(body.pose.apply(v));
  }
  const Vec3 middle = mesh.vertices.empty() ? Vec3{} : box.center();
  const Vec3 size = mesh.vertices.empty() ? Vec3{1, 1, 1} : box.extent();
  Probes probes{.points = {middle, middle + 3.0 * size, middle - 1e6 * size}, .rays = {}};
  const Vec3 outside = middle - Vec3{2 * size.x, 0.25 * size.y, 0.125 * size.z};
  const std::size_t triangles = mesh.triangles.size();
  const std::size_t step = std::max<std::size_t>(1, triangles / std::max<std::size_t>(count, 1));
  for (std::size_t i = 0; i < triangles && i < count * step; i += step) {
    Triangle triangle = mesh.triangle(static_cast<TriangleId>(i));
    for (Vec3* corner : {&triangle.a, &triangle.b, &triangle.c}) {
      *corner = body.pose.apply(*corner);
    }
    const std::size_t first = probes.points.size();
    add_points(triangle, probes.points);
    const Vec3& corner = probes.points[first];
    const Vec3& edge = probes.points[first + 1];
    const Vec3& face = probes.points[first + 2];
    add_ray(outside, corner, kInfinity, probes.rays);
    add_ray(outside, edge, 1, probes.rays);
    add_ray(middle, face, kInfinity, probes.rays);
    add_ray(corner, edge, kInfinity, probes.rays);
    add_ray({corner.x - 4 * size.x, corner.y, corner.z}, corner, 1, probes.rays);
    add_ray({face.x, face.y, face.z + 4 * size.z}, face, kInfinity, probes.rays);
  }
  add_ray(outside, outside - size, kInfinity, probes.rays);
  std::erase_if(probes.points, [](const Vec3& point) { return !is_allowed(point); });
  return probes;
}

}  // namespace soms::test
