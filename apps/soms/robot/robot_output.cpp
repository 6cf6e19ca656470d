#include "apps/soms/robot/robot_output.h"

#include "soms/base/text.h"

#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/soms/pairs/pair_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

constexpr std::size_t kPairsInText = 10;

/// The second of a pair: a link, or "cell: wall".
std::string other_label(const RobotModels& models, const RobotPair& pair) {
  if (!pair.cell) {
    return models.model.link_names()[pair.other];
  }
  return "cell: " + models.cell_names[pair.other];
}

Json other_as_json(const RobotModels& models, const RobotPair& pair) {
  if (!pair.cell) {
    return {{"link", models.model.link_names()[pair.other]}};
  }
  return {{"cell",
           {{"file", models.cell_files[pair.other]},
            {"part", models.cell_names[pair.other]},
            {"index", pair.other}}}};
}

Json number_or_null(double x) {
  return std::isfinite(x) ? Json(x) : Json();
}

Json gap_as_json(const RobotModels& models, const RobotGap& gap) {
  Json json = {
      {"distance", {number_or_null(gap.distance.lower), number_or_null(gap.distance.upper)}}};
  if (gap.farther) {
    json["farther"] = true;
  }
  if (gap.pair) {
    json.update(pair_as_json(models, *gap.pair));
  }
  if (gap.points) {
    json["points"] = Json::array();
    for (const Vec3& p : *gap.points) {
      json["points"].push_back({p.x, p.y, p.z});
    }
  }
  return json;
}

std::string gap_in_text(const RobotModels& models, const RobotGap& gap) {
  if (gap.farther) {
    return fmt::format("farther than {}", readable(gap.distance.lower));
  }
  if (!gap.pair) {
    return "nothing is compared";
  }
  return fmt::format("{} apart ({})", readable(gap.distance.lower),
                     pair_in_text(models, *gap.pair));
}

std::string joints_in_text(const RobotModels& models, const std::vector<std::uint32_t>& joints) {
  std::string text;
  for (const std::uint32_t joint : joints) {
    text += (text.empty() ? "" : ", ") + printable(models.robot.joints[joint].name);
  }
  return text;
}

std::string contacts_in_text(const RobotModels& models, const RobotAnswer& answer) {
  std::string text;
  for (const RobotContact& contact : answer.contacts) {
    text += fmt::format("{}{}{}", text.empty() ? "" : "; ", pair_in_text(models, contact.pair),
                        contact.surfaces_meet ? "" : " (one inside the other)");
  }
  return text;
}

/// "12 pairs", as "1 pair".
std::string why_skipped(const RobotModels& models) {
  return models.robot.allowed ? "named by the SRDF file or an option"
                              : "joint neighbors, or excluded by an option";
}

}  // namespace

std::string pair_in_text(const RobotModels& models, const RobotPair& pair) {
  return printable(models.model.link_names()[pair.link]) + " and " +
         printable(other_label(models, pair));
}

Json pair_as_json(const RobotModels& models, const RobotPair& pair) {
  return {{"a", {{"link", models.model.link_names()[pair.link]}}},
          {"b", other_as_json(models, pair)}};
}

std::string pair_as_csv(const RobotModels& models, const std::optional<RobotPair>& pair) {
  return pair ? fmt::format("{},{}", csv_field(models.model.link_names()[pair->link]),
                            csv_field(other_label(models, *pair)))
              : ",";
}

void RobotTotals::add(const RobotAnswer& answer) {
  const std::uint64_t state = states++;
  free += answer.verdict == RobotVerdict::free ? 1U : 0U;
  contact += answer.verdict == RobotVerdict::contact ? 1U : 0U;
  undecided += answer.verdict == RobotVerdict::undecided ? 1U : 0U;
  const bool is_cut = answer.coverage == Coverage::cut;
  cut += is_cut ? 1U : 0U;
  open += answer.verdict == RobotVerdict::undecided && !is_cut ? 1U : 0U;
  if (answer.verdict == RobotVerdict::contact && !first_contact) {
    first_contact = state;
  }
  if (answer.verdict == RobotVerdict::undecided && !first_undecided) {
    first_undecided = state;
  }
  for (const RobotContact& found : answer.contacts) {
    ++pairs[found.pair];
  }
  beyond_limits += answer.beyond_limits.empty() ? 0U : 1U;
  for (const std::uint32_t joint : answer.beyond_limits) {
    ++limits[joint];
  }
  const auto key = [](const RobotGap& gap) { return std::pair(gap.distance.lower, gap.farther); };
  const auto lower = [&](auto& kept) {
    if (!kept || key(*answer.gap) < key(kept->second)) {
      kept = {state, *answer.gap};
    }
  };
  if (answer.gap) {
    lower(least);
  }
  if (answer.gap && answer.verdict == RobotVerdict::free) {
    lower(least_free);
  }
  cost += answer.cost;
}

