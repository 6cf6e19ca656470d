#include "apps/report/scene_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace soms::report {

namespace {

/// As `side` of apps/report/web/src/words.js: where only two bodies are, or a body is the only one
/// that stands still, its parts need no other name beside theirs.
std::string side_words(const Scene& scene, std::uint32_t body, std::uint32_t part) {
  const std::string& name = scene.bodies[body].name;
  const std::string part_name = part == kNoPart ? std::string() : scene.parts[part].name;
  if (part_name.empty() || part_name == name) {
    return name;
  }
  const auto still = std::count_if(scene.bodies.begin(), scene.bodies.end(),
                                   [](const SceneBody& other) { return !other.moves; });
  const bool alone = scene.bodies.size() == 2 || (!scene.bodies[body].moves && still == 1);
  return alone ? part_name : fmt::format("{} ({})", name, part_name);
}

}  // namespace

std::optional<std::size_t> worst_row(const Scene& scene) {
  if (scene.rows.empty()) {
    return std::nullopt;
  }
  const auto worst = std::max_element(
      scene.rows.begin(), scene.rows.end(), [](const SceneRow& a, const SceneRow& b) {
        return std::tie(a.most_pairs, a.count) < std::tie(b.most_pairs, b.count);
      });
  return static_cast<std::size_t>(worst - scene.rows.begin());
}

std::string who_touches(const Scene& scene, const SceneRow& row) {
  const char* const meets = row.meeting == Meeting::touch     ? "touches"
                            : row.meeting == Meeting::passage ? "passed through"
                                                              : "may have passed through";
  return fmt::format("{} {} {}", side_words(scene, row.a, row.part_a), meets,
                     side_words(scene, row.b, row.part_b));
}

}  // namespace soms::report
