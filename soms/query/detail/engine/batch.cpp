#include "soms/query/detail/engine/batch.h"

#include "soms/base/error.h"
#include "soms/query/detail/engine/pair_frame.h"

#include <string>

namespace soms::detail {

void check_poses(std::span<const Pose> poses, const Shape& shape) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    try {
      check_pose(poses[i], shape);
    } catch (const Error& error) {
      throw Error(error.kind(), "pose " + std::to_string(i) + ": " + error.place(), error.remedy());
    }
  }
}

}  // namespace soms::detail
