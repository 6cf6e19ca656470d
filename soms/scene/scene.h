/// \file
/// Many movers in a static environment: who touches whom, step by step.
#pragma once

#include "soms/base/parallel.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/query/overlap.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace soms {

/// Stable number of a mover or of a part of the environment; never used again after removal.
using MoverId = std::uint32_t;
using EnvironmentId = std::uint32_t;

/// A triangle of a mover touches a triangle of the environment.
struct EnvironmentContact {
  MoverId mover = 0;
  EnvironmentId part = 0;
  TriangleId i = 0;  ///< triangle of the mover
  TriangleId j = 0;  ///< triangle of the part

  [[nodiscard]] auto operator<=>(const EnvironmentContact&) const = default;
};

/// A triangle of one mover touches a triangle of another; `a` is less than `b`.
struct MoverContact {
  MoverId a = 0;
  MoverId b = 0;
  TriangleId i = 0;  ///< triangle of a
  TriangleId j = 0;  ///< triangle of b

  [[nodiscard]] auto operator<=>(const MoverContact&) const = default;
};

/// What a step found: two sorted lists, the same bytes for any number of threads.
struct StepReport {
  std::vector<EnvironmentContact> environment;
  std::vector<MoverContact> movers;
  Coverage coverage = Coverage::complete;
  Cost cost;
  std::uint64_t queries = 0;    ///< narrow-phase queries asked: box pairs not to be ignored
  std::uint64_t box_pairs = 0;  ///< pairs of bodies whose world boxes meet

  [[nodiscard]] bool operator==(const StepReport&) const = default;

  /// FNV-1a 64 over both lists as little-endian u32.
  [[nodiscard]] std::uint64_t hash() const;
};

/// Options of a step.
struct StepOptions {
  /// all: every pair of triangles; any: one pair for each pair of bodies; first: the least such.
  OverlapMode mode = OverlapMode::all;
  bool mover_mover = true;
  /// Use what the steps before left (see `BroadPhase`); the answers are the same without.
  bool coherent = true;
  /// As of OverlapOptions: named ones need shapes that keep their trees.
  TraversalOptions traversal = {};

  [[nodiscard]] bool operator==(const StepOptions&) const = default;
};

/// A static environment of meshes and movers that share shapes. Poses are set through the scene, so
/// no stale box can exist and there is nothing to update, set up or clear.
/// \threads One caller at a time; `step` uses the threads it is given.
class Scene {
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
  MoverId add_mover(Body body, std::uint32_t group = 0);
  void remove_mover(MoverId id);

  /// Movers `a` and `b` are not compared with each other.
  void ignore(MoverId a, MoverId b);

  /// Mover `mover` is not compared with the part `part` of the environment.
  void ignore_environment(MoverId mover, EnvironmentId part);

  /// \errors  ErrorKind::usage for an id that is not there; as `overlap` for the pose, with the
  ///          mover named. The old pose stays then.
  /// \cost    Constant: no tree is touched, nothing is allocated.
  void set_pose(MoverId id, const Pose& pose);

  /// References last until a mover (a part) is added or removed.
  [[nodiscard]] const Body& mover(MoverId id) const;
  [[nodiscard]] const Body& environment(EnvironmentId id) const;
  [[nodiscard]] std::vector<MoverId> movers() const;              ///< ascending
  [[nodiscard]] std::vector<EnvironmentId> environments() const;  ///< ascending

  /// Bytes held, bodies' shapes and names not counted: in proportion to the movers and parts that
  /// are there and to the largest step so far, however many came and went.
  [[nodiscard]] std::size_t memory() const;

  /// All overlaps at the present poses.
  /// \errors  ErrorKind::cancelled; usage for a named traversal without kept trees.
  [[nodiscard]] StepReport step(const StepOptions& options = {}, const Parallel& parallel = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace soms
