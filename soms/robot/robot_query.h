/// \file
/// Which links of a robot touch each other or its cell in given states, and how near are they?
/// Decided exactly for the poses that forward kinematics gives.
///
/// \code
/// soms::Robot robot;  // a ball on a rail
/// robot.links = {{"rail"}, {"ball", {soms::generate_sphere(320)}}};
/// robot.joints = {{"slide", soms::JointType::prismatic, 0, 1}};
/// const std::vector<soms::Mesh> cell{soms::generate_sphere(320)};
/// const soms::RobotModel model(robot, cell);
/// const std::vector<double> states{1.5, 3};  // of the one joint
/// for (const auto& answer : soms::robot_contacts(model, states, {.distance = true})) {
///   std::cout << answer.verdict << ", gap " << answer.gap->distance.lower << '\n';
/// }
/// \endcode
/// It prints:
/// \verbatim
/// contact, gap 0
/// free, gap 1.03038
/// \endverbatim
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"
#include "soms/query/answer.h"
#include "soms/robot/robot_model.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace soms {

/// What a state of a robot is.
enum class RobotVerdict : unsigned char {
  free,       ///< nothing that is compared touches
  contact,    ///< something does
  undecided,  ///< nothing touches for sure, and a pair was not decided: RobotAnswer::undecided
};

template <>
inline constexpr auto kWords<RobotVerdict> =
    words("RobotVerdict", "What a state of a robot is: free, with contact, or not decided.", "free",
          "contact", "undecided");

/// A pair that touches.
struct RobotContact {
  RobotPair pair = {};
  /// Their surfaces share a point. Else one is inside the other, which is closed.
  bool surfaces_meet = false;

  [[nodiscard]] bool operator==(const RobotContact&) const = default;
};

/// The least distance of what is compared.
struct RobotGap {
  /// Holds the least distance of the surfaces of all pairs, as `Distance` has it. [0, 0] where
  /// something touches, also inside of a closed body; where a pair is undecided, of surfaces alone,
  /// too. [infinity, infinity] where nothing is compared.
  Bracket distance = {};
  /// The least pair (by link, then links before parts of the cell) whose distance is in the same
  /// bracket; of a contact, the first one.
  std::optional<RobotPair> pair = std::nullopt;
  /// Where that pair does not touch: ends of a shortest segment, as `Distance` has them.
  std::optional<std::array<Vec3, 2>> points = std::nullopt;
  /// The distance exceeds RobotOptions::at_most: `distance.lower` is that, `distance.upper`
  /// infinity.
  bool farther = false;

  [[nodiscard]] bool operator==(const RobotGap&) const = default;
};

/// Options of `robot_contacts`.
struct RobotOptions {
  bool first_contact = false;  ///< stop at the first pair that touches: the least one
  bool distance = false;       ///< also measure RobotAnswer::gap
  double at_most = std::numeric_limits<double>::infinity();  ///< beyond it, a gap is `farther`

  [[nodiscard]] bool operator==(const RobotOptions&) const = default;
};

/// Answer for a state.
struct RobotAnswer {
  RobotVerdict verdict = RobotVerdict::undecided;
  std::vector<RobotContact> contacts = {};  ///< by pair
  /// Pairs of bodies that were not decided. One may be inside the other, which is open, also where
  /// a pose rounds a T-junction; or the deadline passed, and `coverage` is `cut`.
  std::uint64_t undecided = 0;
  std::vector<std::uint32_t> beyond_limits = {};  ///< joints; the state is answered nevertheless
  std::optional<RobotGap> gap = std::nullopt;     ///< where requested and not cut
  Coverage coverage = Coverage::cut;
  Cost cost = {};

  [[nodiscard]] bool operator==(const RobotAnswer&) const = default;
};

/// For each state, which of the pairs that `model` compares touch. Two bodies touch if their
/// surfaces share a point, as `overlap` decides it. They also touch if a point of one is inside the
/// other, as `contains` decides it, where the other is closed, or in such a connected part of it
/// (RobotBody::core). What an open body encloses else is unknown (PartBody::closed says which these
/// are): it is taken to be closed by caps, as for `clashes`. Where surfaces do not meet, and a
/// connected part of a body lies in the box of an open one or goes through its caps, the pair is
/// undecided.
///
/// All this is exact for the vertices where `Kinematics::link_poses` moves them, rounded. The
/// answer but for `cost` does not depend on threads, trees, layouts or instruction sets; with a
/// deadline it may. `robot_path` proves what is between two states.
///
/// \shape   `states`: n x k, row by row, for k joints of `model.kinematics().movable()`.
/// \errors  ErrorKind::usage unless the numbers are whole rows, and for an `at_most` that is
///          negative or has no effect;
///          not_finite, out_of_range for a state, which is named by its index; cancelled.
/// \cost    Forward kinematics and a broad phase over the boxes. For pairs of boxes that meet,
///          `overlap` with mode `any`, and where that finds nothing, `contains` for each connected
///          part. Where one is open, the vertices of both and an `overlap` with its caps. With
///          `distance`, `distance` of the pairs whose boxes are near enough.
/// \threads Any number of callers; states are shared by as many threads as `limits` says.
[[nodiscard]] std::vector<RobotAnswer> robot_contacts(const RobotModel& model,
                                                      std::span<const double> states,
                                                      const RobotOptions& options = {},
                                                      const Limits& limits = {});

}  // namespace soms
