#include "soms/kinematics/link_pairs.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace soms {

std::vector<std::optional<std::uint32_t>> links_above(const std::vector<Joint>& joints,
                                                      const std::vector<std::uint8_t>& has_meshes) {
  std::vector<std::optional<std::uint32_t>> parents(has_meshes.size());
  for (const Joint& joint : joints) {
    parents[joint.child] = joint.parent;
  }
  std::vector<std::optional<std::uint32_t>> above = parents;
  for (std::optional<std::uint32_t>& other : above) {
    while (other && has_meshes[*other] == 0) {
      other = parents[*other];
    }
  }
  return above;
}

std::vector<LinkPair> neighbor_pairs(const Robot& robot) {
  std::vector<std::uint8_t> has_meshes;
  for (const Link& link : robot.links) {
    has_meshes.push_back(link.collisions.empty() ? 0 : 1);
  }
  const auto above = links_above(robot.joints, has_meshes);
  std::vector<LinkPair> pairs;
  for (std::uint32_t link = 0; link < robot.links.size(); ++link) {
    if (has_meshes[link] != 0 && above[link]) {
      pairs.push_back({std::min(link, *above[link]), std::max(link, *above[link])});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<LinkPair> skipped_pairs(const Robot& robot) {
  if (!robot.allowed) {
    return neighbor_pairs(robot);
  }
  std::vector<LinkPair> pairs;
  for (const LinkPair& pair : *robot.allowed) {
    if (!robot.links[pair.a].collisions.empty() && !robot.links[pair.b].collisions.empty()) {
      pairs.push_back(pair);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<LinkPair> compared_pairs(const Robot& robot) {
  std::vector<std::uint32_t> links;
  for (std::uint32_t link = 0; link < robot.links.size(); ++link) {
    if (!robot.links[link].collisions.empty()) {
      links.push_back(link);
    }
  }
  std::vector<LinkPair> all;
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (std::size_t j = i + 1; j < links.size(); ++j) {
      all.push_back({links[i], links[j]});
    }
  }
  const std::vector<LinkPair> skipped = skipped_pairs(robot);
  std::vector<LinkPair> pairs;
  std::set_difference(all.begin(), all.end(), skipped.begin(), skipped.end(),
                      std::back_inserter(pairs));
  return pairs;
}

}  // namespace soms
