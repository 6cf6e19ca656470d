/// \file
/// The traversal that answers queries, step by step.
#pragma once

#include "soms/thesis/fast_steps.h"

#include "apps/view/drawing/draw_list.h"
#include "apps/view/scene/touch.h"
#include "apps/view/scene/view_scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {

/// A node of a layout in a picture of the tree: its level and its run of triangles.
struct LayoutBar {
  std::uint32_t level = 0;
  std::uint64_t first = 0;
  std::uint64_t count = 0;

  [[nodiscard]] bool operator==(const LayoutBar&) const = default;
};

/// Of each node of a layout; leaves are parts of their nodes.
[[nodiscard]] std::vector<LayoutBar> bars_of(const WideTree& layout);

/// Boxes of a side of a step, in the axes of their node.
struct StepBoxes {
  Pose pose;               ///< of the node's axes in the world
  std::vector<Box> meet;   ///< that are looked into later
  std::vector<Box> apart;  ///< that end here
};

/// The default traversal of a scene's pair at its present poses.
class FastLesson {
 public:
  /// Traverses again if the pair or a pose changed since. Without a pair there are no steps.
  /// \errors As `thesis::fast_steps`.
  void update(const ViewScene& scene);

  [[nodiscard]] std::span<const thesis::FastStep> steps() const { return steps_.steps; }

  /// What a step is and what follows, in sentences. \pre `update`; `step` is one of `steps`.
  [[nodiscard]] std::vector<std::string> sentences(const ViewScene& scene, std::size_t step) const;

  /// The boxes that a step tests, of the first or the second body of the pair. \pre As above.
  [[nodiscard]] StepBoxes boxes(const ViewScene& scene, std::size_t step, bool first) const;

 private:
  struct Key {
    std::pair<BodyRef, BodyRef> pair;
    Pose pose_a;
    Pose pose_b;
    const MeshView* mesh_a = nullptr;
    const MeshView* mesh_b = nullptr;

    [[nodiscard]] bool operator==(const Key&) const = default;
  };

  std::optional<Key> key_;
  thesis::FastSteps steps_;
};

}  // namespace soms::view
