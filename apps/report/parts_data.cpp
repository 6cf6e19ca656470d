#include "apps/report/parts_data.h"

#include "apps/report/data_block.h"
#include "apps/report/packed.h"
#include "apps/report/placing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soms::report {

namespace {

constexpr double kSmallestScene = 1e-3;
constexpr double kLargestScene = 1e7;
constexpr int kBitsOfPart = 16;  ///< of a part's size: 1 mm of 65 m
constexpr std::uint64_t kTrianglesOfBox = 12;
/// Bytes of floats and numbers that a triangle takes at most before it is packed.
constexpr std::uint64_t kBytesOfTriangle = 48;

/// A box in place of a mesh that cannot be drawn by so few triangles.
Mesh box_mesh(const Box& box) {
  Mesh mesh;
  for (unsigned corner = 0; corner < 8; ++corner) {
    mesh.vertices.push_back({(corner & 1U) != 0 ? box.upper.x : box.lower.x,
                             (corner & 2U) != 0 ? box.upper.y : box.lower.y,
                             (corner & 4U) != 0 ? box.upper.z : box.lower.z});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

std::uint64_t sum(std::span<const std::uint64_t> values) {
  std::uint64_t all = 0;
  for (const std::uint64_t value : values) {
    all += value;
  }
  return all;
}

}  // namespace

PartsData::PartsData(std::span<const PagePart> parts, const SceneLimits& limits)
    : parts_(parts), number_(parts.size(), kNoPart) {
  set_frame();
  draw(limits);
}

void PartsData::set_frame() {
  Box box;
  for (const PagePart& part : parts_) {
    box.grow(bounds(part.mesh));
  }
  if (box.empty()) {
    return;
  }
  origin_ = box.center();
  const double size = length(box.extent());
  if (size > 0 && (size < kSmallestScene || size > kLargestScene)) {
    scale_ = std::exp2(std::clamp(-std::floor(std::log2(size)), -1000.0, 1000.0));
  }
  half_ = box.extent() * (0.5 * scale_);
}

void PartsData::draw(const SceneLimits& limits) {
  std::array<std::vector<std::size_t>, 2> chosen;  // parts that rows name, and the others
  std::array<std::vector<std::uint64_t>, 2> wanted;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const std::size_t which = parts_[k].is_listed ? 0 : 1;
    chosen[which].push_back(k);
    wanted[which].push_back(parts_[k].mesh.triangles.size());
    shown_.triangles_in_all += wanted[which].back();
  }
  shown_.parts_in_all = parts_.size();
  shown_.listed = chosen[0].size();
  std::uint64_t room = std::max(limits.triangles, kTrianglesOfBox * chosen[0].size());
  for (std::size_t which = 0; which < 2; ++which) {
    const std::vector<std::uint64_t> shares = fair_shares(wanted[which], room);
    const std::uint64_t bytes = std::max(
        kBytesOfTriangle, limits.mesh_bytes / std::max<std::uint64_t>(1, limits.triangles));
    for (std::size_t k = 0; k < shares.size(); ++k) {
      add(chosen[which][k], shares[k], bytes * shares[k]);
    }
    room -= std::min(room, sum(shares));
  }
}

void PartsData::add(std::size_t part, std::uint64_t share, std::uint64_t bytes) {
  const MeshView& mesh = parts_[part].mesh;
  const Box box = bounds(mesh);
  if (mesh.triangles.empty() || (share == 0 && !parts_[part].is_listed)) {
    return;
  }
  DrawnMesh drawn_part =
      drawn(mesh, scale_, {.triangles = share, .bytes = bytes}, parts_[part].detail);
  if (drawn_part.triangles() == 0) {
    if (!parts_[part].is_listed) {
      return;
    }
    drawn_part = drawn(box_mesh(box), scale_, {});
  }
  number_[part] = static_cast<std::uint32_t>(meshes_.size());
  ++shown_.parts;
  shown_.simplified += drawn_part.triangles() < mesh.triangles.size() ? 1U : 0U;
  shown_.triangles += drawn_part.triangles();
  drawn_part.all = mesh.triangles.size();
  steps_.push_back(step_of(length(box.extent()) * scale_, kBitsOfPart));
  meshes_.push_back(std::move(drawn_part));
}

void PartsData::write(std::ostream& out) const {
  DataBlock block(out, "parts");
  for (std::size_t k = 0; k < meshes_.size(); ++k) {
    const DrawnMesh& mesh = meshes_[k];
    put_unsigned(block.data(), mesh.triangles());
    put_unsigned(block.data(), mesh.all);
    block.data().put(static_cast<float>(steps_[k]));
    const Vec3 middle = place(mesh.middle);
    for (const double value : {middle.x, middle.y, middle.z}) {
      block.data().put(static_cast<float>(value));
    }
    put_mesh(block.data(), mesh, steps_[k]);
  }
  block.finish();
}

}  // namespace soms::report
