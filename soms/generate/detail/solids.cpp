#include "soms/generate/detail/solids.h"

#include "soms/base/assert.h"

#include <utility>

namespace soms::detail {

namespace {

std::uint32_t next_vertex(const Mesh& mesh) {
  return static_cast<std::uint32_t>(mesh.vertices.size());
}

void add_outline(Mesh& mesh, const Frame& frame, std::span<const Corner> outline, double height) {
  for (const Corner& c : outline) {
    mesh.vertices.push_back(frame.at(c.x, c.y, height));
  }
}

/// Side faces between two rings of `n` vertices; outward when the rings turn counter-clockwise.
void add_sides(Mesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t n) {
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = i + 1 == n ? 0 : i + 1;
    mesh.triangles.push_back({lower + i, lower + j, upper + j});
    mesh.triangles.push_back({lower + i, upper + j, upper + i});
  }
}

/// Flat faces between two rings of `n` vertices in one plane; seen from above `outer` turns
/// counter-clockwise about `inner`.
void add_annulus(Mesh& mesh, std::uint32_t outer, std::uint32_t inner, std::uint32_t n) {
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = i + 1 == n ? 0 : i + 1;
    mesh.triangles.push_back({outer + i, outer + j, inner + j});
    mesh.triangles.push_back({outer + i, inner + j, inner + i});
  }
}

}  // namespace

Frame upright(const Vec3& origin, const OnCircle& turn) {
  return {origin, {turn.cosine, turn.sine, 0}, {-turn.sine, turn.cosine, 0}, {0, 0, 1}};
}

Frame lengthwise(const Frame& frame) {
  return {frame.origin, frame.y, frame.z, frame.x};
}

Frame crosswise(const Frame& frame) {
  return {frame.origin, frame.z, frame.x, frame.y};
}

Outline rectangle(double half_x, double half_y) {
  return {{-half_x, -half_y}, {half_x, -half_y}, {half_x, half_y}, {-half_x, half_y}};
}

Outline regular(std::size_t corners, double radius) {
  Outline outline;
  for (std::size_t i = 0; i < corners; ++i) {
    const OnCircle p = on_circle(i, corners);
    outline.push_back({radius * p.cosine, radius * p.sine});
  }
  return outline;
}

void add_frustum(Mesh& mesh, const Frame& frame, std::span<const Corner> lower,
                 std::span<const Corner> upper, double from, double to) {
  SOMS_ASSERT(lower.size() == upper.size());
  const auto n = static_cast<std::uint32_t>(lower.size());
  const std::uint32_t bottom = next_vertex(mesh);
  const std::uint32_t top = bottom + n;
  add_outline(mesh, frame, lower, from);
  add_outline(mesh, frame, upper, to);
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({bottom, bottom + i + 1, bottom + i});
    mesh.triangles.push_back({top, top + i, top + i + 1});
  }
  add_sides(mesh, bottom, top, n);
}

void add_prism(Mesh& mesh, const Frame& frame, std::span<const Corner> outline, double from,
               double to) {
  add_frustum(mesh, frame, outline, outline, from, to);
}

void add_box(Mesh& mesh, const Frame& frame, const Vec3& half) {
  const std::array<Corner, 4> outline{
      {{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}}};
  add_prism(mesh, frame, outline, -half.z, half.z);
}

void add_ring(Mesh& mesh, const Frame& frame, std::span<const Corner> outer,
              std::span<const Corner> inner, double from, double to) {
  SOMS_ASSERT(outer.size() == inner.size());
  const auto n = static_cast<std::uint32_t>(outer.size());
  const std::uint32_t first = next_vertex(mesh);
  add_outline(mesh, frame, outer, from);
  add_outline(mesh, frame, outer, to);
  add_outline(mesh, frame, inner, from);
  add_outline(mesh, frame, inner, to);
  add_sides(mesh, first, first + n, n);
  add_sides(mesh, first + 3 * n, first + 2 * n, n);
  add_annulus(mesh, first + n, first + 3 * n, n);
  add_annulus(mesh, first + 2 * n, first, n);
}

void add_ellipsoid(Mesh& mesh, const Frame& frame, const Vec3& radii, std::uint32_t around,
                   std::uint32_t rings, std::span<const double> swell) {
  const std::uint32_t south = next_vertex(mesh);
  const std::uint32_t first = south + 1;
  const std::uint32_t north = first + around * rings;
  mesh.vertices.push_back(frame.at(0, 0, -radii.z));
  for (std::uint32_t i = 0; i < rings; ++i) {
    // Colatitude from the south pole, half a turn in rings + 1 steps.
    const OnCircle height = on_circle(i + 1, std::size_t{2} * (rings + 1));
    for (std::uint32_t j = 0; j < around; ++j) {
      const OnCircle p = on_circle(j, around);
      const double reach = height.sine * (swell.empty() ? 1 : swell[i * around + j]);
      mesh.vertices.push_back(
          frame.at(radii.x * reach * p.cosine, radii.y * reach * p.sine, -radii.z * height.cosine));
    }
  }
  mesh.vertices.push_back(frame.at(0, 0, radii.z));
  for (std::uint32_t j = 0; j < around; ++j) {
    const std::uint32_t k = j + 1 == around ? 0 : j + 1;
    mesh.triangles.push_back({south, first + k, first + j});
    mesh.triangles.push_back({north, north - around + j, north - around + k});
  }
  for (std::uint32_t i = 0; i + 1 < rings; ++i) {
    add_sides(mesh, first + i * around, first + (i + 1) * around, around);
  }
}

std::uint32_t open_part(Mesh& mesh, std::string name, std::uint32_t parent) {
  mesh.parts.push_back(
      {std::move(name), parent, static_cast<std::uint32_t>(mesh.triangles.size()), 0});
  return static_cast<std::uint32_t>(mesh.parts.size() - 1);
}

void close_part(Mesh& mesh, std::uint32_t part) {
  mesh.parts[part].count =
      static_cast<std::uint32_t>(mesh.triangles.size()) - mesh.parts[part].first;
}

}  // namespace soms::detail
