/// \file
/// Who touches whom, and from when to when: one record for each pair of bodies and stretch of time.
///
/// \code
/// soms::Scene scene;
/// const soms::Shape ball{soms::generate_sphere(320)};  // of radius 1, about the origin
/// scene.add_environment(soms::Body(ball));
/// const soms::MoverId mover = scene.add_mover(soms::Body(ball));
/// soms::ContactSpans spans;
/// for (unsigned step = 0; step < 6; ++step) {
///   scene.set_pose(mover, soms::Pose::translation(4.0 - step, 1, 0));
///   spans.follow(step, scene.step(), soms::contact_bodies(scene));
/// }
/// for (const soms::ContactSpan& span : spans.spans()) {
///   std::cout << "touches in steps " << span.begin << " to " << span.end << '\n';
/// }
/// \endcode
/// It prints:
/// \verbatim
/// touches in steps 3 to 5
/// \endverbatim
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"
#include "soms/describe/fields.h"
#include "soms/geometry/mesh.h"
#include "soms/query/answer.h"
#include "soms/scene/scene_query.h"
#include "soms/scene/step_report.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <tuple>
#include <vector>

namespace soms {

class Scene;

/// One side of a contact: a body, or a part of its mesh.
struct ContactSide {
  SceneBody body = {};
  /// Index in `Mesh::parts`; Part::kNoParent for triangles of no part, and where bodies are not
  /// divided.
  std::uint32_t part = Part::kNoParent;

  [[nodiscard]] auto operator<=>(const ContactSide&) const = default;
};

template <>
struct Fields<ContactSide> {
  static constexpr const char* kName = "ContactSide";
  static constexpr const char* kMeaning = "One side of a contact.";
  static constexpr auto kList =
      std::tuple(field("body", &ContactSide::body, "The body."),
                 field("part", &ContactSide::part, "The part of its mesh, if it is divided."));
};

/// Two bodies touch in each step from `begin` to `end` that compared them.
struct ContactSpan {
  ContactSide a;  ///< of a mover
  ContactSide b;  ///< of the environment, or of a mover of greater number
  std::uint64_t begin = 0;
  std::uint64_t end = 0;         ///< the last step in which they touch
  std::uint64_t steps = 0;       ///< in which they touch
  std::uint64_t most_pairs = 0;  ///< pairs of triangles, in the step that has the most
  std::uint64_t most_step = 0;   ///< the first such step; of it are the fields below
  TrianglePair pair = {};        ///< that shares `place`: a triangle of a, then of b
  /// A point that the two share, for drawing: the middle of what the triangles of `pair` have in
  /// common (see `crossing`).
  Vec3 place = {};
  Box box = {};       ///< holds all that the two share: where the boxes of triangles meet
  bool lasts = true;  ///< they touch in the last step that compared them

  [[nodiscard]] bool operator==(const ContactSpan&) const = default;
};

template <>
struct Fields<ContactSpan> {
  static constexpr const char* kName = "ContactSpan";
  static constexpr const char* kMeaning = "Two bodies touch from step to step.";
  static constexpr auto kList = std::tuple(
      field("a", &ContactSpan::a,
            "(kind, number, part) of a mover; part None where bodies are not divided."),
      field("b", &ContactSpan::b, "(kind, number, part) of the other body."),
      field("begin", &ContactSpan::begin, "The first step."),
      field("end", &ContactSpan::end, "The last step in which they touch."),
      field("steps", &ContactSpan::steps, "How many steps."),
      field("most_pairs", &ContactSpan::most_pairs, "Pairs of triangles, in the step with most."),
      field("most_step", &ContactSpan::most_step, "The first such step."),
      field("pair", &ContactSpan::pair, "(triangle of a, triangle of b) that share place."),
      field("place", &ContactSpan::place, "(3,): a point that the two share then, for drawing."),
      field("box", &ContactSpan::box,
            "(2, 3): least and greatest corner of a box around all that the two share then."),
      field("lasts", &ContactSpan::lasts, "They touch in the last step that compared them."));
};

/// What spans are to know of the bodies that a step compared.
struct ContactBodies {
  /// A triangle, moved by its body's pose in that step. Must not be empty.
  std::function<Triangle(const SceneBody& body, TriangleId triangle)> triangle;
  /// The part of the body's mesh that holds a triangle, as of `PartsOf`: the same in all steps.
  /// Empty: bodies are not divided.
  std::function<std::uint32_t(const SceneBody& body, TriangleId triangle)> part = {};
};

/// The bodies of a scene, not divided, at their present poses. The scene must stay.
[[nodiscard]] ContactBodies contact_bodies(const Scene& scene);

/// Gathers the contacts of steps into spans. A value: a copy goes on from where it was made.
///
/// A span goes on as long as its two touch in every step that compares them. So it ends where a
/// step lies between that compared them and found no touch. It does not end at steps that are left
/// out, or that compare no movers with each other (StepOptions::mover_mover), where two movers are
/// concerned. Bodies that are removed or ignore each other do not touch.
class ContactSpans {
 public:
  /// Adds the report of step number `step`.
  /// \pre     `bodies` are those of the report, where they were in that step.
  /// \errors  ErrorKind::usage unless `step` is greater than the number before, and for a report
  ///          that is not complete (StepScope::first_contact, or another mode than
  ///          OverlapMode::all): it may lack parts that touch. The spans stay as they were then.
  /// \cost    O(n log n) for n contacts and spans that last; triangles are fetched only of spans
  ///          that have more pairs than ever before.
  void follow(std::uint64_t step, const StepReport& report, const ContactBodies& bodies);

  /// All spans, by begin, then a, then b. A span keeps its index: later steps change spans that
  /// last, and append.
  [[nodiscard]] const std::vector<ContactSpan>& spans() const { return spans_; }

  [[nodiscard]] bool operator==(const ContactSpans&) const = default;

 private:
  std::vector<ContactSpan> spans_;
  std::vector<std::size_t> lasting_;  ///< of spans_, by a, then b
  std::optional<std::uint64_t> step_;
};

}  // namespace soms
