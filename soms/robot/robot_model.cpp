#include "soms/robot/robot_model.h"

#include "soms/base/error.h"
#include "soms/geometry/closedness.h"
#include "soms/kinematics/link_pairs.h"
#include "soms/query/detail/closed_surface.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace soms {

namespace {

/// All their pairs are listed.
constexpr std::ptrdiff_t kMostLinks = 4096;

/// Meshes as one, and where its parts are from.
struct OneMesh {
  Mesh mesh;
  std::vector<RobotMeshPart> parts;  ///< of each of its parts; of no part: the first mesh's

  /// Each mesh becomes a part, around its own parts.
  void add(Mesh other, std::uint32_t number) {
    parts.push_back({number, Part::kNoParent});
    for (std::uint32_t k = 0; k < other.parts.size(); ++k) {
      Part& part = other.parts[k];
      part.parent = part.parent == Part::kNoParent ? 0 : part.parent + 1;
      part.continues += part.continues == Part::kNoParent ? 0 : 1;
      parts.push_back({number, k});
    }
    // The outer of two parts with the same triangles is the first.
    other.parts.insert(
        other.parts.begin(),
        {.name = other.source, .count = static_cast<std::uint32_t>(other.triangles.size())});
    if (number == 0) {
      mesh = std::move(other);
    } else {
      append(mesh, other);
    }
  }

  [[nodiscard]] RobotMeshPart part(std::uint32_t number) const {
    return number == Part::kNoParent ? RobotMeshPart{} : parts[number];
  }
};

std::string name_of(std::span<const Mesh> meshes, const RobotMeshPart& part) {
  const MeshView& mesh = meshes[part.mesh];
  return part.part == Part::kNoParent ? mesh.source : mesh.parts[part.part].name;
}

/// Finds out what of a body is connected, and what of an open one is closed.
void look_into(RobotBody& body, const Limits& limits) {
  const MeshView& mesh = body.part.body.shape.mesh();
  detail::ClosedSurface surface = detail::closed_surface(mesh, {.stop = limits.stop});
  body.connected = std::move(surface.first);
  body.connected_of = std::move(surface.part_of);
  if (!body.part.closed) {
    Mesh core = closed_parts(mesh, {}, {.stop = limits.stop});
    if (!core.triangles.empty()) {
      body.core.emplace(Body(std::move(core)));
    }
  }
}

/// The bodies of meshes that do not move against each other.
std::vector<RobotBody> bodies_among(std::span<const Mesh> meshes, std::uint32_t owner,
                                    const Limits& limits) {
  OneMesh one;
  if (meshes.size() == 1) {
    for (std::uint32_t k = 0; k < meshes[0].parts.size(); ++k) {
      one.parts.push_back({0, k});
    }
  } else {
    for (std::uint32_t k = 0; k < meshes.size(); ++k) {
      one.add(meshes[k], k);
    }
  }
  std::vector<RobotBody> bodies;
  for (PartBody& part :
       part_bodies(meshes.size() == 1 ? meshes[0] : one.mesh, {}, limits, OpenParts::joined)) {
    const RobotMeshPart first = one.part(part.part);
    RobotBody body{.owner = owner, .mesh = first.mesh, .name = name_of(meshes, first)};
    for (const std::uint32_t other : part.joined) {
      body.joined.push_back(one.part(other));
      body.name += " + " + name_of(meshes, body.joined.back());
    }
    body.part = std::move(part);
    body.part.part = first.part;
    body.part.joined.clear();
    look_into(body, limits);
    bodies.push_back(std::move(body));
  }
  return bodies;
}

void check_link(std::uint32_t link, std::size_t links) {
  if (link >= links) {
    throw Error(ErrorKind::out_of_range,
                "link " + std::to_string(link) + " of " + std::to_string(links),
                "give numbers of links that exist");
  }
}

/// \param has_meshes A flag for each link
void check_links(const std::vector<std::uint8_t>& has_meshes) {
  const auto count = std::count(has_meshes.begin(), has_meshes.end(), 1);
  if (count > kMostLinks) {
    throw Error(ErrorKind::out_of_range,
                "the robot has " + std::to_string(count) + " links with meshes",
                "give it at most " + std::to_string(kMostLinks));
  }
}

/// A name that no joint has.
std::string free_name(const std::vector<Joint>& joints, std::string name) {
  while (std::any_of(joints.begin(), joints.end(),
                     [&](const Joint& joint) { return joint.name == name; })) {
    name += "'";
  }
  return name;
}

}  // namespace

RobotModel::RobotModel(const Robot& robot, std::span<const Mesh> cell,
                       const RobotModelOptions& options, const Limits& limits)
    : kinematics_(robot), base_(options.base) {
  check(base_);
  choose_pairs(robot, options);
  add_links(robot, limits);
  add_cell(cell, limits);
}

void RobotModel::add_links(const Robot& robot, const Limits& limits) {
  for (std::uint32_t link = 0; link < robot.links.size(); ++link) {
    link_names_.push_back(robot.links[link].name);
    std::vector<RobotBody> bodies = bodies_among(robot.links[link].collisions, link, limits);
    std::move(bodies.begin(), bodies.end(), std::back_inserter(link_bodies_));
  }
}

