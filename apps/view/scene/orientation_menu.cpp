#include "apps/view/scene/orientation_menu.h"

#include "soms/base/error.h"
#include "soms/thesis/thesis_frames.h"

#include <algorithm>
#include <array>
#include <string>

namespace soms::view {

namespace {

constexpr std::string_view kDrive = "drive";

constexpr std::array<OrientationTest, 7> kTests{
    {{"right", "Right", "comes from the right (+x) and ends half inside"},
     {"left", "Left", "comes from the left (-x) and ends half inside"},
     {"top", "Top", "comes from above and ends half inside"},
     {"bottom", "Bottom", "comes from below and ends half inside"},
     {"front", "Front", "comes from the front and ends half inside"},
     {"back", "Back", "comes from the back and ends half inside"},
     {kDrive, "Drive", "drives through the middle along x, partly below the ground"}}};

Pose shift_by(const Vec3& by) {
  return Pose::translation(by.x, by.y, by.z);
}

std::vector<Pose> drive(const Box& still, const Box& moving, const Vec3& to_middle,
                        std::size_t up) {
  constexpr std::size_t kFrames = 221;
  const Vec3 extent = still.extent();
  const std::size_t side = 3 - up;
  // The thesis' way: 5 % of the scene's length before it and behind it; more for a long object.
  const double margin = std::max(0.05 * extent.x, moving.extent().x);
  std::vector<Pose> poses;
  for (std::size_t k = 0; k < kFrames; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(kFrames - 1);
    Vec3 by;
    by[0] = still.lower.x - margin + share * (extent.x + 2 * margin) - moving.center().x;
    by[side] = to_middle[side];
    by[up] = still.lower[up] - 0.01 * extent[up] - moving.lower[up];
    poses.push_back(shift_by(by));
  }
  return poses;
}

}  // namespace

std::span<const OrientationTest> orientation_tests() {
  return kTests;
}

std::vector<Pose> orientation_poses(std::string_view name, const Box& still, const Box& moving,
                                    std::size_t up) {
  const Vec3 to_middle = still.center() - moving.center();
  if (name == kDrive) {
    return drive(still, moving, to_middle, up);
  }
  std::string names;
  for (const auto& [approach, approach_name] : kAllApproaches) {
    if (approach_name == name) {
      std::vector<Pose> poses;
      for (const Vec3& offset : orientation_test(still, approach, up)) {
        poses.push_back(shift_by(to_middle + offset));
      }
      return poses;
    }
    names += std::string(approach_name) + ", ";
  }
  throw Error(ErrorKind::usage, "no orientation test \"" + std::string(name) + "\"",
              "name one of " + names + std::string(kDrive));
}

}  // namespace soms::view
