// Queries of points and rays in a scene, against a loop over its bodies, while it changes.
#include "soms/base/error.h"
#include "soms/scene/print.h"
#include "soms/scene/reference/body_queries.h"
#include "soms/scene/scene.h"

#include "tests/scene/many_bodies.h"
#include "tests/scene/random_bodies.h"
#include "tests/scene/scenes.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

namespace soms {
namespace {

/// The bodies of a scene in their order, and their names.
struct Listed {
  std::vector<Body> bodies;
  std::vector<SceneBody> names;
};

/// A body that takes no part is there without triangles.
Listed listed(const Scene& scene, const SceneFilter& filter) {
  Listed list;
  const auto add = [&](const SceneBody& name, const Body& body, bool takes_part) {
    list.bodies.push_back(takes_part && name != filter.except ? body : Body());
    list.names.push_back(name);
  };
  for (const EnvironmentId id : scene.environments()) {
    add({SceneBodyKind::environment, id}, scene.environment(id), filter.environment);
  }
  for (const MoverId id : scene.movers()) {
    add({SceneBodyKind::mover, id}, scene.mover(id), filter.movers);
  }
  return list;
}

SceneClosest closest_by_loop(const Scene& scene, const Vec3& point, const SceneFilter& filter) {
  const Listed list = listed(scene, filter);
  const BodyClosest found = reference::closest_by_brute_force(list.bodies, point);
  SceneClosest answer{found, found.body ? std::optional(list.names[*found.body]) : std::nullopt};
  answer.cost = {};
  return answer;
}

SceneHit first_hit_by_loop(const Scene& scene, const Ray& ray, const SceneFilter& filter) {
  const Listed list = listed(scene, filter);
  const BodyHit found = reference::closest_hit_by_brute_force(list.bodies, ray);
  SceneHit answer{found, found.body ? std::optional(list.names[*found.body]) : std::nullopt};
  answer.cost = {};
  return answer;
}

/// Any body of the scene, or none.
std::optional<SceneBody> some_body(const Scene& scene, Rng& rng) {
  const bool part = rng.below(2) == 0;
  const std::vector<std::uint32_t> ids = part ? scene.environments() : scene.movers();
  if (ids.empty() || rng.below(2) == 0) {
    return std::nullopt;
  }
  return SceneBody{part ? SceneBodyKind::environment : SceneBodyKind::mover,
                   ids[rng.below(ids.size())]};
}

SceneFilter some_filter(const Scene& scene, Rng& rng) {
  return {.environment = rng.below(4) != 0,
          .movers = rng.below(4) != 0,
          .except = some_body(scene, rng)};
}

std::vector<Vec3> some_points(const Scene& scene, Rng& rng) {
  const Listed list = listed(scene, {});
  std::vector<Vec3> points;
  for (int k = 0; k < 3; ++k) {
    points.push_back(test::point_among(list.bodies, rng));
  }
  return points;
}

void check_points(const Scene& scene, Rng& rng) {
  const SceneFilter filter = some_filter(scene, rng);
  const std::vector<Vec3> points = some_points(scene, rng);
  const SceneClosestBatch batch = scene.closest(points, {}, filter, {.threads = 2});
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(batch.at(i), scene.closest(points[i], {}, filter));
    SceneClosest answer = batch.at(i);
    answer.cost = {};
    ASSERT_EQ(answer, closest_by_loop(scene, points[i], filter)) << filter;
  }
}

void check_rays(const Scene& scene, Rng& rng) {
  const SceneFilter filter = some_filter(scene, rng);
  const Listed list = listed(scene, {});
  std::vector<Ray> rays;
  for (int k = 0; k < 3; ++k) {
    rays.push_back(test::ray_among(list.bodies, rng));
  }
  const SceneHitBatch batch = scene.closest_hit(rays, {}, filter, {.threads = 2});
  const AnyHitBatch any = scene.any_hit(rays, {}, filter, {.threads = 2});
  const SceneAllHits all = scene.all_hits(rays, {}, filter, {.threads = 2});
  ASSERT_EQ(all, scene.all_hits(rays, {}, filter));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(batch.at(i), scene.closest_hit(rays[i], {}, filter));
    ASSERT_EQ(any.at(i), scene.any_hit(rays[i], {}, filter));
    SceneHit answer = batch.at(i);
    answer.cost = {};
    ASSERT_EQ(answer, first_hit_by_loop(scene, rays[i], filter)) << filter;
    ASSERT_EQ(any.hit[i] != 0, answer.triangle.has_value());
    // The first crossing is the first hit.
    ASSERT_EQ(all.offsets[i] != all.offsets[i + 1], answer.triangle.has_value());
    if (answer.triangle) {
      ASSERT_EQ(all.body[all.offsets[i]], answer.body);
      ASSERT_EQ(all.lower[all.offsets[i]], answer.t.lower);
      ASSERT_EQ(all.triangle[all.triangle_offsets[all.offsets[i]]], answer.triangle);
    }
  }
}