std::string limit_in_words(const RobotModels& models, std::uint32_t joint,
                           std::span<const double> state) {
  const Joint& limited = models.robot.joints[joint];
  return fmt::format("joint {} is {}, outside of its limits {} and {}", limited.name,
                     shortest(models.model.kinematics().joint_values(state)[joint]),
                     shortest(limited.lower), shortest(limited.upper));
}

std::string models_in_text(const RobotModels& models) {
  const auto with_meshes = static_cast<std::uint64_t>(
      std::count_if(models.robot.links.begin(), models.robot.links.end(),
                    [](const Link& link) { return !link.collisions.empty(); }));
  std::string text = fmt::format(
      "{}: {}, {} with collision meshes; {}\n",
      printable(models.robot.name.empty() ? models.robot.source : models.robot.name),
      counted(models.robot.links.size(), "link"), with_commas(with_meshes),
      models.model.kinematics().size() == 1
          ? "1 joint moves by itself"
          : with_commas(models.model.kinematics().size()) + " joints move by themselves");
  text += fmt::format("{} of links compared, {} not ({})\n",
                      counted(models.model.compared().size(), "pair"),
                      with_commas(models.model.skipped().size()), why_skipped(models));
  if (models.robot.tessellation_error > 0) {
    text += fmt::format("cylinders and spheres are meshes that exceed them by at most {}\n",
                        readable(models.robot.tessellation_error));
  }
  if (!models.cell.empty()) {
    text += fmt::format("cell: {}, compared with {}\n",
                        counted(models.model.cell_bodies().size(), "part"),
                        counted(models.model.on_cell().size(), "link"));
  }
  if (!models.open.empty()) {
    text += fmt::format("not closed, so that what lies in {} is undecided: {}{}\n",
                        models.open.size() == 1 ? "it" : "them", printable(models.open.front()),
                        models.open.size() == 1
                            ? std::string()
                            : fmt::format(" and {} more", with_commas(models.open.size() - 1)));
  }
  return text;
}

std::string answer_in_text(const RobotModels& models, std::uint64_t state,
                           const RobotAnswer& answer, const Terminal& terminal) {
  const Ink ink =
      ink_of(answer.verdict == RobotVerdict::contact, answer.verdict == RobotVerdict::undecided);
  std::string text = fmt::format("state {}: {}", state, terminal.paint(name(answer.verdict), ink));
  if (!answer.contacts.empty()) {
    text += ": " + contacts_in_text(models, answer);
  } else if (answer.gap) {
    text += (answer.verdict == RobotVerdict::undecided ? ", surfaces " : ", ") +
            gap_in_text(models, *answer.gap);
  }
  if (!answer.beyond_limits.empty()) {
    text += "; out of limits: " + joints_in_text(models, answer.beyond_limits);
  }
  return text + "\n";
}

std::string totals_in_text(const RobotReport& report) {
  const RobotTotals& totals = report.totals;
  std::string text = fmt::format("{}: {} free, {} with contact", counted(totals.states, "state"),
                                 with_commas(totals.free), with_commas(totals.contact));
  if (totals.undecided != 0) {
    text += fmt::format(", {} undecided", with_commas(totals.undecided));
  }
  text += fmt::format("; {} out of limits\n", with_commas(totals.beyond_limits));
  std::vector<std::pair<std::uint64_t, RobotPair>> pairs;
  for (const auto& [pair, count] : totals.pairs) {
    pairs.emplace_back(count, pair);
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t k = 0; k < std::min(pairs.size(), kPairsInText); ++k) {
    text += fmt::format("  {}: {}\n", pair_in_text(report.models, pairs[k].second),
                        counted(pairs[k].first, "state"));
  }
  if (pairs.size() > kPairsInText) {
    text += fmt::format("  and {} more pairs\n", with_commas(pairs.size() - kPairsInText));
  }
  if (totals.least && totals.states > 1) {
    text +=
        totals.least->second.distance.upper == 0
            ? fmt::format("least gap: 0, the first time in state {}\n", totals.least->first)
            : fmt::format("least gap: {}, in state {}\n",
                          gap_in_text(report.models, totals.least->second), totals.least->first);
  }
  if (totals.least_free && totals.contact > 0) {
    text += fmt::format("least gap of the free ones: {}, in state {}\n",
                        gap_in_text(report.models, totals.least_free->second),
                        totals.least_free->first);
  }
  return text + (report.path ? path_in_text(report.models, *report.path) : std::string());
}

Json answer_as_json(const RobotModels& models, std::uint64_t state, const RobotAnswer& answer,
                    std::optional<bool> verified) {
  Json json = {{"schema", "soms.robot/1"},
               {"state", state},
               {"verdict", name(answer.verdict)},
               {"contacts", Json::array()},
               {"out_of_limits", Json::array()}};
  for (const RobotContact& contact : answer.contacts) {
    Json pair = pair_as_json(models, contact.pair);
    pair["surfaces_meet"] = contact.surfaces_meet;
    json["contacts"].push_back(std::move(pair));
  }
  for (const std::uint32_t joint : answer.beyond_limits) {
    json["out_of_limits"].push_back(models.robot.joints[joint].name);
  }
  if (answer.undecided != 0) {
    json["undecided_pairs"] = answer.undecided;
  }
  if (answer.gap) {
    json["gap"] = gap_as_json(models, *answer.gap);
  }
  json["coverage"] = name(answer.coverage);
  json["cost"] = {{"node_tests", answer.cost.node_tests},
                  {"triangle_tests", answer.cost.triangle_tests},
                  {"exact_tests", answer.cost.exact_tests}};
  if (verified) {
    json["verified"] = *verified;
  }
  return json;
}

