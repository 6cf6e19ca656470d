/// \file
/// Meshes, poses and boxes as Bullet wants them.
#pragma once

#include "bench/peers/libraries/library.h"

#include <btBulletCollisionCommon.h>

#include <algorithm>

namespace soms::bench {

/// A mesh that Bullet shares, in parts of a million triangles: a quantized node counts no more than
/// 2^21 in one part.
class BulletMesh {
 public:
  static constexpr std::size_t kPart = 1'000'000;

  explicit BulletMesh(const FloatMesh& mesh) : mesh_(mesh) {
    for (std::size_t first = 0; first < mesh_.triangles.size(); first += kPart) {
      btIndexedMesh part;
      part.m_numTriangles = static_cast<int>(std::min(kPart, mesh_.triangles.size() - first));
      part.m_triangleIndexBase =
          reinterpret_cast<const unsigned char*>(mesh_.triangles.data() + first);
      part.m_triangleIndexStride = sizeof mesh_.triangles[0];
      part.m_numVertices = static_cast<int>(mesh_.vertices.size());
      part.m_vertexBase = reinterpret_cast<const unsigned char*>(mesh_.vertices.data());
      part.m_vertexStride = sizeof mesh_.vertices[0];
      part.m_vertexType = PHY_FLOAT;
      arrays_.addIndexedMesh(part, PHY_INTEGER);
    }
  }

  BulletMesh(const BulletMesh&) = delete;
  BulletMesh& operator=(const BulletMesh&) = delete;

  [[nodiscard]] btStridingMeshInterface* arrays() { return &arrays_; }

  [[nodiscard]] Triangle triangle(int part, int index) const {
    return mesh_.triangle(static_cast<std::size_t>(part) * kPart + static_cast<std::size_t>(index));
  }

 private:
  FloatMesh mesh_;
  btTriangleIndexVertexArray arrays_;
};

inline btVector3 to_bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

inline btVector3 to_bullet(const std::array<float, 3>& v) {
  return {v[0], v[1], v[2]};
}

inline btTransform to_bullet(const Pose& pose) {
  const auto f = [&](std::size_t i) { return static_cast<btScalar>(pose.m[i]); };
  return btTransform(btMatrix3x3(f(0), f(1), f(2), f(4), f(5), f(6), f(8), f(9), f(10)),
                     btVector3(f(3), f(7), f(11)));
}

inline std::string bullet_version() {
  return std::to_string(BT_BULLET_VERSION / 100) + "." + std::to_string(BT_BULLET_VERSION % 100);
}

void add_bullet_tree(Roster& roster, const Loan& loan);
void add_bullet_gimpact(Roster& roster, const Loan& loan);
void add_bullet_moving_boxes(Roster& roster);

}  // namespace soms::bench
