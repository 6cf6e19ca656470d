/// \file
/// A robot and the cell that it moves in, ready for queries.
///
/// \code
/// soms::Robot robot;  // three balls in a row, each turned by the one before
/// for (const char* const name : {"base", "arm", "hand"}) {
///   robot.links.push_back({name, {soms::generate_sphere(320)}});
/// }
/// robot.joints = {{"a", soms::JointType::continuous, 0, 1, soms::Pose::translation(1.9, 0, 0)},
///                 {"b", soms::JointType::continuous, 1, 2, soms::Pose::translation(1.9, 0, 0)}};
/// const soms::RobotModel model(robot);
/// std::cout << model.bodies() << " bodies; links compared:";
/// for (const soms::LinkPair& pair : model.compared()) {
///   std::cout << ' ' << robot.links[pair.a].name << " and " << robot.links[pair.b].name << '\n';
/// }
/// \endcode
/// It prints:
/// \verbatim
/// 3 bodies; links compared: base and hand
/// \endverbatim
#pragma once

#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/clash/part_bodies.h"
#include "soms/geometry/mesh.h"
#include "soms/kinematics/kinematics.h"
#include "soms/kinematics/robot.h"
#include "soms/query/contains.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms {

/// What is compared of a robot.
struct RobotModelOptions {
  Pose base = {};                            ///< of the root link, in the cell
  std::vector<LinkPair> ignored = {};        ///< further pairs of links that are not compared
  std::vector<std::uint32_t> off_cell = {};  ///< links that are not compared with the cell

  [[nodiscard]] bool operator==(const RobotModelOptions&) const = default;
};

/// A part of one of the meshes of a link, or of the cell.
struct RobotMeshPart {
  std::uint32_t mesh = 0;                ///< number among those of the link, or of the cell
  std::uint32_t part = Part::kNoParent;  ///< index in its Mesh::parts

  [[nodiscard]] bool operator==(const RobotMeshPart&) const = default;
};

/// A body of a link, in its frame, or of the cell.
struct RobotBody {
  std::uint32_t owner = 0;  ///< the link; of the cell, the number of the body
  std::uint32_t mesh = 0;   ///< number of its mesh among those of the link, or of the cell
  /// That of the part of its mesh, or the mesh's source; of several parts, with " + " between.
  std::string name = {};
  /// Its `part` is of `mesh`; its triangles count through all meshes of the link, or of the cell.
  PartBody part = {};
  std::vector<RobotMeshPart> joined = {};  ///< the other parts of the body, in PartBody's stead
  std::vector<TriangleId> connected = {};  ///< the first triangle of each connected part
  std::vector<std::uint32_t> connected_of = {};  ///< of each triangle; empty where there is one
  /// Those connected parts of an open body that are closed: a point inside is inside of the body.
  std::optional<ClosedBody> core = std::nullopt;

  [[nodiscard]] bool operator==(const RobotBody&) const = default;
};

/// A pair of a robot: two links, the lesser first, or a link and a part of the cell.
struct RobotPair {
  std::uint32_t link = 0;
  bool cell = false;  ///< `other` is a part of the cell
  std::uint32_t other = 0;

  [[nodiscard]] auto operator<=>(const RobotPair&) const = default;
};

/// Something that a link carries, such as a part in a gripper: a link of its own, by a fixed joint.
struct RobotAttachment {
  std::string name;
  std::uint32_t link = 0;                    ///< that carries it
  std::vector<Mesh> meshes = {};             ///< in its own frame
  Pose pose = {};                            ///< of its frame, in that of the link
  std::vector<std::uint32_t> touching = {};  ///< further links that it may touch

  [[nodiscard]] bool operator==(const RobotAttachment&) const = default;
};

/// The bodies of a robot's links and of its cell, and which of them are compared: pairs of links
/// but `skipped_pairs`, and each link with each part of the cell. Bodies of one link are not, nor
/// parts of the cell. Meshes are divided into their parts. Parts that close each other are one
/// body, also those of several meshes of a link or of the cell. So are open parts that may enclose
/// something together (OpenParts::joined). A value; copies share the meshes and their trees.
class RobotModel {
 public:
  /// \errors  As `check(Robot)`, `part_bodies` and `check(Pose)`; ErrorKind::out_of_range for a
  ///          link that does not exist, and for more than 4,096 links with meshes.
  /// \cost    Trees of all meshes, and whether they are closed.
  /// \threads `limits` gives cancellation, and threads for the trees.
  explicit RobotModel(const Robot& robot, std::span<const Mesh> cell = {},
                      const RobotModelOptions& options = {}, const Limits& limits = {});

