#include "soms/tree/build/detail/reference.h"

#include "tests/support/support.h"
#include "tests/tree/inputs.h"

#include <vector>

namespace soms {
namespace {

using detail::Halves;
using detail::PrimitiveRange;
using detail::Reference;
using detail::ReferenceDivider;

struct References {
  std::vector<Reference> items;
  PrimitiveRange range;
};

References references_of(const Mesh& mesh) {
  References run;
  const detail::PrimitiveFrame frame = detail::frame_of(bounds(mesh));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    run.items.push_back(detail::reference_of(mesh, static_cast<TriangleId>(i), frame));
    run.range.add(run.items.back());
  }
  return run;
}

void expect_same_range(const PrimitiveRange& a, const PrimitiveRange& b) {
  EXPECT_EQ(a.first, b.first);
  EXPECT_EQ(a.count, b.count);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(a.middles.lower[k], b.middles.lower[k]);
    EXPECT_EQ(a.middles.upper[k], b.middles.upper[k]);
    EXPECT_EQ(a.widest[k], b.widest[k]);
  }
}

// From runs that are swept to runs that are binned, and all that follow from both sides.
TEST(ReferenceDivider, DividesAlikeByEveryProcessorsInstructions) {
  for (const Rule rule : {Rule::fast, Rule::quality}) {
    for (const test::Input input : test::kInputs) {
      for (const std::size_t count : {2U, 3U, 8U, 9U, 15U, 16U, 17U, 40U, 700U}) {
        SCOPED_TRACE(test::name(input) + " " + std::to_string(count));
        References plain = references_of(test::make_input(input, count));
        References fast = plain;
        BuildOptions options;
        options.rule = rule;
        ReferenceDivider divider(options);
        std::vector<PrimitiveRange> pending{plain.range};
        while (!pending.empty()) {
          const PrimitiveRange range = pending.back();
          pending.pop_back();
          const Halves a = divider.divide_plainly(plain.items, range);
          const Halves b = divider.divide(fast.items, range);
          expect_same_range(a.left, b.left);
          expect_same_range(a.right, b.right);
          EXPECT_EQ(a.even, b.even);
          for (const PrimitiveRange& half : {a.left, a.right}) {
            if (half.count > 1) {
              pending.push_back(half);
            }
          }
        }
        for (std::size_t i = 0; i < count; ++i) {
          EXPECT_EQ(plain.items[i].id, fast.items[i].id) << i;
        }
      }
    }
  }
}

// What is swept is cut between two neighbors on an axis, and equal ones stay as they lie.
TEST(ReferenceDivider, KeepsTheOrderOfEqualOnes) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 1, 0}, {0, 1, 1}, {8, 0, 0}, {9, 1, 0}, {8, 1, 1}};
  for (std::uint32_t i = 0; i < 12; ++i) {
    const std::uint32_t at = i % 2 == 0 ? 3 : 0;
    mesh.triangles.push_back({at, at + 1, at + 2});
  }
  References run = references_of(mesh);
  ReferenceDivider divider({});
  const Halves halves = divider.divide(run.items, run.range);
  EXPECT_EQ(halves.left.count, 6U);
  std::vector<TriangleId> ids;
  for (const Reference& r : run.items) {
    ids.push_back(r.id);
  }
  EXPECT_EQ(ids, (std::vector<TriangleId>{1, 3, 5, 7, 9, 11, 0, 2, 4, 6, 8, 10}));
}

}  // namespace
}  // namespace soms
