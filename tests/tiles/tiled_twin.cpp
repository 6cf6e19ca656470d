#include "tests/tiles/tiled_twin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace soms::test {

namespace {

/// The first entry of two columns that differs, as "NAME 3"; empty if there is none.
template <class T>
std::string first_other(const std::string& name, const T& tiled, const T& whole) {
  if (tiled.size() != whole.size()) {
    return name + ": other sizes";
  }
  const auto at = std::mismatch(tiled.begin(), tiled.end(), whole.begin()).first;
  return at == tiled.end() ? "" : name + " " + std::to_string(at - tiled.begin());
}

std::string first_of(const std::vector<std::string>& found) {
  const auto at =
      std::find_if(found.begin(), found.end(), [](const auto& x) { return !x.empty(); });
  return at == found.end() ? "" : *at;
}

/// A pair that is named must be one, though any will do.
std::string wrong_pair(const OverlapBatch& any, const OverlapBatch& all) {
  for (std::size_t k = 0; k < any.size(); ++k) {
    const auto pairs = all.pairs_of(k);
    if (any.any[k] != 0 &&
        !std::binary_search(pairs.begin(), pairs.end(), any.pairs_of(k).front())) {
      return "overlap any: pair of " + std::to_string(k);
    }
  }
  return "";
}

std::string overlaps_differ(const TiledQuestions& q, const TiledBody& tiles, const Body& whole,
                            const Limits& limits) {
  const OverlapBatch all = overlap(q.mover, q.poses, whole);
  std::vector<std::string> found;
  for (const OverlapMode mode : {OverlapMode::all, OverlapMode::any, OverlapMode::first}) {
    const OverlapOptions options{.mode = mode};
    const OverlapBatch one = overlap(q.mover, q.poses, whole, options);
    const OverlapBatch many = overlap(q.mover, q.poses, tiles, options, limits);
    const std::string name = "overlap " + std::to_string(static_cast<int>(mode)) + " ";
    found.push_back(first_other(name + "any", many.any, one.any));
    found.push_back(first_other(name + "coverage", many.coverage, one.coverage));
    found.push_back(first_other(name + "offsets", many.offsets, one.offsets));
    found.push_back(mode == OverlapMode::any ? wrong_pair(many, all)
                                             : first_other(name + "pairs", many.pairs, one.pairs));
  }
  return first_of(found);
}

std::string distances_differ(const TiledQuestions& q, const TiledBody& tiles, const Body& whole,
                             double at_most, const Limits& limits) {
  const DistanceBatch one = distance(q.mover, q.poses, whole, {.at_most = at_most});
  const DistanceBatch many = distance(q.mover, q.poses, tiles, {.at_most = at_most}, limits);
  return first_of({first_other("distance lower", many.lower, one.lower),
                   first_other("distance upper", many.upper, one.upper),
                   first_other("distance triangles", many.triangles, one.triangles),
                   first_other("distance point_a", many.point_a, one.point_a),
                   first_other("distance point_b", many.point_b, one.point_b),
                   first_other("distance farther", many.farther, one.farther),
                   first_other("distance coverage", many.coverage, one.coverage)});
}

std::string withins_differ(const TiledQuestions& q, const TiledBody& tiles, const Body& whole,
                           const Limits& limits) {
  const DistanceBatch distances = distance(q.mover, q.poses, whole);
  std::vector<std::string> found;
  for (const double clearance : {0.0, q.at_most}) {
    const WithinBatch one = within(q.mover, q.poses, whole, clearance);
    const WithinBatch many = within(q.mover, q.poses, tiles, clearance, limits);
    found.push_back(first_other("within", many.within, one.within));
    found.push_back(first_other("within at_least", many.at_least, one.at_least));
    found.push_back(first_other("within coverage", many.coverage, one.coverage));
    for (std::size_t k = 0; k < many.size(); ++k) {
      if (many.triangles[k].has_value() != (many.within[k] != 0)) {
        found.push_back("within: pair of " + std::to_string(k));
      } else if (many.triangles[k]) {
        // The pair that is named is as near as that.
        const Mesh a = extract(q.mover.mesh(), std::array{many.triangles[k]->a});
        const Mesh b = extract(whole.shape.mesh(), std::array{many.triangles[k]->b});
        if (!within(Body(a, q.poses[k]), Body(b, whole.pose), clearance).within) {
          found.push_back("within: a pair that is farther, at " + std::to_string(k));
        }
      }
    }
  }
  return first_of(found);
}

std::string points_differ(const TiledQuestions& q, const TiledBody& tiles, const Body& whole,
                          double at_most, const Limits& limits) {
  const ClosestBatch one = closest(whole, q.points, {.at_most = at_most});
  const ClosestBatch many = closest(tiles, q.points, {.at_most = at_most}, limits);
  return first_of({first_other("closest lower", many.lower, one.lower),
                   first_other("closest upper", many.upper, one.upper),
                   first_other("closest triangle", many.triangle, one.triangle),
                   first_other("closest point", many.point, one.point),
                   first_other("closest feature", many.feature, one.feature),
                   first_other("closest farther", many.farther, one.farther),
                   first_other("closest coverage", many.coverage, one.coverage)});
}

template <class Line>
std::string lines_differ(const std::vector<Line>& lines, const TiledBody& tiles, const Body& whole,
                         const RayOptions& options, const Limits& limits) {
  const std::span<const Line> rows(lines);
  const ClosestHitBatch one = closest_hit(whole, rows, options);
  const ClosestHitBatch many = closest_hit(tiles, rows, options, limits);
  const AnyHitBatch any = any_hit(whole, rows, options);
  const AnyHitBatch any_of_tiles = any_hit(tiles, rows, options, limits);
  return first_of({first_other("ray lower", many.lower, one.lower),
                   first_other("ray upper", many.upper, one.upper),
                   first_other("ray triangle", many.triangle, one.triangle),
                   first_other("ray point", many.point, one.point),
                   first_other("ray front", many.front, one.front),
                   first_other("ray coverage", many.coverage, one.coverage),
                   first_other("ray any", any_of_tiles.hit, any.hit),
                   first_other("ray any coverage", any_of_tiles.coverage, any.coverage)});
}

Vec3 point_in(Rng& rng, const Box& box) {
  Vec3 point;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    point[axis] = rng.uniform(box.lower[axis], box.upper[axis]);
  }
  return point;
}

}  // namespace

