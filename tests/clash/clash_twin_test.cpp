// Clashes are those of the brute-force twin.
#include "soms/clash/clash.h"
#include "soms/clash/print.h"
#include "soms/clash/reference/clash.h"

#include "tests/clash/tray.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
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

void expect_as_twins(const std::vector<PartBody>& a, const std::vector<PartBody>& b,
                     const std::vector<std::optional<double>>& withins) {
  for (const std::optional<double> within : withins) {
    const ClashOptions options{.within = within};
    const ClashList list = clashes(a, b, options);
    EXPECT_EQ(list.coverage, Coverage::complete);
    expect_as_twin(list.clashes, reference::clashes_by_brute_force(a, b, within));
    expect_as_twin(clashes(a, options).clashes, reference::clashes_by_brute_force(a, within));
    EXPECT_EQ(clashes(a, b, options, {.threads = 3}), list);
  }
}

void expect_clashes(Rng& rng, Corners corners, double scale, const Vec3& origin) {
  const std::vector<PartBody> a = part_bodies(random_parts(rng, corners, scale, origin));
  const std::vector<PartBody> b = part_bodies(random_parts(rng, corners, scale, origin));
  expect_as_twins(a, b, {std::nullopt, 0.0, scale, 3 * scale});
}

/// Boxes whose faces are parts, with and without lids, and boxes of one part: some in others.
Mesh random_trays(Rng& rng) {
  Mesh mesh;
  const std::size_t count = 1 + rng.below(3);
  for (std::size_t k = 0; k < count; ++k) {
    Vec3 lower;
    Vec3 upper;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // Nested boxes share no plane.
      lower[axis] = static_cast<double>(rng.below(3)) + 0.125 * static_cast<double>(k);
      upper[axis] = lower[axis] + 1 + static_cast<double>(rng.below(5));
    }
    if (rng.below(3) == 0) {
      Mesh box = test::box_body(lower, upper);
      box.parts = {{.name = "box", .first = 0, .count = 12}};
      append(mesh, box);
    } else {
      append(mesh, test::tray(lower, upper, rng.below(3) == 0));
    }
  }
  return mesh;
}

Pose random_rotation(Rng& rng) {
  if (rng.below(2) == 0) {
    const std::vector<Pose> quarters = test::cube_rotations();
    return quarters[rng.below(quarters.size())];
  }
  const Vec3 axis{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.5, 1)};
  return Pose::from_axis_angle((1 / std::sqrt(dot(axis, axis))) * axis, rng.uniform(-3, 3));
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

// Open groups, of one set and of two, which are moved together.
TEST(ClashTwin, AgreesOnWhatIsOpenTogether) {
  std::size_t held = 0;
  std::size_t clear = 0;
  test::for_each_case("clash trays", 200, [&](Rng& rng) {
    const Pose pose = random_rotation(rng);
    const std::vector<PartBody> a = part_bodies(random_trays(rng), pose);
    const std::vector<PartBody> b = part_bodies(random_trays(rng), pose);
    expect_as_twins(a, b, {std::nullopt, 0.25});
    for (const Clash& clash : clashes(a, b).clashes) {
      const bool is_of_groups = a[clash.a].together.body || b[clash.b].together.body;
      held +=
          is_of_groups && clash.kind == ClashKind::undecided && clash.triangle_pairs == 0 ? 1 : 0;
    }
    clear += a.size() * b.size() - clashes(a, b).clashes.size();
  });
  EXPECT_GT(held, 0U);
  EXPECT_GT(clear, 0U);
}

}  // namespace
}  // namespace soms
