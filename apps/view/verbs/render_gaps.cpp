#include "apps/view/verbs/render_gaps.h"

#include "apps/support/text.h"

#include <fmt/format.h>

namespace soms::view {

namespace {

/// A gap with the members that `simulate --clearance --json` gives it.
command::Json gap_json(const ViewScene& scene, const Gap& gap) {
  const auto point = [](const Vec3& p) { return command::Json{p.x, p.y, p.z}; };
  command::Json json{{"mover", gap.a.index}, {"model", scene.body(gap.a).name}};
  if (gap.b.role == Role::city) {
    json["city"] = scene.body(gap.b).name;
  } else {
    json["other_mover"] = gap.b.index;
    json["other_model"] = scene.body(gap.b).name;
  }
  json["lower"] = gap.distance.lower;
  json["upper"] = gap.distance.upper;
  json["triangles"] = {gap.i, gap.j};
  json["points"] = {point(gap.point_a), point(gap.point_b)};
  return json;
}

}  // namespace

std::string gaps_in_words(const ViewScene& scene) {
  const SceneStatistics facts = scene.statistics();
  if (!(facts.clearance > 0)) {
    return {};
  }
  const std::string all = fmt::format(", {} of at most {} m", command::counted(facts.gaps, "gap"),
                                      command::four_digits(facts.clearance));
  return facts.least_gap ? all + ", the least " + length_of(*facts.least_gap) : all;
}

void add_gaps(command::Json& answer, const ViewScene& scene) {
  const SceneStatistics facts = scene.statistics();
  if (!(facts.clearance > 0)) {
    return;
  }
  answer["clearance"] = facts.clearance;
  answer["gaps"] = facts.gaps;
  if (facts.least_gap) {
    answer["least_gap"] = gap_json(scene, *facts.least_gap);
  }
}

}  // namespace soms::view
