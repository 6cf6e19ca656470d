#include "soms/geometry/part_runs.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

namespace soms::test {
namespace {

TEST(PartRuns, HoldThePartOfEachTriangle) {
  for_each_case("part_runs", 200, [](Rng& rng) {
    Mesh mesh;
    mesh.triangles.resize(rng.below(40));
    for (std::uint64_t n = rng.below(12); n > 0; --n) {
      const auto first = static_cast<std::uint32_t>(rng.below(mesh.triangles.size() + 1));
      const auto count = static_cast<std::uint32_t>(rng.below(mesh.triangles.size() - first + 1));
      mesh.parts.push_back({"", Part::kNoParent, first, count});
    }
    const std::vector<PartRun> runs = part_runs(mesh);
    ASSERT_EQ(runs.empty(), mesh.triangles.empty());
    for (std::size_t k = 0; k < runs.size(); ++k) {
      ASSERT_EQ(k == 0, runs[k].first == 0);
      const std::size_t end = k + 1 < runs.size() ? runs[k + 1].first : mesh.triangles.size();
      ASSERT_LT(runs[k].first, end);
      for (std::size_t i = runs[k].first; i < end; ++i) {
        EXPECT_EQ(runs[k].part, part_of(mesh, static_cast<TriangleId>(i))) << i;
      }
    }
  });
}

}  // namespace
}  // namespace soms::test
