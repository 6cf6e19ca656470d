#include "soms/io/detail/srdf.h"

#include "soms/io/detail/urdf_values.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

class SrdfReader {
 public:
  SrdfReader(Source& source, const Robot& robot) : document_(source, "robot"), robot_(robot) {
    for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
      links_.emplace(robot.links[i].name, i);
    }
    for (std::uint32_t i = 0; i < robot.joints.size(); ++i) {
      joints_.emplace(robot.joints[i].name, i);
    }
    for (const pugi::xml_node joint : document_.root().children("virtual_joint")) {
      virtual_joints_.insert(required_text(document_, joint, "name"));
    }
    refuse_macros(document_);
    if (const pugi::xml_node link = document_.root().child("link")) {
      document_.fail(link, "defines a link: a URDF file, not an SRDF file",
                     "give the SRDF file of this robot");
    }
  }

  [[nodiscard]] std::vector<LinkPair> allowed();
  [[nodiscard]] std::vector<NamedState> states();
  [[nodiscard]] std::string other_name() const;

 private:
  [[nodiscard]] std::uint32_t link_of(pugi::xml_node element, const char* attribute);
  [[nodiscard]] std::vector<LinkPair> pairs_of(const char* name);
  void add_value(pugi::xml_node element, NamedState& state);

  XmlDocument document_;
  const Robot& robot_;
  std::unordered_map<std::string, std::uint32_t> links_;
  std::unordered_map<std::string, std::uint32_t> joints_;
  std::unordered_set<std::string> virtual_joints_;
};

std::uint32_t SrdfReader::link_of(pugi::xml_node element, const char* attribute) {
  const std::string name = required_text(document_, element, attribute);
  const auto found = links_.find(name);
  if (found == links_.end()) {
    document_.fail(element,
                   std::string(attribute) + " of " + named_element(element) + ", " +
                       in_quotes(name) + ", is a link that the robot does not have",
                   "give the SRDF file of this robot");
  }
  return found->second;
}

/// Pairs of links that elements of this name list, sorted.
std::vector<LinkPair> SrdfReader::pairs_of(const char* name) {
  std::vector<LinkPair> pairs;
  for (const pugi::xml_node element : document_.root().children(name)) {
    const std::uint32_t a = link_of(element, "link1");
    const std::uint32_t b = link_of(element, "link2");
    if (a == b) {
      document_.fail(element, named_element(element) + " names one link twice", "name two links");
    }
    document_.take(sizeof(LinkPair));
    pairs.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<LinkPair> SrdfReader::allowed() {
  std::vector<LinkPair> by_default;
  std::unordered_set<std::uint32_t> seen;
  const auto n = static_cast<std::uint32_t>(robot_.links.size());
  for (const pugi::xml_node element : document_.root().children("disable_default_collisions")) {
    const std::uint32_t link = link_of(element, "link");
    if (!seen.insert(link).second) {
      continue;
    }
    document_.take(sizeof(LinkPair) * n);
    for (std::uint32_t other = 0; other < n; ++other) {
      if (other != link) {
        by_default.push_back({std::min(link, other), std::max(link, other)});
      }
    }
  }
  std::sort(by_default.begin(), by_default.end());
  const std::vector<LinkPair> enabled = pairs_of("enable_collisions");
  std::vector<LinkPair> pairs = pairs_of("disable_collisions");
  std::set_difference(by_default.begin(), by_default.end(), enabled.begin(), enabled.end(),
                      std::back_inserter(pairs));
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

void SrdfReader::add_value(pugi::xml_node element, NamedState& state) {
  const std::string name = required_text(document_, element, "name");
  if (virtual_joints_.contains(name)) {
    return;  // it places the robot, which the caller does
  }
  const auto found = joints_.find(name);
  if (found == joints_.end()) {
    document_.fail(element, named_element(element) + " is a joint that the robot does not have",
                   "give the SRDF file of this robot");
  }
  const double value = required_number(document_, element, "value");
  if (robot_.joints[found->second].type != JointType::fixed) {
    document_.take(sizeof(state.values.front()));
    state.values.emplace_back(found->second, value);
  }
}

std::vector<NamedState> SrdfReader::states() {
  std::vector<NamedState> states;
  for (const pugi::xml_node element : document_.root().children("group_state")) {
    NamedState state{.name = required_text(document_, element, "name"),
                     .group = element.attribute("group").value()};
    document_.take(sizeof(NamedState) + state.name.size() + state.group.size());
    for (const pugi::xml_node joint : element.children("joint")) {
      add_value(joint, state);
    }
    states.push_back(std::move(state));
  }
  return states;
}

/// The name of the robot that the file is of, if that is another one.
std::string SrdfReader::other_name() const {
  const std::string name = document_.root().attribute("name").value();
  return name == robot_.name ? std::string() : name;
}

}  // namespace

void read_srdf(Source& source, Robot& robot) {
  SrdfReader reader(source, robot);
  std::vector<LinkPair> allowed = reader.allowed();
  std::vector<NamedState> states = reader.states();
  if (const std::string name = reader.other_name(); !name.empty()) {
    robot.notes.push_back(source.name + ": it is of a robot named " + in_quotes(name) + ", not " +
                          in_quotes(robot.name));
  }
  robot.allowed = std::move(allowed);
  robot.states = std::move(states);
}

}  // namespace soms::detail
