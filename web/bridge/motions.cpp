// First contacts along motions.
#include "soms/motion/first_contact.h"

#include "web/bridge/answer.h"
#include "web/bridge/arguments.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <cstdint>
#include <vector>

using soms::Body;
using soms::Pose;
using soms::RigidMotion;
using soms::Vec3;
using soms::web::Answer;
using soms::web::answer_of;
using soms::web::answer_of_batch;
using soms::web::guarded;
using soms::web::HeldShape;
using soms::web::within_time;

namespace {

/// A motion as arrays.js has it: 28 numbers.
struct MotionNumbers {
  double kind;  ///< 0 along, 1 between, 2 turn
  Pose start;
  double rest[15];  ///< by; end and pivot; center, axis and angle

  [[nodiscard]] Vec3 vector(int first) const {
    return {rest[first], rest[first + 1], rest[first + 2]};
  }

  [[nodiscard]] RigidMotion motion() const {
    if (kind == 0) {
      return RigidMotion::along(start, vector(0));
    }
    if (kind == 2) {
      return RigidMotion::turn(start, vector(0), vector(3), rest[6]);
    }
    Pose end;
    for (std::size_t k = 0; k < 12; ++k) {
      end.m[k] = rest[k];
    }
    return RigidMotion::between(start, end, vector(12));
  }
};

static_assert(sizeof(MotionNumbers) == 28 * sizeof(double));

}  // namespace

SOMS_EXPORT(soms_first_contact)

Answer* soms_first_contact(const HeldShape* mover, const MotionNumbers* numbers,
                           std::uint32_t count, const HeldShape* fixed, const Pose* pose,
                           double within, std::uint32_t parting, double milliseconds) {
  return guarded([&] {
    std::vector<RigidMotion> motions;
    motions.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      motions.push_back(numbers[i].motion());
    }
    return answer_of_batch<soms::FirstContact>(soms::first_contact(
        mover->shape(), motions, Body(fixed->shape(), *pose),
        {.within = within, .parting = parting != 0}, within_time(milliseconds)));
  });
}

SOMS_EXPORT(soms_pose_at)

Answer* soms_pose_at(const MotionNumbers* numbers, double t) {
  return guarded([&] {
    const Pose pose = numbers->motion().pose_at(t);
    return answer_of(std::vector<double>(pose.m.begin(), pose.m.end()));
  });
}