  /// This robot in another cell. Bodies of links are shared, with their trees.
  /// \errors As the constructor. \cost Trees of the cell.
  [[nodiscard]] RobotModel with_cell(std::span<const Mesh> cell, const Limits& limits = {}) const;

  /// This robot with something attached: the last of its links, which adds nothing to a state. It
  /// is compared with the cell, and with all links but those of `touching` and the nearest link
  /// with meshes that it hangs from. The model without it is what this was called of.
  /// \errors As the constructor; ErrorKind::bad_file for a name that is taken or empty.
  /// \cost   Trees of its meshes.
  [[nodiscard]] RobotModel with_attached(const RobotAttachment& object,
                                         const Limits& limits = {}) const;

  /// This robot without comparing these pairs of links, in either order.
  /// \errors ErrorKind::out_of_range for a link that does not exist. \cost No tree is built.
  [[nodiscard]] RobotModel with_ignored(std::span<const LinkPair> pairs) const;

  [[nodiscard]] const Kinematics& kinematics() const { return kinematics_; }

  [[nodiscard]] const Pose& base() const { return base_; }

  [[nodiscard]] const std::vector<std::string>& link_names() const { return link_names_; }

  /// Bodies of all links, by link.
  [[nodiscard]] const std::vector<RobotBody>& link_bodies() const { return link_bodies_; }

  /// Bodies of the cell.
  [[nodiscard]] const std::vector<RobotBody>& cell_bodies() const { return cell_bodies_; }

  /// A body by its number: those of links come first.
  [[nodiscard]] const RobotBody& body(std::size_t i) const {
    return i < link_bodies_.size() ? link_bodies_[i] : cell_bodies_[i - link_bodies_.size()];
  }

  [[nodiscard]] std::size_t bodies() const { return link_bodies_.size() + cell_bodies_.size(); }

  /// Whether bodies i and j are compared, i the lesser number.
  [[nodiscard]] bool compares(std::size_t i, std::size_t j) const;

  /// The pair that two bodies belong to, i the lesser number. \pre One is of a link.
  [[nodiscard]] RobotPair pair_of(std::size_t i, std::size_t j) const {
    return {body(i).owner, j >= link_bodies_.size(), body(j).owner};
  }

  /// Pairs of links that are compared, sorted, and those that are not though both have meshes.
  [[nodiscard]] const std::vector<LinkPair>& compared() const { return compared_; }

  [[nodiscard]] const std::vector<LinkPair>& skipped() const { return skipped_; }

  /// Links that are compared with the cell: those with meshes, but RobotModelOptions::off_cell.
  [[nodiscard]] const std::vector<std::uint32_t>& on_cell() const { return on_cell_; }

 private:
  void add_links(const Robot& robot, const Limits& limits);
  void add_cell(std::span<const Mesh> cell, const Limits& limits);
  void choose_pairs(const Robot& robot, const RobotModelOptions& options);
  void ignore(std::span<const LinkPair> pairs);
  void flag_pairs();

  Kinematics kinematics_;
  Pose base_;
  std::vector<std::string> link_names_;
  std::vector<RobotBody> link_bodies_;
  std::vector<RobotBody> cell_bodies_;
  std::vector<LinkPair> compared_;
  std::vector<LinkPair> skipped_;
  std::vector<std::uint32_t> on_cell_;
  std::vector<std::uint8_t> has_meshes_;   ///< a flag for each link
  std::vector<std::uint32_t> rows_;        ///< of each link, its number among those with meshes
  std::uint32_t with_meshes_ = 0;          ///< links
  std::vector<std::uint8_t> is_compared_;  ///< flags of pairs of links with meshes
  std::vector<std::uint8_t> is_on_cell_;   ///< a flag for each link
};

}  // namespace soms
