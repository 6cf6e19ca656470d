#include "soms/generate/detail/pavement.h"

#include "soms/generate/detail/ground.h"
#include "soms/generate/detail/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace soms::detail {

namespace {

constexpr double kKerbLine = 7.3;    ///< from the street's center line to its kerb
constexpr double kFoundation = 0.2;  ///< how far sidewalks reach below the street
constexpr double kPaint = 0.01;      ///< height of marks above the street
constexpr double kDash = 3;          ///< length of a dash, and of the gap after it
constexpr double kDashWidth = 0.18;
constexpr double kZebraFrom = 1;  ///< from the crossing's square to its zebra, and its end
constexpr double kZebraTo = 4;
constexpr std::uint64_t kZebraStripes = 12;  ///< half a meter wide, a meter apart
constexpr std::uint64_t kMostShare = 10;
constexpr std::uint64_t kRingTriangles = 64;

std::uint64_t blocks_of(const City& city) {
  return city.street_lines.size() - 1;
}

/// Dashes between two crossings, clear of both zebras.
std::uint64_t dashes_of(const City& city) {
  const double free = city.street_spacing - city.street_width - 2 * kZebraTo - 2;
  return static_cast<std::uint64_t>(std::max(0.0, free / (2 * kDash)));
}

std::uint64_t ring_triangles(const City& city) {
  return kRingTriangles * blocks_of(city) * blocks_of(city);
}

std::uint64_t mark_triangles(const City& city) {
  const std::uint64_t stretches = 2 * blocks_of(city) * (blocks_of(city) + 1);
  return 2 * stretches * (dashes_of(city) + 2 * kZebraStripes);
}

/// Whether there are triangles for `cost`, as long as the streets are paved at all.
bool affords(const City& city, std::uint64_t cost) {
  return city.options.streets == CityStreets::paved && kMostShare * cost <= city.options.triangles;
}

bool has_marks(const City& city) {
  return affords(city, ring_triangles(city) + mark_triangles(city));
}

/// The side of a block's sidewalk: from the kerb to the block, at either end of the block.
struct Border {
  std::array<double, 4> at;  ///< kerb, block, block, kerb
};

Border border_of(const City& city, std::size_t line) {
  const double half = 0.5 * city.street_width;
  const double low = city.street_lines[line];
  const double high = city.street_lines[line + 1];
  return {{low + kKerbLine, low + half, high - half, high - kKerbLine}};
}

/// A closed ring about block (i, j), level at the crossings. Its points lie on a grid of 4 by 4,
/// first those of the top, then those of the underside.
void add_ring_about(City& city, std::size_t i, std::size_t j) {
  Mesh& mesh = city.mesh;
  const Border x = border_of(city, i);
  const Border y = border_of(city, j);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const double shift : {kKerb, -kFoundation}) {
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t u = 0; u < 4; ++u) {
        const double z = crossing_height(city, i + u / 2, j + v / 2) + shift;
        mesh.vertices.push_back({x.at[u], y.at[v], z});
      }
    }
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({first + a, first + b, first + c});
    mesh.triangles.push_back({first + a, first + c, first + d});
  };
  for (std::uint32_t v = 0; v < 3; ++v) {
    for (std::uint32_t u = 0; u < 3; ++u) {
      if (u != 1 || v != 1) {
        const std::uint32_t a = 4 * v + u;
        quad(a, a + 1, a + 5, a + 4);
        quad(a + 16, a + 20, a + 21, a + 17);
      }
    }
  }
  for (std::uint32_t k = 0; k < 3; ++k) {  // kerbs
    quad(k + 16, k + 17, k + 1, k);
    quad(12 + k, 13 + k, 29 + k, 28 + k);
    quad(4 * k, 4 * k + 4, 4 * k + 20, 4 * k + 16);
    quad(4 * k + 19, 4 * k + 23, 4 * k + 7, 4 * k + 3);
  }
  quad(5, 6, 22, 21);  // toward the block
  quad(25, 26, 10, 9);
  quad(21, 25, 9, 5);
  quad(6, 10, 26, 22);
}

