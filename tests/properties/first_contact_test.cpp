// First contacts along motions of all kinds, beside their twin in whole numbers.
#include "soms/motion/first_contact.h"

#include "soms/base/random.h"
#include "soms/motion/reference/first_contact.h"
#include "soms/query/overlap.h"
#include "soms/query/within.h"

#include "tests/properties/property.h"
#include "tests/support/bodies.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::check_property;

/// How the bodies of a case lie, beside random ones.
enum class MotionKind { random, lattice, flat, far, tiny, uneven, degenerate };

constexpr int kMotionKinds = 7;

/// A moving and a resting body.
struct MotionCase {
  Mesh mover;
  Mesh fixed;
  RigidMotion motion;
};

class MotionMaker {
 public:
  MotionMaker(MotionKind kind, std::uint64_t seed) : kind_(kind), rng_(seed) {
    unit_ = kind == MotionKind::tiny ? 0x1p-200 : 1;
    place_ = kind == MotionKind::far ? any(1e6) : Vec3{};
  }

  [[nodiscard]] MotionCase make() {
    MotionCase made;
    made.mover = soup({});
    made.fixed = soup(any(2));
    made.motion = motion();
    return made;
  }

 private:
  [[nodiscard]] Vec3 any(double most) {
    return {rng_.uniform(-most, most), rng_.uniform(-most, most), rng_.uniform(-most, most)};
  }

  [[nodiscard]] Vec3 corner(const Vec3& about) {
    Vec3 p = about + any(1.5);
    if (kind_ == MotionKind::lattice) {
      p = {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2, std::round(2 * p.z) / 2};
    }
    if (kind_ == MotionKind::flat) {
      p.z = std::round(p.z);
    }
    if (kind_ == MotionKind::uneven) {
      p = {p.x * 0x1p-20, p.y, p.z * 0x1p10};
    }
    return p * unit_ + place_;
  }

  [[nodiscard]] Mesh soup(const Vec3& about) {
    std::vector<Triangle> triangles;
    const std::uint64_t count = 1 + rng_.below(3);
    for (std::uint64_t k = 0; k < count; ++k) {
      Triangle t{corner(about), corner(about), corner(about)};
      if (kind_ == MotionKind::degenerate && rng_.below(2) == 0) {
        t.c = rng_.below(2) == 0 ? t.a : t.b;
        t.b = rng_.below(3) == 0 ? t.a : t.b;
      }
      triangles.push_back(t);
    }
    return test::soup_body(triangles);
  }

  [[nodiscard]] RigidMotion motion() {
    Vec3 by = any(4);
    if (kind_ == MotionKind::lattice) {
      by = {std::round(by.x), std::round(by.y), std::round(by.z)};
    }
    by = by * unit_;
    constexpr std::array kAngles{3.0, 1.0, 1e-2, 1e-7};
    const double angle = kAngles[rng_.below(kAngles.size())] * rng_.uniform(-1, 1);
    switch (rng_.below(4)) {
      case 0:
        return RigidMotion::along(Pose(), by);
      case 1:
        return RigidMotion::turn(Pose(), place_ + any(2) * unit_, any(1), angle);
      case 2:
        return RigidMotion::turn(Pose::translation(by.x, by.y, by.z), place_, {0, 0, 1}, angle);
      default: {
        const Pose there = Pose::translation(place_.x + by.x, place_.y + by.y, place_.z + by.z);
        const Pose back = Pose::translation(-place_.x, -place_.y, -place_.z);
        return RigidMotion::between(Pose(), there * Pose::from_axis_angle(any(1), angle) * back,
                                    place_ + any(1) * unit_);
      }
    }
  }

  MotionKind kind_;
  Rng rng_;
  double unit_;
  Vec3 place_;
};

