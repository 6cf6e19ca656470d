/// \file
/// When does a moving body first touch another, if at all? Proved for all times of the way, not for
/// samples of it.
///
/// \code
/// const soms::Shape ball(soms::generate_sphere(320));  // of radius 1, about the origin
/// const soms::Body other(ball, soms::Pose::translation(0, 0, 5));
/// const soms::FirstContact answer = soms::first_contact(
///     ball, soms::RigidMotion::along(soms::Pose::identity(), {0, 0, 6}), other);
/// std::cout << answer.verdict << " at " << answer.t.upper << " of the way\n";
/// \endcode
/// It prints:
/// \verbatim
/// contact at 0.5 of the way
/// \endverbatim
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/motion/rigid_motion.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"

#include <optional>
#include <tuple>

namespace soms {

/// What is proved of a motion.
enum class ContactVerdict : unsigned char {
  free,     ///< no contact at any time
  contact,  ///< free until `t.lower`, in contact at `t.upper`
  grazing,  ///< neither: nearer than rounding can tell, or the deadline passed first
  started,  ///< in contact at the start
};

template <>
inline constexpr auto kWords<ContactVerdict> = words(
    "ContactVerdict",
    "What is proved of a motion: no contact at all, a contact on the way, neither of the two, "
    "or a contact at the start.",
    "free", "contact", "grazing", "started");

/// Options of `first_contact`.
struct FirstContactOptions {
  /// Being this near is a contact; 0 for a common point.
  double within = 0;

  [[nodiscard]] bool operator==(const FirstContactOptions&) const = default;
};

template <>
struct Fields<FirstContactOptions> {
  static constexpr const char* kName = "FirstContactOptions";
  static constexpr const char* kMeaning = "Options of first_contact.";
  static constexpr auto kList =
      std::tuple(field("within", &FirstContactOptions::within, "Being this near is a contact."));
};

/// Answer of `first_contact`. Times are parts of the way, from 0 to 1.
struct FirstContact {
  ContactVerdict verdict = ContactVerdict::free;
  /// Holds the time of the first contact. Before `lower` there is none, neither of the body where
  /// the law of the motion puts it in real numbers, nor at poses of `pose_at`. At `upper` the body
  /// at `pose_at(upper)` is in contact, as `within` decides it; infinity where none is proved.
  /// [1, infinity] where all is free, [0, 0] where the motion starts in contact.
  ///
  /// For straight motions without a clearance the law alone counts, and these are the doubles next
  /// to the exact time.
  Bracket t = {};
  /// A triangle of the mover and one of the fixed body that are in contact at `t.upper`. Where no
  /// contact is proved, those that are next to one at `t.lower`. Nothing where all is free.
  std::optional<TrianglePair> triangles = std::nullopt;
  /// In world: a common point of the pair at `t.upper`. Where there is none, it is the point of the
  /// fixed triangle that is next to the other.
  Vec3 point = {};
  /// From the fixed body to the mover at `point`, of length 1. Only where a corner meets a face, or
  /// an edge an edge, inside of both: elsewhere a contact has no one normal. Nothing with a
  /// clearance, and at the start.
  std::optional<Vec3> normal = std::nullopt;
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const FirstContact&) const = default;
};

template <>
struct Fields<FirstContact> {
  static constexpr const char* kName = "FirstContact";
  static constexpr const char* kMeaning = "Answer of first_contact.";
  static constexpr auto kList = std::tuple(
      field("verdict", &FirstContact::verdict, "What is proved."),
      field("t", &FirstContact::t, "The time of the first contact, a part of the way."),
      field("triangles", &FirstContact::triangles, "A pair that is in contact then."),
      field("point", &FirstContact::point, "Where it is, in world.").where_named(),
      field("normal", &FirstContact::normal, "From the fixed body to the mover, of length 1."),
      field("coverage", &FirstContact::coverage, "How much of the question is decided."),
      field("cost", &FirstContact::cost, "Work done."));
};

/// The first contact of `mover` on its way with `fixed`, which rests. Surfaces only, as `overlap`.
///
/// A straight motion (RigidMotion::along) without a clearance is decided exactly. Vertices are
/// where the pose of the start moves them, and shifted from there in real numbers. The time is a
/// quotient of whole numbers, the pair the least (i, j) of all that touch first. `pose_at` rounds
/// shifts, so next to a contact `overlap` may say otherwise there.
///
/// For all others, `free` holds at every time, for the body in real numbers and at every pose of
/// `pose_at`. `contact` says that the body at `pose_at(t.upper)` is in contact by the library's
/// exact decision. Poses at both ends that are rotations to 1e-6 only are decided as they are.
/// `grazing` is what remains: nearer than some 2^-44 of the largest coordinate, beyond `within`, at
/// `t.lower`, and no time was found with a contact. The bracket is as wide as that gap takes to
/// close. The pair named is the least of those with the earliest proof, not always the first one to
/// touch where several do so within the bracket.
///
/// \errors  ErrorKind::not_rigid, not_finite, out_of_range for a pose, or where the body may come
///          beyond 2^300 on its way; usage as `check(FirstContactOptions)`; cancelled.
/// \cost    Typically a few times `distance` of the start. A deadline ends it with coverage `cut`
///          and what is proved until then. Bodies that slide along each other for long at next to
///          no gap cost most.
/// \threads Any number of callers; the query runs on the caller's thread.
/// \source  Mirtich 1996 (conservative advancement), Redon, Kheddar and Coquillart 2002 (intervals
///          of time in box hierarchies); chords instead of velocities are our own.
[[nodiscard]] FirstContact first_contact(const Shape& mover, const RigidMotion& motion,
                                         const Body& fixed, const FirstContactOptions& options = {},
                                         const Limits& limits = {});

}  // namespace soms
