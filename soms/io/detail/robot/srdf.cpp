#include "soms/io/detail/robot/srdf.h"

#include "soms/io/detail/left_out.h"
#include "soms/io/detail/robot/urdf_values.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
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
  /// What the file says of links and joints that are not there, and so of no answer.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  [[nodiscard]] std::optional<std::uint32_t> link_of(pugi::xml_node element, const char* attribute);
  [[nodiscard]] std::vector<LinkPair> pairs_of(const char* name);
  void add_value(pugi::xml_node element, NamedState& state);

  XmlDocument document_;
  const Robot& robot_;
  std::unordered_map<std::string, std::uint32_t> links_;
  std::unordered_map<std::string, std::uint32_t> joints_;
  std::unordered_set<std::string> virtual_joints_;
  LeftOut unknown_links_;
  LeftOut single_links_;
  LeftOut unknown_joints_;
};

/// Nothing for a link that the robot does not have.
std::optional<std::uint32_t> SrdfReader::link_of(pugi::xml_node element, const char* attribute) {
  const auto found = links_.find(required_text(document_, element, attribute));
  return found == links_.end() ? std::nullopt : std::optional(found->second);
}

/// Pairs of links that elements of this name list, sorted.
std::vector<LinkPair> SrdfReader::pairs_of(const char* name) {
  std::vector<LinkPair> pairs;
  for (const pugi::xml_node element : document_.root().children(name)) {
    const std::optional<std::uint32_t> a = link_of(element, "link1");
    const std::optional<std::uint32_t> b = link_of(element, "link2");
    const auto place = [&] { return document_.place_of(element); };
    if (!a || !b) {
      unknown_links_.add(place);
    } else if (*a == *b) {
      single_links_.add(place);
    } else {
      document_.take(sizeof(LinkPair));
      pairs.push_back({std::min(*a, *b), std::max(*a, *b)});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<LinkPair> SrdfReader::allowed() {
  std::vector<LinkPair> by_default;
  std::unordered_set<std::uint32_t> seen;
  const auto n = static_cast<std::uint32_t>(robot_.links.size());
  for (const pugi::xml_node element : document_.root().children("disable_default_collisions")) {
    const std::optional<std::uint32_t> link = link_of(element, "link");
    if (!link) {
      unknown_links_.add([&] { return document_.place_of(element); });
      continue;
    }
    if (!seen.insert(*link).second) {
      continue;
    }
    document_.take(sizeof(LinkPair) * n);
    for (std::uint32_t other = 0; other < n; ++other) {
      if (other != *link) {
        by_default.push_back({std::min(*link, other), std::max(*link, other)});
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
    unknown_joints_.add([&] { return document_.place_of(element); });
    document_.take(sizeof(name) + name.size());
    state.unknown.push_back(name);
    return;  // its value may be a list, as that of a floating joint
  }
  if (robot_.joints[found->second].type != JointType::fixed) {
    const double value = required_number(document_, element, "value");
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

std::vector<std::string> SrdfReader::notes() const {
  std::vector<std::string> notes;
  add_note(notes, unknown_links_, "entries of links that the robot does not have");
  add_note(notes, single_links_, "pairs of a link with itself");
  add_note(notes, unknown_joints_, "values of joints that the robot does not have");
  return notes;
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
  for (const std::string& note : reader.notes()) {
    robot.notes.push_back(source.name + ": " + note);
  }
  robot.allowed = std::move(allowed);
  robot.states = std::move(states);
}

}  // namespace soms::detail
