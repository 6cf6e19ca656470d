// What a first contact that a deadline cut says, wherever it was cut.
#include "soms/generate/shapes.h"
#include "soms/motion/first_contact.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>

namespace soms {
namespace {

// Whatever a deadline leaves is proved: it agrees with the whole answer.
TEST(FirstContactCut, WhatADeadlineLeavesIsProved) {
  const Shape mover(generate_knot(3000));
  const Body fixed(Shape(generate_knot(3000)), Pose::about_z(0.4, {9, 0, 0}));
  const RigidMotion motion =
      RigidMotion::between(Pose(), Pose::from_axis_angle({1, 2, 3}, 1.5, {18, 0, 0}));
  const FirstContact whole = first_contact(mover, motion, fixed);
  ASSERT_EQ(whole.verdict, ContactVerdict::contact);
  int cut = 0;
  double wait = 10;
  for (bool complete = false; !complete; wait *= 1.3) {
    const auto deadline = std::chrono::steady_clock::now() +
                          std::chrono::microseconds(static_cast<std::int64_t>(wait));
    const FirstContact part = first_contact(mover, motion, fixed, {}, {.deadline = deadline});
    complete = part.coverage == Coverage::complete;
    ASSERT_NE(part.verdict, ContactVerdict::free);
    ASSERT_LE(part.t.lower, whole.t.upper);
    ASSERT_GE(part.t.upper, whole.t.lower);
    cut += complete ? 0 : 1;
  }
  EXPECT_GT(cut, 0);
}

}  // namespace
}  // namespace soms
