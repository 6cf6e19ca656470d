#include "soms/query/self_overlap.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/generate/statue.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/self/neighbor_overlap.h"
#include "soms/query/print.h"
#include "soms/query/reference/self_overlap.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace soms {
namespace {

using Pairs = std::vector<TrianglePair>;

constexpr std::array kWays{CommonCorners::index, CommonCorners::position};

/// What does not depend on trees.
void expect_same(const SelfOverlap& answer, const SelfOverlap& truth) {
  ASSERT_EQ(answer.any, truth.any);
  ASSERT_EQ(answer.pairs, truth.pairs);
  ASSERT_EQ(answer.duplicates, truth.duplicates);
  ASSERT_EQ(answer.coverage, truth.coverage);
}

/// Every way to put the question.
void expect_everywhere(const Shape& shape, CommonCorners by, const SelfOverlap& truth) {
  const SelfOverlap answer = self_overlap(shape, {.by = by}, {.threads = 1});
  ASSERT_NO_FATAL_FAILURE(expect_same(answer, truth));
  ASSERT_EQ(self_overlap(shape, {.by = by}, {.threads = 2}), answer);
  const SelfOverlap any = self_overlap(shape, {.by = by, .mode = OverlapMode::any});
  const SelfOverlap first = self_overlap(shape, {.by = by, .mode = OverlapMode::first});
  ASSERT_EQ(any.any, truth.any);
  ASSERT_EQ(first.any, truth.any);
  if (truth.any) {
    ASSERT_TRUE(std::binary_search(truth.pairs.begin(), truth.pairs.end(), any.pairs.front()));
    ASSERT_EQ(first.pairs, Pairs{truth.pairs.front()});
  }
  const SelfOverlap few = self_overlap(shape, {.by = by, .limit = 2});
  ASSERT_EQ(few.pairs.size(), std::min<std::size_t>(2, truth.pairs.size()));
  ASSERT_EQ(few.coverage == Coverage::cut, truth.pairs.size() > 2 || truth.duplicates.size() > 2);
}

/// The truth of one mesh: tests/data/self.
struct SelfTruth {
  std::string kind;
  Mesh mesh;
  std::array<SelfOverlap, 2> answers;  ///< by index, by position
};

std::vector<SelfTruth> self_truth() {
  std::vector<SelfTruth> all;
  for (const auto& row : test::read_csv(test::data("self/counts.csv"))) {
    if (row[0] != "mesh") {
      all.push_back({row[1], {}, {}});
    }
  }
  for (const auto& row : test::read_csv(test::data("self/meshes.csv"))) {
    if (row[0] == "mesh") {
      continue;
    }
    Mesh& mesh = all.at(std::stoul(row[0])).mesh;
    const auto number = [&](std::size_t k) { return std::strtod(row[k].c_str(), nullptr); };
    if (row[1] == "v") {
      mesh.vertices.push_back({number(2), number(3), number(4)});
    } else {
      const auto corner = [&](std::size_t k) {
        return static_cast<std::uint32_t>(std::stoul(row[2 + k]));
      };
      mesh.triangles.push_back({corner(0), corner(1), corner(2)});
    }
  }
  for (const auto& row : test::read_csv(test::data("self/pairs.csv"))) {
    if (row[0] == "mesh") {
      continue;
    }
    SelfOverlap& answer = all.at(std::stoul(row[0])).answers.at(row[1] == "index" ? 0 : 1);
    const TrianglePair pair{static_cast<TriangleId>(std::stoul(row[2])),
                            static_cast<TriangleId>(std::stoul(row[3]))};
    (row[5] == "duplicate" ? answer.duplicates : answer.pairs).push_back(pair);
  }
  for (SelfTruth& truth : all) {
    for (SelfOverlap& answer : truth.answers) {
      std::sort(answer.pairs.begin(), answer.pairs.end());
      std::sort(answer.duplicates.begin(), answer.duplicates.end());
      answer.any = !answer.pairs.empty();
    }
  }
  return all;
}

TEST(SelfOverlapTruth, HoldsInEveryWay) {
  const std::vector<SelfTruth> all = self_truth();
  ASSERT_EQ(all.size(), 111U);
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE("mesh " + std::to_string(i) + ", " + all[i].kind);
    const int per_leaf = 1 + static_cast<int>(i % 9);
    for (std::size_t way = 0; way < kWays.size(); ++way) {
      const SelfOverlap& truth = all[i].answers.at(way);
      pairs += truth.pairs.size() + truth.duplicates.size();
      ASSERT_NO_FATAL_FAILURE(
          expect_same(reference::self_overlap(all[i].mesh, kWays.at(way)), truth));
      for (const Layout layout : {Layout::wide, Layout::compact}) {
        for (const Rule rule : {Rule::sah, Rule::soms}) {
          const Shape shape(all[i].mesh,
                            {.build = {.rule = rule, .per_leaf = per_leaf}, .layout = layout});
          ASSERT_NO_FATAL_FAILURE(expect_everywhere(shape, kWays.at(way), truth));
        }
      }
    }
  }
  EXPECT_EQ(pairs, 4983U);
}