/// Changes one thing that queries see.
void change(Scene& scene, Rng& rng) {
  const auto any_of = [&](const std::vector<std::uint32_t>& ids) {
    return ids[rng.below(ids.size())];
  };
  const std::vector<MoverId> movers = scene.movers();
  const std::vector<EnvironmentId> parts = scene.environments();
  const Shape shape(test::random_mesh(rng));
  switch (rng.below(7)) {
    case 0:
      scene.add_mover(Body(shape, test::random_pose(rng, 8)));
      break;
    case 1:
      scene.add_environment(Body(shape, test::random_pose(rng, 8)));
      break;
    case 2:
      if (!movers.empty()) {
        scene.remove_mover(any_of(movers));
      }
      break;
    case 3:
      if (!parts.empty()) {
        scene.remove_environment(any_of(parts));
      }
      break;
    case 4:
      if (!movers.empty()) {
        scene.set_shape(any_of(movers), shape);
      }
      break;
    case 5:
      if (!parts.empty()) {
        scene.set_environment_shape(any_of(parts), shape);
      }
      break;
    default:
      for (const MoverId id : movers) {
        scene.set_pose(id, test::random_pose(rng, 8));
      }
  }
}

TEST(SceneQuery, AnEmptySceneHasNothingNear) {
  const Scene scene;
  const SceneClosest answer = scene.closest({1, 2, 3});
  EXPECT_EQ(answer.body, std::nullopt);
  EXPECT_EQ(answer.triangle, std::nullopt);
  EXPECT_FALSE(answer.farther);
}

TEST(SceneQuery, PartsAreBeforeMoversAmongEquallyNearBodies) {
  Scene scene;
  const Shape cube(test::box_body({0, 0, 0}, {1, 1, 1}));
  const Vec3 point{2, 0.5, 0.5};
  const MoverId first = scene.add_mover(Body(cube));
  const MoverId second = scene.add_mover(Body(cube));
  EXPECT_EQ(scene.closest(point).body, (SceneBody{SceneBodyKind::mover, first}));
  const EnvironmentId part = scene.add_environment(Body(cube));
  EXPECT_EQ(scene.closest(point).body, (SceneBody{SceneBodyKind::environment, part}));
  scene.remove_environment(part);
  scene.remove_mover(first);
  EXPECT_EQ(scene.closest(point).body, (SceneBody{SceneBodyKind::mover, second}));
}

TEST(SceneQuery, SeesAMoverWhereItIsNow) {
  Scene scene;
  const Shape cube(test::box_body({0, 0, 0}, {1, 1, 1}));
  const MoverId mover = scene.add_mover(Body(cube, Pose::translation(-900, 0, 0)));
  scene.add_mover(Body(cube, Pose::translation(20, 0, 0)));
  const Vec3 point{9, 0.5, 0.5};
  EXPECT_EQ(scene.closest(point).distance, (Bracket{11, 11}));
  scene.set_pose(mover, Pose::translation(9.5, 0, 0));
  EXPECT_EQ(scene.closest(point).distance, (Bracket{0.5, 0.5}));
  scene.set_shape(mover, Shape(test::box_body({2, 0, 0}, {3, 1, 1})));
  EXPECT_EQ(scene.closest(point).distance, (Bracket{2.5, 2.5}));
  scene.remove_mover(mover);
  EXPECT_EQ(scene.closest(point).distance, (Bracket{11, 11}));
}

