#include "apps/report/drawn_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace soms::report {

namespace {

using Corner = std::array<float, 3>;
using Triple = std::array<std::uint32_t, 3>;
using Cell = std::array<std::int64_t, 3>;

constexpr int kHalvings = 6;
constexpr int kAttempts = 14;
/// A triangle over more cells than this is large, and worth keeping wherever it lies.
constexpr std::int64_t kManyCells = 64;
/// Cells along an axis at most.
constexpr double kMostCells = 1 << 30;
/// Points farther off than this many cells share the last one.
constexpr double kFarCell = 1e15;

/// A triangle by the vertices that it is drawn with, and its number in the mesh.
struct Kept {
  Triple corners;
  TriangleId source = 0;
};

/// A vertex with the key of its cell; sorted, cells lie together.
struct Keyed {
  Triple key;
  std::uint32_t vertex = 0;

  [[nodiscard]] bool operator<(const Keyed& other) const {
    return key != other.key ? key < other.key : vertex < other.vertex;
  }
};

Corner minus(const Corner& a, const Corner& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double area(const Corner& a, const Corner& b, const Corner& c) {
  const Corner u = minus(b, a);
  const Corner v = minus(c, a);
  const auto minor = [&](std::size_t i, std::size_t j) {
    return static_cast<double>(u[i]) * static_cast<double>(v[j]) -
           static_cast<double>(u[j]) * static_cast<double>(v[i]);
  };
  return 0.5 * std::hypot(minor(1, 2), minor(2, 0), minor(0, 1));
}

std::int64_t cell_number(double offset, double size) {
  return static_cast<std::int64_t>(std::clamp(std::floor(offset / size), -kFarCell, kFarCell));
}

/// Triangles that come near one of the points of a detail.
class Near {
 public:
  Near(const Detail& detail, double radius, const Vec3& middle)
      : middle_(middle), size_(2 * radius) {
    for (const Vec3& point : detail.points) {
      Box box;
      box.grow(point - Vec3{radius, radius, radius});
      box.grow(point + Vec3{radius, radius, radius});
      static_cast<void>(visit(box, [&](const Cell& cell) {
        cells_.push_back(cell);
        return false;
      }));
    }
    std::sort(cells_.begin(), cells_.end());
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
  }

  [[nodiscard]] bool holds(const Triangle& triangle) const {
    Box box;
    for (const Vec3& corner : {triangle.a, triangle.b, triangle.c}) {
      box.grow(corner);
    }
    return visit(box, [&](const Cell& cell) {
      return std::binary_search(cells_.begin(), cells_.end(), cell);
    });
  }

 private:
  /// True if a cell of the box says so, or if there are too many cells to ask.
  template <typename Ask>
  [[nodiscard]] bool visit(const Box& box, const Ask& ask) const {
    const Cell low = cell_of(box.lower);
    const Cell high = cell_of(box.upper);
    std::int64_t count = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      count *= std::min(kManyCells, high[k] - low[k]) + 1;
    }
    if (count > kManyCells) {
      return true;
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          if (ask(Cell{x, y, z})) {
            return true;
          }
        }
      }
    }
    return false;
  }

  [[nodiscard]] Cell cell_of(const Vec3& at) const {
    const Vec3 offset = at - middle_;
    return {cell_number(offset.x, size_), cell_number(offset.y, size_),
            cell_number(offset.z, size_)};
  }

  Vec3 middle_;
  double size_;
  std::vector<Cell> cells_;
};

/// Draws one mesh.
class Drawer {
 public:
  Drawer(const MeshView& mesh, double scale) : mesh_(mesh) {
    const Box box = bounds(mesh);
    drawn_.scale = scale;
    drawn_.all = mesh.triangles.size();
    if (!box.empty()) {
      drawn_.middle = box.center();
      extent_ = box.extent();
    }
    place_corners();
    join_equal_corners();
  }

