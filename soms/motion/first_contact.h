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
///
/// const std::vector<soms::RigidMotion> motions{
///     soms::RigidMotion::along(soms::Pose::identity(), {0, 0, 6}),
///     soms::RigidMotion::along(soms::Pose::identity(), {6, 0, 0})};
/// std::cout << soms::first_contact(ball, motions, other).verdict[1] << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// contact at 0.5 of the way
/// free
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

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

/// What is proved of a motion.
enum class ContactVerdict : unsigned char {
  free,     ///< no contact at any time
  contact,  ///< free until `t.lower`, in contact at `t.upper`
  grazing,  ///< neither: out of time, or next to rounding where the law is not decided
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
  /// Pairs of triangles in contact at the start are left out all the way, also where they part and
  /// meet again: what rests on a triangle can slide. On a plate of several, each that it comes
  /// to is a new contact. The verdict stays `started`, and `t` and
  /// `triangles` are those of the first contact of another pair.
  bool parting = false;

  [[nodiscard]] bool operator==(const FirstContactOptions&) const = default;
};

template <>
struct Fields<FirstContactOptions> {
  static constexpr const char* kName = "FirstContactOptions";
  static constexpr const char* kMeaning = "Options of first_contact.";
  static constexpr auto kList =
      std::tuple(field("within", &FirstContactOptions::within, "Being this near is a contact."),
                 field("parting", &FirstContactOptions::parting,
                       "Pairs of triangles in contact at the start are left out."));
};

/// Answer of `first_contact`. Times are parts of the way, from 0 to 1.
struct FirstContact {
  ContactVerdict verdict = ContactVerdict::free;
  /// Holds the time of the first contact. Before `lower` there is none of the body where the law of
  /// the motion puts it in real numbers, nor at poses of `pose_at` but for their rounding. By
  /// `upper` there is one: of the body at `pose_at(upper)`, as `within` decides it, or by the law.
  /// Infinity where none is proved. [1, infinity] where all is free, [0, 0] where the motion starts
  /// in contact, unless `parting` is set.
  ///
  /// Where the law decides, as always for straight motions without a clearance, these are the
  /// doubles next to the exact time.
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

/// Answers for a batch of motions: columns, one entry a motion, as those of `FirstContact`.
struct FirstContactBatch {
  std::vector<ContactVerdict> verdict;                 ///< n
  std::vector<double> lower;                           ///< n, of `t`
  std::vector<double> upper;                           ///< n
  std::vector<std::optional<TrianglePair>> triangles;  ///< n
  std::vector<Vec3> point;                             ///< n
  std::vector<std::optional<Vec3>> normal;             ///< n
  std::vector<Coverage> coverage;                      ///< n
  std::vector<Cost> costs;                             ///< n
  Cost cost;                                           ///< of all motions together

  [[nodiscard]] bool operator==(const FirstContactBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return verdict.size(); }

  /// The answer for a motion.
  [[nodiscard]] FirstContact at(std::size_t motion) const;

