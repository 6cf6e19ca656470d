// First contacts of turning triangles in whole numbers, beside the twin and beside times that are
// known.
#include "soms/motion/detail/exact_motion.h"

#include "soms/base/random.h"
#include "soms/motion/reference/first_contact.h"
#include "soms/query/body.h"

#include "tests/motion/known_motion.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace soms::detail {
namespace {

using test::MotionTable;
using test::next_to;

/// How the triangles of a case lie: coordinates are multiples of `step` unless that is 0, then
/// stretched, and moved by up to `far`.
struct ExactKind {
  const char* name;
  Vec3 stretch = {1, 1, 1};
  double step = 0;
  double far = 0;
  bool degenerate = false;  ///< some are segments and points
};

constexpr std::array kExactKinds{
    ExactKind{"random"},
    ExactKind{"lattice", {1, 1, 1}, 0.5},
    ExactKind{"far", {1, 1, 1}, 0, 1e6},
    ExactKind{"tiny", {0x1p-200, 0x1p-200, 0x1p-200}},
    ExactKind{"uneven", {0x1p-20, 1, 0x1p10}},
    ExactKind{"degenerate", {1, 1, 1}, 0, 0, true},
    ExactKind{"in a plane", {1, 1, 0}, 0, 0, true},
};

struct ExactCase {
  Triangle moving;
  Triangle resting;
  RigidMotion motion;
};

class ExactCaseMaker {
 public:
  ExactCaseMaker(const ExactKind& kind, Rng& rng)
      : kind_(kind), rng_(rng), place_(stretched(kind.far)) {}

  [[nodiscard]] ExactCase make() {
    const Vec3 beside = stretched(1.5);
    const Triangle moving = triangle({});
    const Triangle resting = triangle(beside);
    const bool planar = kind_.stretch.z == 0;
    const Vec3 axis = planar || rng_.below(3) == 0 ? Vec3{0, 0, 1} : any(1);
    constexpr std::array kAngles{3.0, 1.0, 1e-2, 1e-7};
    const double angle = kAngles[rng_.below(kAngles.size())] * rng_.uniform(-1, 1);
    const Vec3 there = place_ + (rng_.below(3) == 0 ? Vec3{} : stretched(3));
    const Pose end = Pose::from_axis_angle(axis, angle, there) *
                     Pose::translation(-place_.x, -place_.y, -place_.z);
    return {moving, resting, RigidMotion::between(Pose(), end, place_ + stretched(1))};
  }

 private:
  [[nodiscard]] Vec3 any(double most) {
    return {rng_.uniform(-most, most), rng_.uniform(-most, most), rng_.uniform(-most, most)};
  }

  [[nodiscard]] Vec3 stretched(double most) {
    Vec3 v = any(most);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      v[axis] = kind_.step > 0 ? std::round(v[axis] / kind_.step) * kind_.step : v[axis];
      v[axis] *= kind_.stretch[axis];
    }
    return v;
  }

  [[nodiscard]] Triangle triangle(const Vec3& beside) {
    const Vec3 about = place_ + beside;
    Triangle t{about + stretched(1.5), about + stretched(1.5), about + stretched(1.5)};
    if (kind_.degenerate && rng_.below(2) == 0) {
      t.c = rng_.below(2) == 0 ? t.a : t.b;
      t.b = rng_.below(3) == 0 ? t.c : t.b;
    }
    return t;
  }

  const ExactKind& kind_;
  Rng& rng_;
  Vec3 place_;
};

Shape shape_of(const Triangle& t) {
  return Shape(test::soup_body({t}));
}

/// What is wrong with the time beside the twin's; nothing if all is well.
std::string fault_beside_the_twin(const std::optional<Bracket>& found, const FirstContact& twin) {
  if (found && !(found->lower >= 0 && found->upper <= 1 && found->lower <= found->upper &&
                 found->upper <= std::nextafter(found->lower, 2))) {
    return "no doubles next to a time";
  }
  if (twin.verdict == ContactVerdict::free) {
    return found ? "in contact, but free" : "";
  }
  if (found && found->upper < twin.t.lower) {
    return "in contact too early";
  }
  if (twin.verdict == ContactVerdict::contact && (!found || found->lower > twin.t.upper)) {
    return found ? "in contact too late" : "free, but in contact";
  }
  return "";
}