/// The street between crossing (i, j) and the next one in x, or in y if `northward`.
struct Stretch {
  const City& city;
  std::size_t i;
  std::size_t j;
  bool northward;

  [[nodiscard]] double length() const { return city.street_spacing - city.street_width; }

  /// A place `along` meters from the first crossing's square, `across` to the left of the middle.
  [[nodiscard]] Vec3 at(double along, double across) const {
    const double here = crossing_height(city, i, j);
    const double there = crossing_height(city, northward ? i : i + 1, northward ? j + 1 : j);
    const double z = here + (there - here) * (along / length()) + kPaint;
    const double begin = 0.5 * city.street_width + along;
    const Vec3 corner{city.street_lines[i], city.street_lines[j], z};
    return corner + (northward ? Vec3{-across, begin, 0} : Vec3{begin, across, 0});
  }
};

void add_mark(Mesh& mesh, const Stretch& street, double from, double to, double right,
              double left) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(street.at(from, right));
  mesh.vertices.push_back(street.at(to, right));
  mesh.vertices.push_back(street.at(to, left));
  mesh.vertices.push_back(street.at(from, left));
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

void add_marks(City& city, const Stretch& street) {
  const std::uint64_t dashes = dashes_of(city);
  const double begin = 0.5 * (street.length() - kDash * static_cast<double>(2 * dashes) + kDash);
  for (std::uint64_t k = 0; k < dashes; ++k) {
    const double from = begin + 2 * kDash * static_cast<double>(k);
    add_mark(city.mesh, street, from, from + kDash, -0.5 * kDashWidth, 0.5 * kDashWidth);
  }
  for (std::uint64_t k = 0; k < kZebraStripes; ++k) {
    const double right = static_cast<double>(k) - 0.5 * kZebraStripes + 0.25;
    const double far = street.length();
    add_mark(city.mesh, street, kZebraFrom, kZebraTo, right, right + 0.5);
    add_mark(city.mesh, street, far - kZebraTo, far - kZebraFrom, right, right + 0.5);
  }
}

}  // namespace

bool on_sidewalk(const City& city, double x, double y) {
  const auto is_outside = [&](double c) {
    return c < city.street_lines.front() || c > city.street_lines.back();
  };
  if (!affords(city, ring_triangles(city)) || is_outside(x) || is_outside(y)) {
    return false;
  }
  const auto from_line = [&](double c) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const double line : city.street_lines) {
      nearest = std::min(nearest, std::abs(c - line));
    }
    return nearest;
  };
  const double nearer = std::min(from_line(x), from_line(y));
  return nearer >= kKerbLine && nearer <= 0.5 * city.street_width;
}

std::uint64_t pavement_triangles(const City& city) {
  return (affords(city, ring_triangles(city)) ? ring_triangles(city) : 0) +
         (has_marks(city) ? mark_triangles(city) : 0);
}

void add_pavement(City& city) {
  const std::size_t blocks = blocks_of(city);
  if (affords(city, ring_triangles(city))) {
    const std::uint32_t part = open_part(city.mesh, "sidewalks");
    for (std::size_t j = 0; j < blocks; ++j) {
      for (std::size_t i = 0; i < blocks; ++i) {
        add_ring_about(city, i, j);
      }
    }
    close_part(city.mesh, part);
  }
  if (has_marks(city)) {
    const std::uint32_t part = open_part(city.mesh, "lane marks");
    for (std::size_t j = 0; j <= blocks; ++j) {
      for (std::size_t i = 0; i <= blocks; ++i) {
        if (i < blocks) {
          add_marks(city, {city, i, j, false});
        }
        if (j < blocks) {
          add_marks(city, {city, i, j, true});
        }
      }
    }
    close_part(city.mesh, part);
  }
}

}  // namespace soms::detail
