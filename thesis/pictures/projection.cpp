#include "thesis/pictures/projection.h"

#include "apps/draw/depth_grid.h"

#include <algorithm>
#include <cmath>

namespace soms::reproduce {

namespace {

/// Samples a pixel in each direction.
constexpr double kSampling = 2;

Vec3 unit(const Vec3& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 ? v * (1 / length) : v;
}

double square_between(const Vec3& a, const Vec3& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

}  // namespace

look::CameraFrame frame_of(const View& view) {
  return look::frame_along(unit(view.toward), unit(view.up));
}

bool is_flat(const look::CameraFrame& frame) {
  const Vec3& v = frame.forward;
  return (v.x != 0 ? 1 : 0) + (v.y != 0 ? 1 : 0) + (v.z != 0 ? 1 : 0) == 1;
}

View axonometric(UpAxis up) {
  if (up == UpAxis::y) {
    return {{-0.55, -0.45, -1}, {0, 1, 0}};
  }
  return {{-0.55, 1, -0.75}, {0, 0, 1}};
}

View flat_view() {
  return {{0, 0, -1}, {0, 1, 0}};
}

std::array<Vec3, 8> corners(const Box& box) {
  std::array<Vec3, 8> all;
  for (std::size_t k = 0; k < 8; ++k) {
    all[k] = {(k & 1U) != 0 ? box.upper.x : box.lower.x, (k & 2U) != 0 ? box.upper.y : box.lower.y,
              (k & 4U) != 0 ? box.upper.z : box.lower.z};
  }
  return all;
}

std::size_t far_corner(const std::array<Vec3, 8>& corners, const look::CameraFrame& from) {
  const auto nearer = [&](const Vec3& a, const Vec3& b) {
    return dot(a, from.forward) < dot(b, from.forward);
  };
  return static_cast<std::size_t>(std::max_element(corners.begin(), corners.end(), nearer) -
                                  corners.begin());
}

BoxEdges edges_of(const std::array<Spot, 8>& spots, std::size_t far) {
  BoxEdges edges;
  for (std::size_t k = 0; k < spots.size(); ++k) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if ((k & bit) == 0) {
        PathData& path = k == far || (k | bit) == far ? edges.hidden : edges.front;
        path.move(spots[k]).line(spots[k | bit]);
      }
    }
  }
  return edges;
}

void PageBounds::take(const Vec3& seen) {
  left = std::min(left, seen.x);
  top = std::min(top, seen.y);
  right = std::max(right, seen.x);
  bottom = std::max(bottom, seen.y);
}

void PageBounds::take(const look::CameraFrame& from, const Box& box) {
  for (const Vec3& corner : corners(box)) {
    take(from.on_page(corner));
  }
}

double Facet::farthest() const {
  return std::max({corners[0].z, corners[1].z, corners[2].z});
}

void keep_visible(std::vector<Facet>& facets, double width, double height) {
  std::stable_sort(facets.begin(), facets.end(),
                   [](const Facet& a, const Facet& b) { return a.farthest() > b.farthest(); });
  const auto samples = [](double pixels) {
    return static_cast<std::size_t>(std::max(1.0, pixels * kSampling));
  };
  look::DepthGrid grid({.cell = 1 / kSampling, .columns = samples(width), .rows = samples(height)});
  for (std::size_t k = 0; k < facets.size(); ++k) {
    const auto& [a, b, c] = facets[k].corners;
    grid.draw(a, b, c, static_cast<std::uint32_t>(k));
  }
  for (const std::uint32_t number : grid.shown()) {
    if (number != look::DepthGrid::kNothing) {
      ++facets[number].samples;
    }
  }
  std::erase_if(facets, [](const Facet& facet) { return facet.samples == 0; });
}

void cut_long(std::vector<Facet>& facets, double pixels) {
  for (std::size_t k = 0; k < facets.size(); ++k) {
    for (;;) {
      std::size_t side = 0;
      double longest = 0;
      for (std::size_t s = 0; s < 3; ++s) {
        const double size = square_between(facets[k].corners[s], facets[k].corners[(s + 1) % 3]);
        if (size > longest) {
          longest = size;
          side = s;
        }
      }
      if (!(longest > pixels * pixels)) {
        break;
      }
      facets[k].whole = false;
      Facet half = facets[k];
      const Vec3 cut = 0.5 * (half.corners[side] + half.corners[(side + 1) % 3]);
      facets[k].corners[(side + 1) % 3] = cut;
      half.corners[side] = cut;
      facets.push_back(half);
    }
  }
}

}  // namespace soms::reproduce