  /// The first motion that is not proved to be free: where a path ends. Nothing where all are.
  [[nodiscard]] std::optional<std::size_t> first_blocked() const;
};

template <>
struct Fields<FirstContact> {
  static constexpr const char* kName = "FirstContact";
  static constexpr const char* kMeaning = "Answer of first_contact.";
  static constexpr const char* kBatchName = "FirstContactBatch";
  static constexpr const char* kBatchMeaning = "Answers of first_contact for n motions.";
  static constexpr const char* kRows = "motions";
  using Batch = FirstContactBatch;
  static constexpr std::array kCounted{Counted<FirstContact>{
      [](const FirstContact& answer) { return answer.verdict == ContactVerdict::free; }, "free"}};
  static constexpr auto kList = std::tuple(
      field("verdict", &FirstContact::verdict, &Batch::verdict, "What is proved."),
      field("t", &FirstContact::t, BracketColumns<Batch>{&Batch::lower, &Batch::upper},
            "The part of the way at the first contact"),
      field("triangles", &FirstContact::triangles, &Batch::triangles,
            "A pair that is in contact then."),
      field("point", &FirstContact::point, &Batch::point, "Where it is, in world.").where_named(),
      field("normal", &FirstContact::normal, &Batch::normal,
            "From the fixed body to the mover, of length 1."),
      coverage_field(&FirstContact::coverage, &Batch::coverage),
      cost_field(&FirstContact::cost, &Batch::costs));
};

/// The first contact of `mover` on its way with `fixed`, which rests. Surfaces only, as `overlap`.
///
/// A straight motion (RigidMotion::along) without a clearance is decided exactly. Vertices are
/// where the pose of the start moves them, and shifted from there in real numbers. The time is a
/// quotient of whole numbers, the pair the least (i, j) of all that touch first. `pose_at` rounds
/// shifts, so next to a contact `overlap` may say otherwise there.
///
/// For all others, `free` holds at every time for the body in real numbers. It holds at poses of
/// `pose_at`, too, but where the bodies are nearer than some 2^-44 of the largest coordinate: there
/// poses are rounded by more than the gap. `contact` has one of two proofs. The body at
/// `pose_at(t.upper)` is in contact by the library's exact decision, and the bracket is as wide as
/// the rounding takes to cross. Or they come nearer than rounding at no pose that is in contact,
/// and the law decides in whole numbers. Then t is the doubles next to the exact time, which is a
/// root of a polynomial. Poses at both ends that are rotations to 1e-6 only are decided as they
/// are.
///
/// `grazing` remains with a clearance: nearer to it than rounding at `t.lower`, and no time was
/// found with a contact, or a glide of over 2,000 steps. The pair named is the least of those with
/// the earliest proof, not always the first one to touch where several do so within the bracket.
///
/// \errors  ErrorKind::not_rigid, not_finite, out_of_range for a pose, or where the body may come
///          beyond 2^300 on its way. Usage for a `within` that is negative, not a number, or with
///          `parting`;
///          cancelled.
/// \cost    Typically a few times `distance` of the start. A deadline ends it with coverage `cut`
///          and what is proved until then. Bodies that slide along each other for long at next to
///          no gap cost most.
/// \threads Any number of callers; the query runs on the caller's thread.
/// \source  Mirtich 1996 (conservative advancement), Redon, Kheddar and Coquillart 2002 (intervals
///          of time in box hierarchies); chords instead of velocities are our own.
[[nodiscard]] FirstContact first_contact(const Shape& mover, const RigidMotion& motion,
                                         const Body& fixed, const FirstContactOptions& options = {},
                                         const Limits& limits = {});

/// The same for two bodies that move at the same time, `other` on a way of its own. The answer is
/// that of a motion with a turn, also for two shifts: nothing is decided in whole numbers, and what
/// is next to rounding is `grazing`. `point` and `normal` are in world at `t.upper`. Slacks and
/// brackets grow with the coordinates of both.
///
/// \errors  As above, for both.
/// \cost    As above; where both turn, more of the way is halved.
[[nodiscard]] FirstContact first_contact(const Shape& mover, const RigidMotion& motion,
                                         const Shape& other, const RigidMotion& motion_of_other,
                                         const FirstContactOptions& options = {},
                                         const Limits& limits = {});

/// `first_contact` of `mover` on each of `motions`: the answers of single queries. What
/// a deadline leaves is `cut`.
///
/// \shape   `motions`: n.
/// \errors  As `first_contact`; a motion at fault is named by its index, before any is answered.
/// \threads Motions are shared by as many threads as `limits` says.
[[nodiscard]] FirstContactBatch first_contact(const Shape& mover,
                                              std::span<const RigidMotion> motions,
                                              const Body& fixed,
                                              const FirstContactOptions& options = {},
                                              const Limits& limits = {});

}  // namespace soms
