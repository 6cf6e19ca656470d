// URDF, SRDF and states of any bytes: typed errors, or a robot without a fault whose answers are
// those of the brute-force twin in a state of its own.
#include "soms/base/error.h"
#include "soms/io/robot.h"
#include "soms/kinematics/link_pairs.h"
#include "soms/robot/reference/robot_query.h"
#include "soms/robot/robot_query.h"

#include "tests/fuzz/require.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms {
namespace {

using fuzz::require;

constexpr std::size_t kMostTriangles = 3000;  // brute force compares all pairs

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

void check_kind(const Error& error) {
  const ErrorKind kind = error.kind();
  require(kind == ErrorKind::bad_file || kind == ErrorKind::not_finite ||
              kind == ErrorKind::out_of_range || kind == ErrorKind::unsupported ||
              kind == ErrorKind::cannot_open || kind == ErrorKind::out_of_memory ||
              kind == ErrorKind::empty_mesh || kind == ErrorKind::not_rigid,
          "the kind of a robot's error");
  require(error.place().find("fuzzed") == 0, "an error without the file");
}

std::optional<Robot> read(std::string_view text) {
  const RobotReadOptions options{.tessellation_error = 0.05, .max_memory = std::uint64_t{32} << 20};
  try {
    return read_robot(bytes_of(text), "fuzzed.urdf", options);
  } catch (const Error& error) {
    check_kind(error);
    return std::nullopt;
  }
}

std::size_t triangles_of(const Robot& robot) {
  std::size_t count = 0;
  for (const Link& link : robot.links) {
    for (const Mesh& mesh : link.collisions) {
      count += mesh.triangles.size();
    }
  }
  return count;
}

void check_answers(const Robot& robot) {
  if (triangles_of(robot) > kMostTriangles || robot.links.size() > 50) {
    return;
  }
  try {
    const RobotModel model(robot);
    Rng rng(triangles_of(robot));
    const std::vector<double> state = random_state(model.kinematics(), rng);
    const RobotAnswer answer = robot_contacts(model, state).at(0);
    require(reference::agrees(answer, reference::robot_contacts_by_brute_force(model, state)),
            "what brute force finds");
  } catch (const Error& error) {  // links beyond 2^300, or products that are no rotation any more
    require(error.kind() == ErrorKind::out_of_range || error.kind() == ErrorKind::not_finite ||
                error.kind() == ErrorKind::not_rigid,
            "the kind of a state's error");
  }
}

void check_semantics(std::string_view text) {
  static const std::optional<Robot> kArm = read(
      R"(<robot name="arm"><link name="base"/><link name="column"/><link name="boom"/>
      <joint name="turn" type="continuous"><parent link="base"/><child link="column"/></joint>
      <joint name="lift" type="prismatic"><parent link="column"/><child link="boom"/>
      <limit upper="1"/></joint></robot>)");
  require(kArm.has_value(), "a robot to read semantics for");
  Robot robot = *kArm;
  try {
    read_semantics(robot, bytes_of(text), "fuzzed.srdf", {.max_memory = std::uint64_t{32} << 20});
  } catch (const Error& error) {
    check_kind(error);
    require(robot == *kArm, "a robot that a broken file changed");
    return;
  }
  require(!find_fault(robot), "a fault after reading semantics");
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto robot = soms::read(text)) {
    soms::fuzz::require(!soms::find_fault(*robot), "a robot with a fault");
    soms::check_answers(*robot);
  }
  soms::check_semantics(text);
  return 0;
}
