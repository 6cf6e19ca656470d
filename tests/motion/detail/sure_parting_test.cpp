// The filter before whole numbers: it never says more than they do, and says enough of near misses.
#include "soms/motion/detail/exact/sure_parting.h"

#include "soms/motion/reference/first_contact.h"
#include "soms/query/body.h"

#include "tests/motion/known_motion.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace soms::detail {
namespace {

Shape parted_shape(const Triangle& t) {
  Mesh mesh;
  mesh.vertices = {t.a, t.b, t.c};
  mesh.triangles = {{0, 1, 2}};
  return Shape(std::move(mesh));
}

Triangle near_triangle(Rng& rng, double step) {
  const auto number = [&] {
    const double x = rng.uniform(-1, 1);
    return step > 0 ? std::round(x / step) * step : x;
  };
  const auto corner = [&] { return Vec3{number(), number(), number()}; };
  return {corner(), corner(), corner()};
}

TEST(SureParting, SaysNothingThatTheTwinDenies) {
  int parted = 0;
  int contacts = 0;
  test::for_each_case("sure parting", 2000, [&](Rng& rng) {
    const double step = rng.below(2) == 0 ? 0 : 0.25;
    const Triangle moving = near_triangle(rng, step);
    const Triangle resting = near_triangle(rng, step);
    const Pose end = Pose::from_axis_angle({rng.uniform(-1, 1), rng.uniform(-1, 1), 1},
                                           rng.uniform(-3, 3), {rng.uniform(-1, 1), 0, 0});
    const RigidMotion motion = RigidMotion::between(Pose(), end);
    if (!surely_parted(motion, moving, resting, 0, 1)) {
      ++contacts;
      return;
    }
    ++parted;
    const FirstContact twin = reference::first_contact_by_brute_force(parted_shape(moving), motion,
                                                                      Body(parted_shape(resting)));
    ASSERT_EQ(twin.verdict, ContactVerdict::free);
  });
  EXPECT_GT(parted, 500);
  EXPECT_GT(contacts, 200);
}

// Kisses and their misses by 2^-20 to 2^-40 are as hard as can be.
TEST(SureParting, TellsMissesFromKisses) {
  const test::MotionTable table(test::data("motion/kisses.csv"));
  int misses = 0;
  int said = 0;
  for (std::size_t row = 0; row < table.size(); ++row) {
    SCOPED_TRACE("row " + std::to_string(row));
    const test::KnownMotion known = test::known_motion(table, row);
    const bool parted = surely_parted(known.motion, known.moving, known.resting, 0, 1);
    if (known.time) {
      ASSERT_FALSE(parted);
      if (known.time->lower > 0x1p-10) {
        const double before = known.time->lower * (1 - 0x1p-20);
        said += surely_parted(known.motion, known.moving, known.resting, before,
                              known.time->lower * (1 - 0x1p-40))
                    ? 1
                    : 0;
        ASSERT_FALSE(
            surely_parted(known.motion, known.moving, known.resting, before, known.time->upper));
      }
    } else {
      ++misses;
      said += parted ? 1 : 0;
    }
  }
  EXPECT_GE(misses, 20);
  EXPECT_GT(said, 50);  // others glide, or are nearer than the numbers tell
}

// A plate that glides over another, at gaps below the rounding of a double.
TEST(SureParting, PartsWhatGlidesAtNextToNoGap) {
  const RigidMotion motion = RigidMotion::between(Pose(), Pose::about_z(0.3, {0.2, 0.1, 0}));
  const Triangle resting{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const double gap : {1e-14, 1e-17, 1e-23}) {
    const Triangle moving{{0, 0, gap}, {1, 0, gap}, {0, 1, gap}};
    EXPECT_TRUE(surely_parted(motion, moving, resting, 0, 1)) << gap;
    EXPECT_FALSE(surely_parted(motion, resting, resting, 0, 1));
  }
  const Triangle flush{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_FALSE(surely_parted(motion, flush, resting, 0, 1));
}

}  // namespace
}  // namespace soms::detail
