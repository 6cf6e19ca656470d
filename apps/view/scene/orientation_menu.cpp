#include "apps/view/scene/orientation_menu.h"

#include "soms/base/error.h"
#include "soms/thesis/thesis_frames.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

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

[[noreturn]] void refuse(std::string_view name) {
  std::string names;
  for (const OrientationTest& test : kTests) {
    names += (names.empty() ? "" : ", ") + std::string(test.name);
  }
  throw Error(ErrorKind::usage, "no orientation test \"" + std::string(name) + "\"",
              "name one of " + names);
}

std::vector<Pose> poses_of(const std::vector<Vec3>& offsets) {
  std::vector<Pose> poses;
  poses.reserve(offsets.size());
  for (const Vec3& by : offsets) {
    poses.push_back(Pose::translation(by.x, by.y, by.z));
  }
  return poses;
}

}  // namespace

std::span<const OrientationTest> orientation_tests() {
  return kTests;
}

std::vector<Pose> orientation_poses(std::string_view name, const Box& still, const Box& moving,
                                    std::size_t up) {
  if (name == kDrive) {
    return poses_of(drive_through(still, moving, up));
  }
  for (const auto& [approach, approach_name] : kAllApproaches) {
    if (approach_name == name) {
      return poses_of(orientation_test(still, moving, approach, up));
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
