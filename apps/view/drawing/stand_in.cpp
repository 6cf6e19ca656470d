#include "apps/view/drawing/stand_in.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace soms::view {

namespace {

/// Cubes on the longest side of the box that are tried, the most first.
constexpr std::array<int, 11> kSides{64, 48, 32, 24, 16, 12, 8, 6, 4, 3, 2};
/// A piece is small if its longest side is at most this part of the box's, and few of its triangles
/// would do as well.
constexpr double kSmall = 0.3;
constexpr std::size_t kTrianglesOfBox = 10;
/// Boxes take at most this part of all triangles where there are pieces that reach far.
constexpr double kShareOfBoxes = 0.8;

double longest_side(const Box& box) {
  const Vec3 extent = box.extent();
  return std::max({extent.x, extent.y, extent.z});
}

using Piece = StandInMaker::Piece;

struct HashOfPlace {
  std::size_t operator()(const Vec3& p) const {
    std::uint64_t hash = 0;
    for (const double x : {p.x, p.y, p.z}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15U;  // -0 as 0
      hash ^= hash >> 29;
    }
    return hash;
  }
};

/// Places that hang together: each leads to another, and the last to itself.
class Roots {
 public:
  /// Number of a place; vertices at one place are one.
  std::size_t place(const Vec3& p) {
    const auto [at, fresh] = number_.try_emplace(p, parent_.size());
    if (fresh) {
      parent_.push_back(at->second);
    }
    return at->second;
  }

  std::size_t of(std::size_t place) {
    while (parent_[place] != place) {
      parent_[place] = parent_[parent_[place]];
      place = parent_[place];
    }
    return place;
  }

  void join(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

 private:
  std::unordered_map<Vec3, std::size_t, HashOfPlace> number_;
  std::vector<std::size_t> parent_;
};

/// In the order of their first triangles.
std::vector<Piece> pieces_of(const Mesh& mesh, std::span<const TriangleId> triangles) {
  Roots roots;
  std::vector<std::size_t> places;  // of the first corners
  places.reserve(triangles.size());
  for (const TriangleId i : triangles) {
    const Triangle t = mesh.triangle(i);
    const std::size_t a = roots.place(t.a);
    roots.join(a, roots.place(t.b));
    roots.join(a, roots.place(t.c));
    places.push_back(a);
  }
  std::vector<Piece> pieces;
  std::unordered_map<std::size_t, std::size_t> number;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const TriangleId i = triangles[k];
    const auto [at, fresh] = number.try_emplace(roots.of(places[k]), pieces.size());
    if (fresh) {
      pieces.emplace_back();
    }
    Piece& piece = pieces[at->second];
    piece.triangles.push_back(i);
    piece.box.grow(bounds(mesh.triangle(i)));
  }
  return pieces;
}

/// Four walls and a roof.
void add_box(const Box& box, TriangleId of, std::vector<StandInTriangle>& few) {
  const auto corner = [&box](int x, int y, int z) {
    return Vec3{x == 0 ? box.lower.x : box.upper.x, y == 0 ? box.lower.y : box.upper.y,
                z == 0 ? box.lower.z : box.upper.z};
  };
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    few.push_back({{a, b, c}, of});
    few.push_back({{a, c, d}, of});
  };
  add(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  add(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
  add(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
  add(corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1));
  add(corner(0, 1, 0), corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1));
}

/// Gives each corner the one in its cube that is farthest from the middle of the box.
class Cubes {
 public:
  Cubes(const Mesh& mesh, std::span<const TriangleId> triangles, const Box& box, int side)
      : mesh_(mesh), box_(box), side_(static_cast<std::uint64_t>(side)) {
    const double longest = longest_side(box);
    scale_ = longest > 0 ? side / longest : 0;
    for (const TriangleId i : triangles) {
      for (const std::uint32_t v : mesh.triangles[i]) {
        std::uint32_t& outermost = outermost_.try_emplace(cube_of(v), v).first->second;
        if (off_middle(v) > off_middle(outermost)) {
          outermost = v;
        }
      }
    }
  }

  [[nodiscard]] std::uint32_t of(std::uint32_t v) const { return outermost_.at(cube_of(v)); }

 private:
  [[nodiscard]] double off_middle(std::uint32_t v) const {
    const Vec3 off = mesh_.vertices[v] - box_.center();
    return dot(off, off);
  }

  [[nodiscard]] std::uint64_t cube_of(std::uint32_t v) const {
    const Vec3 place = (mesh_.vertices[v] - box_.lower) * scale_;
    const auto step = [this](double x) {
      return static_cast<std::uint64_t>(std::clamp(x, 0.0, static_cast<double>(side_ - 1)));
    };
    return (step(place.x) * side_ + step(place.y)) * side_ + step(place.z);
  }

  const Mesh& mesh_;
  Box box_;
  std::uint64_t side_;
  double scale_ = 0;
  std::unordered_map<std::uint64_t, std::uint32_t> outermost_;
};

/// Neighbors that become one box.
struct Neighbors {
  const Piece* largest = nullptr;
  Box box;
  double footprint = 0;
  double volume = 0;

