#include "soms/generate/teapot.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/generate/detail/solids.h"

#include <array>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace soms {

namespace {

using Row = std::array<Vec3, 4>;
using Patch = std::array<Row, 4>;

/// Control points of a quarter turn about z: (r, 0), (r, -k), (k, -r), (0, -r) at height z.
struct Ring {
  double r = 0;
  double k = 0;
  double z = 0;
};

/// Control points of half a tube, from (x0, z0) to (x1, z1) in the plane y = 0, `y` wide.
struct Oval {
  double x0 = 0;
  double z0 = 0;
  double x1 = 0;
  double z1 = 0;
  double y = 0;
};

// Patches that follow each other share a row.
constexpr std::array<Ring, 4> kRim{{
    {1.4, 0.784, 2.4},
    {1.3375, 0.749, 2.53125},
    {1.4375, 0.805, 2.53125},
    {1.5, 0.84, 2.4},
}};
constexpr std::array<Ring, 7> kBody{{
    {1.5, 0.84, 2.4},
    {1.75, 0.98, 1.875},
    {2, 1.12, 1.35},
    {2, 1.12, 0.9},
    {2, 1.12, 0.45},
    {1.5, 0.84, 0.225},
    {1.5, 0.84, 0.15},
}};
constexpr std::array<Ring, 7> kLid{{
    {0, 0, 3.15},
    {0.8, 0.45, 3.15},
    {0, 0, 2.85},
    {0.2, 0.112, 2.7},
    {0.4, 0.224, 2.55},
    {1.3, 0.728, 2.55},
    {1.3, 0.728, 2.4},
}};
constexpr std::array<Ring, 4> kBottom{{
    {1.5, 0.84, 0.15},
    {1.5, 0.84, 0.075},
    {1.425, 0.798, 0},
    {0, 0, 0},
}};
constexpr std::array<Oval, 7> kHandle{{
    {-1.6, 2.025, -1.5, 2.25, 0.3},
    {-2.3, 2.025, -2.5, 2.25, 0.3},
    {-2.7, 2.025, -3, 2.25, 0.3},
    {-2.7, 1.8, -3, 1.8, 0.3},
    {-2.7, 1.575, -3, 1.35, 0.3},
    {-2.5, 1.125, -2.65, 0.9375, 0.3},
    {-2, 0.9, -1.9, 0.6, 0.3},
}};
constexpr std::array<Oval, 7> kSpout{{
    {1.7, 1.425, 1.7, 0.6, 0.66},
    {2.6, 1.425, 3.1, 0.825, 0.66},
    {2.3, 2.1, 2.4, 2.025, 0.25},
    {2.7, 2.4, 3.3, 2.4, 0.25},
    {2.8, 2.475, 3.525, 2.49375, 0.25},
    {2.9, 2.475, 3.45, 2.5125, 0.15},
    {2.8, 2.4, 3.2, 2.4, 0.15},
}};

/// Collects the cells of patches; equal points become one vertex.
class Teapot {
 public:
  explicit Teapot(std::uint32_t subdivisions) : cells_(subdivisions) {
    for (std::uint32_t i = 0; i <= cells_; ++i) {
      const double t = static_cast<double>(i) / cells_;
      const double s = static_cast<double>(cells_ - i) / cells_;
      weights_.push_back({s * s * s, 3 * (s * s) * t, 3 * (t * t) * s, t * t * t});
    }
  }

  /// Rows from the top down, four quarter turns.
  void add_turned(const char* name, std::span<const Ring> rings);
  /// Rows along the tube, two halves.
  void add_tube(const char* name, std::span<const Oval> ovals);
  Mesh finish();

 private:
  [[nodiscard]] Vec3 blend(std::uint32_t i, const Row& p) const;
  std::uint32_t vertex(const Vec3& v);
  void add(const Patch& patch);

