/// \file
/// What a page needs to answer again when its reader moves a body: the corners and poses as they
/// are, where the drawn ones are rounded and may be fewer.
#pragma once

#include "soms/base/box.h"

#include "apps/report/scene.h"

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace soms::report {

/// Numbers of a mesh as they are: triangles in order, corner by corner. 0 for a vertex that comes
/// first, or how many vertices ago the corner's vertex was first (`put_unsigned`). A vertex that
/// comes first is followed by its coordinates: floats where all of the mesh are floats, else
/// doubles. Vertices that no triangle has are left out.
class ExactMesh {
 public:
  explicit ExactMesh(const MeshView& mesh);

  [[nodiscard]] bool has_floats() const { return floats_; }

  /// Bytes that `write` puts into a block, before they become base64.
  [[nodiscard]] std::uint64_t bytes() const;

  /// Writes the element "soms-ID".
  void write(std::ostream& out, const std::string& id) const;

 private:
  MeshView mesh_;
  bool floats_;
};

/// The models of a scene as they are, and where its bodies are; nothing where no body moves. Where
/// there is no room for models that stand still, only their triangles near the places of rows are
/// here: those that meet boxes which the page has, too. Nothing where there is no room for these.
class LiveData {
 public:
  /// `bodies` are those of the page, `steps` those whose poses it holds.
  LiveData(const Scene& scene, std::span<const std::uint32_t> bodies,
           std::span<const std::uint64_t> steps, const SceneLimits& limits);

  /// The page holds what it takes to answer.
  [[nodiscard]] bool is_there() const { return !models_.empty(); }

  /// Writes "soms-exact-K" for each model, and "soms-exact-poses": 12 doubles, the rows of [R | t],
  /// for each body that stands still, then for each that moves at each step, step after step.
  /// \errors Those of `scene.pose`.
  void write(std::ostream& out) const;

  /// A value of JSON: null where no body moves. `middle` is of each model, in its own coordinates.
  [[nodiscard]] std::string json(const std::function<Vec3(std::size_t model)>& middle) const;

 private:
  void set_near(double margin);
  [[nodiscard]] std::vector<MeshView> meshes();

  const Scene& scene_;
  std::span<const std::uint32_t> bodies_;
  std::span<const std::uint64_t> steps_;
  std::uint64_t room_;
  bool any_moves_ = false;
  bool has_movers_ = false;  ///< all that move are here, with their poses
  std::vector<ExactMesh> models_;
  std::vector<Box> near_;  ///< where models are whole, if they are not everywhere; in the scene
  std::deque<std::vector<std::array<std::uint32_t, 3>>> parts_;  ///< triangles of cut models
};

}  // namespace soms::report
