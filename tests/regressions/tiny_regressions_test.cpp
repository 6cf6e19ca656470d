// Faults of our own releases at sizes where products of lengths underflow: one test a fault. An id
// is never used again.
#include "soms/io/poses.h"
#include "soms/io/read_mesh.h"
#include "soms/query/print.h"
#include "soms/query/ray.h"
#include "soms/query/reference/ray.h"
#include "soms/query/reference/winding.h"
#include "soms/query/winding.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace soms {
namespace {

std::filesystem::path tiny_data(const std::string& file) {
  return test::data("rays/" + file);
}

/// Numbers of the only row of a CSV file, the least ones too.
std::vector<double> only_row(const std::string& file) {
  const auto rows = test::read_csv(tiny_data(file));
  std::vector<double> numbers;
  for (const std::string& field : rows.at(1)) {
    numbers.push_back(std::strtod(field.c_str(), nullptr));
  }
  return numbers;
}

Ray only_ray(const std::string& file) {
  const std::vector<double> n = only_row(file);
  return {{n.at(0), n.at(1), n.at(2)}, {n.at(3), n.at(4), n.at(5)}};
}

/// The first, any and all hits of a ray, against brute force.
void expect_ray_as_brute_force(const Body& body, const Ray& ray) {
  ClosestHit twin = reference::closest_hit_by_brute_force(body, ray);
  const ClosestHit hit = closest_hit(body, ray);
  twin.cost = hit.cost;
  EXPECT_EQ(hit, twin);
  EXPECT_EQ(any_hit(body, ray).hit, twin.triangle.has_value());
  AllHits all_twin = reference::all_hits_by_brute_force(body, ray);
  const AllHits all = all_hits(body, std::span(&ray, 1));
  all_twin.cost = all.cost;
  all_twin.costs = all.costs;
  EXPECT_EQ(all, all_twin);
}

TEST(TinyRegressions, R121TheFirstOfTinyTrianglesOfABodyOfUsualSizeIsHit) {
  const Body body(read_mesh(tiny_data("ray-usual-size.ply")));
  const Ray ray = only_ray("ray-usual-size.csv");
  const ClosestHit hit = closest_hit(body, ray);
  EXPECT_EQ(hit.triangle, 0U);
  EXPECT_NEAR(hit.t.lower, 2.6645e-15, 1e-19);
  expect_ray_as_brute_force(body, ray);
}

TEST(TinyRegressions, R121TheFirstOfTwoTrianglesOfTheLeastSizeIsHit) {
  const Body body(read_mesh(tiny_data("ray-first.ply")));
  const Ray ray = only_ray("ray-first.csv");
  EXPECT_EQ(closest_hit(body, ray).triangle, 0U);
  expect_ray_as_brute_force(body, ray);
}

TEST(TinyRegressions, R121NoHitIsInventedAtTheLeastSize) {
  const Body body(read_mesh(tiny_data("ray-invented.ply")),
                  read_poses(tiny_data("ray-invented-pose.csv")).at(0));
  const Ray ray = only_ray("ray-invented.csv");
  EXPECT_FALSE(any_hit(body, ray).hit);
  expect_ray_as_brute_force(body, ray);
}

// The vertices of all triangles move to one place.
TEST(TinyRegressions, R122TheWindingNumberOfTrianglesInOnePlaceIsZero) {
  const Body body(read_mesh(tiny_data("winding-nan.ply")),
                  read_poses(tiny_data("winding-nan-pose.csv")).at(0));
  const std::vector<double> p = only_row("winding-nan.csv");
  const Vec3 point{p.at(0), p.at(1), p.at(2)};
  const Winding answer = winding(WindingIndex(body), point);
  EXPECT_GE(answer.number.lower, -1e-9);
  EXPECT_LE(answer.number.upper, 1e-9);
  EXPECT_EQ(answer.side, Side::outside);
  const Bracket twin = reference::winding_by_brute_force(body, point);
  EXPECT_LE(answer.number.lower, twin.upper);
  EXPECT_GE(answer.number.upper, twin.lower);
}

}  // namespace
}  // namespace soms
