/// \file
/// A body beside itself: which of its triangles share more than their common corners?
#pragma once

#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/self/neighbors.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace soms::detail {

/// One shape as both sides of a query, in its own coordinates. Pairs are unordered: the lesser
/// triangle comes first.
class SelfFrame : public PairFrame {
 public:
  static constexpr bool kSelf = true;

  /// `joined` names for each vertex the one that stands for it, or is empty where each stands for
  /// itself. \pre The shape of `body`, which is at the identity, is not empty.
  SelfFrame(const Body& body, const std::vector<std::uint32_t>& joined)
      : PairFrame(body, body), mesh_(&body.shape.mesh()), joined_(&joined) {}

  [[nodiscard]] TrianglePair in_callers_order(TriangleId x, TriangleId y) const {
    return x < y ? TrianglePair{x, y} : TrianglePair{y, x};
  }

  [[nodiscard]] const MeshView& mesh() const { return *mesh_; }

  /// By the vertices that stand for them.
  [[nodiscard]] CornerNames corners_of(TriangleId id) const {
    CornerNames names = mesh_->triangles[id];
    if (!joined_->empty()) {
      for (std::uint32_t& name : names) {
        name = (*joined_)[name];
      }
    }
    return names;
  }

  /// Notes that two triangles with the same corners were met. \threads Any number of callers.
  void meet_duplicates() const { met_duplicates_.store(true, std::memory_order_relaxed); }

  [[nodiscard]] bool met_duplicates() const { return met_duplicates_; }

 private:
  const MeshView* mesh_;
  const std::vector<std::uint32_t>* joined_;
  mutable std::atomic<bool> met_duplicates_ = false;
};

}  // namespace soms::detail
