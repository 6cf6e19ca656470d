#include "bench/peers/core/bunches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace soms::bench {

namespace {

Vec3 middle(const Triangle& t) {
  return (1.0 / 3) * (t.a + t.b + t.c);
}

/// Place of a point on a curve that fills the box: the bits of its coordinates in turn.
std::uint64_t place_on_curve(const Box& box, const Vec3& p) {
  std::uint64_t place = 0;
  std::array<std::uint32_t, 3> cell{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = box.upper[k] - box.lower[k];
    cell[k] = side > 0 ? static_cast<std::uint32_t>((p[k] - box.lower[k]) / side * 1023) : 0;
  }
  for (unsigned bit = 10; bit-- > 0;) {
    for (std::size_t k = 0; k < 3; ++k) {
      place = 2 * place + ((cell[k] >> bit) & 1U);
    }
  }
  return place;
}

/// Puts the triangles in the order in which a curve meets their middles.
void order(std::vector<Triangle>& triangles) {
  Box box;
  for (const Triangle& t : triangles) {
    box.grow(middle(t));
  }
  std::vector<std::pair<std::uint64_t, std::size_t>> places;
  places.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    places.emplace_back(place_on_curve(box, middle(triangles[i])), i);
  }
  std::sort(places.begin(), places.end());
  std::vector<Triangle> ordered;
  ordered.reserve(triangles.size());
  for (const auto& [place, i] : places) {
    ordered.push_back(triangles[i]);
  }
  triangles = std::move(ordered);
}

}  // namespace

Bunches bunches_of(const FloatMesh& mesh) {
  Bunches result;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    result.triangles.push_back(mesh.triangle(i));
  }
  order(result.triangles);
  const std::size_t n = result.triangles.size();
  const auto each =
      static_cast<std::size_t>(std::max(1.0, std::ceil(std::sqrt(static_cast<double>(n)))));
  for (std::size_t first = 0; first < n; first += each) {
    result.list.push_back({{}, first, std::min(each, n - first)});
  }
  return placed(result, {});
}

Bunches placed(const Bunches& mesh, const Pose& pose) {
  Bunches result = mesh;
  for (Triangle& t : result.triangles) {
    t = {pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)};
  }
  for (Bunch& bunch : result.list) {
    bunch.box = {};
    for (std::size_t i = bunch.first; i < bunch.first + bunch.count; ++i) {
      bunch.box.grow(bounds(result.triangles[i]));
    }
  }
  return result;
}

Box bounds_of(const Bunches& mesh) {
  Box box;
  for (const Bunch& bunch : mesh.list) {
    box.grow(bunch.box);
  }
  return box;
}

double reach(const Box& box) {
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    most = std::max({most, std::abs(box.lower[k]), std::abs(box.upper[k])});
  }
  return most;
}

}  // namespace soms::bench
