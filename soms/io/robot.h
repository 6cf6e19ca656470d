/// \file
/// Reading robots: URDF, with the meshes that it names, and SRDF.
#pragma once

#include "soms/base/limits.h"
#include "soms/kinematics/robot.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms {

/// Options of reading a robot.
struct RobotReadOptions {
  /// SRDF file of the pairs of links that may touch, and of named states. Empty: none.
  std::filesystem::path srdf = {};
  /// Names of packages and their folders: where `package://NAME/` is looked for first.
  std::vector<std::pair<std::string, std::filesystem::path>> packages = {};
  /// Folders in which packages lie, or that are one, as ROS_PACKAGE_PATH lists them.
  std::vector<std::filesystem::path> package_path = {};
  /// How far cylinders and spheres may exceed the true ones, as meshes: in meters.
  double tessellation_error = 0.0005;
  /// Most bytes to allocate, for each file; 0: as `read_mesh`, and 1 GiB for shapes and copies.
  std::uint64_t max_memory = 0;
  /// Make an error of what would be noted in `Robot::notes`.
  bool strict = false;

  [[nodiscard]] bool operator==(const RobotReadOptions&) const = default;
};

/// Reads a robot from a URDF file, in meters and radians: links with the meshes of their
/// `collision` elements in the frame of the link, and joints. What neither shape nor motion depends
/// on (visuals, inertia, materials, transmissions) is passed over. The robot passes `check`.
///
/// A mesh is read as `read_mesh` does, multiplied by its unit in meters if the file states one,
/// by `scale`, and moved by `origin`, each rounded; its up axis turns nothing. Its name is
/// `package://NAME/REST`, found by `packages`, then in a folder NAME (or one whose package.xml has
/// this name) that holds the URDF file or lies beside one that does, then by `package_path`;
/// `file:///PATH`; or a path from the folder of the URDF file. Cylinders and spheres become closed
/// meshes that hold them (primitive_meshes.h).
///
/// \errors  cannot_open (a file or package that is missing: names the element that needs it),
///          bad_file (names file and line), not_finite, out_of_range, empty_mesh, out_of_memory,
///          unsupported (planar and floating joints, other shapes, xacro, other protocols, a build
///          without pugixml), usage for options; cancelled.
/// \threads `limits` gives cancellation; reading is one thread.
[[nodiscard]] Robot read_robot(const std::filesystem::path& path,
                               const RobotReadOptions& options = {}, const Limits& limits = {});

/// The same from bytes in memory; `name` stands for the path in messages. Meshes are found by
/// `packages`, `package_path` and whole paths alone.
[[nodiscard]] Robot read_robot(std::span<const std::byte> bytes, const std::string& name,
                               const RobotReadOptions& options = {}, const Limits& limits = {});

/// Adds what an SRDF file says of a robot: Robot::allowed, which are the pairs of
/// `disable_collisions`, and those of `disable_default_collisions` but for `enable_collisions`; and
/// Robot::states.
/// What it says of links and joints that the robot does not have changes no answer: a note counts
/// it, and NamedState::unknown names such joints. \errors As `read_robot`.
void read_semantics(Robot& robot, const std::filesystem::path& path,
                    const RobotReadOptions& options = {}, const Limits& limits = {});

/// The same from bytes in memory.
void read_semantics(Robot& robot, std::span<const std::byte> bytes, const std::string& name,
                    const RobotReadOptions& options = {}, const Limits& limits = {});

}  // namespace soms
