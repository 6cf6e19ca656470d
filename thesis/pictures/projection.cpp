#include "thesis/pictures/projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms::reproduce {

namespace {

/// Samples a pixel in each direction.
constexpr double kSampling = 2;
constexpr double kAmbient = 0.42;
constexpr std::uint32_t kNoTriangle = 0xffffffffU;

Vec3 unit(const Vec3& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 ? v * (1 / length) : v;
}

/// The nearest facet of each sample.
class SampleGrid {
 public:
  SampleGrid(double width, double height)
      : columns_(std::max(1, static_cast<int>(width * kSampling))),
        rows_(std::max(1, static_cast<int>(height * kSampling))),
        nearest_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kNoTriangle),
        depth_(nearest_.size(), std::numeric_limits<double>::infinity()) {}

  void add(const Facet& facet, std::uint32_t number) {
    const auto& [a, b, c] = facet.corners;
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0) {
      return;
    }
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    for (int row = first(top); row <= last(bottom, rows_); ++row) {
      for (int column = first(left); column <= last(right, columns_); ++column) {
        const double x = (column + 0.5) / kSampling;
        const double y = (row + 0.5) / kSampling;
        const double u = ((b.x - x) * (c.y - y) - (b.y - y) * (c.x - x)) / area;
        const double v = ((c.x - x) * (a.y - y) - (c.y - y) * (a.x - x)) / area;
        const double w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0) {
          continue;
        }
        const double depth = u * a.depth + v * b.depth + w * c.depth;
        const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                        static_cast<std::size_t>(column);
        // Of what lies in one plane the later wins, as it does in painter's order.
        if (depth <= depth_[at]) {
          depth_[at] = depth;
          nearest_[at] = number;
        }
      }
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> nearest() const { return nearest_; }

 private:
  [[nodiscard]] static int first(double begin) {
    return std::max(0, static_cast<int>(std::floor(begin * kSampling - 0.5)));
  }

  [[nodiscard]] static int last(double end, int count) {
    return std::min(count - 1, static_cast<int>(std::ceil(end * kSampling - 0.5)));
  }

  int columns_;
  int rows_;
  std::vector<std::uint32_t> nearest_;
  std::vector<double> depth_;
};

Seen middle(const Seen& a, const Seen& b) {
  return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.depth + b.depth)};
}

double length(const Seen& a, const Seen& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

}  // namespace

Projection::Projection(const View& view) : toward_(unit(view.toward)) {
  right_ = unit(cross(toward_, view.up));
  down_ = cross(toward_, right_);
  light_ = unit(-0.55 * toward_ - 0.75 * down_ - 0.45 * right_);
  const auto axes = (toward_.x != 0 ? 1 : 0) + (toward_.y != 0 ? 1 : 0) + (toward_.z != 0 ? 1 : 0);
  flat_ = axes == 1;
}

Seen Projection::see(const Vec3& point) const {
  return {dot(point, right_), dot(point, down_), dot(point, toward_)};
}

double Projection::brightness(const Triangle& triangle) const {
  Vec3 normal = unit(cross(triangle.b - triangle.a, triangle.c - triangle.a));
  if (dot(normal, toward_) > 0) {
    normal = -normal;
  }
  return kAmbient + (1 - kAmbient) * std::max(0.0, dot(normal, light_));
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

double Facet::farthest() const {
  return std::max({corners[0].depth, corners[1].depth, corners[2].depth});
}

void keep_visible(std::vector<Facet>& facets, double width, double height) {
  std::stable_sort(facets.begin(), facets.end(),
                   [](const Facet& a, const Facet& b) { return a.farthest() > b.farthest(); });
  SampleGrid grid(width, height);
  for (std::size_t k = 0; k < facets.size(); ++k) {
    grid.add(facets[k], static_cast<std::uint32_t>(k));
  }
  for (const std::uint32_t number : grid.nearest()) {
    if (number != kNoTriangle) {
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
        const double size = length(facets[k].corners[s], facets[k].corners[(s + 1) % 3]);
        if (size > longest) {
          longest = size;
          side = s;
        }
      }
      if (!(longest > pixels)) {
        break;
      }
      facets[k].whole = false;
      Facet half = facets[k];
      const Seen cut = middle(half.corners[side], half.corners[(side + 1) % 3]);
      facets[k].corners[(side + 1) % 3] = cut;
      half.corners[side] = cut;
      facets.push_back(half);
    }
  }
}

}  // namespace soms::reproduce
