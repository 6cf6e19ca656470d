/// \file
/// From step to step: which bodies begin to touch, still touch, and touch no longer.
///
/// \code
/// soms::Scene scene;
/// const soms::Shape ball{soms::generate_sphere(320)};  // of radius 1, about the origin
/// scene.add_environment(soms::Body(ball));
/// const soms::MoverId mover = scene.add_mover(soms::Body(ball));
/// soms::ContactTracker tracker;
/// for (const double x : {3.0, 1.5, 1.0, 3.0}) {
///   scene.set_pose(mover, soms::Pose::translation(x, 0, 0));
///   for (const soms::EnvironmentEvent& event : tracker.follow(scene.step()).environment) {
///     std::cout << "at " << x << ": " << event.change << '\n';
///   }
/// }
/// \endcode
/// It prints:
/// \verbatim
/// at 1.5: begin
/// at 1: stay
/// at 3: end
/// \endverbatim
#pragma once

#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/scene/step_report.h"

#include <compare>
#include <cstdint>
#include <tuple>
#include <vector>

namespace soms {

/// What became of a contact of two bodies since the step before.
enum class ContactChange : std::uint8_t {
  begin,  ///< they touch, and did not before
  stay,   ///< they touch, and did before
  end,    ///< they do not touch, and did before; one of them may have been removed
};

template <>
inline constexpr auto kWords<ContactChange> =
    words("ContactChange", "What became of a contact of two bodies since the step before.", "begin",
          "stay", "end");

/// Change of a contact between a mover and a part of the environment, which is a whole body.
struct EnvironmentEvent {
  MoverId mover = 0;
  EnvironmentId part = 0;  ///< number of the body, not of a part of its mesh
  ContactChange change = ContactChange::begin;

  [[nodiscard]] auto operator<=>(const EnvironmentEvent&) const = default;
};

template <>
struct Fields<EnvironmentEvent> {
  static constexpr const char* kName = "EnvironmentEvent";
  static constexpr const char* kMeaning = "Change of a contact with the environment.";
  static constexpr auto kList =
      std::tuple(field("mover", &EnvironmentEvent::mover, "The mover."),
                 field("part", &EnvironmentEvent::part, "Number of the body of the environment."),
                 field("change", &EnvironmentEvent::change, "What became of the contact."));
};

/// Change of a contact between two movers; `a` is less than `b`.
struct MoverEvent {
  MoverId a = 0;
  MoverId b = 0;
  ContactChange change = ContactChange::begin;

  [[nodiscard]] auto operator<=>(const MoverEvent&) const = default;
};

template <>
struct Fields<MoverEvent> {
  static constexpr const char* kName = "MoverEvent";
  static constexpr const char* kMeaning = "Change of a contact between two movers.";
  static constexpr auto kList =
      std::tuple(field("a", &MoverEvent::a, "The mover of the lesser number."),
                 field("b", &MoverEvent::b, "The other mover."),
                 field("change", &MoverEvent::change, "What became of the contact."));
};

/// Changes from one step to the next, each pair of bodies once: two sorted lists.
struct ContactEvents {
  std::vector<EnvironmentEvent> environment;
  std::vector<MoverEvent> movers;

  [[nodiscard]] bool operator==(const ContactEvents&) const = default;
};

/// Compares the report of each step with that of the step before. A value: a copy goes on from
/// where it was made. Holds the touching pairs of bodies of the last step, no triangles.
class ContactTracker {
 public:
  /// Changes since the report before; at the first, every contact begins. The events depend only on
  /// which pairs of bodies touch in the two steps: they are the same for any number of threads and
  /// any mode of the steps.
  /// \errors  ErrorKind::usage for a report of StepScope::first_contact, which may lack pairs that
  ///          touch. ErrorKind::usage where this report compares movers with each other and the one
  ///          before does not, or the reverse (`clear` starts again). The tracker stays as it was
  ///          then.
  /// \cost    O(n), n contacts of the report and touching pairs of the report before.
  [[nodiscard]] ContactEvents follow(const StepReport& report);

  /// Forgets the report before: at the next one, every contact begins.
  void clear() { *this = {}; }

  [[nodiscard]] bool operator==(const ContactTracker&) const = default;

 private:
  bool has_report_ = false;
  bool mover_mover_ = false;
  std::vector<EnvironmentEvent> environment_;  ///< touching pairs of the report before
  std::vector<MoverEvent> movers_;             ///< likewise
};

}  // namespace soms
