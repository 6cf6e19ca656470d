#include "soms/query/detail/engine/batch.h"

#include "soms/base/error.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/kernels/instruction_set.h"

#include <string>

namespace soms::detail {

void check_poses(std::span<const Pose> poses, const Shape& shape) {
  const Vec3 far = farthest(shape.bounds());
  const Kernels& tests = kernels();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    i += tests.passing_poses(&poses[i], poses.size() - i, far);
    if (i == poses.size()) {
      return;
    }
    try {
      check_pose(poses[i], shape);
    } catch (const Error& error) {
      throw Error(error.kind(), "pose " + std::to_string(i) + ": " + error.place(), error.remedy());
    }
  }
}

}  // namespace soms::detail
