#include "tests/scene/random_bodies.h"

#include <cmath>
#include <cstdint>

namespace soms::test {

Mesh random_mesh(Rng& rng) {
  Mesh mesh;
  const std::uint64_t count = 1 + rng.below(20);
  const auto coordinate = [&] { return static_cast<double>(rng.below(7)) - 3; };
  for (std::uint32_t k = 0; k < count; ++k) {
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back({coordinate(), coordinate(), coordinate()});
    }
    mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  return mesh;
}

Mesh box_mesh(const Box& box) {
  Mesh mesh;
  for (std::uint32_t k = 0; k < 8; ++k) {
    mesh.vertices.push_back({(k & 1U) != 0 ? box.upper.x : box.lower.x,
                             (k & 2U) != 0 ? box.upper.y : box.lower.y,
                             (k & 4U) != 0 ? box.upper.z : box.lower.z});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

Pose random_pose(Rng& rng, double reach) {
  const Vec3 shift{std::floor(rng.uniform(-reach, reach)), std::floor(rng.uniform(-reach, reach)),
                   std::floor(rng.uniform(-reach, reach))};
  if (rng.below(2) == 0) {
    return Pose::translation(shift.x, shift.y, shift.z);
  }
  double q[4];
  double square = 0;
  for (double& component : q) {
    component = rng.uniform(-1, 1);
    square += component * component;
  }
  const double length = std::sqrt(square);
  return Pose::from_quaternion(q[0] / length, q[1] / length, q[2] / length, q[3] / length, shift);
}

std::vector<Box> random_boxes(Rng& rng) {
  const std::uint64_t kind = rng.below(8);
  const std::uint64_t count = rng.below(300);
  std::vector<Box> boxes;
  for (std::uint64_t k = 0; k < count; ++k) {
    Vec3 at{rng.uniform(0, 30), rng.uniform(0, 30), rng.uniform(0, 30)};
    Vec3 size{rng.uniform(0, 4), rng.uniform(0, 4), rng.uniform(0, 4)};
    if (kind == 1) {
      at.z = 0;
    } else if (kind == 2) {
      at.y = at.z = 0;
    } else if (kind == 3) {
      size = size * std::pow(10.0, rng.uniform(-2, 1));
    } else if (kind == 4) {
      at = {std::floor(at.x), std::floor(at.y), std::floor(at.z)};
      size = {0, 0, 0};
    } else if (kind == 5) {
      at = {7, 7, 7};
      size = {1, 1, 1};
    } else if (kind == 6) {
      at = at + Vec3{0x1p299, -0x1p299, 4e6};
    }
    Box box;
    if (kind != 7 || rng.below(3) != 0) {
      box.grow(at);
      box.grow(at + size);
    }
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace soms::test
