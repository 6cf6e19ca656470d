#include "soms/generate/shapes.h"
#include "soms/generate/urban.h"

#include "apps/view/scene/load.h"
#include "apps/view/scene/view_scene.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace soms::view {
namespace {

/// Distance along a ray to a triangle, or infinity; by the formula of Moeller and Trumbore.
double cast(const Ray& ray, const Triangle& t) {
  const Vec3 e1 = t.b - t.a;
  const Vec3 e2 = t.c - t.a;
  const Vec3 p = cross(ray.direction, e2);
  const double det = dot(e1, p);
  const Vec3 s = ray.origin - t.a;
  const double u = dot(s, p) / det;
  const Vec3 q = cross(s, e1);
  const double v = dot(ray.direction, q) / det;
  const double d = dot(e2, q) / det;
  const bool hit = u >= 0 && v >= 0 && u + v <= 1 && d >= 0;
  return hit ? d : std::numeric_limits<double>::infinity();
}

double cast(const ViewScene& scene, const Ray& ray) {
  double least = std::numeric_limits<double>::infinity();
  const auto look_at = [&](BodyRef body) {
    for (TriangleId i = 0; i < scene.body(body).shape.mesh().triangles.size(); ++i) {
      least = std::min(least, cast(ray, scene.triangle(body, i)));
    }
  };
  look_at(city_part(0));
  look_at(mover(0));
  return least;
}

Vec3 unit(Rng& rng) {
  for (;;) {
    const Vec3 v{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const double length = std::sqrt(dot(v, v));
    if (length > 0.1 && length < 1) {
      return v * (1 / length);
    }
  }
}

void expect_as_brute_force(const ViewScene& scene, const Vec3& middle, double reach,
                           std::string_view tag) {
  std::size_t hits = 0;
  test::for_each_case(tag, 400, [&](Rng& rng) {
    const Vec3 target = middle + unit(rng) * (0.5 * reach * rng.unit());
    const Vec3 origin = middle + unit(rng) * (2 * reach);
    const Vec3 d = target - origin;
    const Ray ray{origin, d * (1 / std::sqrt(dot(d, d)))};
    const double expected = cast(scene, ray);
    const std::optional<Picked> picked = scene.pick(ray);
    ASSERT_EQ(picked.has_value(), std::isfinite(expected));
    if (picked) {
      ++hits;
      ASSERT_NEAR(picked->distance, expected, 1e-9 * reach);
      ASSERT_NEAR(cast(ray, picked->corners), expected, 1e-9 * reach);
      ASSERT_EQ(picked->corners, scene.triangle(picked->body, picked->triangle));
    }
  });
  EXPECT_GT(hits, 100U);
}

TEST(Pick, FindsWhatBruteForceFinds) {
  ViewScene scene(two_bodies(Body(generate_knot(600)), Body(generate_sphere(200))));
  scene.set_pose(0, Pose::about_z(0.7, {0.8, 0.3, 0.4}));
  expect_as_brute_force(scene, {0.4, 0.1, 0}, 2, "pick/near");
}

TEST(Pick, IsAsSureFarFromTheOrigin) {
  const auto far = [](const Vec3& v) { return v + Vec3{1'234'567, 7'654'321, 100}; };
  ViewScene scene(two_bodies(Body(test::mapped(generate_knot(600), far)),
                             Body(test::mapped(generate_sphere(200), far))));
  scene.set_pose(0, Pose::translation(0.5, 0.25, 0.125));
  // Coordinates are multiples of 1e-9 there, so rays are distinguished by more than that.
  std::size_t hits = 0;
  test::for_each_case("pick/far", 200, [&](Rng& rng) {
    const Vec3 origin = far(unit(rng) * 3.0);
    const Vec3 d = far(unit(rng) * 0.5) - origin;
    const Ray ray{origin, d * (1 / std::sqrt(dot(d, d)))};
    const double expected = cast(scene, ray);
    const std::optional<Picked> picked = scene.pick(ray);
    if (std::isfinite(expected)) {
      ASSERT_TRUE(picked.has_value());
      ASSERT_NEAR(picked->distance, expected, 1e-6);
      ++hits;
    }
  });
  EXPECT_GT(hits, 100U);
}

TEST(Pick, TellsPartVerticesAndContacts) {
  Mesh house =
      test::joined(test::box_body({0, 0, 0}, {4, 4, 1}), test::box_body({0, 0, 1}, {4, 4, 3}));
  house.parts = {{"house", Part::kNoParent, 0, 24}, {"floor", 0, 0, 12}, {"upper", 0, 12, 12}};
  Body body(std::move(house));
  body.name = "house";
  Body ball(test::box_body({0, 0, 0}, {1, 1, 1}));
  ball.name = "block";
  ViewScene scene(two_bodies(std::move(body), std::move(ball)));
  scene.set_pose(0, Pose::translation(-0.5, 1, 1.5));
  const std::optional<Picked> picked = scene.pick({{-9, 1.5, 2.9}, {1, 0, 0}});
  ASSERT_TRUE(picked.has_value());
  EXPECT_EQ(picked->body, city_part(0));
  EXPECT_EQ(picked->part_name, "upper");
  EXPECT_EQ(picked->point, (Vec3{0, 1.5, 2.9}));
  EXPECT_EQ(picked->distance, 9);
  EXPECT_EQ(picked->vertices, scene.body(city_part(0)).shape.mesh().triangles[picked->triangle]);
  EXPECT_FALSE(picked->touches.empty());
  for (const Touch& touch : picked->touches) {
    EXPECT_EQ(touch.j, picked->triangle);
    EXPECT_EQ(touch.b, city_part(0));
  }
  EXPECT_NE(picked->explanation.find("part upper"), std::string::npos);
  EXPECT_NE(picked->explanation.find("block"), std::string::npos);
  EXPECT_FALSE(scene.pick({{-9, 1.5, 2.9}, {-1, 0, 0}}).has_value());
}

TEST(Pick, NamesTrianglesAndVerticesAsTheFileDoes) {
  SceneContent content;
  content.city.emplace_back(Shape(test::soup_body({{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}})));
  content.city.back().name = "sheet";
  content.numbers.triangles = {command::FileNumbers({41})};
  content.numbers.vertices = {command::FileNumbers({5, 70, 900})};
  const ViewScene scene(std::move(content));
  const std::optional<Picked> picked = scene.pick({{0, 0, 5}, {0, 0, -1}});
  ASSERT_TRUE(picked.has_value());
  EXPECT_EQ(picked->triangle, 0U) << "of the shape";
  EXPECT_EQ(scene.numbers().triangle(picked->body, 0), 41U);
  EXPECT_EQ(picked->vertices, (std::array<std::uint32_t, 3>{5, 70, 900}));
  EXPECT_NE(picked->explanation.find("sheet, triangle 41 "), std::string::npos)
      << picked->explanation;
  EXPECT_NE(picked->explanation.find("vertices 5, 70, 900"), std::string::npos);
}

TEST(Pick, FindsNothingInAnEmptyScene) {
  EXPECT_FALSE(ViewScene(SceneContent{}).pick({{0, 0, 0}, {0, 0, 1}}).has_value());
}

/// Least tangent of the angle between a ray and 10,001 points along the outline of a crossing.
double sampled_slope(const Ray& ray, const CommonPoints& crossing) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < crossing.count; ++k) {
    const Vec3 a = crossing.corners[k];
    const Vec3 along = crossing.corners[(k + 1) % crossing.count] - a;
    for (int n = 0; n <= 10'000; ++n) {
      const Vec3 d = a + along * (n / 10'000.0) - ray.origin;
      const double ahead = dot(d, ray.direction);
      const Vec3 beside = d - ray.direction * ahead;
      least = std::min(least, std::sqrt(dot(beside, beside)) / ahead);
    }
  }
  return least;
}

TEST(Pick, FindsTheContactThatIsSeenNearestToTheRay) {
  ViewScene scene(two_bodies(Body(generate_knot(600)), Body(generate_sphere(200))));
  scene.set_pose(0, Pose::about_z(0.7, {0.8, 0.3, 0.4}));
  ASSERT_GT(scene.contacts().size(), 20U);
  const Vec3 eye{6, -7, 5};
  for (const Touch& touch : scene.contacts()) {
    const CommonPoints crossing = scene.common_points(touch);
    const Vec3 middle = (crossing.corners[0] + crossing.corners[crossing.count - 1]) * 0.5;
    const Vec3 d = middle - eye;
    const Ray ray{eye, d * (1 / std::sqrt(dot(d, d)))};
    const std::optional<Touch> found = scene.pick_contact(ray, 0.01);
    ASSERT_TRUE(found.has_value());
    // Another may lie behind it on the ray, but none is farther off.
    EXPECT_LT(sampled_slope(ray, scene.common_points(*found)), 1e-5);
    EXPECT_FALSE(scene.pick_contact({eye, ray.direction * -1.0}, 0.01).has_value());
  }
  EXPECT_FALSE(scene.pick_contact({{50, 50, 50}, {0, 0, 1}}, 0.01).has_value());
}

}  // namespace
}  // namespace soms::view
