// The first hit of rays and segments on many bodies, against a loop over all bodies.
#include "soms/base/error.h"
#include "soms/scene/body_index.h"
#include "soms/scene/print.h"
#include "soms/scene/reference/body_queries.h"

#include "tests/scene/many_bodies.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace soms {
namespace {

BodyHit without_work(BodyHit answer) {
  answer.cost = {};
  return answer;
}

/// A triangle across the x axis, met there at `x`.
Body screen_at(double x) {
  return Body(test::soup_body({{{x, -9, -9}, {x, 9, -9}, {x, 0, 9}}}));
}

TEST(BodyHit, NamesBodyAndTriangle) {
  const std::vector<Body> bodies{screen_at(8), Body(), screen_at(4), screen_at(6)};
  const BodyIndex index(bodies);
  const BodyHit first = index.closest_hit(Ray{{0, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(first.body, 2U);
  EXPECT_EQ(first.triangle, 0U);
  EXPECT_EQ(first.t, (Bracket{2, 2}));
  EXPECT_EQ(first.point, (Vec3{4, 0, 0}));
  EXPECT_EQ(index.closest_hit(Ray::between({7, 0, 0}, {5, 0, 0})).body, 3U);
  EXPECT_EQ(index.closest_hit(Ray{{9, 0, 0}, {1, 0, 0}}).body, std::nullopt);
  EXPECT_FALSE(index.any_hit(Ray{{0, 0, 0}, {1, 0, 0}, 3.5}).hit);
  EXPECT_TRUE(index.any_hit(Ray{{0, 0, 0}, {1, 0, 0}, 4}).hit);
}

TEST(BodyHit, WithoutTrianglesThereIsNone) {
  for (const std::vector<Body>& bodies : {std::vector<Body>(), std::vector<Body>(3)}) {
    const BodyIndex index(bodies);
    EXPECT_EQ(index.closest_hit(Ray{{0, 0, 0}, {1, 0, 0}}), BodyHit());
    EXPECT_EQ(index.any_hit(Ray{{0, 0, 0}, {1, 0, 0}}), AnyHit());
  }
}

TEST(BodyHit, HitsAtTheSameTimeAreDecidedByNumber) {
  const std::vector<Body> bodies{screen_at(5), screen_at(4), screen_at(3), screen_at(4),
                                 screen_at(3)};
  const BodyIndex index(bodies);
  EXPECT_EQ(index.closest_hit(Ray{{0, 0, 0}, {1, 0, 0}}).body, 2U);
  EXPECT_EQ(index.closest_hit(Ray::between({4.5, 0, 0}, {3.5, 0, 0})).body, 1U);
}

// Where no double is the time, brackets of all are alike, and only exact numbers decide.
TEST(BodyHit, TimesBetweenTheSameDoublesAreCompared) {
  const double near = 7.9;
  const double next = std::nextafter(near, 9.0);
  const std::vector<Body> bodies{screen_at(next), screen_at(near), screen_at(next),
                                 screen_at(near)};
  const Ray ray{{0, 0, 0}, {7.7, 0, 0}};
  const Ray segment = Ray::between({0, 0, 0}, {15.4, 0, 0});
  ASSERT_EQ(closest_hit(bodies[0], ray).t, closest_hit(bodies[1], ray).t);
  ASSERT_EQ(closest_hit(bodies[0], segment).t, closest_hit(bodies[1], segment).t);
  ASSERT_LT(closest_hit(bodies[0], segment).t.lower, closest_hit(bodies[0], segment).t.upper);
  const BodyIndex index(bodies);
  EXPECT_EQ(index.closest_hit(segment).body, 1U);
  EXPECT_EQ(index.closest_hit(ray).body, 1U);
}

/// One row of `hits`, by itself and without costs.
BodyAllHits hits_of_line(const BodyAllHits& hits, std::size_t line) {
  BodyAllHits row;
  for (std::uint64_t i = hits.offsets[line]; i < hits.offsets[line + 1]; ++i) {
    row.lower.push_back(hits.lower[i]);
    row.upper.push_back(hits.upper[i]);
    row.kind.push_back(hits.kind[i]);
    row.body.push_back(hits.body[i]);
    for (std::uint64_t k = hits.triangle_offsets[i]; k < hits.triangle_offsets[i + 1]; ++k) {
      row.triangle.push_back(hits.triangle[k]);
    }
    row.triangle_offsets.push_back(row.triangle.size());
  }
  row.offsets.push_back(row.kind.size());
  row.coverage = {hits.coverage[line]};
  row.costs.resize(1);
  return row;
}

TEST(BodyAllHits, AreInTheOrderOfTheRayAndThenOfBodies) {
  // Bodies 1 and 3 at the same place; body 0 is a box whose far face is there, too.
  const std::vector<Body> bodies{Body(test::box_body({2, -1, -1}, {4, 1, 1})), screen_at(4),
                                 screen_at(6), screen_at(4), screen_at(1)};
  const BodyIndex index(bodies);
  const std::vector<Ray> rays{
      {{0, 0.25, 0.125}, {1, 0, 0}}, {{0, 0, 50}, {1, 0, 0}}, {{5, 0.25, 0.125}, {-1, 0, 0}, 3}};
  const BodyAllHits hits = index.all_hits(rays);
  EXPECT_EQ(hits.offsets, (std::vector<std::uint64_t>{0, 6, 6, 10}));
  EXPECT_EQ(hits.body, (std::vector<std::uint32_t>{4, 0, 0, 1, 3, 2, 0, 1, 3, 0}));
  EXPECT_EQ(hits.lower, (std::vector<double>{1, 2, 4, 4, 4, 6, 1, 1, 1, 3}));
  EXPECT_EQ(hits.kind[1], CrossingKind::enter);
  EXPECT_EQ(hits.kind[2], CrossingKind::leave);
  EXPECT_EQ(index.all_hits(rays, {}, {.except = 0}).body,
            (std::vector<std::uint32_t>{4, 1, 3, 2, 1, 3}));
  EXPECT_EQ(index.all_hits(rays, {.skip = 0}, {.except = 4}).body,
            (std::vector<std::uint32_t>{0, 0, 1, 3, 2, 0, 1, 3, 0}));
}

TEST(BodyAllHits, TimesBetweenTheSameDoublesAreCompared) {
  const double near = 7.9;
  const double next = std::nextafter(near, 9.0);
  const std::vector<Body> bodies{screen_at(next), screen_at(near), screen_at(next),
                                 screen_at(near)};
  const std::vector<Ray> segments{Ray::between({0, 0, 0}, {15.4, 0, 0})};
  ASSERT_EQ(closest_hit(bodies[0], segments[0]).t, closest_hit(bodies[1], segments[0]).t);
  EXPECT_EQ(BodyIndex(bodies).all_hits(segments).body, (std::vector<std::uint32_t>{1, 3, 0, 2}));
}

void check_lines(const std::vector<Body>& bodies, const BodyIndex& index,
                 const std::vector<Ray>& lines) {
  const std::span<const Ray> all(lines);
  const BodyHitBatch one = index.closest_hit(all);
  ASSERT_EQ(one, index.closest_hit(all, {}, {}, {.threads = 2}));
  const AnyHitBatch any = index.any_hit(all);
  ASSERT_EQ(any, index.any_hit(all, {}, {}, {.threads = 2}));
  const BodyAllHits hits = index.all_hits(all);
  ASSERT_EQ(hits, index.all_hits(all, {}, {}, {.threads = 2}));
  ASSERT_EQ(hits.size(), lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ASSERT_EQ(hits_of_line(hits, i),
              hits_of_line(reference::all_hits_by_brute_force(bodies, lines[i]), 0));
    const BodyHit truth = reference::closest_hit_by_brute_force(bodies, lines[i]);
    ASSERT_EQ(without_work(one.at(i)), without_work(truth));
    ASSERT_EQ(one.at(i), index.closest_hit(lines[i]));
    ASSERT_EQ(any.at(i), index.any_hit(lines[i]));
    ASSERT_EQ(any.hit[i] != 0, truth.triangle.has_value());
    ASSERT_EQ(any.coverage[i], Coverage::complete);
  }
}

TEST(BodyHit, RaysAnswerAsALoopOverAllBodies) {
  test::for_each_case("scene/body-hit", 300, [](Rng& rng) {
    const std::vector<Body> bodies = test::many_bodies(rng);
    std::vector<Ray> rays;
    for (int k = 0; k < 5; ++k) {
      rays.push_back(test::ray_among(bodies, rng));
    }
    check_lines(bodies, BodyIndex(bodies), rays);
  });
}

TEST(BodyHit, SegmentsAnswerAsALoopOverAllBodies) {
  test::for_each_case("scene/body-hit/segments", 300, [](Rng& rng) {
    const std::vector<Body> bodies = test::many_bodies(rng);
    std::vector<Ray> segments;
    for (int k = 0; k < 5; ++k) {
      const Vec3 from = test::point_among(bodies, rng);
      segments.push_back(Ray::between(from, test::point_among(bodies, rng)));
    }
    segments.push_back(Ray::between(segments[0].origin, segments[0].origin));
    check_lines(bodies, BodyIndex(bodies), segments);
  });
}

TEST(BodyHit, ABodyThatIsLeftOutTakesNoPart) {
  test::for_each_case("scene/body-hit/except", 300, [](Rng& rng) {
    std::vector<Body> bodies = test::many_bodies(rng);
    const BodyIndex index(bodies);
    const Ray ray = test::ray_among(bodies, rng);
    const BodyHit first = index.closest_hit(ray);
    if (!first.body) {
      return;
    }
    const BodyFilter others{.except = first.body};
    // Its triangle alone does not, either.
    const RayOptions beside{.skip = first.triangle};
    Mesh mesh(bodies[*first.body].shape.mesh());
    const Triangle corner = mesh.triangle(0);
    const BodyHit second = index.closest_hit(ray, {}, others);
    const BodyHit next = index.closest_hit(ray, beside, others);
    ASSERT_EQ(index.any_hit(ray, {}, others).hit, second.body.has_value());
    ASSERT_EQ(index.any_hit(ray, beside, others).hit, next.body.has_value());
    // Far away and alone, so that the numbers of the other triangles stay.
    const auto far_corner = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(corner.a + Vec3{0x1p60, 0x1p59, 0x1p58});
    mesh.triangles[*first.triangle] = {far_corner, far_corner, far_corner};
    bodies[*first.body].shape = Shape(mesh);
    ASSERT_EQ(without_work(next), without_work(reference::closest_hit_by_brute_force(bodies, ray)));
    bodies[*first.body] = Body();
    ASSERT_EQ(without_work(second),
              without_work(reference::closest_hit_by_brute_force(bodies, ray)));
  });
}

// What lies behind the first hit is not visited.
TEST(BodyHit, HiddenBodiesCostNothing) {
  const Shape cube(test::box_body({0, 0, 0}, {1, 1, 1}));
  std::vector<Body> bodies;
  for (int k = 0; k < 4096; ++k) {
    bodies.emplace_back(cube, Pose::translation(3.0 * (k % 64), 3.0 * (k / 64), 0));
  }
  const BodyIndex index(bodies);
  const Ray along{{-1, 0.3, 0.4}, {1, 0, 0}};
  EXPECT_EQ(index.closest_hit(along).body, 0U);
  EXPECT_EQ(index.closest_hit(along).cost.exact_tests,
            closest_hit(bodies[0], along).cost.exact_tests);
  EXPECT_EQ(index.closest_hit(along).cost.triangle_tests,
            closest_hit(bodies[0], along).cost.triangle_tests);
  EXPECT_EQ(index.any_hit(along).cost.triangle_tests,
            any_hit(bodies[0], along).cost.triangle_tests);
  EXPECT_EQ(index.closest_hit(Ray{{-1, 0.3, 2}, {1, 0, 0}}).cost.triangle_tests, 0U);
}

TEST(BodyHit, ADeadlineCutsIt) {
  const std::vector<Body> bodies{screen_at(3), screen_at(4)};
  const BodyIndex index(bodies);
  const Limits late{.deadline = std::chrono::steady_clock::time_point::min()};
  const BodyHit answer = index.closest_hit(Ray{{0, 0, 0}, {1, 0, 0}}, {}, {}, late);
  EXPECT_EQ(answer.coverage, Coverage::cut);
  EXPECT_LE(answer.t.lower, 3);
  EXPECT_GE(answer.t.upper, 3);
  EXPECT_EQ(index.any_hit(Ray{{0, 0, 0}, {1, 0, 0}}, {}, {}, late).coverage, Coverage::cut);
  const std::vector<Ray> rays(2, Ray{{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(index.all_hits(rays, {}, {}, late).coverage, (std::vector<Coverage>(2, Coverage::cut)));
}

TEST(BodyHit, FaultsAreNamed) {
  const std::vector<Body> bodies{screen_at(3), screen_at(4)};
  const BodyIndex index(bodies);
  const Ray ray{{0, 0, 0}, {1, 0, 0}};
  const auto kind_of = [](const auto& call) {
    try {
      call();
    } catch (const Error& error) {
      return error.kind();
    }
    ADD_FAILURE() << "no error";
    return ErrorKind::cancelled;
  };
  for (const BodyIndex& any : {index, BodyIndex()}) {
    EXPECT_EQ(kind_of([&] { (void)any.closest_hit(Ray{}); }), ErrorKind::usage);
    EXPECT_EQ(kind_of([&] { (void)any.any_hit(Ray{}); }), ErrorKind::usage);
    EXPECT_EQ(kind_of([&] { (void)any.all_hits(std::vector<Ray>(1)); }), ErrorKind::usage);
    EXPECT_EQ(kind_of([&] { (void)any.all_hits(std::vector<Ray>{ray}, {.skip = 0}); }),
              ErrorKind::usage);
    EXPECT_EQ(kind_of([&] { (void)any.closest_hit(ray, {.skip = 0}); }), ErrorKind::usage);
    EXPECT_EQ(kind_of([&] { (void)any.closest_hit(ray, {}, {.except = 2}); }), ErrorKind::usage);
  }
  EXPECT_EQ(kind_of([&] { (void)index.closest_hit(ray, {.skip = 1}, {.except = 0}); }),
            ErrorKind::usage);
  try {
    (void)index.closest_hit(std::vector<Ray>{ray, Ray{}});
    FAIL() << "a ray without a direction was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.place().rfind("ray 1", 0), 0U) << error.place();
  }
}

}  // namespace
}  // namespace soms
