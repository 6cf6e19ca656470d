/// \file
/// Collision elements of a URDF file as meshes.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/left_out.h"
#include "soms/io/detail/robot/urdf_values.h"
#include "soms/io/robot.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace soms::detail {

/// Reads the shapes of links; a mesh file that is named several times is read once.
class UrdfShapes {
 public:
  UrdfShapes(const XmlDocument& document, const RobotReadOptions& options)
      : document_(document), options_(options) {}

  /// The mesh of a <collision> element, in the frame of its link.
  /// \errors As `read_robot`.
  [[nodiscard]] Mesh read(pugi::xml_node collision);

  /// The greatest error of round shapes so far.
  [[nodiscard]] double error() const { return error_; }

  /// Sizes of 0: shapes that are disks, segments or points.
  [[nodiscard]] const LeftOut& flat() const { return flat_; }

  /// What was noted about meshes.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  [[nodiscard]] Mesh shape_of(pugi::xml_node geometry);
  [[nodiscard]] Mesh read_file(pugi::xml_node element);
  [[nodiscard]] Mesh primitive(pugi::xml_node element);
  [[nodiscard]] const Mesh& stored(const std::filesystem::path& path);
  void note(const std::string& text);

  const XmlDocument& document_;
  const RobotReadOptions& options_;
  std::map<std::filesystem::path, Mesh> files_;
  std::vector<std::string> notes_;
  LeftOut flat_;
  double error_ = 0;
};

}  // namespace soms::detail
