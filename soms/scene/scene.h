/// \file
/// Many movers in a static environment, step by step: who touches whom, who is near, and who passes
/// through what. And what is nearest to a point or first on a ray.
///
/// \code
/// soms::Scene scene;
/// const soms::Shape ball{soms::generate_sphere(320)};  // of radius 1, about the origin
/// scene.add_environment(soms::Body(ball));
/// const soms::MoverId a = scene.add_mover(soms::Body(ball, soms::Pose::translation(1.5, 0, 0)));
/// scene.add_mover(soms::Body(ball, soms::Pose::translation(0, 4, 0)));
/// for (const soms::Vec3& p : {soms::Vec3{1.5, 0, 0}, {1.5, 3, 0}, {-9, -3, 0}}) {
///   scene.set_pose(a, soms::Pose::translation(p.x, p.y, p.z));
///   const soms::StepReport report = scene.step({.swept = true});
///   std::cout << report.environment.size() << " pairs with the environment, "
///             << report.movers.size() << " among movers; passed on the way: "
///             << report.environment_passages.size() << '\n';
/// }
/// \endcode
/// It prints:
/// \verbatim
/// 74 pairs with the environment, 0 among movers; passed on the way: 0
/// 0 pairs with the environment, 40 among movers; passed on the way: 1
/// 0 pairs with the environment, 0 among movers; passed on the way: 1
/// \endverbatim
#pragma once

#include "soms/base/limits.h"
#include "soms/query/body.h"
#include "soms/query/overlap.h"
#include "soms/query/overlap_method.h"
#include "soms/scene/body_queries.h"
#include "soms/scene/scene_query.h"
#include "soms/scene/step_report.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace soms {

/// Options of a step.
struct StepOptions {
  /// all: every pair of triangles; any: one pair for each pair of bodies; first: the least such.
  OverlapMode mode = OverlapMode::all;
  /// Which pairs of bodies are compared: all, or those of each mover up to its first contact. What
  /// is reported of a pair follows `mode` either way.
  StepScope scope = StepScope::every_pair;
  bool mover_mover = true;  ///< compare movers with each other, too
  /// Use what the steps before left (see `BroadPhase`); the answers are the same without.
  bool coherent = true;
  /// What finds the overlaps of a pair of bodies, if not `overlap`. Not owned.
  const OverlapMethod* method = nullptr;
  /// Pairs of bodies that do not touch but are at most this far apart are reported as gaps; 0: none
  /// are searched for, at no cost. Needs StepScope::every_pair.
  double clearance = 0;
  /// Report passages, too: who touches whom on the way from the last step to this one. Needs
  /// StepScope::every_pair.
  bool swept = false;

  [[nodiscard]] bool operator==(const StepOptions&) const = default;
};

/// A static environment of meshes and movers that share shapes. Poses are set through the scene, so
/// no stale box can exist and there is nothing to update, set up or clear.
///
/// Its queries of points and rays are those of BodyQueries: `closest`, `closest_hit`, `any_hit` and
/// `all_hits`. They see all bodies at their present poses. Equally near bodies are decided by the
/// order of SceneBody. Groups and ignored pairs do not matter for them. The first query after
/// parts, or movers, were changed builds their index: O(n log n), n of them. So batches are for
/// many movers that move. \threads One caller at a time, of const members, too: a query after a
/// change builds what it
///          needs. `step` and batches use the threads they are given.
class Scene : public BodyQueries<Scene, SceneBody, SceneFilter> {
 public:
  Scene();
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  /// Adds a static body. \errors As `overlap` for its pose.
  EnvironmentId add_environment(Body body);

  /// \errors  ErrorKind::usage for an id that is not there, here and below.
  void remove_environment(EnvironmentId id);

  /// Adds a mover. Movers that share a group are not compared with each other; group 0 is none.
  /// However many movers of one group are in one place, their pairs take neither time nor memory.
  MoverId add_mover(Body body, std::uint32_t group = 0);
  void remove_mover(MoverId id);
  void set_group(MoverId id, std::uint32_t group);