/// A mesh whose triangles share vertices, with folds, flat parts and repeated corners.
Mesh joined_mesh(Rng& rng) {
  Mesh mesh;
  const auto count = static_cast<std::uint32_t>(4 + rng.below(12));
  const bool lattice = rng.below(2) == 0;
  const auto coordinate = [&] {
    return lattice ? static_cast<double>(rng.below(4)) : rng.uniform(0, 4);
  };
  for (std::uint32_t v = 0; v < count; ++v) {
    mesh.vertices.push_back({coordinate(), coordinate(), rng.below(2) == 0 ? 0 : coordinate()});
  }
  const std::size_t triangles = 1 + rng.below(40);
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto corner = [&] { return static_cast<std::uint32_t>(rng.below(count)); };
    mesh.triangles.push_back({corner(), corner(), corner()});
  }
  return mesh;
}

TEST(SelfOverlap, EqualsItsTwinOnMeshesOfEveryKind) {
  std::size_t crossing = 0;
  test::for_each_case("query/self-overlap", 400, [&](Rng& rng) {
    const double scale = rng.below(3) == 0 ? std::exp2(rng.uniform(-300, 280)) : 1;
    const double far = rng.below(4) == 0 ? scale * std::exp2(rng.uniform(0, 40)) : 0;
    const Mesh mesh = test::placed(
        rng.below(3) == 0 ? test::awkward_mesh(rng, 60) : joined_mesh(rng), scale, {far, -far, 0});
    const Shape shape(mesh, {.build = test::awkward_options(rng),
                             .layout = rng.below(3) == 0 ? Layout::compact : Layout::wide});
    for (const CommonCorners by : kWays) {
      const SelfOverlap truth = reference::self_overlap(mesh, by);
      ASSERT_NO_FATAL_FAILURE(expect_everywhere(shape, by, truth));
      crossing += truth.any ? 1 : 0;
    }
  });
  EXPECT_GT(crossing, 200U);
}

/// The mesh with three vertices of its own for each triangle.
Mesh soup(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    triangles.push_back(mesh.triangle(i));
  }
  return test::soup_body(triangles);
}

TEST(SelfOverlap, EqualsItsTwinOnModels) {
  // The statue stands in its plinth; a file of single triangles has neighbors by position alone.
  for (const Mesh& mesh : {generate_statue(2000), soup(generate_knot(600))}) {
    for (const CommonCorners by : kWays) {
      ASSERT_NO_FATAL_FAILURE(
          expect_everywhere(Shape(mesh), by, reference::self_overlap(mesh, by)));
    }
  }
}

TEST(SelfOverlap, FindsNoFaultInClosedSurfaces) {
  for (const Mesh& mesh : {generate_sphere(2000), generate_knot(4000)}) {
    for (const double scale : {1.0, 10.0, 0x1p-200, 1e9}) {
      const SelfOverlap answer = self_overlap(Shape(test::placed(mesh, scale, {})));
      EXPECT_FALSE(answer.any) << scale;
      EXPECT_TRUE(answer.duplicates.empty());
    }
  }
}