/// What the answer has wrong beside the twin; nothing if all is well.
std::string fault_beside_twin(const Shape& mover, const RigidMotion& motion, const Body& fixed) {
  const FirstContact found = first_contact(mover, motion, fixed);
  const FirstContact twin = reference::first_contact_by_brute_force(mover, motion, fixed);
  const bool contact = found.verdict == ContactVerdict::contact;
  if ((found.verdict == ContactVerdict::started) != (twin.verdict == ContactVerdict::started)) {
    return "the start";
  }
  if (twin.verdict == ContactVerdict::contact) {
    if (found.verdict == ContactVerdict::free) {
      return "free, but in contact";
    }
    if (found.t.lower > twin.t.upper) {
      return "free for too long";
    }
  }
  if (contact && motion.straight()) {
    return twin.verdict == ContactVerdict::free ? "in contact, but free"
           : found.t.upper < twin.t.lower       ? "in contact too early"
                                                : "";
  }
  if (found.verdict == ContactVerdict::grazing) {
    return "neither proved";
  }
  const bool by_law = twin.verdict != ContactVerdict::free && found.t.upper >= twin.t.lower &&
                      found.t.upper <= std::nextafter(found.t.lower, 2);
  if (contact && !by_law && !overlap(Body(mover, motion.pose_at(found.t.upper)), fixed).any) {
    return "no contact at the time of the contact";
  }
  return found.t.lower <= found.t.upper ? "" : "the bracket";
}

TEST(FirstContactProperty, AnswersAsBruteForce) {
  check_property("first-contact/twin", [](std::uint64_t seed) {
    const auto kind = static_cast<MotionKind>(*rc::gen::inRange(0, kMotionKinds));
    const MotionCase c = MotionMaker(kind, seed).make();
    RC_ASSERT(fault_beside_twin(Shape(c.mover), c.motion, Body(c.fixed)) == "");
    RC_ASSERT(fault_beside_twin(Shape(c.mover, {.layout = Layout::compact}), c.motion,
                                Body(Shape(c.fixed, {.layout = Layout::compact}))) == "");
  });
}

// Bodies that are where they are, so nothing is rounded: seen from the other one, it is the same.
TEST(FirstContactProperty, StraightMotionsAreTheSameSeenFromTheOther) {
  check_property("first-contact/exchanged", [](std::uint64_t seed) {
    const auto kind = static_cast<MotionKind>(*rc::gen::inRange(0, kMotionKinds));
    const MotionCase c = MotionMaker(kind, seed).make();
    Rng rng(seed + 1);
    const Vec3 by = Vec3{rng.uniform(-4, 4), rng.uniform(-4, 4), rng.uniform(-4, 4)} *
                    (kind == MotionKind::tiny ? 0x1p-200 : 1);
    const FirstContact one =
        first_contact(Shape(c.mover), RigidMotion::along(Pose(), by), Body(c.fixed));
    const FirstContact other =
        first_contact(Shape(c.fixed), RigidMotion::along(Pose(), -by), Body(c.mover));
    RC_ASSERT(one.verdict == other.verdict);
    RC_ASSERT(one.t == other.t);
    RC_ASSERT(one.verdict != ContactVerdict::grazing);
  });
}

// A free motion is free at poses between, and keeps its clearance; so do its parts before a
// contact.
TEST(FirstContactProperty, NothingIsNearBeforeTheFirstContact) {
  check_property("first-contact/before", [](std::uint64_t seed) {
    const auto kind = static_cast<MotionKind>(*rc::gen::inRange(0, kMotionKinds));
    const MotionCase c = MotionMaker(kind, seed).make();
    Rng rng(seed + 2);
    const double clearance = rng.uniform(0, 0.5) * (kind == MotionKind::tiny ? 0x1p-200 : 1);
    const Shape mover(c.mover);
    const Body fixed(c.fixed);
    const FirstContact found = first_contact(mover, c.motion, fixed, {.within = clearance});
    for (int k = 0; k < 8 && found.t.lower > 0; ++k) {
      const double t = rng.unit() * std::min(1.0, found.t.lower);
      RC_ASSERT(!within(Body(mover, c.motion.pose_at(t)), fixed, clearance).within);
    }
    if (found.verdict == ContactVerdict::contact) {
      RC_ASSERT(within(Body(mover, c.motion.pose_at(found.t.upper)), fixed, clearance).within);
    }
  });
}

}  // namespace
}  // namespace soms
