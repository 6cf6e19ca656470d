#include "soms/base/error.h"
#include "soms/tree/build.h"
#include "soms/tree/check.h"
#include "soms/tree/layout/detail/wide_tree.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/tree/inputs.h"

#include <cmath>
#include <string>

namespace soms {
namespace {

/// A mesh in several parts, larger than any other here.
constexpr std::size_t kMany = 12'000;

BuildOptions product(const RuleEntry& rule) {
  BuildOptions options;
  options.rule = rule.rule;
  return options;
}

TEST(BuildWide, EqualsBuildingAndConvertingForEveryRuleSizeAndInput) {
  std::size_t row = 0;
  for (const RuleEntry& rule : rules()) {
    ++row;
    for (std::size_t column = 0; column < test::kInputs.size(); ++column) {
      if (!test::is_tried(row, column, test::kInputs.size())) {
        continue;
      }
      const test::Input input = test::kInputs[column];
      for (const std::size_t size :
           {std::size_t{0}, std::size_t{1}, std::size_t{9}, std::size_t{1000}, kMany}) {
        SCOPED_TRACE(std::string(rule.name) + " " + test::name(input) + " " + std::to_string(size));
        const Mesh mesh = test::make_input(input, size);
        for (const BuildOptions& options : {product(rule), thesis_options(rule.rule, 12)}) {
          EXPECT_TRUE(build_wide(mesh, options) == WideTree(build(mesh, options), mesh));
        }
      }
    }
  }
}

TEST(BuildWide, GivesTheSameBytesForAnyNumberOfThreads) {
  for (const RuleEntry& rule : rules()) {
    for (const test::Input input :
         {test::Input::random, test::Input::huge_and_tiny, test::Input::coincident}) {
      SCOPED_TRACE(std::string(rule.name) + " " + test::name(input));
      const Mesh mesh = test::make_input(input, kMany);
      const WideTree one = build_wide(mesh, product(rule));
      for (const int threads : test::kSlowBuild ? std::vector{3} : std::vector{2, 3, 8}) {
        EXPECT_TRUE(build_wide(mesh, product(rule), Limits{.threads = threads}) == one) << threads;
      }
    }
  }
}

TEST(BuildWide, StopsOnRequestAndReportsItsWholeWay) {
  const Mesh mesh = test::make_input(test::Input::random, kMany);
  for (const RuleEntry& rule : rules()) {
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(static_cast<void>(build_wide(mesh, product(rule),
                                              Limits{.threads = 2, .stop = source.get_token()})),
                 Error);
    double last = 0;
    const WideTree tree =
        build_wide(mesh, product(rule), Limits{.threads = 2, .progress = [&](double share) {
                                                 EXPECT_GE(share, last);
                                                 last = share;
                                               }});
    EXPECT_EQ(last, 1) << rule.name;
  }
}

/// Triangles of a grid of boxes, one triangle over all of them, and a nest of tiny ones in one
/// spot.
Mesh uneven(double least, double greatest) {
  Mesh mesh;
  Rng rng(5);
  const auto add = [&](const Vec3& at, double size) {
    const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(),
                         {at, at + Vec3{size, 0, size * rng.unit()}, at + Vec3{0, size, 0}});
    mesh.triangles.push_back({v, v + 1, v + 2});
  };
  for (int i = 0; i < 12'000; ++i) {
    add({rng.uniform(0, 1), rng.uniform(0, 1), 0}, 0.001);
    add(Vec3{rng.unit(), rng.unit(), rng.unit()} * least, least / 100);
  }
  add({0, 0, 0}, 1);
  add({0, 0, 0}, greatest);
  return mesh;
}

// All the tiny ones lie in one cell of any grid, and in one float of the largest.
/// A triangle of these corners at the end of the mesh.
void add_triangle(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

void expect_whole_by_references(const Mesh& mesh) {
  for (const Rule rule : {Rule::fast, Rule::quality, Rule::quick}) {
    const BuildOptions options{.rule = rule};
    EXPECT_EQ(find_fault(build(mesh, options), mesh), "");
    EXPECT_TRUE(build_wide(mesh, options) == WideTree(build(mesh, options), mesh));
  }
}

// Seen from there, the large ones' middles are what rounding left of them: no float holds it.
TEST(BuildWide, DividesHugeTrianglesAboutTheMiddleOfTinyOnes) {
  const double u = 0x1p299;
  const double low = u * (1 + 0x1p-52);
  const double high = u * (2 + 0x1p-51);
  const double middle = u * (1.5 + 0x1p-51);
  Mesh mesh;
  for (int k = 0; k < 10; ++k) {
    add_triangle(mesh, {low, -u, -u}, {high, u, u}, {low, u, -u});
    add_triangle(mesh, {middle, -1, -1}, {middle, 1, 1}, {middle, 1, -1});
  }
  expect_whole_by_references(mesh);
}

// Floats hold the distance of their middles, but not what scales it to cells.
TEST(BuildWide, DividesManyPointsThatAreAlmostOne) {
  Mesh mesh;
  add_triangle(mesh, {-1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  for (int k = 0; k < 9000; ++k) {
    const Vec3 p{k % 2 == 0 ? 0 : 0x1p-140, 0, 0};
    add_triangle(mesh, p, p, p);
  }
  expect_whole_by_references(mesh);
}

TEST(BuildWide, DividesATinyNestBesideATriangleAsLargeAsAll) {
  for (const auto& [least, greatest] : {std::pair{1e-3, 1.0}, {1e-12, 1e12}, {0x1p-300, 0x1p290}}) {
    const Mesh mesh = uneven(least, greatest);
    for (const RuleEntry& rule : rules()) {
      SCOPED_TRACE(std::string(rule.name) + " " + std::to_string(least));
      const Tree tree = build(mesh, product(rule));
      EXPECT_EQ(find_fault(tree, mesh), "");
      EXPECT_TRUE(build_wide(mesh, product(rule)) == WideTree(tree, mesh));
    }
  }
}

}  // namespace
}  // namespace soms