  /// Movers `a` and `b` are not compared with each other, or, after `unignore`, are again. Each is
  /// without effect where it was called before.
  void ignore(MoverId a, MoverId b);
  void unignore(MoverId a, MoverId b);

  /// The same for a mover and a part of the environment.
  void ignore_environment(MoverId mover, EnvironmentId part);
  void unignore_environment(MoverId mover, EnvironmentId part);

  /// \errors  ErrorKind::usage for an id that is not there; as `overlap` for the pose, with the
  ///          mover named. The old pose stays then.
  /// \cost    Constant: no tree is touched, nothing is allocated.
  void set_pose(MoverId id, const Pose& pose);

  /// Gives a body another shape, such as one from `refit`. Its number, pose, name and group stay,
  /// and so does whom it ignores.
  /// \errors  ErrorKind::usage for an id that is not there; out_of_range where the body's pose
  /// takes
  ///          the new shape too far. The old shape stays then.
  /// \cost    Constant for a mover. After that of a part, the next step builds the index of the
  ///          environment: O(n log n), n parts.
  void set_shape(MoverId id, Shape shape);
  void set_environment_shape(EnvironmentId id, Shape shape);

  /// References last until a mover (a part) is added or removed.
  [[nodiscard]] const Body& mover(MoverId id) const;
  [[nodiscard]] const Body& environment(EnvironmentId id) const;
  [[nodiscard]] std::vector<MoverId> movers() const;              ///< ascending
  [[nodiscard]] std::vector<EnvironmentId> environments() const;  ///< ascending

  /// Bytes held, bodies' shapes and names not counted. They are in proportion to the movers, the
  /// parts and the ignored pairs that are there, and to the pairs of bodies and the contacts that
  /// the last step found. What earlier steps needed beyond that is given back (what movers needed
  /// among themselves, by the next step that compares them).
  [[nodiscard]] std::size_t memory() const;

  /// All overlaps at the present poses. With StepScope::first_contact, which movers touch anything:
  /// each is compared with the parts of the environment, ascending, then with the other movers,
  /// ascending, until its first contact. No pair is compared twice, so no more comparisons are made
  /// than by querying one mover after the other. No more pairs of bodies touch in the report than
  /// there are movers.
  ///
  /// With a clearance D the least distance of each pair of bodies within D is reported as well. It
  /// is the answer of `distance` for the two, decided exactly, wherever the bodies lie. Groups and
  /// ignored pairs are left out as for contacts, and contacts are those of a step without it.
  ///
  /// A swept step reports passages as well, so nothing passes through anything unseen. The way of a
  /// mover is RigidMotion::between of its poses at the last step, swept or not, and now. The pivot
  /// is the center of its shape's bounds. No mover has a way at the first step, nor one that was
  /// added or given another shape since the last. Such a mover, one that rests, and the environment
  /// are for all the way as they are now.
  ///
  /// Each pair of bodies of which one has a way is answered as by `first_contact`; boxes that hold
  /// whole ways may prove more to be free. It is reported unless it is free, also where it touches
  /// now. Where it touched at the begin (`started`), it is reported if it does not touch now. So a
  /// pair that is compared and in no list is proved free from the last step to now. Groups and
  /// ignored pairs are left out as for contacts. While two bodies touch from begin to end, no
  /// passage through other triangles of the two is reported.
  /// \errors  ErrorKind::cancelled, timed_out. usage for a clearance that is negative or not
  ///          finite, and for one, or a swept step, with StepScope::first_contact. out_of_range for
  ///          a way next to 2^300, as `first_contact`. What StepOptions::method throws. After an
  ///          error the last step is the one before.
  /// \cost    Time and memory linear in the pairs of bodies whose boxes meet, or, with a clearance,
  ///          are within it. Where many movers of no group, or of many groups, are in one place,
  ///          that is quadratic in the movers. Boxes of a swept step hold whole ways.
  [[nodiscard]] StepReport step(const StepOptions& options = {}, const Limits& limits = {});

 private:
  friend BodyQueries<Scene, SceneBody, SceneFilter>;
  struct State;
  class View;
  [[nodiscard]] View view(const SceneFilter& filter) const;

  std::unique_ptr<State> state_;
};

}  // namespace soms
