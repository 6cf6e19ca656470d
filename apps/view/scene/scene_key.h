/// \file
/// What the colors of a picture mean.
#pragma once

#include "apps/view/drawing/draw_list.h"
#include "apps/view/scene/view_options.h"
#include "apps/view/scene/view_scene.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace soms::view {

/// Movers by kind: those that share a mesh.
class MoverKinds {
 public:
  explicit MoverKinds(const ViewScene& scene);

  [[nodiscard]] std::size_t of(std::uint32_t mover) const { return kinds_[mover]; }

  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::vector<std::size_t> kinds_;
  std::size_t count_ = 0;
};

/// The key of a picture: bodies by the names of their models, then boxes, gaps and contacts.
/// `nearest` says that nearest points are drawn.
[[nodiscard]] std::vector<KeyEntry> scene_key(const ViewScene& scene, const ViewOptions& options,
                                              bool nearest);

}  // namespace soms::view
