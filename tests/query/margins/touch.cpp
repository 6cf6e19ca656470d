#include "tests/query/margins/touch.h"

#include "tests/query/overlap_inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace soms::test {

namespace {

using Real = long double;

Shape segment(const Vec3& from, const Vec3& to) {
  Mesh mesh;
  mesh.vertices = {from, to};
  mesh.triangles = {{0, 1, 1}};
  return Shape(mesh);
}

Vec3 inside(Rng& rng, double half) {
  return {rng.uniform(-half, half), rng.uniform(-half, half), rng.uniform(-half, half)};
}

/// Half sides of a box, some shorter than `longest`.
Vec3 half_sides(Rng& rng, double longest) {
  Vec3 half{longest, longest, longest};
  for (std::size_t i = 0; i < 3; ++i) {
    half[i] *= rng.below(2) == 0 ? 1 : rng.unit();
  }
  return half;
}

/// One of the touch's numbers but the shift of y, which follows from all others.
double& number_of(Touch& touch, std::uint64_t which) {
  if (which < 12) {
    const std::array<Vec3*, 4> points{&touch.x, &touch.end_x, &touch.y, &touch.end_y};
    return (*points[which / 3])[which % 3];
  }
  if (which < 24) {
    return touch.pose_x.m[which - 12];
  }
  return touch.pose_y.m[4 * ((which - 24) / 3) + which % 3];
}

}  // namespace

Shape shape_x(const Touch& touch) {
  return segment(touch.x, touch.end_x);
}

Shape shape_y(const Touch& touch) {
  return segment(touch.y, touch.end_y);
}

bool bring_together(Touch& touch) {
  const Vec3 meet = touch.pose_x.apply(touch.x);
  touch.pose_y = moving(touch.pose_y, touch.y, meet);
  return touch.pose_y.apply(touch.y) == meet;
}

Touch random_touch(Rng& rng, double far) {
  Touch touch;
  touch.pose_x = awkward_rotation(rng);
  touch.pose_y = awkward_rotation(rng);
  const Vec3 half_x = half_sides(rng, std::exp2(-rng.uniform(0, 6)));
  const Vec3 half_y = half_sides(rng, std::exp2(-rng.uniform(0, 6)));
  const Vec3 center_x = rng.below(2) == 0 ? Vec3{} : inside(rng, std::max(far, 1.0));
  const Vec3 center_y = rng.below(2) == 0 ? Vec3{} : inside(rng, 1);
  const std::size_t axis = rng.below(3);
  const double side = rng.below(2) == 0 ? 1 : -1;
  for (std::size_t j = 0; j < 3; ++j) {
    double seen = 0;  // axis j of x along the axis of y
    for (std::size_t k = 0; k < 3; ++k) {
      seen += touch.pose_y.m[4 * k + axis] * touch.pose_x.m[4 * k + j];
    }
    const double to_x = (seen < 0 ? -side : side) * half_x[j];
    const double to_y = (j == axis ? -side : rng.below(2) == 0 ? 1 : -1) * half_y[j];
    touch.x[j] = center_x[j] + to_x;
    touch.end_x[j] = center_x[j] - to_x;
    touch.y[j] = center_y[j] + to_y;
    touch.end_y[j] = center_y[j] - to_y;
    touch.pose_x.m[4 * j + 3] = rng.below(2) == 0 ? 0 : rng.uniform(-far, far);
  }
  return touch;
}

Touch changed(Rng& rng, Touch touch) {
  for (std::uint64_t left = 1 + rng.below(3); left > 0; --left) {
    double& number = number_of(touch, rng.below(33));
    if (rng.below(3) == 0) {
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      number = std::nextafter(number, rng.below(2) == 0 ? kInfinity : -kInfinity);
    } else {
      number *= 1 + rng.uniform(-1, 1) * std::exp2(-rng.uniform(21, 52));
    }
  }
  return touch;
}

Needed needed(const Touch& touch, const Shape& x, const Shape& y,
              const detail::ReferenceFrame& frame) {
  const WideTree& tree_x = x.layout();
  const WideTree& tree_y = y.layout();
  detail::RelativePose relative(tree_x, touch.pose_x, frame);
  relative.prepare();
  const detail::PoseNumbers& numbers = relative.numbers();
  const Real slack = numbers.slack;
  std::array<Real, 3> z{};
  Needed most;
  const Vec3 half_x = tree_x.bounds().extent() * 0.5;
  const Vec3 half_y = tree_y.bounds().extent() * 0.5;
  Real gap = -std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    z[i] = Real{numbers.shift[i]} - (Real{touch.y[i]} - Real{tree_y.origin()[i]});
    double radius = 0;  // as the roots' test has it
    for (std::size_t j = 0; j < 3; ++j) {
      z[i] += Real{numbers.column[j][i]} * (Real{touch.x[j]} - Real{tree_x.origin()[j]});
      radius += std::abs(numbers.column[j][i]) * half_x[j];
    }
    most.along_y = std::max(most.along_y, static_cast<double>(2 * std::abs(z[i]) / slack));
    gap = std::max(gap, std::abs(Real{numbers.shift[i]}) - Real{radius + half_y[i]});
  }
  for (const auto& column : numbers.column) {
    const Real along = column[0] * z[0] + column[1] * z[1] + column[2] * z[2];
    most.along_x = std::max(most.along_x, static_cast<double>(std::abs(along) / slack));
  }
  most.of_roots = static_cast<double>(gap / slack);
  return most;
}

Needed needed(const Touch& touch) {
  const Shape x = shape_x(touch);
  const Shape y = shape_y(touch);
  return needed(touch, x, y, detail::ReferenceFrame(y.layout(), touch.pose_y));
}

}  // namespace soms::test