std::optional<Error> open_warning(const RobotReport& report) {
  if (report.totals.open == 0) {
    return std::nullopt;
  }
  return Error(ErrorKind::bad_file,
               fmt::format("{} undecided: a link or the cell may be inside of a body that is not "
                           "closed, such as {}",
                           counted(report.totals.open, "state"),
                           report.models.open.empty() ? "one that its pose rounds"
                                                      : printable(report.models.open.front())),
               "close its mesh: soms info lists where it is open");
}

Json totals_as_json(const RobotReport& report) {
  const RobotTotals& totals = report.totals;
  const RobotModels& models = report.models;
  Json json = {{"schema", "soms.robot/1"},
               {"robot", models.robot.name},
               {"states", totals.states},
               {"free", totals.free},
               {"contact", totals.contact},
               {"undecided", totals.undecided},
               {"out_of_limits", totals.beyond_limits},
               {"pairs", Json::array()},
               {"joints_out_of_limits", Json::object()}};
  for (const auto& [pair, count] : totals.pairs) {
    Json row = pair_as_json(models, pair);
    row["states"] = count;
    json["pairs"].push_back(std::move(row));
  }
  for (const auto& [joint, count] : totals.limits) {
    json["joints_out_of_limits"][models.robot.joints[joint].name] = count;
  }
  if (totals.least) {
    json["least_gap"] = gap_as_json(models, totals.least->second);
    json["least_gap"]["state"] = totals.least->first;
  }
  if (totals.least_free) {
    json["least_free_gap"] = gap_as_json(models, totals.least_free->second);
    json["least_free_gap"]["state"] = totals.least_free->first;
  }
  if (report.path) {
    json["path"] = path_as_json(models, *report.path);
    json["path"]["first_contact"] = totals.first_contact ? Json(*totals.first_contact) : Json();
    json["path"]["first_undecided"] =
        totals.first_undecided ? Json(*totals.first_undecided) : Json();
  }
  json["compared"] = {{"link_pairs", models.model.compared().size()},
                      {"link_pairs_not_compared", models.model.skipped().size()},
                      {"not_compared_by", models.robot.allowed ? "srdf" : "neighbors"},
                      {"cell_parts", models.model.cell_bodies().size()},
                      {"links_on_cell", models.model.on_cell().size()}};
  json["open"] = models.open;
  json["round_error"] = models.robot.tessellation_error;
  json["coverage"] = totals.cut == 0 && (!report.path || report.path->cut == 0) &&
                             !report.timed_out && !report.interrupted
                         ? "complete"
                         : "cut";
  json["cost"] = {{"node_tests", totals.cost.node_tests},
                  {"triangle_tests", totals.cost.triangle_tests},
                  {"exact_tests", totals.cost.exact_tests}};
  for (const auto& [key, value] :
       {std::pair{"verified", report.verified}, std::pair{"timed_out", report.timed_out},
        std::pair{"interrupted", report.interrupted}}) {
    if (value) {
      json[key] = true;
    }
  }
  const std::vector<MeshView> cell(models.cell.begin(), models.cell.end());
  add_georeference(json, georeference_of(cell));
  json["notes"] = models.notes;
  json["warnings"] = warnings_json(models.warnings);
  if (const auto warning = open_warning(report)) {
    json["warnings"].push_back({{"kind", "open"}, {"message", warning->what()}});
  }
  return json;
}

std::string robot_csv_header() {
  return "state,verdict,contacts,pairs,out_of_limits,gap_lower,gap_upper,gap_a,gap_b";
}

std::string answer_as_csv(const RobotModels& models, std::uint64_t state,
                          const RobotAnswer& answer) {
  std::string pairs;
  for (const RobotContact& contact : answer.contacts) {
    pairs += (pairs.empty() ? "" : "; ") + models.model.link_names()[contact.pair.link] + " | " +
             other_label(models, contact.pair);
  }
  std::string joints;
  for (const std::uint32_t joint : answer.beyond_limits) {
    joints += (joints.empty() ? "" : "; ") + models.robot.joints[joint].name;
  }
  std::string gap = ",,,";
  if (answer.gap) {
    const RobotGap& found = *answer.gap;
    gap = fmt::format("{},{},{}", shortest(found.distance.lower), shortest(found.distance.upper),
                      pair_as_csv(models, found.pair));
  }
  return fmt::format("{},{},{},{},{},{}", state, name(answer.verdict), answer.contacts.size(),
                     csv_field(pairs), csv_field(joints), gap);
}

}  // namespace soms::command
