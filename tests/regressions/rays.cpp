#include "tests/regressions/rays.h"

#include "soms/query/reference/ray.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace soms::test {

namespace {

/// Row `ray` of the answer.
std::vector<Place> places_of(const AllHits& hits, std::size_t ray) {
  std::vector<Place> places;
  for (std::size_t i = hits.offsets[ray]; i < hits.offsets[ray + 1]; ++i) {
    Place place{{hits.lower[i], hits.upper[i]}, hits.kind[i], {}};
    for (std::size_t k = hits.triangle_offsets[i]; k < hits.triangle_offsets[i + 1]; ++k) {
      place.triangles.push_back(hits.triangle[k]);
    }
    places.push_back(std::move(place));
  }
  return places;
}

bool same(const ClosestHit& a, const ClosestHit& b) {
  return a.t == b.t && a.triangle == b.triangle && a.point == b.point && a.front == b.front &&
         a.coverage == b.coverage;
}

Ray turned(const Pose& turn, const Ray& ray) {
  return {turn.apply(ray.origin), turn.apply(ray.direction), ray.length};
}

std::vector<Ray> turned(const Pose& turn, std::vector<Ray> rays) {
  for (Ray& ray : rays) {
    ray = turned(turn, ray);
  }
  return rays;
}

RayTruth turned(const Pose& turn, RayTruth truth) {
  for (ClosestHit& hit : truth.first) {
    hit.point = hit.triangle ? turn.apply(hit.point) : hit.point;
  }
  return truth;
}

/// The same with lengths in another unit: t does not change.
void expect_scaled(const Mesh& mesh, const std::vector<Ray>& rays, const RayTruth& truth, int k) {
  const double factor = std::ldexp(1.0, k);
  std::vector<Ray> scaled = rays;
  for (Ray& ray : scaled) {
    ray.origin = ray.origin * factor;
    ray.direction = ray.direction * factor;
  }
  RayTruth expected = truth;
  for (ClosestHit& hit : expected.first) {
    hit.point = hit.point * factor;
  }
  ASSERT_EQ(fault_of_rays(Body(mapped(mesh, [&](const Vec3& v) { return v * factor; })), scaled,
                          expected),
            "");
}

}  // namespace

std::vector<Place> places_on(const Body& body, const Ray& ray) {
  return places_of(all_hits(body, std::vector<Ray>{ray}), 0);
}

RayTruth truth_of(const Body& body, const std::vector<Ray>& rays) {
  RayTruth truth;
  for (const Ray& ray : rays) {
    truth.first.push_back(reference::closest_hit_by_brute_force(body, ray));
    truth.all.push_back(places_of(reference::all_hits_by_brute_force(body, ray), 0));
  }
  return truth;
}

std::string fault_of_rays(const Body& body, const std::vector<Ray>& rays, const RayTruth& truth) {
  const ClosestHitBatch first = closest_hit(body, rays);
  const AnyHitBatch any = any_hit(body, rays);
  const AllHits all = all_hits(body, rays);
  if (first.size() != rays.size() || any.size() != rays.size() || all.size() != rays.size()) {
    return "a batch has another size";
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::string ray = "ray " + std::to_string(i) + ": ";
    const bool hit = truth.first[i].triangle.has_value();
    if (!same(first.at(i), truth.first[i])) {
      return ray + "first hit in a batch";
    }
    if (!same(closest_hit(body, rays[i]), truth.first[i])) {
      return ray + "first hit";
    }
    if (any.at(i).hit != hit || any_hit(body, rays[i]).hit != hit) {
      return ray + "any hit";
    }
    if (places_of(all, i) != truth.all[i]) {
      return ray + "all hits";
    }
  }
  return {};
}

void expect_rays_as_brute_force(const Mesh& mesh, const std::vector<Ray>& rays) {
  const RayTruth truth = truth_of(Body(mesh), rays);
  ASSERT_EQ(fault_of_rays(Body(mesh), rays, truth), "");
  for (const Pose& turn : cube_rotations()) {
    const std::vector<Ray> others = turned(turn, rays);
    const Body moved(mesh, turn);
    // Kinds at the rim of an open surface depend on the side to which a ray is moved.
    RayTruth expected = truth_of(moved, others);
    const RayTruth same_but_turned = turned(turn, truth);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ASSERT_TRUE(same(expected.first[i], same_but_turned.first[i])) << "ray " << i;
    }
    ASSERT_EQ(fault_of_rays(moved, others, expected), "");
    ASSERT_EQ(fault_of_rays(Body(mapped(mesh, [&](const Vec3& v) { return turn.apply(v); })),
                            others, expected),
              "");
  }
  for (const int k : {-40, -13, 1, 40}) {
    expect_scaled(mesh, rays, truth, k);
  }
  for (const RuleEntry& rule : rules()) {
    for (const int per_leaf : {1, 4, 1000}) {
      for (const Layout layout : {Layout::wide, Layout::compact}) {
        const ShapeOptions options{.build = {.rule = rule.rule, .per_leaf = per_leaf},
                                   .layout = layout};
        ASSERT_EQ(fault_of_rays(Body(Shape(mesh, options)), rays, truth), "");
      }
    }
  }
}

}  // namespace soms::test
