#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/tree/build.h"
#include "soms/tree/layout/detail/compact_node.h"
#include "soms/tree/refit.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/support.h"
#include "tests/tree/inputs.h"
#include "tests/tree/layout/whole.h"

#include <cmath>

namespace soms {
namespace {

/// Every box of `large` holds that of `small`, and is at most two steps wider on each side.
void expect_around(const WideTree& large, const WideTree& small) {
  ASSERT_EQ(large.nodes().size(), small.nodes().size());
  for (std::size_t i = 0; i < small.nodes().size(); ++i) {
    const WideNode& a = large.nodes()[i];
    const WideNode& b = small.nodes()[i];
    ASSERT_EQ(a.child, b.child);
    ASSERT_EQ(a.leaves, b.leaves);
    ASSERT_EQ(a.origin, b.origin);
    ASSERT_EQ(a.axes(), b.axes());
    ASSERT_GE(a.l1_radius, b.l1_radius);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double step = std::max(1.01 * static_cast<double>(b.own_half()[axis]) / 127, 0x1p-99);
      for (std::size_t k = 0; k < b.count; ++k) {
        const double grown =
            static_cast<double>(a.half[axis][k]) - static_cast<double>(b.half[axis][k]);
        const double moved = std::abs(static_cast<double>(a.center[axis][k]) -
                                      static_cast<double>(b.center[axis][k]));
        ASSERT_GE(grown, moved);
        ASSERT_LE(grown, step);
      }
    }
  }
}

TEST(Compact, HoldsWhatTheWideTreeHoldsAndReadsTheSameBlocks) {
  for (const RuleEntry& rule : rules()) {
    for (const test::Input input : test::kInputs) {
      for (const std::size_t count : {0U, 1U, 2U, 3U, 7U, 64U, 1000U}) {
        for (const int per_leaf : {1, 8, 100}) {
          SCOPED_TRACE(std::string(rule.name) + ' ' + test::name(input) + ' ' +
                       std::to_string(count) + ' ' + std::to_string(per_leaf));
          const Mesh mesh = test::make_input(input, count);
          BuildOptions options;
          options.rule = rule.rule;
          options.per_leaf = per_leaf;
          const WideTree wide = build_wide(mesh, options);
          const WideTree compact = wide.compacted();
          ASSERT_TRUE(compact.nodes().empty());
          ASSERT_EQ(compact.empty(), mesh.triangles.empty());
          const WideTree again = compact.expanded(mesh);
          ASSERT_TRUE(std::equal(again.blocks().begin(), again.blocks().end(),
                                 wide.blocks().begin(), wide.blocks().end()));
          ASSERT_NO_FATAL_FAILURE(expect_around(again, wide));
          if (input == test::Input::random && count > 0) {
            ASSERT_NO_FATAL_FAILURE(test::expect_whole(again, mesh));
          }
          ASSERT_EQ(again.compacted(), compact);
        }
      }
    }
  }
}

TEST(Compact, IsTheSameForAnyNumberOfThreads) {
  ShapeOptions options;
  options.layout = Layout::compact;
  const Mesh mesh = generate_knot(50'000);
  const Shape one(mesh, options);
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(Shape(mesh, options, {threads, {}, {}}).layout(), one.layout()) << threads;
  }
}

TEST(Compact, TakesAtMost48BytesATriangleWithItsMesh) {
  ShapeOptions options;
  options.layout = Layout::compact;
  for (const Mesh& mesh : {generate_knot(100'000), generate_sphere(100'000)}) {
    const auto count = static_cast<double>(mesh.triangles.size());
    EXPECT_LE(static_cast<double>(Shape(mesh, options).memory()) / count, 48);
  }
}

TEST(Compact, StaysSoWhenItIsRefitted) {
  ShapeOptions options;
  options.layout = Layout::compact;
  const Mesh mesh = generate_knot(20'000);
  const Shape shape(mesh, options);
  EXPECT_EQ(refit(shape, mesh.vertices).layout(), shape.layout());
  Mesh moved = mesh;
  for (Vec3& v : moved.vertices) {
    v.z += 0.3 * std::sin(4 * v.x);
  }
  const Shape bent = refit(shape, moved.vertices);
  ASSERT_NE(bent.layout().compact(), nullptr);
  ASSERT_NO_FATAL_FAILURE(test::expect_whole(bent.layout().expanded(moved), moved));
  EXPECT_GT(bent.sah_degradation(), 1);
}

}  // namespace
}  // namespace soms