TEST(ExactMotion, AgreesWithTheTwin) {
  for (const ExactKind& kind : kExactKinds) {
    int free = 0;
    int contacts = 0;
    test::for_each_case(kind.name, 200, [&](Rng& rng) {
      const ExactCase c = ExactCaseMaker(kind, rng).make();
      const FirstContact twin = reference::first_contact_by_brute_force(
          shape_of(c.moving), c.motion, Body(shape_of(c.resting)));
      if (twin.verdict != ContactVerdict::started) {
        const std::optional<Bracket> found = exact_motion(c.motion, c.moving, c.resting, 0, 1);
        ASSERT_EQ(fault_beside_the_twin(found, twin), "");
        ++(found ? contacts : free);
      }
    });
    EXPECT_GT(free, 20) << kind.name;
    EXPECT_GT(contacts, 5) << kind.name;
  }
}

TEST(ExactMotion, KissesAndGlidesAreAtTheirTimes) {
  const MotionTable table(test::data("motion/kisses.csv"));
  ASSERT_EQ(table.size(), 184U);
  for (std::size_t row = 0; row < table.size(); ++row) {
    SCOPED_TRACE("row " + std::to_string(row) + ", " + table.text(row, "kind"));
    const test::KnownMotion known = test::known_motion(table, row);
    const auto exact = [&](double from, double until) {
      return exact_motion(known.motion, known.moving, known.resting, from, until);
    };
    const std::optional<Bracket> found = exact(0, 1);
    ASSERT_EQ(found, known.time);
    const FirstContact twin = reference::first_contact_by_brute_force(
        shape_of(known.moving), known.motion, Body(shape_of(known.resting)));
    ASSERT_EQ(fault_beside_the_twin(found, twin), "");
    if (found) {
      ASSERT_FALSE(exact(0, std::nextafter(found->lower, 0)));
      ASSERT_EQ(exact(found->lower, found->upper), found);
    }
  }
}

TEST(ExactMotion, BeginAndEndBelongToIt) {
  // A corner turns from the x axis to the y axis, where it meets a wall from below.
  const RigidMotion motion =
      RigidMotion::between(Pose(), Pose::from_quaternion(0, 0, 0, 1, {0, 0, 0}));
  const Triangle moving{{4, 0, 0}, {1, 0, -1}, {1, 0, 1}};
  const Triangle wall{{-5, 4, -5}, {5, 4, -5}, {0, 4, 9}};
  EXPECT_EQ(exact_motion(motion, moving, wall, 0, 1), (Bracket{0.5, 0.5}));
  EXPECT_EQ(exact_motion(motion, moving, wall, 0.25, 0.5), (Bracket{0.5, 0.5}));
  EXPECT_EQ(exact_motion(motion, moving, wall, 0.5, 1), (Bracket{0.5, 0.5}));
  EXPECT_EQ(exact_motion(motion, moving, wall, 0.5, 0.5), (Bracket{0.5, 0.5}));
  EXPECT_FALSE(exact_motion(motion, moving, wall, 0, std::nextafter(0.5, 0.0)));
  EXPECT_FALSE(exact_motion(motion, moving, wall, std::nextafter(0.5, 1.0), 1));
  // Edges pass through a face at the begin, and no corner or edge meets another.
  const Triangle across{{-5, 2, -9}, {5, 2, -9}, {0, 2, 9}};
  EXPECT_EQ(exact_motion(motion, moving, across, 0.5, 1), (Bracket{0.5, 0.5}));
}

// From 2^-1074 to 2^300: thousands of bits.
TEST(ExactMotion, AllMagnitudesAtOnce) {
  const RigidMotion motion =
      RigidMotion::between(Pose(), Pose::from_quaternion(0, 0, 0, 1, {0, 0, 0}));
  constexpr double kLarge = 0x1p290;
  constexpr double kLeast = 0x1p-1074;
  const Triangle moving{{5 * kLarge, 0, 0}, {kLeast, kLeast, -kLeast}, {kLarge, 0x1p-500, kLeast}};
  const Triangle wall{{-0x1p299, 4 * kLarge, -kLeast},
                      {0x1p299, 4 * kLarge, -kLeast},
                      {kLeast, 4 * kLarge, 0x1p299}};
  EXPECT_EQ(exact_motion(motion, moving, wall, 0, 1), next_to(1, 3));
  EXPECT_EQ(exact_motion(motion, moving, wall, kLeast, 1 - 0x1p-53), next_to(1, 3));
  EXPECT_FALSE(exact_motion(motion, moving, wall, kLeast, 0.25));
}

}  // namespace
}  // namespace soms::detail
