/// \file
/// A step of a shown scene by a named traversal: what it finds, and what that takes.
#pragma once

#include "soms/base/parallel.h"
#include "soms/base/pose.h"
#include "soms/geometry/mesh.h"
#include "soms/query/answer.h"
#include "soms/scene/broad_phase.h"
#include "soms/thesis/named_overlap.h"
#include "soms/thesis/pair_traversal.h"
#include "soms/tree/shape.h"

#include "apps/view/scene/touch.h"
#include "apps/view/scene/view_options.h"
#include "apps/view/scene/view_scene.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace soms::view {

/// What a named traversal found in a scene, and its work.
struct CountedStep {
  std::vector<Touch> touches;  ///< sorted; where `cut` is false those of ViewScene::contacts
  Cost cost;                   ///< of all pairs of bodies together
  TraversalCounts counts;      ///< likewise
  std::uint64_t queries = 0;   ///< pairs of bodies that were traversed
  double milliseconds = 0;     ///< of moving boxes, traversing and deciding triangles
  bool cut = false;            ///< patience ended it: there is more of everything
};

/// Queries a shown scene by the traversal of its choice of trees, on trees built by that choice.
///
/// Traversed are the pairs of bodies whose world boxes meet, as in a step of the scene; of a scene
/// of two bodies these, wherever they are. The first tree is that of the part of the city, of two
/// movers that of the lesser number. Each pair starts at the roots, Traversal::e_node_front, too.
/// \threads One caller at a time.
class StepCounter {
 public:
  /// Ends a step when its queries took this long; nothing: never.
  void set_patience(std::optional<std::chrono::steady_clock::duration> patience) {
    patience_ = patience;
  }

  /// The step at the present poses; the last one while nothing changed. Nothing for
  /// Traversal::fast, whose step is the scene's own.
  /// \errors As `NamedOverlap` and `Shape`.
  /// \cost   Builds a tree for each mesh, once for each choice of trees; queries on one thread.
  [[nodiscard]] const std::optional<CountedStep>& find(const ViewScene& scene,
                                                       const Limits& limits = {});

 private:
  /// A body of the city with one mesh of movers, or two meshes of movers.
  using Key = std::tuple<const MeshView*, std::optional<std::uint32_t>, const MeshView*>;

  void set_choice(const TreeChoice& choice);
  [[nodiscard]] const Shape& shape_of(const Body& body, const Limits& limits);
  [[nodiscard]] thesis::NamedOverlap& query_of(const ViewScene& scene, BodyRef a, BodyRef b,
                                               const Limits& limits);
  [[nodiscard]] std::vector<std::pair<BodyRef, BodyRef>> pairs_of(const ViewScene& scene);
  void run(const ViewScene& scene, BodyRef a, BodyRef b, const Limits& limits);

  std::optional<std::chrono::steady_clock::duration> patience_;
  std::optional<TreeChoice> choice_;
  std::vector<Pose> poses_;  ///< of the last step
  std::optional<CountedStep> step_;
  std::map<const Mesh*, Shape> shapes_;
  std::map<Key, thesis::NamedOverlap> queries_;
  BroadPhase broad_phase_;
  std::uint32_t parts_ = 0;  ///< that the broad phase knows not to compare
};

}  // namespace soms::view