void RobotModel::add_cell(std::span<const Mesh> cell, const Limits& limits) {
  for (RobotBody& body : bodies_among(cell, 0, limits)) {
    body.owner = static_cast<std::uint32_t>(cell_bodies_.size());
    cell_bodies_.push_back(std::move(body));
  }
}

void RobotModel::choose_pairs(const Robot& robot, const RobotModelOptions& options) {
  const std::size_t n = robot.links.size();
  is_on_cell_.assign(n, 0);
  for (std::uint32_t link = 0; link < n; ++link) {
    has_meshes_.push_back(robot.links[link].collisions.empty() ? 0 : 1);
    is_on_cell_[link] = has_meshes_[link];
  }
  for (const std::uint32_t link : options.off_cell) {
    check_link(link, n);
    is_on_cell_[link] = 0;
  }
  for (std::uint32_t link = 0; link < n; ++link) {
    if (is_on_cell_[link] != 0) {
      on_cell_.push_back(link);
    }
  }
  check_links(has_meshes_);
  skipped_ = skipped_pairs(robot);
  compared_ = compared_pairs(robot);
  ignore(options.ignored);
}

/// Makes pairs that are compared ones that are not.
void RobotModel::ignore(std::span<const LinkPair> pairs) {
  std::vector<LinkPair> given;
  for (const LinkPair& pair : pairs) {
    check_link(std::max(pair.a, pair.b), has_meshes_.size());
    given.push_back({std::min(pair.a, pair.b), std::max(pair.a, pair.b)});
  }
  std::sort(given.begin(), given.end());
  given.erase(std::unique(given.begin(), given.end()), given.end());
  std::vector<LinkPair> all;
  std::swap(all, compared_);
  std::set_difference(all.begin(), all.end(), given.begin(), given.end(),
                      std::back_inserter(compared_));
  std::set_intersection(all.begin(), all.end(), given.begin(), given.end(),
                        std::back_inserter(skipped_));
  std::sort(skipped_.begin(), skipped_.end());
  flag_pairs();
}

void RobotModel::flag_pairs() {
  rows_.clear();
  with_meshes_ = 0;
  for (const std::uint8_t has : has_meshes_) {
    rows_.push_back(with_meshes_);
    with_meshes_ += has;
  }
  is_compared_.assign(std::size_t{with_meshes_} * with_meshes_, 0);
  for (const LinkPair& pair : compared_) {
    is_compared_[std::size_t{rows_[pair.a]} * with_meshes_ + rows_[pair.b]] = 1;
  }
}

RobotModel RobotModel::with_cell(std::span<const Mesh> cell, const Limits& limits) const {
  RobotModel model = *this;
  model.cell_bodies_.clear();
  model.add_cell(cell, limits);
  return model;
}

RobotModel RobotModel::with_ignored(std::span<const LinkPair> pairs) const {
  RobotModel model = *this;
  model.ignore(pairs);
  return model;
}

RobotModel RobotModel::with_attached(const RobotAttachment& object, const Limits& limits) const {
  check_link(object.link, link_names_.size());
  const auto link = static_cast<std::uint32_t>(link_names_.size());
  Robot robot{.joints = kinematics_.joints()};
  for (const std::string& name : link_names_) {
    robot.links.push_back({.name = name});
  }
  robot.links.push_back({.name = object.name});
  robot.joints.push_back({.name = free_name(robot.joints, object.name),
                          .parent = object.link,
                          .child = link,
                          .origin = object.pose});
  RobotModel model = *this;
  model.kinematics_ = Kinematics(robot);
  model.link_names_.push_back(object.name);
  model.has_meshes_.push_back(object.meshes.empty() ? 0 : 1);
  model.is_on_cell_.push_back(model.has_meshes_.back());
  check_links(model.has_meshes_);
  if (model.is_on_cell_.back() != 0) {
    model.on_cell_.push_back(link);
  }
  std::vector<RobotBody> bodies = bodies_among(object.meshes, link, limits);
  std::move(bodies.begin(), bodies.end(), std::back_inserter(model.link_bodies_));
  std::vector<LinkPair> ignored;
  if (const auto holder = links_above(robot.joints, model.has_meshes_)[link]) {
    ignored.push_back({*holder, link});
  }
  for (const std::uint32_t other : object.touching) {
    ignored.push_back({other, link});
  }
  for (std::uint32_t other = 0; other < link; ++other) {
    if (model.has_meshes_[other] != 0 && model.has_meshes_[link] != 0) {
      model.compared_.push_back({other, link});
    }
  }
  std::sort(model.compared_.begin(), model.compared_.end());
  model.ignore(ignored);
  return model;
}

bool RobotModel::compares(std::size_t i, std::size_t j) const {
  if (i >= link_bodies_.size()) {
    return false;
  }
  const std::uint32_t link = link_bodies_[i].owner;
  if (j >= link_bodies_.size()) {
    return is_on_cell_[link] != 0;
  }
  return is_compared_[std::size_t{rows_[link]} * with_meshes_ + rows_[link_bodies_[j].owner]] != 0;
}

}  // namespace soms
