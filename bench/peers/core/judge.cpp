#include "bench/peers/core/judge.h"

#include "soms/query/reference/overlap.h"

#include "bench/peers/scenarios/solids.h"

#include <algorithm>

namespace soms::bench {

namespace {

Mesh widened(const FloatMesh& mesh) {
  Mesh result;
  for (const auto& v : mesh.vertices) {
    result.vertices.push_back(wide(v));
  }
  result.triangles = mesh.triangles;
  return result;
}

/// The triangles whose boxes meet `region`: all that could touch what lies in it.
Mesh within(const Mesh& mesh, const Box& region) {
  Mesh result;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    if (overlaps(bounds(t), region)) {
      const auto first = static_cast<std::uint32_t>(result.vertices.size());
      result.vertices.insert(result.vertices.end(), {t.a, t.b, t.c});
      result.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return result;
}

bool touches(const Mesh& mover, const Pose& pose, const Mesh& fixed) {
  Mesh moved = mover;
  Box region;
  for (Vec3& v : moved.vertices) {
    v = pose.apply(v);
    region.grow(v);
  }
  return reference::overlap(moved, {}, within(fixed, region), {}).any;
}

}  // namespace

std::vector<Verdict> judge(const FloatMesh& mover, const FloatMesh& fixed,
                           std::span<const Pose> poses,
                           std::span<const std::vector<std::uint8_t>> answers, double budget) {
  const Mesh moving = widened(mover);
  const Mesh still = widened(fixed);
  // Bodies of like size share much of their boxes; a small mover meets little of a large scene.
  const auto m = static_cast<double>(moving.triangles.size());
  const auto n = static_cast<double>(still.triangles.size());
  const double each = n > 4 * m ? 20 * n : m * n;
  const auto most = static_cast<std::size_t>(std::max(1.0, budget / each));
  const std::size_t stride = std::max<std::size_t>(1, poses.size() / most);
  std::vector<Verdict> verdicts(answers.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const bool differ = std::any_of(answers.begin(), answers.end(),
                                    [&](const auto& a) { return a[i] != answers[0][i]; });
    if (!differ && i % stride != 0) {
      continue;
    }
    const std::uint8_t truth = touches(moving, poses[i], still) ? 1 : 0;
    for (std::size_t k = 0; k < answers.size(); ++k) {
      ++verdicts[k].checked;
      if (answers[k][i] != truth) {
        ++verdicts[k].wrong;
        verdicts[k].wrong_poses.push_back(i);
      }
    }
  }
  return verdicts;
}

}  // namespace soms::bench
