/// \file
/// What a shape is made of: its mesh with what keeps that in memory, and what a tree file states.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/shape.h"

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace soms::detail {

/// A view of a mesh, with the mesh, or with what holds the arrays that a tree file has.
class HeldMesh : public MeshView {
 public:
  /// The view of a mesh. \pre `mesh` is set.
  [[nodiscard]] static std::shared_ptr<const HeldMesh> of(std::shared_ptr<const Mesh> mesh) {
    auto held = std::make_shared<HeldMesh>(MeshView(*mesh), nullptr);
    held->mesh_ = std::move(mesh);
    return held;
  }

  HeldMesh(const MeshView& view, std::shared_ptr<const void> owner)
      : MeshView(view), owner_(std::move(owner)) {}

  /// The mesh; a copy, made once, where the arrays lie in a file.
  [[nodiscard]] std::shared_ptr<const Mesh> shared() const {
    std::call_once(copied_, [this] {
      if (!mesh_) {
        mesh_ = std::make_shared<const Mesh>(static_cast<const MeshView&>(*this));
      }
    });
    return mesh_;
  }

  void set_tree_file(TreeFileName file) { file_ = std::move(file); }

  [[nodiscard]] const TreeFileName* tree_file() const { return file_ ? &*file_ : nullptr; }

 private:
  std::shared_ptr<const void> owner_;
  std::optional<TreeFileName> file_;
  mutable std::once_flag copied_;
  mutable std::shared_ptr<const Mesh> mesh_;
};

/// A shape as a tree file has it.
struct ShapeParts {
  std::shared_ptr<const HeldMesh> mesh;
  std::shared_ptr<const WideTree> layout;
  BuildOptions build_options;
  double sah_area_ratio = 0;
  double sah_degradation = 1;
};

[[nodiscard]] Shape opened(ShapeParts parts);

/// Both numbers that a shape compares its boxes with.
[[nodiscard]] std::pair<double, double> areas_of(const Shape& shape);

}  // namespace soms::detail