TileSet tiles_of(const std::filesystem::path& folder, std::span<const Mesh> meshes,
                 const CutOptions& options, const TileOptions& opening) {
  TileCutter cutter(folder, options);
  for (const Mesh& mesh : meshes) {
    cutter.add(mesh);
  }
  cutter.finish();
  return TileSet::open(folder, opening);
}

Mesh unstated(Mesh mesh) {
  mesh.unit = 0;
  mesh.up = UpAxis::unknown;
  mesh.georeference = {};
  return mesh;
}

Mesh whole_of(std::span<const Mesh> meshes) {
  Mesh whole;
  for (const Mesh& mesh : meshes) {
    append(whole, mesh);
  }
  return whole;
}

TiledQuestions random_questions(Rng& rng, Shape mover, const Box& box, std::size_t rows) {
  TiledQuestions q{.mover = std::move(mover)};
  const Vec3 size = box.empty() ? Vec3{1, 1, 1} : box.extent();
  Box around = box.empty() ? Box{{0, 0, 0}, {1, 1, 1}} : box;
  around.grow(around.lower - 0.1 * size);
  around.grow(around.upper + 0.1 * size);
  q.at_most = 0.05 * (size.x + size.y + size.z);
  for (std::size_t k = 0; k < rows; ++k) {
    q.poses.push_back(Pose::about_z(rng.uniform(0, 6), point_in(rng, around)));
    q.points.push_back(point_in(rng, around));
    const Vec3 to = point_in(rng, around);
    q.segments.push_back(Ray::between(q.points.back(), to));
    q.rays.push_back({q.points.back(), to - q.points.back(),
                      rng.below(2) == 0 ? std::numeric_limits<double>::infinity() : 1.0});
  }
  return q;
}

std::string difference(const TiledQuestions& q, const TiledBody& tiles, const Body& whole,
                       const Limits& limits) {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  RayOptions skip;
  if (!whole.shape.mesh().triangles.empty()) {
    skip.skip = static_cast<TriangleId>(whole.shape.mesh().triangles.size() / 2);
  }
  return first_of({overlaps_differ(q, tiles, whole, limits),
                   distances_differ(q, tiles, whole, kUnlimited, limits),
                   distances_differ(q, tiles, whole, q.at_most, limits),
                   withins_differ(q, tiles, whole, limits),
                   points_differ(q, tiles, whole, kUnlimited, limits),
                   points_differ(q, tiles, whole, q.at_most, limits),
                   lines_differ(q.rays, tiles, whole, {}, limits),
                   lines_differ(q.rays, tiles, whole, skip, limits),
                   lines_differ(q.segments, tiles, whole, {}, limits)});
}

ErrorKind kind_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "no error";
  return {};
}

}  // namespace soms::test
