/// \file
/// Canonical trees of shown bodies, built when they are first requested.
#pragma once

#include "soms/base/parallel.h"
#include "soms/query/body.h"
#include "soms/thesis/posed_boxes.h"
#include "soms/tree/build_options.h"
#include "soms/tree/statistics.h"
#include "soms/tree/tree.h"

#include "apps/view/scene/touch.h"

#include <map>
#include <memory>

namespace soms::view {

/// Trees by mesh, since bodies share meshes, and moved boxes by body.
class TreeStore {
 public:
  /// The tree of a mesh; kept until `clear`. \errors As `build`.
  [[nodiscard]] const Tree& tree(const std::shared_ptr<const Mesh>& mesh,
                                 const BuildOptions& options, const Limits& limits);

  /// Counts of the tree where it was built, else nullptr.
  [[nodiscard]] const TreeStatistics* statistics(const Mesh& mesh) const;

  /// The tree's boxes at the pose of the body.
  [[nodiscard]] const PosedBoxes& boxes(BodyRef ref, const Body& body, const BuildOptions& options,
                                        BoxUpdate update, const Limits& limits);

  void clear();

 private:
  struct Kept {
    std::shared_ptr<const Mesh> mesh;
    std::unique_ptr<const Tree> tree;
    TreeStatistics statistics;
  };

  std::map<const Mesh*, Kept> trees_;
  std::map<BodyRef, PosedBoxes> boxes_;
};

}  // namespace soms::view
