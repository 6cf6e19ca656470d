/// \file
/// The models of a scene as blocks of data: coarse ones for a first picture, then the rest.
#pragma once

#include "apps/report/base64.h"
#include "apps/report/drawn_mesh.h"
#include "apps/report/scene.h"

#include <cstdint>
#include <functional>
#include <map>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace soms::report {

/// A model of more triangles has a coarse stand-in of so many.
inline constexpr std::uint64_t kCoarseTriangles = 15'000;

/// The meshes that a page draws.
class SceneModels {
 public:
  /// `detail` says where a model keeps all its triangles.
  SceneModels(const Scene& scene, std::span<const std::uint32_t> bodies, double scale,
              const SceneLimits& limits, const std::function<Detail(std::size_t model)>& detail);

  /// What a first picture needs: small models, and stand-ins of large ones.
  void write_first(std::ostream& out) const;

  /// The large models.
  void write_rest(std::ostream& out) const;

  /// Objects of JSON, without the brackets around them.
  [[nodiscard]] std::string json() const;

  /// The middle of a model in its own coordinates: what is at the place of a body.
  [[nodiscard]] const Vec3& middle(std::size_t model) const { return meshes_[model].middle; }

  [[nodiscard]] std::uint64_t triangles() const;         ///< drawn
  [[nodiscard]] std::uint64_t triangles_in_all() const;  ///< of the models

 private:
  void number_parts();
  void write(std::ostream& out, const std::string& id, std::size_t model,
             const DrawnMesh& mesh) const;
  /// Behind a mesh, so that a page can color the parts that rows name: how many triangles in a row
  /// are of a part, and its number in `Scene::parts` plus 1; 0 for all others. Nothing where no row
  /// names a part of the model.
  void put_parts(Base64Writer& data, std::size_t model, const DrawnMesh& mesh) const;

  const Scene& scene_;
  std::vector<double> steps_;      ///< of each model
  std::vector<DrawnMesh> meshes_;  ///< likewise
  std::vector<DrawnMesh> coarse_;  ///< likewise; empty where the mesh is small
  std::vector<std::map<std::uint32_t, std::uint32_t>> parts_;  ///< likewise: of mesh and of scene
};

}  // namespace soms::report
