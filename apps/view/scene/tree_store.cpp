#include "apps/view/scene/tree_store.h"

#include "soms/tree/build.h"

namespace soms::view {

namespace {

/// Bodies whose moved boxes are kept: the pair's, and one more that is looked at.
constexpr std::size_t kKeptBodies = 3;

}  // namespace

const Tree& TreeStore::tree(const std::shared_ptr<const Mesh>& mesh, const BuildOptions& options,
                            const Limits& limits) {
  const auto known = trees_.find(mesh.get());
  if (known != trees_.end()) {
    return *known->second.tree;
  }
  Kept kept{mesh, std::make_unique<const Tree>(build(*mesh, options, limits)), {}};
  kept.statistics = soms::statistics(*kept.tree, options);
  return *trees_.emplace(mesh.get(), std::move(kept)).first->second.tree;
}

const TreeStatistics* TreeStore::statistics(const Mesh& mesh) const {
  const auto known = trees_.find(&mesh);
  return known == trees_.end() ? nullptr : &known->second.statistics;
}

const PosedBoxes& TreeStore::boxes(BodyRef ref, const Body& body, const BuildOptions& options,
                                   BoxUpdate update, const Limits& limits) {
  const Tree& of_body = tree(body.shape.shared_mesh(), options, limits);
  auto known = boxes_.find(ref);
  if (known == boxes_.end()) {
    if (boxes_.size() >= kKeptBodies) {
      boxes_.clear();
    }
    known = boxes_.emplace(ref, PosedBoxes(body.shape.mesh(), of_body)).first;
  }
  known->second.move(body.pose, update);
  return known->second;
}

void TreeStore::clear() {
  boxes_.clear();
  trees_.clear();
}

}  // namespace soms::view
