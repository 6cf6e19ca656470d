#include "soms/tree/layout/detail/block.h"

namespace soms::layout {

namespace {

constexpr std::size_t kLanes = TriangleBlock::kWidth;

// Loops over a row become vector instructions; sums over one do not, as their order counts.
using Row = std::array<double, kLanes>;
/// Row 3 * corner + axis.
using Rows = std::array<Row, 9>;

double least(Row v) {
  for (std::size_t half = kLanes / 2; half > 0; half /= 2) {
    for (std::size_t k = 0; k < half; ++k) {
      v[k] = v[k + half] < v[k] ? v[k + half] : v[k];
    }
  }
  return v[0];
}

double greatest(Row v) {
  for (std::size_t half = kLanes / 2; half > 0; half /= 2) {
    for (std::size_t k = 0; k < half; ++k) {
      v[k] = v[k + half] > v[k] ? v[k + half] : v[k];
    }
  }
  return v[0];
}

struct Range {
  double lower;
  double upper;
};

/// Least and greatest of three rows, and with them of all corners.
Range range(const Row& a, const Row& b, const Row& c) {
  Row lower = a;
  Row upper = a;
  for (const Row* row : {&b, &c}) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      lower[k] = (*row)[k] < lower[k] ? (*row)[k] : lower[k];
      upper[k] = (*row)[k] > upper[k] ? (*row)[k] : upper[k];
    }
  }
  return {least(lower), greatest(upper)};
}

/// Corners about the tree's origin; lanes not in use repeat the last triangle.
void gather(const Mesh& mesh, std::span<const TriangleId> ids, const Vec3& origin, Rows& rows,
            TriangleBlock& block) {
  for (std::size_t k = 0; k < kLanes; ++k) {
    const TriangleId id = ids[std::min(k, ids.size() - 1)];
    block.id[k] = id;
    const auto& corners = mesh.triangles[id];
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& v = mesh.vertices[corners[c]];
      rows[3 * c][k] = v.x - origin.x;
      rows[3 * c + 1][k] = v.y - origin.y;
      rows[3 * c + 2][k] = v.z - origin.z;
    }
  }
}

/// Puts the block's origin in the middle and takes corners about it, in units of the layout;
/// returns the farthest on each axis.
std::array<double, 3> center(const Frame& frame, Rows& rows, TriangleBlock& block) {
  std::array<double, 3> far = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lower, upper] = range(rows[axis], rows[3 + axis], rows[6 + axis]);
    const double middle = 0.5 * (lower + upper);
    block.origin[axis] = middle;
    far[axis] = std::max(upper - middle, middle - lower) * frame.scale;
    for (std::size_t row = axis; row < 9; row += 3) {
      for (std::size_t k = 0; k < kLanes; ++k) {
        rows[row][k] = (rows[row][k] - middle) * frame.scale;
        block.corner[row][k] = static_cast<float>(rows[row][k]);
      }
    }
  }
  return far;
}

/// Sum of the lanes in use.
double sum(Row v, std::size_t count) {
  for (std::size_t k = count; k < kLanes; ++k) {
    v[k] = 0;
  }
  for (std::size_t half = kLanes / 2; half > 0; half /= 2) {
    for (std::size_t k = 0; k < half; ++k) {
      v[k] += v[k + half];
    }
  }
  return v[0];
}

Moments moments_of(const Rows& rows, std::size_t count) {
  Moments m;
  m.points = static_cast<double>(3 * count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3;
    Row first;
    Row square;
    Row product;
    Row normal;
    for (std::size_t k = 0; k < kLanes; ++k) {
      const double a = rows[axis][k];
      const double b = rows[3 + axis][k];
      const double c = rows[6 + axis][k];
      const double p = rows[next][k];
      const double q = rows[3 + next][k];
      const double r = rows[6 + next][k];
      first[k] = (a + b) + c;
      square[k] = (a * a + b * b) + c * c;
      product[k] = (a * p + b * q) + c * r;
      normal[k] = (b - a) * (r - p) - (q - p) * (c - a);
    }
    m.sum[axis] = sum(first, count);
    m.square[axis] = sum(square, count);
    m.product[axis] = sum(product, count);
    m.normal[(axis + 2) % 3] = sum(normal, count);
    for (double& x : normal) {
      x = std::abs(x);
    }
    m.area += sum(normal, count);
  }
  return m;
}

/// Mean normal of the triangles, and the interval of the corners on it. Coordinates are in doubt by
/// `give`, which is more than the products with the normal, of 1-norm below 1.74, can add.
void store_slab(const std::array<double, 3>& sum, const Rows& rows, double give,
                TriangleBlock& block) {
  // Divided by its largest entry first, so that no square underflows.
  const double most = std::max({std::abs(sum[0]), std::abs(sum[1]), std::abs(sum[2])});
  const Vec3 n = most > 0 ? Vec3{sum[0] / most, sum[1] / most, sum[2] / most} : Vec3{0, 0, 1};
  const double length = std::sqrt(dot(n, n));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.normal[axis] = static_cast<float>(n[axis] / length);
  }
  const Vec3 rounded{block.normal[0], block.normal[1], block.normal[2]};
  std::array<Row, 3> height;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      height[c][k] = (rounded.x * rows[3 * c][k] + rounded.y * rows[3 * c + 1][k]) +
                     rounded.z * rows[3 * c + 2][k];
    }
  }
  const auto [lower, upper] = range(height[0], height[1], height[2]);
  block.lower = -rounded_up(3 * give - lower);
  block.upper = rounded_up(3 * give + upper);
}

}  // namespace

Moments make_block(const Mesh& mesh, std::span<const TriangleId> ids, const Frame& frame,
                   TriangleBlock& block) {
  Rows rows;
  gather(mesh, ids, frame.origin, rows, block);
  const std::array<double, 3> far = center(frame, rows, block);
  const Moments moments = moments_of(rows, ids.size());
  block.count = static_cast<std::uint32_t>(ids.size()) & 0xf;
  const double give = frame.doubt((far[0] + far[1]) + far[2], false);
  double reach = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.own_half[axis] = rounded_up(far[axis] + give);
    reach += static_cast<double>(block.own_half[axis]);
  }
  block.reach = rounded_up(reach * (1 + 0x1p-50));  // the sum of three had two roundings
  store_slab(moments.normal, rows, give, block);
  return moments;
}

}  // namespace soms::layout
