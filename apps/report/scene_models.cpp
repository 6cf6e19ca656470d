#include "apps/report/scene_models.h"

#include "soms/geometry/parts_of.h"

#include "apps/report/data_block.h"
#include "apps/report/packed.h"
#include "apps/report/placing.h"
#include "apps/report/script_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

namespace soms::report {

namespace {

/// A model's size has so many bits of steps: 2 mm of 4 km.
constexpr int kBitsOfModel = 21;

}  // namespace

SceneModels::SceneModels(const Scene& scene, std::span<const std::uint32_t> bodies, double scale,
                         const SceneLimits& limits,
                         const std::function<Detail(std::size_t model)>& detail)
    : scene_(scene), parts_(scene.models.size()) {
  number_parts();
  const std::vector<std::uint64_t> shares = shared_out(scene, bodies, limits);
  const std::uint64_t all = std::accumulate(shares.begin(), shares.end(), std::uint64_t{0});
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const DrawLimits room{
        .triangles = shares[k],
        .bytes = static_cast<std::uint64_t>(static_cast<double>(limits.mesh_bytes) *
                                            static_cast<double>(shares[k]) /
                                            static_cast<double>(std::max<std::uint64_t>(1, all)))};
    const MeshView& mesh = scene.models[k].mesh;
    meshes_.push_back(drawn(mesh, scale, room, detail(k)));
    coarse_.push_back(meshes_[k].triangles() > kCoarseTriangles
                          ? drawn(mesh, scale, {.triangles = kCoarseTriangles})
                          : DrawnMesh{});
    const Box box = bounds(mesh);
    steps_.push_back(step_of(box.empty() ? 0 : length(box.extent()) * scale, kBitsOfModel));
  }
}

void SceneModels::number_parts() {
  std::vector<std::optional<PartsOf>> parts_of(scene_.models.size());
  for (const SceneRow& row : scene_.rows) {
    for (const auto& [body, part, triangle] :
         {std::tuple(row.a, row.part_a, row.first.a), std::tuple(row.b, row.part_b, row.first.b)}) {
      const std::size_t model = scene_.bodies[body].model;
      const MeshView& mesh = scene_.models[model].mesh;
      if (part == kNoPart || triangle >= mesh.triangles.size()) {
        continue;
      }
      if (!parts_of[model]) {
        parts_of[model].emplace(mesh);
      }
      const std::uint32_t own = first_run(mesh, (*parts_of[model])(triangle));
      if (own != Part::kNoParent) {
        parts_[model].emplace(own, part);
      }
    }
  }
}

void SceneModels::put_parts(Base64Writer& data, std::size_t model, const DrawnMesh& mesh) const {
  if (parts_[model].empty()) {
    return;
  }
  const PartsOf parts_of(scene_.models[model].mesh);
  std::uint64_t length = 0;
  std::uint64_t number = 0;
  const auto put_run = [&] {
    if (length > 0) {
      put_unsigned(data, length);
      put_unsigned(data, number);
    }
  };
  for (const TriangleId source : mesh.sources) {
    const auto found = parts_[model].find(first_run(scene_.models[model].mesh, parts_of(source)));
    const std::uint64_t next = found == parts_[model].end() ? 0 : found->second + std::uint64_t{1};
    if (next != number) {
      put_run();
      number = next;
      length = 0;
    }
    ++length;
  }
  put_run();
}

void SceneModels::write(std::ostream& out, const std::string& id, std::size_t model,
                        const DrawnMesh& mesh) const {
  DataBlock block(out, id);
  put_mesh(block.data(), mesh, steps_[model]);
  put_parts(block.data(), model, mesh);
  block.finish();
}

void SceneModels::write_first(std::ostream& out) const {
  for (std::size_t k = 0; k < meshes_.size(); ++k) {
    if (coarse_[k].triangles() > 0) {
      write(out, fmt::format("coarse-{}", k), k, coarse_[k]);
    } else {
      write(out, fmt::format("model-{}", k), k, meshes_[k]);
    }
  }
}

void SceneModels::write_rest(std::ostream& out) const {
  for (std::size_t k = 0; k < meshes_.size(); ++k) {
    if (coarse_[k].triangles() > 0) {
      write(out, fmt::format("model-{}", k), k, meshes_[k]);
    }
  }
}

std::string SceneModels::json() const {
  std::string text;
  for (std::size_t k = 0; k < meshes_.size(); ++k) {
    text +=
        fmt::format("{}{{\"name\":{},\"triangles\":{},\"drawn\":{},\"step\":{},\"coarse\":{}}}",
                    k == 0 ? "" : ",", script_text(shortened(scene_.models[k].name, kLongestText)),
                    meshes_[k].all, meshes_[k].triangles(), steps_[k], coarse_[k].triangles());
  }
  return text;
}

std::uint64_t SceneModels::triangles() const {
  return std::accumulate(
      meshes_.begin(), meshes_.end(), std::uint64_t{0},
      [](std::uint64_t sum, const DrawnMesh& mesh) { return sum + mesh.triangles(); });
}

std::uint64_t SceneModels::triangles_in_all() const {
  return std::accumulate(meshes_.begin(), meshes_.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const DrawnMesh& mesh) { return sum + mesh.all; });
}

}  // namespace soms::report
