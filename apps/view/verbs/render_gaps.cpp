#include "apps/view/verbs/render_gaps.h"

#include "apps/cli/text.h"

#include <fmt/format.h>

namespace soms::view {

namespace {

/// A gap with the members that `simulate --clearance --json` gives it.
command::Json named_gap_json(const ViewScene& scene, const Gap& gap) {
  const auto point = [](const Vec3& p) { return command::Json{p.x, p.y, p.z}; };
  command::Json json{{"mover", gap.a.index}, {"model", scene.body(gap.a).name}};
  if (gap.b.role == Role::city) {
    json["city"] = scene.body(gap.b).name;
  } else {
    json["other_mover"] = gap.b.index;
    json["other_model"] = scene.body(gap.b).name;
  }
  const Distance& near = gap.distance;
  json["lower"] = near.distance.lower;
  json["upper"] = near.distance.upper;
  json["triangles"] = {scene.numbers().triangle(gap.a, near.triangles->a),
                       scene.numbers().triangle(gap.b, near.triangles->b)};
  json["points"] = {point(near.point_a), point(near.point_b)};
  return json;
}

}  // namespace

std::string words_of_gaps(const ViewScene& scene, const std::optional<Gap>& drawn) {
  const SceneStatistics facts = scene.statistics();
  if (!(facts.clearance > 0)) {
    return drawn ? ", gap " + length_in_text(*drawn) : std::string();
  }
  const std::string all = fmt::format(", {} of at most {} m", command::counted(facts.gaps, "gap"),
                                      command::four_digits(facts.clearance));
  return facts.least_gap ? all + ", the least " + meters_in_text(*facts.least_gap) : all;
}

void add_gaps(command::Json& answer, const ViewScene& scene) {
  const SceneStatistics facts = scene.statistics();
  if (!(facts.clearance > 0)) {
    return;
  }
  answer["clearance"] = facts.clearance;
  answer["gaps"] = facts.gaps;
  if (facts.least_gap) {
    answer["least_gap"] = named_gap_json(scene, *facts.least_gap);
  }
}

}  // namespace soms::view
