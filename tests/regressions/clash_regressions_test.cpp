// Clash lists of other programs: what they got wrong.
#include "soms/base/error.h"
#include "soms/clash/clash.h"
#include "soms/clash/print.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace soms {
namespace {

/// `n` x `n` bars along x or y, one a part.
std::vector<PartBody> bars(int n, bool along_x) {
  Mesh mesh;
  for (int k = 0; k < n; ++k) {
    const double at = 2.0 * k;
    mesh = test::joined(mesh, along_x ? test::box_body({-1, at, 0}, {2.0 * n, at + 1, 1})
                                      : test::box_body({at, -1, 0}, {at + 1, 2.0 * n, 1}));
    mesh.parts.push_back({.name = "bar", .first = static_cast<std::uint32_t>(12 * k), .count = 12});
  }
  return part_bodies(mesh);
}

// R45: the list named parts in another order than the sets.
TEST(Regression, R45AThousandClashesNameThePartsInTheOrderOfTheSets) {
  const std::vector<PartBody> a = bars(32, true);
  const std::vector<PartBody> b = bars(32, false);
  const ClashList list = clashes(a, b);
  ASSERT_EQ(list.clashes.size(), 1024U);
  std::map<PartNumbers, Clash> there;
  for (const Clash& clash : list.clashes) {
    EXPECT_EQ(clash.kind, ClashKind::crossing);
    // The bars' places say which is which.
    EXPECT_LE(a[clash.a].body.shape.bounds().lower.y, clash.place.y);
    EXPECT_LE(b[clash.b].body.shape.bounds().lower.x, clash.place.x);
    there[{clash.a, clash.b}] = clash;
  }
  for (const Clash& clash : clashes(b, a).clashes) {
    const Clash& other = there.at({clash.b, clash.a});
    EXPECT_EQ(clash.place, other.place);
    EXPECT_EQ(clash.box, other.box);
    EXPECT_EQ(clash.triangle_pairs, other.triangle_pairs);
  }
}

// R78: with a tolerance of NaN nothing was compared, and all was well.
TEST(Regression, R78ADistanceThatIsNoNumberIsRefusedAndListsSayWhatWasCompared) {
  const std::vector<PartBody> outer{part_bodies(test::box_body({0, 0, 0}, {9, 9, 9})).at(0)};
  const std::vector<PartBody> inner{part_bodies(test::box_body({1, 1, 1}, {2, 2, 2})).at(0)};
  EXPECT_THROW(static_cast<void>(
                   clashes(outer, inner, {.within = std::numeric_limits<double>::quiet_NaN()})),
               Error);
  const ClashList list = clashes(outer, inner, {.within = 0});
  EXPECT_EQ(list.compared, 1U);
  ASSERT_EQ(list.clashes.size(), 1U);
  EXPECT_EQ(list.clashes[0].kind, ClashKind::inside);
}

}  // namespace
}  // namespace soms
