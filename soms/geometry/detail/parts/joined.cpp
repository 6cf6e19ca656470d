#include "soms/geometry/detail/parts/joined.h"

#include "soms/base/portable.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <tuple>

namespace soms::detail {

namespace {

/// Buckets of places: a power of two, about four vertices each.
std::size_t bucket_count(const MeshView& mesh) {
  return std::bit_ceil(mesh.vertices.size() / 8 + 1);
}

/// A bucket for a place: equal places have equal ones, and neighbors rarely do.
std::size_t bucket_of(const Vec3& p, std::size_t buckets) {
  std::uint64_t mixed = 0;
  for (const double x : {p.x, p.y, p.z}) {
    // Adding 0 turns -0 into 0. The rotation lets high bits of all three meet.
    mixed = (std::rotl(mixed, 29) ^ bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15ULL;
  }
  return static_cast<std::size_t>((mixed ^ mixed >> 32) & (buckets - 1));
}

bool before(const Vec3& p, const Vec3& q) {
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

}  // namespace

std::uint64_t joining_work(const MeshView& mesh) {
  return mesh.triangles.size() + 2 * std::uint64_t{mesh.vertices.size()} + bucket_count(mesh);
}

std::vector<std::uint32_t> joined_by_position(const MeshView& mesh, Work& work) {
  std::vector<std::uint32_t> joined(mesh.vertices.size(), kUnused);
  work.run(mesh.triangles.size(), [&](std::size_t i) {
    for (const std::uint32_t v : mesh.triangles[i]) {
      joined[v] = v;
    }
  });
  const std::size_t buckets = bucket_count(mesh);
  auto places = sort_into_buckets<std::uint32_t>(
      buckets, mesh.vertices.size(), work, [&](std::size_t i, const auto& put) {
        if (joined[i] != kUnused) {
          put(bucket_of(mesh.vertices[i], buckets), static_cast<std::uint32_t>(i));
        }
      });
  work.run(places.size(), [&](std::size_t k) {
    const auto bucket = places[k];
    std::sort(bucket.begin(), bucket.end(), [&mesh](std::uint32_t v, std::uint32_t w) {
      const Vec3& p = mesh.vertices[v];
      const Vec3& q = mesh.vertices[w];
      return before(p, q) || (!before(q, p) && v < w);
    });
    for (std::size_t i = 1; i < bucket.size(); ++i) {
      if (mesh.vertices[bucket[i - 1]] == mesh.vertices[bucket[i]]) {
        joined[bucket[i]] = joined[bucket[i - 1]];
      }
    }
  });
  return joined;
}

}  // namespace soms::detail
