/// \file
/// How near a body comes to others along a path: the gap at stations, and what is proved of the
/// motion between them.
///
/// \code
/// const soms::Shape ball{soms::generate_sphere(320)};  // of radius 1, about the origin
/// const std::vector<soms::Body> fixed{soms::Body(ball)};
/// const soms::MotionPath path = soms::motion_path(
///     {soms::Pose::translation(-6, 0, 2.5), soms::Pose::translation(6, 0, 2.5)});
/// const soms::Clearance answer = soms::clearance_along(
///     ball, path, fixed, {.every = 1, .accuracy = 0.01, .clearance = 0.6});
/// std::cout << "the gap is at least " << answer.at_least << ", and " << answer.least.gap.upper
///           << " at chainage " << answer.least.chainage << '\n';
/// std::cout << std::boolalpha << "contact: " << answer.first_contact.has_value() << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// the gap is at least 0.490662, and 0.5 at chainage 6
/// contact: false
/// \endverbatim
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/scene/motion_path.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace soms {

/// Options of `clearance_along`; lengths in the unit of the bodies, all finite.
struct ClearanceOptions {
  double every = 0;     ///< chainage from one station to the next; above 0
  double accuracy = 0;  ///< how well the least gap of a stretch is to be known; above 0
  double clearance =
      0;  ///< that is required, at least 0; 0: none, so that only contact is to be avoided
  /// A stop ends the call with what is decided so far and coverage `cut`, not with
  /// ErrorKind::cancelled.
  bool keep_on_stop = false;

  [[nodiscard]] bool operator==(const ClearanceOptions&) const = default;
};

/// A place on the path, and how near the body is there to the nearest of the others.
struct ClearanceStation {
  std::size_t segment = 0;  ///< from this pose of the path to the next
  double t = 0;             ///< part of the segment, 0 to 1
  double chainage = 0;
  Pose pose = {};
  /// The gap as `Distance` has it: 0 exactly where the surfaces overlap; infinity where there is
  /// nothing to be near to.
  Bracket gap{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  std::optional<std::size_t> body = std::nullopt;  ///< the nearest; of equally near ones the first
  std::optional<TrianglePair> triangles = std::nullopt;  ///< of the moving body and of that one
  Vec3 point_a = {};                                     ///< of that pair, as `Distance` has them
  Vec3 point_b = {};

  [[nodiscard]] bool operator==(const ClearanceStation&) const = default;

  [[nodiscard]] bool overlaps() const { return gap.upper == 0; }
};

/// What is known of the motion from a station to the next, both included.
struct ClearanceStretch {
  double at_least = 0;          ///< proved: at no time is the gap less
  ClearanceStation least = {};  ///< the place of the least gap among those that were queried
  /// Length of the path on which the gap is less than the clearance: what is proved to be, and all
  /// that may be. 0 without a clearance.
  Bracket below = {};
  std::uint64_t queries = 0;  ///< places between the stations

  [[nodiscard]] bool operator==(const ClearanceStretch&) const = default;
};

/// What a clearance makes of a stretch.
enum class ClearanceVerdict : std::uint8_t {
  ok,         ///< proved: at no time less than the clearance, and no contact
  below,      ///< less than the clearance somewhere, no contact found
  contact,    ///< the surfaces overlap somewhere
  undecided,  ///< neither is proved within the accuracy
};

template <>
inline constexpr auto kWords<ClearanceVerdict> = words("ClearanceVerdict",
                                                       "What a stretch of a path is.", "ok",
                                                       "below", "contact", "undecided");

/// The verdict on a station, and on a stretch. \pre `clearance` >= 0.
[[nodiscard]] ClearanceVerdict verdict(const ClearanceStation& station, double clearance);
[[nodiscard]] ClearanceVerdict verdict(const ClearanceStretch& stretch, double clearance);

/// The first contact along a path: a place where the surfaces overlap, and up to where it is proved
/// that they do not.
struct PathContact {
  double free_until = 0;  ///< chainage
  ClearanceStation station = {};

  [[nodiscard]] bool operator==(const PathContact&) const = default;
};

/// Answer of `clearance_along`.
struct Clearance {
  std::vector<ClearanceStation> stations = {};   ///< n, in the order of the path
  std::vector<ClearanceStretch> stretches = {};  ///< n - 1: from a station to the next
  double at_least = 0;                           ///< proved of all stretches together
  ClearanceStation least = {};                   ///< the first place of the least gap of all
  std::optional<PathContact> first_contact = std::nullopt;
  Bracket below = {};  ///< as of the stretches, summed up
  std::uint64_t queries = 0;
  /// `cut` after a stop: stations may be missing at the end, and bounds may be weaker.
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const Clearance&) const = default;
};

/// How near `mover` comes to the nearest of `fixed` on its way along `path` (`MotionPath` says what
/// the motion is). Stations are the poses of the path, and each multiple of `every` along it. The
/// gap at a place is `distance`, exactly.
///
/// Between two places no point of the body moves farther than a bound that is known. So neither
/// does the gap change by more, and the motion between is decided, too. A gap that is `at_least` is
/// one of all the motion, for the ideal pose at each time and for the rounded one of `pose_at`.
/// Stretches are halved, again and again, until
///
/// - without a clearance, the least gap of each is known to `accuracy`;
/// - with a clearance, each part is proved to have it, or proved not to; and the least gap of the
///   path is known to `accuracy`;
/// - the first contact, if there is one, is known to `accuracy`;
/// - or the body moves by at most `accuracy` in a part.
///
/// Only surfaces count: inside of a closed body is not in contact with it.
///
/// \errors  ErrorKind::usage for options that are not finite or below what they must be, for more
/// than 10,000,000 stations; as `check(MotionPath)`;
///          as `distance`; cancelled, unless options say otherwise.
/// \cost    A distance for each place and body of `fixed`; along a wall, some 2 m / `accuracy`
///          places for each length m of motion, elsewhere far fewer.
/// \threads Any number of callers; places are dealt out to as many threads as `limits` says. The
///          same bytes for any number.
/// \source  Lipschitz bound of the distance under motion: Mirtich 1996 (conservative advancement);
///          Schwarzer, Saha and Latombe 2005 (adaptive bisection of paths).
[[nodiscard]] Clearance clearance_along(const Shape& mover, const MotionPath& path,
                                        std::span<const Body> fixed,
                                        const ClearanceOptions& options, const Limits& limits = {});

}  // namespace soms
