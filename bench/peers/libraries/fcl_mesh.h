/// \file
/// Meshes and poses as FCL wants them, in float or double.
#pragma once

#include "bench/peers/libraries/fcl_headers.h"
#include "bench/peers/libraries/library.h"

namespace soms::bench {

/// Builds the model of a mesh.
template <class Volume>
void fill(fcl::BVHModel<Volume>& model, const FloatMesh& mesh) {
  std::vector<fcl::Vector3<typename Volume::S>> points;
  points.reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) {
    points.emplace_back(v[0], v[1], v[2]);
  }
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(t[0], t[1], t[2]);
  }
  model.beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size()));
  model.addSubModel(points, triangles);
  model.endModel();
}

template <class Number>
fcl::Transform3<Number> placed(const Pose& pose) {
  fcl::Transform3<Number> transform = fcl::Transform3<Number>::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      transform.linear()(i, j) = static_cast<Number>(pose.m[static_cast<std::size_t>(4 * i + j)]);
    }
    transform.translation()(i) = static_cast<Number>(pose.m[static_cast<std::size_t>(4 * i + 3)]);
  }
  return transform;
}

void add_fcl_overlap(Roster& roster);
void add_fcl_distance(Roster& roster);

}  // namespace soms::bench
