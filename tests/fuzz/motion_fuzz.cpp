// A few triangles of awkward numbers and sizes on an awkward way past others: the first contact by
// the traversal, against brute force in whole numbers and poses on the way.
#include "soms/base/error.h"
#include "soms/motion/first_contact.h"
#include "soms/motion/reference/first_contact.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/query/overlap.h"
#include "soms/query/within.h"

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/poses.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/scales.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

using fuzz::Bytes;
using fuzz::require;

/// A coordinate on a lattice, a step of the last place beside it, or anywhere.
double coordinate_of(Bytes& bytes, std::uint32_t kind) {
  const double on_lattice = static_cast<double>(bytes.below(7)) - 3;
  switch (kind) {
    case 0:
      return on_lattice;
    case 1:
      return on_lattice + std::ldexp(static_cast<double>(bytes.below(7)) - 3, -51);
    case 2:
      return std::ldexp(on_lattice, static_cast<int>(bytes.below(40)) - 38);
    default:
      return 4 * bytes.fraction();
  }
}

Vec3 vector_of(Bytes& bytes, std::uint32_t kind, double unit) {
  const double x = coordinate_of(bytes, kind);
  const double y = coordinate_of(bytes, kind);
  return Vec3{x, y, coordinate_of(bytes, kind)} * unit;
}

Mesh soup_of(Bytes& bytes, double unit) {
  Mesh mesh;
  const std::uint32_t kind = bytes.below(4);
  for (std::uint32_t i = 0, count = 1 + bytes.below(3); i < count; ++i) {
    std::array<std::uint32_t, 3> corners = {};
    for (std::uint32_t& corner : corners) {
      const auto known = static_cast<std::uint32_t>(mesh.vertices.size());
      corner = known;
      if (known > 0 && bytes.below(8) == 0) {
        corner = bytes.below(known);  // wires and points among them
      } else {
        mesh.vertices.push_back(vector_of(bytes, kind, unit));
      }
    }
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

/// A shift, a turn, or both; quarter turns about an axis of the lattice are among them.
RigidMotion motion_of(Bytes& bytes, double unit) {
  constexpr std::array kAngles{0.5, -1.0, 1.5707963267948966, 3.0, 1e-3, 1e-9};
  const std::uint32_t kind = bytes.below(4);
  const Pose start = fuzz::pose_of(bytes, unit);
  const Vec3 by = vector_of(bytes, kind, 2 * unit);
  switch (bytes.below(3)) {
    case 0:
      return RigidMotion::along(start, by);
    case 1: {
      Vec3 axis;
      axis[bytes.below(3)] = 1;
      return RigidMotion::turn(start, by, axis, kAngles[bytes.below(kAngles.size())]);
    }
    default: {
      const Pose end = fuzz::pose_of(bytes, unit);
      return RigidMotion::between(start, end, by);
    }
  }
}

/// The bodies overlap at `pose_at(t)`, and still do if the mover is shifted by 2^-38 of the largest
/// coordinates along any axis. Poses are off the law by less than 2^-44 of them.
bool deep_contact_at(const Shape& mover, const RigidMotion& motion, const Body& fixed, double t) {
  const Pose pose = motion.pose_at(t);
  const Vec3& pivot = motion.pivot();
  const double by = 0x1p-38 * (detail::moved_extent(pose, mover.bounds()) +
                               detail::moved_extent(fixed.pose, fixed.shape.bounds()) +
                               std::abs(pivot.x) + std::abs(pivot.y) + std::abs(pivot.z));
  const std::array<Vec3, 7> shifts{Vec3{0, 0, 0},   Vec3{by, 0, 0}, Vec3{-by, 0, 0}, Vec3{0, by, 0},
                                   Vec3{0, -by, 0}, Vec3{0, 0, by}, Vec3{0, 0, -by}};
  return std::all_of(shifts.begin(), shifts.end(), [&](const Vec3& shift) {
    const Body there(mover, Pose::translation(shift.x, shift.y, shift.z) * pose);
    return overlap(there, fixed, {.mode = OverlapMode::any}).any;
  });
}

/// What is said holds at poses of the way, but for their rounding.
void check_poses(const FirstContact& found, const Shape& mover, const RigidMotion& motion,
                 const Body& fixed) {
  const double until = std::min(found.t.lower, 1.0);
  for (const double part : {0.0, 0.25, 0.5, 0.8125, 1.0}) {
    const double t = part * until;
    if (t < found.t.lower) {
      require(!deep_contact_at(mover, motion, fixed, t), "a contact before the first one");
    }
  }
}

/// Brute force decides the law, and the poses at both ends are decided as they are.
void check_twin(const FirstContact& found, const Shape& mover, const RigidMotion& motion,
                const Body& fixed) {
  const FirstContact twin = reference::first_contact_by_brute_force(mover, motion, fixed);
  require((found.verdict == ContactVerdict::started) == (twin.verdict == ContactVerdict::started),
          "a contact at the start");
  if (twin.verdict == ContactVerdict::contact) {
    require(found.verdict != ContactVerdict::free, "free, though brute force finds a contact");
    require(found.t.lower <= twin.t.upper, "a contact before the first one, by brute force");
  }
  require(found.verdict != ContactVerdict::grazing, "a motion that is not decided");
  if (motion.straight()) {
    require(twin.verdict != ContactVerdict::free || found.verdict == ContactVerdict::free,
            "a contact of a straight motion that brute force proves free");
    require(found.verdict != ContactVerdict::contact || found.t.upper >= twin.t.lower,
            "a contact of a straight motion before that of brute force");
  }
}

/// Layouts, batches, threads, a clearance, and a second body whose motion is to rest.
void check_kinds(const FirstContact& found, const Shape& mover, const RigidMotion& motion,
                 const Body& fixed) {
  const std::vector<RigidMotion> twice{motion, motion};
  const FirstContactBatch batch = first_contact(mover, twice, fixed, {}, {.threads = 2});
  require(batch.at(0) == found && batch.at(1) == found, "a batch");
  const Shape compact(Mesh(mover.mesh()), {.layout = Layout::compact});
  const FirstContact other = first_contact(compact, motion, fixed);
  require(other.verdict == found.verdict && other.t.lower <= found.t.upper &&
              found.t.lower <= other.t.upper,
          "another layout");
  const Pose rests = fixed.pose;
  const FirstContact two =
      first_contact(mover, motion, fixed.shape, RigidMotion::along(rests, {0, 0, 0}));
  require(found.verdict != ContactVerdict::contact || two.verdict != ContactVerdict::free,
          "free beside a body whose motion is to rest");
}

void check_motion_input(Bytes& bytes) {
  const double unit = bytes.below(4) == 0 ? fuzz::unit_of(bytes) : 1;
  const Shape mover(soup_of(bytes, unit));
  const Body fixed(Shape(soup_of(bytes, unit)), fuzz::pose_of(bytes, unit));
  const RigidMotion motion = motion_of(bytes, unit);
  const FirstContact found = first_contact(mover, motion, fixed);
  require(found.coverage == Coverage::complete, "complete without a deadline");
  check_poses(found, mover, motion, fixed);
  check_kinds(found, mover, motion, fixed);
  check_twin(found, mover, motion, fixed);
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  soms::fuzz::Bytes bytes({data, size});
  try {
    soms::check_motion_input(bytes);
  } catch (const soms::Error& error) {
    // Units near the limits lead beyond them.
    soms::fuzz::require(
        error.kind() == soms::ErrorKind::out_of_range || error.kind() == soms::ErrorKind::usage,
        error.what());
  }
  return 0;
}