  std::uint32_t cells_ = 0;
  std::vector<std::array<double, 4>> weights_;
  std::map<std::tuple<double, double, double>, std::uint32_t> numbers_;
  Mesh mesh_;
};

Vec3 Teapot::blend(std::uint32_t i, const Row& p) const {
  if (p[0] == p[1] && p[1] == p[2] && p[2] == p[3]) {
    return p[0];  // weights are rounded, and the knob must stay one point
  }
  const auto& w = weights_[i];
  return (w[0] * p[0] + w[3] * p[3]) + (w[1] * p[1] + w[2] * p[2]);  // alike from both ends
}

std::uint32_t Teapot::vertex(const Vec3& v) {
  const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
  const auto [at, inserted] = numbers_.try_emplace(std::tuple(v.x, v.y, v.z), next);
  if (inserted) {
    mesh_.vertices.push_back(v);
  }
  return at->second;
}

/// Weights at both ends are 0 and 1, so neighbors get the same points on the row or column that
/// they share.
void Teapot::add(const Patch& patch) {
  const std::size_t side = cells_ + std::size_t{1};
  std::vector<std::uint32_t> grid;
  grid.reserve(side * side);
  for (std::uint32_t i = 0; i <= cells_; ++i) {
    for (std::uint32_t j = 0; j <= cells_; ++j) {
      const Vec3 zero{};  // adding it turns -0 into 0
      grid.push_back(vertex(zero + blend(i, {blend(j, patch[0]), blend(j, patch[1]),
                                             blend(j, patch[2]), blend(j, patch[3])})));
    }
  }
  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) {
      mesh_.triangles.push_back({a, b, c});
    }
  };
  for (std::size_t i = 0; i < cells_; ++i) {
    for (std::size_t j = 0; j < cells_; ++j) {
      const std::size_t at = i * side + j;
      triangle(grid[at], grid[at + 1], grid[at + side + 1]);
      triangle(grid[at], grid[at + side + 1], grid[at + side]);
    }
  }
}

void Teapot::add_turned(const char* name, std::span<const Ring> rings) {
  const std::uint32_t part = detail::open_part(mesh_, name);
  for (std::size_t first = 0; first + 3 < rings.size(); first += 3) {
    Patch patch;
    for (std::size_t i = 0; i < 4; ++i) {
      const Ring& p = rings[first + i];
      patch[i] = {{{p.r, 0, p.z}, {p.r, -p.k, p.z}, {p.k, -p.r, p.z}, {0, -p.r, p.z}}};
    }
    for (int quarter = 0; quarter < 4; ++quarter) {
      add(patch);
      for (Row& row : patch) {
        for (Vec3& p : row) {
          p = {p.y, -p.x, p.z};
        }
      }
    }
  }
  detail::close_part(mesh_, part);
}

void Teapot::add_tube(const char* name, std::span<const Oval> ovals) {
  const std::uint32_t part = detail::open_part(mesh_, name);
  for (std::size_t first = 0; first + 3 < ovals.size(); first += 3) {
    Patch one;
    Patch two;
    for (std::size_t i = 0; i < 4; ++i) {
      const Oval& p = ovals[first + i];
      one[i] = {{{p.x0, 0, p.z0}, {p.x0, -p.y, p.z0}, {p.x1, -p.y, p.z1}, {p.x1, 0, p.z1}}};
      two[i] = {{{p.x1, 0, p.z1}, {p.x1, p.y, p.z1}, {p.x0, p.y, p.z0}, {p.x0, 0, p.z0}}};
    }
    add(one);
    add(two);
  }
  detail::close_part(mesh_, part);
}

Mesh Teapot::finish() {
  mesh_.up = UpAxis::z;
  mesh_.source = "generated teapot";
  return std::move(mesh_);
}

}  // namespace

Mesh generate_teapot(std::uint32_t subdivisions) {
  const PlainArithmetic plain;
  if (subdivisions < kLeastTeapotSubdivisions || subdivisions > kMostTeapotSubdivisions) {
    throw Error(ErrorKind::usage, "teapot of " + std::to_string(subdivisions) + " subdivisions",
                "take " + std::to_string(kLeastTeapotSubdivisions) + " to " +
                    std::to_string(kMostTeapotSubdivisions));
  }
  Teapot teapot(subdivisions);
  teapot.add_turned("rim", kRim);
  teapot.add_turned("body", kBody);
  teapot.add_turned("lid", kLid);
  teapot.add_turned("bottom", kBottom);
  teapot.add_tube("handle", kHandle);
  teapot.add_tube("spout", kSpout);
  return teapot.finish();
}

}  // namespace soms