TEST(SceneQuery, TheMoverThatLooksCanBeLeftOut) {
  Scene scene;
  const Shape cube(test::box_body({0, 0, 0}, {1, 1, 1}));
  const MoverId looks = scene.add_mover(Body(cube));
  const EnvironmentId wall = scene.add_environment(Body(cube, Pose::translation(5, 0, 0)));
  const Vec3 eye{0.5, 0.5, 0.5};
  const SceneBody itself{SceneBodyKind::mover, looks};
  EXPECT_EQ(scene.closest(eye).body, itself);
  EXPECT_EQ(scene.closest(eye, {}, {.except = itself}).body,
            (SceneBody{SceneBodyKind::environment, wall}));
  EXPECT_EQ(scene.closest(eye, {}, {.environment = false, .except = itself}).body, std::nullopt);
  const Ray ahead{eye, {1, 0, 0}};
  EXPECT_EQ(scene.closest_hit(ahead).body, itself);
  EXPECT_EQ(scene.closest_hit(ahead, {}, {.except = itself}).t, (Bracket{4.5, 4.5}));
  EXPECT_TRUE(scene.any_hit(Ray::between(eye, {5, 0.5, 0.5}), {}, {.except = itself}).hit);
  EXPECT_FALSE(scene.any_hit(Ray::between(eye, {4, 0.5, 0.5}), {}, {.except = itself}).hit);
  EXPECT_FALSE(scene.any_hit(ahead, {}, {.environment = false, .except = itself}).hit);
  scene.remove_mover(looks);
  EXPECT_THROW((void)scene.closest(eye, {}, {.except = itself}), Error);
}

// What is proved when time is up holds for movers, too, which are searched after the parts.
TEST(SceneQuery, ADeadlineIsProvedOfPartsAndMovers) {
  Scene scene;
  const Shape cube(test::box_body({0, 0, 0}, {1, 1, 1}));
  scene.add_environment(Body(cube, Pose::translation(8, 0, 0)));
  scene.add_mover(Body(cube, Pose::translation(1, 0, 0)));
  const auto past = std::chrono::steady_clock::time_point::min();
  const SceneClosest near = scene.closest({0, 0.5, 0.5}, {}, {}, {.deadline = past});
  EXPECT_EQ(near.coverage, Coverage::cut);
  EXPECT_LE(near.distance.lower, 1);
  EXPECT_GE(near.distance.upper, 1);
  const SceneHit first =
      scene.closest_hit(Ray{{0, 0.5, 0.5}, {1, 0, 0}}, {}, {}, {.deadline = past});
  EXPECT_EQ(first.coverage, Coverage::cut);
  EXPECT_LE(first.t.lower, 1);
  EXPECT_GE(first.t.upper, 1);
}

TEST(SceneQuery, AnswersAsALoopOverAllBodiesWhileItChanges) {
  test::for_each_case("scene/query", 60, [](Rng& rng) {
    Scene scene = test::random_scene(rng, 8, rng.below(12), rng.below(12));
    for (int k = 0; k < 12; ++k) {
      check_points(scene, rng);
      check_rays(scene, rng);
      change(scene, rng);
      if (rng.below(4) == 0) {
        Scene moved = std::move(scene);
        scene = std::move(moved);
      }
    }
  });
}

// What a query builds is of no consequence to steps, nor the other way round.
TEST(SceneQuery, StepsAndQueriesDoNotDisturbEachOther) {
  test::for_each_case("scene/query/steps", 40, [](Rng& rng) {
    Scene scene = test::random_scene(rng, 6, 1 + rng.below(10), rng.below(10));
    for (int k = 0; k < 4; ++k) {
      const StepReport report = scene.step();
      ASSERT_EQ(report.hash(), test::scan(scene).hash());
      check_points(scene, rng);
      check_rays(scene, rng);
      change(scene, rng);
    }
  });
}

}  // namespace
}  // namespace soms
