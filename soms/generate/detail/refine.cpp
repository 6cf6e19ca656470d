#include "soms/generate/detail/refine.h"

#include "soms/base/assert.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

/// An edge by its two vertices, the lower first: also the order among edges of equal length.
using EdgeKey = std::uint64_t;

EdgeKey key(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

class Refiner {
 public:
  explicit Refiner(Mesh& mesh) : mesh_(mesh), part_of_(mesh.triangles.size(), 0) {
    for (std::uint32_t p = 0; p < mesh.parts.size(); ++p) {
      const Part& part = mesh.parts[p];
      std::fill_n(part_of_.begin() + part.first, part.count, p);
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& v = mesh.triangles[t];
      for (std::size_t i = 0; i < 3; ++i) {
        attach(v[i], v[(i + 1) % 3], t);
      }
    }
    for (const auto& [edge, beside] : beside_) {
      offer(edge);
    }
  }

  void run(std::uint64_t triangles) {
    while (mesh_.triangles.size() < triangles) {
      split(longest_.top().second);
    }
    sort_by_part();
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  void attach(std::uint32_t a, std::uint32_t b, std::uint32_t triangle) {
    auto& beside = beside_.try_emplace(key(a, b), std::array{kNone, kNone}).first->second;
    SOMS_ASSERT(beside[1] == kNone);
    beside[beside[0] == kNone ? 0 : 1] = triangle;
  }

  void offer(EdgeKey edge) {
    const Vec3 d =
        mesh_.vertices[edge >> 32] - mesh_.vertices[static_cast<std::uint32_t>(edge & kNone)];
    longest_.emplace(dot(d, d), ~edge);
  }

  void split(EdgeKey inverted) {
    const EdgeKey edge = ~inverted;
    longest_.pop();
    const auto a = static_cast<std::uint32_t>(edge >> 32);
    const auto b = static_cast<std::uint32_t>(edge & kNone);
    const auto beside = beside_.at(edge);
    beside_.erase(edge);
    const auto middle = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.push_back(0.5 * (mesh_.vertices[a] + mesh_.vertices[b]));
    for (const std::uint32_t t : beside) {
      halve(t, a, b, middle);
    }
    offer(key(a, middle));
    offer(key(b, middle));
  }

  /// Cuts triangle `t` from the middle of its edge a-b to the opposite corner: `t` keeps `a`.
  void halve(std::uint32_t t, std::uint32_t a, std::uint32_t b, std::uint32_t middle) {
    const auto other = static_cast<std::uint32_t>(mesh_.triangles.size());
    auto kept = mesh_.triangles[t];
    auto added = kept;
    std::replace(kept.begin(), kept.end(), b, middle);
    std::replace(added.begin(), added.end(), a, middle);
    const std::uint32_t opposite = *std::find_if(
        kept.begin(), kept.end(), [&](std::uint32_t v) { return v != a && v != middle; });
    mesh_.triangles[t] = kept;
    mesh_.triangles.push_back(added);
    part_of_.push_back(part_of_[t]);
    auto& moved = beside_.at(key(b, opposite));
    std::replace(moved.begin(), moved.end(), t, other);
    attach(a, middle, t);
    attach(b, middle, other);
    attach(middle, opposite, t);
    attach(middle, opposite, other);
    offer(key(middle, opposite));
  }

  void sort_by_part() {
    std::vector<std::uint32_t> order(mesh_.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t s, std::uint32_t t) { return part_of_[s] < part_of_[t]; });
    auto sorted = mesh_.triangles;
    for (std::size_t i = 0; i < order.size(); ++i) {
      sorted[i] = mesh_.triangles[order[i]];
    }
    mesh_.triangles = std::move(sorted);
    std::uint32_t first = 0;
    for (std::uint32_t p = 0; p < mesh_.parts.size(); ++p) {
      mesh_.parts[p].first = first;
      mesh_.parts[p].count =
          static_cast<std::uint32_t>(std::count(part_of_.begin(), part_of_.end(), p));
      first += mesh_.parts[p].count;
    }
  }

  Mesh& mesh_;
  std::vector<std::uint32_t> part_of_;
  std::unordered_map<EdgeKey, std::array<std::uint32_t, 2>> beside_;
  std::priority_queue<std::pair<double, EdgeKey>> longest_;  // the key inverted: lower ones first
};

}  // namespace

void refine(Mesh& mesh, std::uint64_t triangles) {
  SOMS_ASSERT(triangles >= mesh.triangles.size());
  SOMS_ASSERT((triangles - mesh.triangles.size()) % 2 == 0);
  Refiner(mesh).run(triangles);
}

}  // namespace soms::detail
