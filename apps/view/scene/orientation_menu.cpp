#include "apps/view/scene/orientation_menu.h"

#include "soms/base/error.h"
#include "soms/thesis/thesis_frames.h"

#include <algorithm>
#include <array>
#include <string>

namespace soms::view {

namespace {

constexpr std::string_view kDrive = "drive";
constexpr std::size_t kApproachFrames = 49;
constexpr std::size_t kDriveFrames = 221;

constexpr std::array<OrientationTest, 7> kTests{
    {{"right", "Right", "comes from the right (+x) and ends half inside"},
     {"left", "Left", "comes from the left (-x) and ends half inside"},
     {"top", "Top", "comes from above and ends half inside"},
     {"bottom", "Bottom", "comes from below and ends half inside"},
     {"front", "Front", "comes from the front and ends half inside"},
     {"back", "Back", "comes from the back and ends half inside"},
     {kDrive, "Drive", "drives through the middle along x, partly below the ground"}}};

[[noreturn]] void refuse(std::string_view name) {
  std::string names;
  for (const OrientationTest& test : kTests) {
    names += (names.empty() ? "" : ", ") + std::string(test.name);
  }
  throw Error(ErrorKind::usage, "no orientation test \"" + std::string(name) + "\"",
              "name one of " + names);
}

Pose shift_by(const Vec3& by) {
  return Pose::translation(by.x, by.y, by.z);
}

std::vector<Pose> drive(const Box& still, const Box& moving, const Vec3& to_middle,
                        std::size_t up) {
  const Vec3 extent = still.extent();
  const std::size_t side = 3 - up;
  // The thesis' way: 5 % of the scene's length before it and behind it; more for a long object.
  const double margin = std::max(0.05 * extent.x, moving.extent().x);
  std::vector<Pose> poses;
  for (std::size_t k = 0; k < kDriveFrames; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(kDriveFrames - 1);
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
  for (const auto& [approach, approach_name] : kAllApproaches) {
    if (approach_name == name) {
      std::vector<Pose> poses;
      for (const Vec3& offset : orientation_test(still, approach, up)) {
        poses.push_back(shift_by(to_middle + offset));
      }
      return poses;
    }
  }
  refuse(name);
}

std::size_t orientation_row(std::string_view name) {
  const auto* const found =
      std::find_if(kTests.begin(), kTests.end(),
                   [name](const OrientationTest& test) { return test.name == name; });
  if (found == kTests.end()) {
    refuse(name);
  }
  return static_cast<std::size_t>(found - kTests.begin());
}

std::size_t frame_count(std::string_view name) {
  return kTests[orientation_row(name)].name == kDrive ? kDriveFrames : kApproachFrames;
}

std::size_t fullest_frame(std::string_view name) {
  return name == kDrive ? kDriveFrames / 2 : frame_count(name) - 1;
}

}  // namespace soms::view
