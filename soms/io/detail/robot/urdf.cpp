#include "soms/io/detail/robot/urdf.h"

#include "soms/io/detail/left_out.h"
#include "soms/io/detail/robot/urdf_geometry.h"
#include "soms/io/detail/robot/urdf_values.h"

#include <array>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace soms::detail {

namespace {

/// Puts a robot together, and knows which element each of its links and joints is.
class UrdfReader {
 public:
  UrdfReader(Source& source, const RobotReadOptions& options)
      : document_(source, "robot"), shapes_(document_, options) {}

  [[nodiscard]] Robot read() {
    refuse_macros(document_);
    robot_.name = document_.root().attribute("name").value();
    robot_.source = document_.source().name;
    read_links();
    for (const pugi::xml_node element : document_.root().children("joint")) {
      read_joint(element);
    }
    read_mimics();
    refuse_faults();
    robot_.tessellation_error = shapes_.error();
    robot_.notes = shapes_.notes();
    add_note(robot_.notes, only_seen_, "links that are drawn and have no collision geometry");
    add_note(robot_.notes, shapes_.flat(),
             "sizes of 0, which make a shape flat, a segment or a point");
    add_note(robot_.notes, idle_mimics_, "<mimic> of fixed joints");
    return std::move(robot_);
  }

 private:
  void read_links();
  void read_joint(pugi::xml_node element);
  void read_limits(pugi::xml_node element, Joint& joint);
  void read_mimics();
  void refuse_faults();
  [[nodiscard]] JointType type_of(pugi::xml_node element);
  [[nodiscard]] std::uint32_t linked(pugi::xml_node joint, const char* which);

  XmlDocument document_;
  UrdfShapes shapes_;
  Robot robot_;
  std::vector<pugi::xml_node> link_elements_;
  std::vector<pugi::xml_node> joint_elements_;
  std::unordered_map<std::string, std::uint32_t> links_;
  std::unordered_map<std::string, std::uint32_t> joints_;
  LeftOut only_seen_;
  LeftOut idle_mimics_;
};

void UrdfReader::read_links() {
  for (const pugi::xml_node element : document_.root().children("link")) {
    const std::string name = required_text(document_, element, "name");
    document_.take(sizeof(Link) + 2 * name.size());
    if (!links_.emplace(name, static_cast<std::uint32_t>(robot_.links.size())).second) {
      document_.fail(element, named_element(element) + " has the name of another link",
                     "give each link a name of its own");
    }
    Link link{.name = name};
    for (const pugi::xml_node collision : element.children("collision")) {
      link.collisions.push_back(shapes_.read(collision));
    }
    if (link.collisions.empty() && element.child("visual")) {
      only_seen_.add([&] { return document_.place_of(element); });
    }
    robot_.links.push_back(std::move(link));
    link_elements_.push_back(element);
  }
}

JointType UrdfReader::type_of(pugi::xml_node element) {
  constexpr std::array<std::pair<std::string_view, JointType>, 4> kTypes = {
      {{"fixed", JointType::fixed},
       {"revolute", JointType::revolute},
       {"continuous", JointType::continuous},
       {"prismatic", JointType::prismatic}}};
  const std::string type = required_text(document_, element, "type");
  for (const auto& [name, value] : kTypes) {
    if (type == name) {
      return value;
    }
  }
  const bool is_known = type == "planar" || type == "floating";
  document_.fail(element,
                 named_element(element) + " is of the type " + in_quotes(type) +
                     (is_known ? ", which has several values" : ", which is not known"),
                 is_known ? "split it into prismatic and revolute joints"
                          : "make it fixed, revolute, continuous or prismatic",
                 is_known ? ErrorKind::unsupported : ErrorKind::bad_file);
}

std::uint32_t UrdfReader::linked(pugi::xml_node joint, const char* which) {
  const pugi::xml_node element = required_child(document_, joint, which);
  const std::string name = required_text(document_, element, "link");
  const auto found = links_.find(name);
  if (found == links_.end()) {
    document_.fail(element,
                   "the " + std::string(which) + " of " + named_element(joint) + ", " +
                       in_quotes(name) + ", is a link that does not exist",
                   "name a link of the robot");
  }
  return found->second;
}

void UrdfReader::read_joint(pugi::xml_node element) {
  Joint joint;
  joint.name = required_text(document_, element, "name");
  document_.take(sizeof(Joint) + 2 * joint.name.size());
  if (!joints_.emplace(joint.name, static_cast<std::uint32_t>(robot_.joints.size())).second) {
    document_.fail(element, named_element(element) + " has the name of another joint",
                   "give each joint a name of its own");
  }
  joint.type = type_of(element);
  joint.parent = linked(element, "parent");
  joint.child = linked(element, "child");
  joint.origin = read_origin(document_, element);
  if (joint.type != JointType::fixed) {
    const pugi::xml_node axis = only_child(document_, element, "axis");
    joint.axis = vector_or(document_, axis, "xyz", joint.axis);
    read_limits(element, joint);
  }
  robot_.joints.push_back(std::move(joint));
  joint_elements_.push_back(element);
}

void UrdfReader::read_limits(pugi::xml_node element, Joint& joint) {
  const pugi::xml_node limit = only_child(document_, element, "limit");
  if (joint.type == JointType::continuous) {
    return;
  }
  if (!limit) {
    document_.fail(element, named_element(element) + " has no <limit>",
                   "give it one, or make it continuous if it turns without end");
  }
  joint.lower = number_or(document_, limit, "lower", 0);
  joint.upper = number_or(document_, limit, "upper", 0);
}

void UrdfReader::read_mimics() {
  for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
    const pugi::xml_node element = only_child(document_, joint_elements_[i], "mimic");
    if (!element) {
      continue;
    }
    if (robot_.joints[i].type == JointType::fixed) {
      idle_mimics_.add([&] { return document_.place_of(element); });
      continue;  // it has no value that could follow another
    }
    const std::string name = required_text(document_, element, "joint");
    const auto found = joints_.find(name);
    if (found == joints_.end()) {
      document_.fail(element,
                     named_element(joint_elements_[i]) + " mimics " + in_quotes(name) +
                         ", which does not exist",
                     "name a joint of the robot");
    }
    robot_.joints[i].mimic = Mimic{.joint = found->second,
                                   .multiplier = number_or(document_, element, "multiplier", 1),
                                   .offset = number_or(document_, element, "offset", 0)};
  }
}

void UrdfReader::refuse_faults() {
  if (const auto fault = find_fault(robot_)) {
    const pugi::xml_node element = fault->joint  ? joint_elements_[*fault->joint]
                                   : fault->link ? link_elements_[*fault->link]
                                                 : document_.root();
    document_.fail(element, fault->what, fault->remedy, fault->kind);
  }
}

}  // namespace

Robot read_urdf(Source& source, const RobotReadOptions& options) {
  return UrdfReader(source, options).read();
}

}  // namespace soms::detail