  void add(const Piece& piece) {
    const Vec3 extent = piece.box.extent();
    largest = largest == nullptr ? &piece : largest;
    box.grow(piece.box);
    footprint += extent.x * extent.y;
    volume += extent.x * extent.y * extent.z;
  }

  /// About their middle: what was free between them is free around it, so streets stay.
  [[nodiscard]] Piece together() const {
    const Vec3 extent = box.extent();
    const double covered = extent.x * extent.y;
    const double part = covered > 0 ? std::sqrt(std::min(1.0, footprint / covered)) : 1;
    const double height = footprint > 0 ? volume / footprint : extent.z;
    const Vec3 middle = box.center();
    const Vec3 half = extent * (0.5 * part);
    const double top = std::min(box.upper.z, box.lower.z + std::max(height, 0.0));
    const Box block{{middle.x - half.x, middle.y - half.y, box.lower.z},
                    {middle.x + half.x, middle.y + half.y, top}};
    return {{largest->triangles.front()}, block};
  }
};

/// At most `room` pieces, but one at least: those in a square of the ground become one.
/// \pre `pieces` are sorted, the largest first.
std::vector<Piece> joined(const std::vector<Piece>& pieces, const Box& box, std::size_t room) {
  std::map<std::pair<int, int>, Neighbors> squares;
  for (int side = kSides.front(); side > 0; side = side > 8 ? side - 8 : side - 1) {
    squares.clear();
    const double scale = longest_side(box) > 0 ? side / longest_side(box) : 0;
    for (const Piece& piece : pieces) {
      const Vec3 at = (piece.box.center() - box.lower) * scale;
      squares[{static_cast<int>(at.x), static_cast<int>(at.y)}].add(piece);
    }
    if (squares.size() <= room) {
      break;
    }
  }
  std::vector<Piece> blocks;
  for (const auto& [square, neighbors] : squares) {
    blocks.push_back(neighbors.together());
  }
  std::stable_sort(blocks.begin(), blocks.end(), [](const Piece& a, const Piece& b) {
    return half_area(a.box) > half_area(b.box);
  });
  return blocks;
}

/// What is left of a triangle that shrinks to a line is dropped, and of equal ones the first stays.
std::vector<StandInTriangle> merged(const Mesh& mesh, std::span<const TriangleId> triangles,
                                    const Box& box, int side) {
  const Cubes cubes(mesh, triangles, box, side);
  std::set<std::array<std::uint32_t, 3>> known;
  std::vector<StandInTriangle> kept;
  for (const TriangleId i : triangles) {
    const auto& [a, b, c] = mesh.triangles[i];
    const std::array<std::uint32_t, 3> now{cubes.of(a), cubes.of(b), cubes.of(c)};
    std::array<std::uint32_t, 3> sorted = now;
    std::sort(sorted.begin(), sorted.end());
    const bool is_line = sorted[0] == sorted[1] || sorted[1] == sorted[2];
    if (!is_line && known.insert(sorted).second) {
      kept.push_back({{mesh.vertices[now[0]], mesh.vertices[now[1]], mesh.vertices[now[2]]}, i});
    }
  }
  return kept;
}

std::vector<StandInTriangle> coarser(const Mesh& mesh, std::span<const TriangleId> triangles,
                                     const Box& box, std::size_t most) {
  std::vector<StandInTriangle> kept;
  for (const int side : kSides) {
    const auto squares = static_cast<std::size_t>(side * side);
    if (squares > most && side != kSides.back()) {
      continue;  // a surface across the box has twice as many triangles
    }
    kept = merged(mesh, triangles, box, side);
    if (kept.size() <= most) {
      break;
    }
  }
  return kept;
}

}  // namespace

StandInMaker::StandInMaker(const Mesh& mesh, std::span<const TriangleId> triangles, const Box& box)
    : mesh_(mesh), box_(box) {
  for (Piece& piece : pieces_of(mesh, triangles)) {
    if (longest_side(piece.box) <= kSmall * longest_side(box) &&
        piece.triangles.size() >= kTrianglesOfBox) {
      small_.push_back(std::move(piece));
    } else {
      far_reaching_.insert(far_reaching_.end(), piece.triangles.begin(), piece.triangles.end());
    }
  }
  std::stable_sort(small_.begin(), small_.end(), [](const Piece& a, const Piece& b) {
    return half_area(a.box) > half_area(b.box);
  });
}

std::vector<StandInTriangle> StandInMaker::at_most(std::size_t most) const {
  const double share = far_reaching_.empty() ? 1 : kShareOfBoxes;
  const auto room = static_cast<std::size_t>(share * static_cast<double>(most)) / kTrianglesOfBox;
  const std::vector<Piece> blocks = small_.size() > room ? joined(small_, box_, room) : small_;
  std::vector<StandInTriangle> few =
      coarser(mesh_, far_reaching_, box_, most - std::min(most, kTrianglesOfBox * blocks.size()));
  for (const Piece& block : blocks) {
    add_box(block.box, block.triangles.front(), few);
  }
  return few;
}

std::vector<StandInTriangle> one_box(TriangleId of, const Box& box) {
  std::vector<StandInTriangle> few;
  add_box(box, of, few);
  return few;
}

}  // namespace soms::view