  DrawnMesh draw(const DrawLimits& limits, const Detail& detail) {
    std::vector<Kept> whole;
    whole.reserve(mesh_.triangles.size());
    for (TriangleId i = 0; i < mesh_.triangles.size(); ++i) {
      const Triple& t = mesh_.triangles[i];
      whole.push_back({{leader_[t[0]], leader_[t[1]], leader_[t[2]]}, i});
    }
    if (!fits(whole, limits)) {
      choose_kept(limits, detail);
      weigh();
      whole = search(limits);
    }
    emit(whole);
    return std::move(drawn_);
  }

 private:
  void place_corners() {
    corners_.reserve(mesh_.vertices.size());
    const auto place = [&](double offset) {
      return static_cast<float>(offset * drawn_.scale) + 0.0F;  // -0 becomes 0
    };
    for (const Vec3& vertex : mesh_.vertices) {
      const Vec3 at = vertex - drawn_.middle;
      corners_.push_back({place(at.x), place(at.y), place(at.z)});
    }
  }

  /// Leaders of corners that are the same floats.
  void join_equal_corners() {
    std::vector<Keyed> keyed(corners_.size());
    for (std::uint32_t v = 0; v < keyed.size(); ++v) {
      keyed[v].vertex = v;
      for (std::size_t k = 0; k < 3; ++k) {
        keyed[v].key[k] = std::bit_cast<std::uint32_t>(corners_[v][k]);
      }
    }
    std::sort(keyed.begin(), keyed.end());
    leader_.resize(corners_.size());
    for (std::size_t k = 0; k < keyed.size(); ++k) {
      const bool same = k > 0 && keyed[k].key == keyed[k - 1].key;
      leader_[keyed[k].vertex] = same ? leader_[keyed[k - 1].vertex] : keyed[k].vertex;
    }
  }

  [[nodiscard]] bool fits(const std::vector<Kept>& triangles, const DrawLimits& limits) const {
    if (triangles.size() > limits.triangles) {
      return false;
    }
    std::vector<std::uint8_t> used(corners_.size(), 0);
    std::uint64_t vertices = 0;
    for (const Kept& t : triangles) {
      for (const std::uint32_t v : t.corners) {
        vertices += used[v] == 0 ? 1U : 0U;
        used[v] = 1;
      }
    }
    return 12 * (vertices + triangles.size()) <= limits.bytes;
  }

  void choose_kept(const DrawLimits& limits, const Detail& detail) {
    kept_.assign(corners_.size(), 0);
    const double reach = std::max({extent_.x, extent_.y, extent_.z});
    double radius = detail.radius;
    for (int k = 0; k < kHalvings && radius > 1e-9 * reach && !detail.points.empty(); ++k) {
      const Near near(detail, radius, drawn_.middle);
      std::vector<TriangleId> found;
      for (TriangleId i = 0; i < mesh_.triangles.size() && 2 * found.size() <= limits.triangles;
           ++i) {
        if (near.holds(mesh_.triangle(i))) {
          found.push_back(i);
        }
      }
      if (2 * found.size() <= limits.triangles && 48 * found.size() <= limits.bytes) {
        for (const TriangleId i : found) {
          for (const std::uint32_t v : mesh_.triangles[i]) {
            kept_[leader_[v]] = 1;
          }
        }
        return;
      }
      radius /= 2;
    }
  }

  /// Area of the triangles around each leader; -1 where there are none.
  void weigh() {
    weight_.assign(corners_.size(), -1);
    for (const Triple& t : mesh_.triangles) {
      const double size = area(corners_[t[0]], corners_[t[1]], corners_[t[2]]);
      area_ += size;
      for (const std::uint32_t v : t) {
        weight_[leader_[v]] = std::max(0.0, weight_[leader_[v]]) + size;
      }
    }
  }

