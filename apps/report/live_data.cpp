#include "apps/report/live_data.h"

#include "apps/report/data_block.h"
#include "apps/report/packed.h"
#include "apps/report/placing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace soms::report {

namespace {

constexpr std::uint64_t kBytesOfExactPose = sizeof(Pose::m);

/// A float has the same value. The double that is compared comes from a variable of type float:
/// CONTRIBUTING.md says why.
bool is_float(double value) {
  if (!(std::abs(value) <= double{std::numeric_limits<float>::max()})) {
    return false;
  }
  const float narrow = static_cast<float>(value);
  return double{narrow} == value;
}

bool all_floats(const MeshView& mesh) {
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Vec3& at) {
    return is_float(at.x) && is_float(at.y) && is_float(at.z);
  });
}

void put_exact(Base64Writer& data, const MeshView& mesh, bool floats) {
  constexpr std::uint64_t kNew = ~std::uint64_t{0};
  std::vector<std::uint64_t> number(mesh.vertices.size(), kNew);
  std::uint64_t count = 0;
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) {
      if (number[index] != kNew) {
        put_unsigned(data, count - number[index]);
        continue;
      }
      number[index] = count++;
      put_unsigned(data, 0);
      const Vec3& at = mesh.vertices[index];
      for (const double value : {at.x, at.y, at.z}) {
        floats ? data.put(static_cast<float>(value)) : data.put(value);
      }
    }
  }
}

void put_exact_pose(Base64Writer& data, const Pose& pose) {
  for (const double value : pose.m) {
    data.put(value);
  }
}

/// What is near a row: so many diameters of what moves in it, beyond where it touches. The first
/// margin that there is room for counts.
constexpr std::array kMargins{3.0, 2.0, 1.5, 1.0};
/// Places of rows: those with the most pairs of triangles.
constexpr std::size_t kMostPlaces = 400;

/// All of them as they are, as long as they fit into `room`; nothing if they do not.
std::vector<ExactMesh> models_within(std::span<const MeshView> meshes, std::uint64_t room) {
  std::vector<ExactMesh> models;
  std::uint64_t bytes = 0;
  for (const MeshView& mesh : meshes) {
    // At least a byte a corner: large models need not be counted.
    if (bytes + 3 * mesh.triangles.size() > room) {
      return {};
    }
    models.emplace_back(mesh);
    bytes += models.back().bytes();
  }
  return bytes > room ? std::vector<ExactMesh>() : models;
}

}  // namespace

ExactMesh::ExactMesh(const MeshView& mesh) : mesh_(mesh), floats_(all_floats(mesh)) {
}

std::uint64_t ExactMesh::bytes() const {
  std::ostream nowhere(nullptr);
  Base64Writer data(nowhere);
  put_exact(data, mesh_, floats_);
  return data.bytes();
}

void ExactMesh::write(std::ostream& out, const std::string& id) const {
  DataBlock block(out, id);
  put_exact(block.data(), mesh_, floats_);
  block.finish();
}

LiveData::LiveData(const Scene& scene, std::span<const std::uint32_t> bodies,
                   std::span<const std::uint64_t> steps, const SceneLimits& limits)
    : scene_(scene), bodies_(bodies), steps_(steps), room_(limits.exact_bytes) {
  std::uint64_t moving = 0;
  for (const std::uint32_t body : bodies) {
    moving += scene.bodies[body].moves ? 1U : 0U;
  }
  any_moves_ = moving > 0;
  if (!any_moves_) {
    return;
  }
  has_movers_ = bodies.size() == scene.bodies.size() &&
                moving * steps.size() <= limits.exact_pose_bytes / kBytesOfExactPose;
  models_ = models_within(meshes(), limits.exact_bytes);
  for (std::size_t k = 0; models_.empty() && k < kMargins.size(); ++k) {
    set_near(kMargins[k]);
    if (!near_.empty()) {
      models_ = models_within(meshes(), limits.exact_bytes);
    }
  }
}

