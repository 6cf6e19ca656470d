// The truth set of rays, by every rule, layout, number of threads and instruction set, alone and in
// batches.
#include "soms/query/ray.h"
#include "soms/query/reference/ray.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/needs_instruction_set.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/question_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace soms {
namespace {

/// Triangles that a ray meets, by t, then by number.
using RayList = std::vector<test::RayListRow>;

/// The rows of one mesh, and their lists where the set has them.
struct Rays {
  std::vector<Ray> rays;
  std::vector<test::RayTruthRow> rows;
  std::vector<RayList> lists;
};

std::map<std::string, Rays> by_mesh(const std::vector<test::RayTruthRow>& rows,
                                    const std::vector<test::RayListRow>& list_rows) {
  std::map<std::uint64_t, RayList> lists;
  for (const test::RayListRow& row : list_rows) {
    lists[row.ray].push_back(row);
  }
  std::map<std::string, Rays> meshes;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Rays& mesh = meshes[rows[i].mesh];
    mesh.rays.push_back(rows[i].ray);
    mesh.rows.push_back(rows[i]);
    mesh.lists.push_back(lists[i]);
  }
  return meshes;
}

/// "sliver ray 3".
std::string name_of(const Rays& rays, std::size_t i) {
  return rays.rows[i].kind + " ray " + std::to_string(i);
}

/// Rows of `hits` against the counts and lists of the set.
void expect_all(const AllHits& hits, const Rays& rays) {
  ASSERT_EQ(hits.size(), rays.rays.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    SCOPED_TRACE(name_of(rays, i));
    RayList found;
    for (std::uint64_t k = hits.offsets[i]; k < hits.offsets[i + 1]; ++k) {
      ASSERT_TRUE(k == hits.offsets[i] || hits.lower[k - 1] <= hits.lower[k]);
      for (std::uint64_t m = hits.triangle_offsets[k]; m < hits.triangle_offsets[k + 1]; ++m) {
        found.push_back({0, 0, {hits.lower[k], hits.upper[k]}, hits.triangle[m]});
      }
    }
    ASSERT_EQ(found.size(), rays.rows[i].hits);
    ASSERT_EQ(hits.coverage[i], Coverage::complete);
    const RayList& list = rays.lists[i];
    // Crossings at one t come one after the other, each with its triangles in order.
    for (std::size_t begin = 0; begin < list.size();) {
      std::size_t end = begin;
      for (; end < list.size() && list[end].group == list[begin].group; ++end) {
        ASSERT_EQ(found[end].t, list[end].t);
      }
      std::sort(found.begin() + static_cast<std::ptrdiff_t>(begin),
                found.begin() + static_cast<std::ptrdiff_t>(end),
                [](const auto& a, const auto& b) { return a.triangle < b.triangle; });
      for (; begin < end; ++begin) {
        ASSERT_EQ(found[begin].triangle, list[begin].triangle);
      }
    }
  }
}

void expect_closest(const ClosestHit& found, const test::RayTruthRow& row) {
  ASSERT_EQ(found.triangle, row.closest.triangle);
  ASSERT_EQ(found.t, row.closest.t);
  ASSERT_EQ(found.coverage, Coverage::complete);
}

/// One body, in batches and one by one, which must cost the same.
void run(const Body& body, const Rays& rays) {
  const ClosestHitBatch closest = closest_hit(body, rays.rays);
  ASSERT_EQ(closest_hit(body, rays.rays, {}, {.threads = 2}), closest);
  const AnyHitBatch any = any_hit(body, rays.rays);
  ASSERT_EQ(any_hit(body, rays.rays, {}, {.threads = 2}), any);
  for (std::size_t i = 0; i < rays.rays.size(); ++i) {
    SCOPED_TRACE(name_of(rays, i));
    ASSERT_NO_FATAL_FAILURE(expect_closest(closest.at(i), rays.rows[i]));
    ASSERT_EQ(closest_hit(body, rays.rays[i]), closest.at(i));
    ASSERT_EQ(any.hit[i] != 0, rays.rows[i].hits != 0);
    ASSERT_EQ(any_hit(body, rays.rays[i]), any.at(i));
  }
  const AllHits all = all_hits(body, rays.rays);
  ASSERT_EQ(all_hits(body, rays.rays, {}, {.threads = 2}), all);
  ASSERT_NO_FATAL_FAILURE(expect_all(all, rays));
}

/// By each rule of `chosen` and every layout.
void run(const std::map<std::string, Rays>& meshes, std::span<const RuleEntry> chosen = rules()) {
  for (const auto& [name, rays] : meshes) {
    const Mesh& mesh = *test::question_mesh(name);
    for (const RuleEntry& rule : chosen) {
      for (const Layout layout : {Layout::wide, Layout::compact}) {
        SCOPED_TRACE(name + ", " + std::string(rule.name) +
                     (layout == Layout::wide ? "" : ", compact"));
        const ShapeOptions options{.build = {.rule = rule.rule}, .layout = layout};
        ASSERT_NO_FATAL_FAILURE(run(Body(Shape(mesh, options)), rays));
      }
    }
  }
}

/// What brute force finds, and that the query's points, sides and kinds are its.
void run_twin(const std::map<std::string, Rays>& meshes) {
  for (const auto& [name, rays] : meshes) {
    SCOPED_TRACE(name);
    const Body body(*test::question_mesh(name));
    for (std::size_t i = 0; i < rays.rays.size(); ++i) {
      SCOPED_TRACE(name_of(rays, i));
      ClosestHit twin = reference::closest_hit_by_brute_force(body, rays.rays[i]);
      ASSERT_NO_FATAL_FAILURE(expect_closest(twin, rays.rows[i]));
      const ClosestHit found = closest_hit(body, rays.rays[i]);
      twin.cost = found.cost;
      ASSERT_EQ(found, twin);
      AllHits all = reference::all_hits_by_brute_force(body, rays.rays[i]);
      const AllHits query = all_hits(body, std::span(&rays.rays[i], 1));
      all.cost = query.cost;
      all.costs = query.costs;
      ASSERT_EQ(query, all);
    }
  }
}

using RayTruth = test::NeedsInstructionSet;

std::map<std::string, Rays> rays_here() {
  return by_mesh(test::read_ray_rows(test::data("questions/ray.csv")),
                 test::read_ray_lists(test::data("questions/ray_lists.csv")));
}

TEST_F(RayTruth, HoldsForTheRaysHere) {
  run(rays_here());
}

TEST_F(RayTruth, OfTheRaysHereIsWhatBruteForceFinds) {
  run_twin(rays_here());
}

TEST_F(RayTruth, HoldsForAllRays) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const auto file = test::outside_question("ray.csv");
  const auto lists = test::outside_question("ray_lists.csv");
  if (!file || !lists) {
    GTEST_SKIP() << "SOMS_DATA has no questions/ray.csv: skipped 13,400 rays";
  }
  const auto rows = test::read_ray_rows(*file);
  ASSERT_EQ(rows.size(), 13'400U);
  run(by_mesh(rows, test::read_ray_lists(*lists)), std::span(&entry(BuildOptions{}.rule), 1));
}

}  // namespace
}  // namespace soms
