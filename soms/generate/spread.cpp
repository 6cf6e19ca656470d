#include "soms/generate/spread.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/generate/detail/circle.h"
#include "soms/generate/detail/counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace soms {

namespace {

constexpr double kMostRatio = 1e6;

void require(bool holds, const std::string& place, const std::string& remedy) {
  if (!holds) {
    throw Error(ErrorKind::usage, "scene of unlike triangles: " + place, remedy);
  }
}

void check(const SpreadOptions& options) {
  require(options.triangles >= 1 && options.triangles <= detail::kMostTriangles,
          fmt::format("{} triangles", options.triangles),
          fmt::format("ask for 1 to {}", detail::kMostTriangles));
  require(options.ratio >= 1 && options.ratio <= kMostRatio, fmt::format("ratio {}", options.ratio),
          "use 1 to 1000000");
  require(options.height >= 0 && options.height <= 1e6, fmt::format("height {}", options.height),
          "use 0 to 1000000");
  for (const auto& [name, value] : {std::pair{"cover", options.cover}, {"size", options.size}}) {
    require(value >= 1e-6 && value <= 1e6, fmt::format("{} {}", name, value),
            "use 0.000001 to 1000000");
  }
}

/// base^share for a share of 0 to 1, from square roots, which are the same bits everywhere.
double power(double base, double share) {
  double result = 1;
  double root = base;
  double left = share;
  for (int bit = 0; bit < 40; ++bit) {
    if (left >= 1) {
      result *= root;
      left -= 1;
    }
    root = std::sqrt(root);
    left *= 2;
  }
  return result;
}

/// Edges of all triangles relative to the shortest, in the order of the triangles.
std::vector<double> relative_edges(const SpreadOptions& options, Rng& rng) {
  std::vector<std::uint64_t> ranks(options.triangles);
  std::iota(ranks.begin(), ranks.end(), std::uint64_t{0});
  for (std::uint64_t i = options.triangles; i > 1; --i) {
    std::swap(ranks[i - 1], ranks[rng.below(i)]);
  }
  const auto last = static_cast<double>(std::max<std::uint64_t>(options.triangles - 1, 1));
  std::vector<double> edges(options.triangles);
  std::transform(ranks.begin(), ranks.end(), edges.begin(), [&](std::uint64_t rank) {
    return power(options.ratio, static_cast<double>(rank) / last);
  });
  return edges;
}

/// Appends an equilateral triangle about `center`; the direction of its plane is drawn evenly.
void add_triangle(Mesh& mesh, const Vec3& center, double edge, Rng& rng) {
  const double z = rng.uniform(-1, 1);
  const double flat = std::sqrt(1 - z * z);
  const auto [cosine, sine] = detail::on_circle(rng.unit());
  const double turn = rng.unit();
  // Two directions at right angles to (flat * cosine, flat * sine, z).
  const Vec3 u{-sine, cosine, 0};
  const Vec3 v{-z * cosine, -z * sine, flat};
  const double radius = edge / std::sqrt(3.0);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int corner = 0; corner < 3; ++corner) {
    const auto at = detail::on_circle(turn + corner / 3.0);
    mesh.vertices.push_back(center + radius * at.cosine * u + radius * at.sine * v);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
}

}  // namespace

Mesh generate_spread(const SpreadOptions& options) {
  const PlainArithmetic plain;
  check(options);
  Rng rng(options.seed);
  const std::vector<double> edges = relative_edges(options, rng);
  double squares = 0;
  for (const double edge : edges) {
    squares += edge * edge;
  }
  const double area = options.cover * options.size * options.size;
  const double shortest = std::sqrt(area / (0.25 * std::sqrt(3.0) * squares));
  Mesh mesh;
  mesh.source = "generated scene of unlike triangles";
  mesh.vertices.reserve(3 * edges.size());
  mesh.triangles.reserve(edges.size());
  for (const double edge : edges) {
    const Vec3 center{rng.uniform(0, options.size), rng.uniform(0, options.size),
                      rng.uniform(0, options.height)};
    add_triangle(mesh, center, shortest * edge, rng);
  }
  return mesh;
}

}  // namespace soms