void LiveData::set_near(double margin) {
  std::vector<const SceneRow*> rows;
  for (const SceneRow& row : scene_.rows) {
    if (!row.box.empty()) {
      rows.push_back(&row);
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const SceneRow* a, const SceneRow* b) {
    return a->most_pairs > b->most_pairs;
  });
  rows.resize(std::min(rows.size(), kMostPlaces));
  near_.clear();
  for (const SceneRow* row : rows) {
    double size = 0;
    for (const std::uint32_t body : {row->a, row->b}) {
      if (scene_.bodies[body].moves) {
        size =
            std::max(size, length(bounds(scene_.models[scene_.bodies[body].model].mesh).extent()));
      }
    }
    const double by = margin * size;
    Box box;
    box.grow(row->box.lower - Vec3{by, by, by});
    box.grow(row->box.upper + Vec3{by, by, by});
    near_.push_back(box);
  }
}

/// The meshes of the page's models; of those that stand still alone, what is near.
std::vector<MeshView> LiveData::meshes() {
  static const Mesh kNone;
  std::vector<MeshView> found(scene_.models.size(), kNone);
  std::vector<std::vector<Pose>> places(scene_.models.size());  // where a model may be cut
  std::vector<bool> moves(scene_.models.size(), false);
  for (const std::uint32_t body : bodies_) {
    const SceneBody& shown = scene_.bodies[body];
    found[shown.model] = scene_.models[shown.model].mesh;
    if (shown.moves) {
      moves[shown.model] = true;
    } else {
      places[shown.model].push_back(scene_.pose(body, 0));
    }
  }
  parts_.clear();
  for (std::size_t k = 0; k < found.size() && !near_.empty(); ++k) {
    if (moves[k]) {
      continue;
    }
    std::vector<std::array<std::uint32_t, 3>>& kept = parts_.emplace_back();
    for (TriangleId i = 0; i < found[k].triangles.size(); ++i) {
      const bool is_near = std::any_of(places[k].begin(), places[k].end(), [&](const Pose& pose) {
        const Box box = bounds(moved(found[k].triangle(i), pose));
        return std::any_of(near_.begin(), near_.end(),
                           [&](const Box& place) { return overlaps(place, box); });
      });
      if (is_near) {
        kept.push_back(found[k].triangles[i]);
      }
    }
    found[k].triangles = kept;
  }
  return found;
}

void LiveData::write(std::ostream& out) const {
  for (std::size_t k = 0; k < models_.size(); ++k) {
    models_[k].write(out, fmt::format("exact-{}", k));
  }
  DataBlock block(out, "exact-poses");
  for (const std::uint32_t body : bodies_) {
    if (!scene_.bodies[body].moves) {
      put_exact_pose(block.data(), scene_.pose(body, 0));
    }
  }
  if (has_movers_) {
    for (const std::uint64_t step : steps_) {
      for (const std::uint32_t body : bodies_) {
        if (scene_.bodies[body].moves) {
          put_exact_pose(block.data(), scene_.pose(body, step));
        }
      }
    }
  }
  block.finish();
}

std::string LiveData::json(const std::function<Vec3(std::size_t model)>& middle) const {
  if (!any_moves_) {
    return "null";
  }
  std::string models;
  for (std::size_t k = 0; k < models_.size(); ++k) {
    const Vec3 at = middle(k);
    models += fmt::format("{}{{\"floats\":{},\"middle\":[{},{},{}]}}", k == 0 ? "" : ",",
                          models_[k].has_floats(), at.x, at.y, at.z);
  }
  std::string places;
  for (std::size_t k = 0; k < near_.size() && is_there(); ++k) {
    const auto& [lower, upper] = near_[k];
    places += fmt::format("{}[{},{},{},{},{},{}]", k == 0 ? "" : ",", lower.x, lower.y, lower.z,
                          upper.x, upper.y, upper.z);
  }
  return fmt::format("{{\"room\":{},\"movers\":{},\"near\":[{}],\"models\":[{}]}}", room_,
                     has_movers_, places, models);
}

}  // namespace soms::report