  /// What is left with cells of this size.
  [[nodiscard]] std::vector<Kept> clustered(double size) const {
    std::vector<Keyed> keyed;
    std::vector<std::uint32_t> leader(corners_.size());
    std::iota(leader.begin(), leader.end(), 0U);
    for (std::uint32_t v = 0; v < corners_.size(); ++v) {
      if (leader_[v] == v && weight_[v] >= 0 && kept_[v] == 0) {
        Keyed& next = keyed.emplace_back(Keyed{.key = {}, .vertex = v});
        for (std::size_t k = 0; k < 3; ++k) {
          next.key[k] = static_cast<std::uint32_t>(
              std::floor(static_cast<double>(corners_[v][k]) / size) + kMostCells);
        }
      }
    }
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t begin = 0, end = 0; begin < keyed.size(); begin = end) {
      std::uint32_t best = keyed[begin].vertex;
      for (end = begin; end < keyed.size() && keyed[end].key == keyed[begin].key; ++end) {
        best = weight_[keyed[end].vertex] > weight_[best] ? keyed[end].vertex : best;
      }
      for (std::size_t k = begin; k < end; ++k) {
        leader[keyed[k].vertex] = best;
      }
    }
    return without_duplicates(leader);
  }

  [[nodiscard]] std::vector<Kept> without_duplicates(
      const std::vector<std::uint32_t>& leader) const {
    std::vector<std::tuple<Triple, Triple, TriangleId>>
        left;  // sorted corners, as they turn, source
    for (TriangleId i = 0; i < mesh_.triangles.size(); ++i) {
      const Triple& t = mesh_.triangles[i];
      const Triple moved{leader[leader_[t[0]]], leader[leader_[t[1]]], leader[leader_[t[2]]]};
      if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]) {
        Triple sorted = moved;
        std::sort(sorted.begin(), sorted.end());
        left.emplace_back(sorted, moved, i);
      }
    }
    std::sort(left.begin(), left.end());
    std::vector<Kept> triangles;
    for (std::size_t k = 0; k < left.size(); ++k) {
      const auto& [sorted, moved, source] = left[k];
      if (k == 0 || sorted != std::get<0>(left[k - 1])) {
        triangles.push_back({moved, source});
      }
    }
    return triangles;
  }

  /// Cells about as small as the limits allow: bisection of their size, from a size that would suit
  /// a smooth surface.
  [[nodiscard]] std::vector<Kept> search(const DrawLimits& limits) const {
    const double reach =
        std::max({extent_.x, extent_.y, extent_.z}) * drawn_.scale + 1e-30;  // of a mere point
    const double least = 8 * reach / kMostCells;
    double size = std::max(
        least,
        std::sqrt(area_ / static_cast<double>(std::max<std::uint64_t>(1, limits.triangles))));
    double too_small = 0;
    std::optional<double> large_enough;
    std::vector<Kept> best;
    for (int k = 0; (k < kAttempts || !large_enough) && size < 4 * reach; ++k) {
      std::vector<Kept> found = clustered(size);
      if (fits(found, limits)) {
        large_enough = size;
        best = std::move(found);
        if (4 * best.size() >= 3 * limits.triangles || size <= least) {
          break;
        }
      } else {
        too_small = size;
      }
      size = !large_enough    ? 2 * size
             : too_small == 0 ? std::max(least, *large_enough / 2)
                              : std::sqrt(too_small * *large_enough);
      if (large_enough && too_small > 0 && *large_enough < 1.05 * too_small) {
        break;
      }
    }
    return best;
  }

  void emit(const std::vector<Kept>& triangles) {
    constexpr std::uint32_t kNone = 0xffffffffU;
    std::vector<std::uint32_t> number(corners_.size(), kNone);
    std::uint32_t next = 0;
    drawn_.indices.reserve(3 * triangles.size());
    for (const Kept& t : triangles) {
      drawn_.sources.push_back(t.source);
      for (const std::uint32_t v : t.corners) {
        if (number[v] == kNone) {
          number[v] = next++;
          drawn_.vertices.insert(drawn_.vertices.end(), corners_[v].begin(), corners_[v].end());
        }
        drawn_.indices.push_back(number[v]);
      }
    }
  }

  MeshView mesh_;
  DrawnMesh drawn_;
  Vec3 extent_;
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> leader_;
  std::vector<std::uint8_t> kept_;
  std::vector<double> weight_;
  double area_ = 0;
};

}  // namespace

DrawnMesh drawn(const MeshView& mesh, double scale, const DrawLimits& limits,
                const Detail& detail) {
  return Drawer(mesh, scale).draw(limits, detail);
}

}  // namespace soms::report