TEST(SelfOverlap, DoesNotDependOnOrder) {
  test::for_each_case("query/self-overlap-order", 60, [&](Rng& rng) {
    const Mesh mesh = joined_mesh(rng);
    Mesh turned = mesh;
    std::reverse(turned.triangles.begin(), turned.triangles.end());
    for (auto& corners : turned.triangles) {
      std::swap(corners[0], corners[rng.below(3)]);
    }
    const auto last = static_cast<TriangleId>(mesh.triangles.size() - 1);
    SelfOverlap answer = self_overlap(Shape(turned));
    for (Pairs* pairs : {&answer.pairs, &answer.duplicates}) {
      for (TrianglePair& pair : *pairs) {
        pair = {last - pair.b, last - pair.a};
      }
      std::sort(pairs->begin(), pairs->end());
    }
    const SelfOverlap truth = self_overlap(Shape(mesh));
    ASSERT_EQ(answer.pairs, truth.pairs);
    ASSERT_EQ(answer.duplicates, truth.duplicates);
  });
}

TEST(SelfOverlap, TakesALimitAndADeadline) {
  const Shape shape(generate_knot(2000));
  EXPECT_THROW(static_cast<void>(self_overlap(shape, {.mode = OverlapMode::any, .limit = 5})),
               Error);
  const Limits late{.deadline = std::chrono::steady_clock::time_point()};
  EXPECT_EQ(self_overlap(shape, {}, late).coverage, Coverage::cut);
  EXPECT_EQ(self_overlap(Shape(Mesh{})), SelfOverlap{});
}

/// Corners whose triangles nearly or really share more.
std::array<Vec3, 5> close_corners(Rng& rng) {
  std::array<Vec3, 5> corners;
  const double scale = rng.below(4) == 0 ? std::exp2(rng.uniform(-500, 299)) : 1;
  const bool flat = rng.below(2) == 0;
  for (Vec3& corner : corners) {
    const auto part = [&] {
      return rng.below(3) == 0 ? static_cast<double>(rng.below(3)) - 1 : rng.uniform(-1, 1);
    };
    corner = scale * Vec3{part(), part(), flat ? rng.uniform(-1, 1) * 0x1p-50 : part()};
  }
  if (rng.below(8) == 0) {
    corners[1 + rng.below(4)] = corners[rng.below(5)];
  }
  return corners;
}

TEST(SelfOverlap, KernelsAreSureOfWhatIsTrueAlone) {
  const PlainArithmetic plain;
  std::size_t sure = 0;
  std::size_t all = 0;
  test::for_each_case("query/self-overlap-kernels", 3000, [&](Rng& rng) {
    detail::NeighborLanes lanes;
    std::array<std::array<Vec3, 5>, detail::NeighborLanes::kMost> corners;
    for (std::size_t lane = 0; lane < corners.size(); ++lane) {
      corners[lane] = close_corners(rng);
      for (std::size_t row = 0; row < 15; ++row) {
        lanes.corner[row][lane] = corners[lane][row / 3][row % 3];
      }
    }
    const std::uint32_t at_corner = detail::scalar::kernels().apart_at_corner(lanes);
    const std::uint32_t at_edge = detail::scalar::kernels().apart_at_edge(lanes);
    for (const detail::Kernels* kernels : detail::kernels_here()) {
      ASSERT_EQ(kernels->apart_at_corner(lanes), at_corner) << kernels->name;
      ASSERT_EQ(kernels->apart_at_edge(lanes), at_edge) << kernels->name;
    }
    for (std::size_t lane = 0; lane < corners.size(); ++lane) {
      const auto& [v, p, q, r, s] = corners[lane];
      const bool corner_is_sure = (at_corner >> lane & 1U) != 0;
      const bool edge_is_sure = (at_edge >> lane & 1U) != 0;
      ASSERT_FALSE(corner_is_sure && detail::share_beyond_corner(v, p, q, r, s));
      ASSERT_FALSE(edge_is_sure && detail::share_beyond_edge(v, p, q, r));
      sure += std::size_t{corner_is_sure} + std::size_t{edge_is_sure};
      all += 2;
    }
  });
  EXPECT_GT(sure, all / 4);
}

}  // namespace
}  // namespace soms
