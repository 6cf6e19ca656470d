// Clashes are those of the brute-force twin.
#include "soms/clash/clash.h"
#include "soms/clash/print.h"
#include "soms/clash/reference/clash.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace soms {
namespace {

/// Where boxes have their corners: on few coordinates, so that many touch; or anywhere.
enum class Corners { grid, anywhere };

Mesh random_parts(Rng& rng, Corners corners, double scale, const Vec3& origin) {
  Mesh mesh;
  const std::size_t count = 2 + rng.below(7);
  for (std::size_t k = 0; k < count; ++k) {
    Vec3 lower;
    Vec3 upper;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double from =
          corners == Corners::grid ? static_cast<double>(rng.below(4)) : 4 * rng.unit();
      const double side =
          corners == Corners::grid ? static_cast<double>(1 + rng.below(3)) : 0.1 + rng.unit();
      lower[axis] = origin[axis] + scale * from;
      upper[axis] = origin[axis] + scale * (from + side);
    }
    Mesh box = test::box_body(lower, upper);
    if (rng.below(6) == 0) {
      // A second component, in the first or beside it.
      const double shift = corners == Corners::grid ? static_cast<double>(rng.below(4)) : 1.5;
      const Vec3 by = scale * Vec3{shift, shift, 0};
      box = test::joined(box, test::box_body(lower + by, lower + by + 0.25 * (upper - lower)));
      box.parts.clear();
    }
    if (rng.below(4) == 0) {
      box.triangles.erase(box.triangles.begin() + static_cast<std::ptrdiff_t>(rng.below(12)));
    }
    const auto first = static_cast<std::uint32_t>(mesh.triangles.size());
    const auto triangles = static_cast<std::uint32_t>(box.triangles.size());
    mesh = test::joined(mesh, box);
    mesh.parts.push_back({.name = std::to_string(k), .first = first, .count = triangles});
  }
  return mesh;
}

void expect_as_twin(const std::vector<Clash>& found, const std::vector<Clash>& twin) {
  ASSERT_EQ(found.size(), twin.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    Clash clash = found[k];
    EXPECT_GE(clash.place.x, clash.box.lower.x - 1e-9 * std::abs(clash.box.lower.x));
    EXPECT_LE(clash.place.x, clash.box.upper.x + 1e-9 * std::abs(clash.box.upper.x));
    clash.place = {};
    clash.box = {};
    clash.penetration.reset();
    EXPECT_EQ(clash, twin[k]);
  }
}

void expect_clashes(Rng& rng, Corners corners, double scale, const Vec3& origin) {
  const std::vector<PartBody> a = part_bodies(random_parts(rng, corners, scale, origin));
  const std::vector<PartBody> b = part_bodies(random_parts(rng, corners, scale, origin));
  for (const std::optional<double> within : {std::optional<double>(), std::optional(0.0),
                                             std::optional(scale), std::optional(3 * scale)}) {
    const ClashOptions options{.within = within};
    const ClashList list = clashes(a, b, options);
    EXPECT_EQ(list.coverage, Coverage::complete);
    expect_as_twin(list.clashes, reference::clashes_by_brute_force(a, b, within));
    expect_as_twin(clashes(a, options).clashes, reference::clashes_by_brute_force(a, within));
    EXPECT_EQ(clashes(a, b, options, {.threads = 3}), list);
  }
}

TEST(ClashTwin, AgreesWhereBoxesTouch) {
  test::for_each_case("clash grid", 6, [](Rng& rng) { expect_clashes(rng, Corners::grid, 1, {}); });
}

TEST(ClashTwin, AgreesAnywhere) {
  test::for_each_case("clash anywhere", 4,
                      [](Rng& rng) { expect_clashes(rng, Corners::anywhere, 1, {}); });
}

TEST(ClashTwin, AgreesFarAway) {
  test::for_each_case("clash far", 2, [](Rng& rng) {
    expect_clashes(rng, Corners::grid, 0.25, {5e6, -4e5, 1e3});
    expect_clashes(rng, Corners::anywhere, 1, {5e6, -4e5, 1e3});
  });
}

TEST(ClashTwin, AgreesOnTinyParts) {
  test::for_each_case("clash tiny", 2, [](Rng& rng) {
    expect_clashes(rng, Corners::grid, 0x1p-1060, {});
    expect_clashes(rng, Corners::anywhere, 1e-30, {});
  });
}

}  // namespace
}  // namespace soms
