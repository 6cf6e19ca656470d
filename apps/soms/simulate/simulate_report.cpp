#include "apps/soms/simulate/simulate_report.h"

#include "soms/base/text.h"

#include "apps/cli/machine_use.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/model/models.h"
#include "apps/output/json.h"
#include "apps/soms/simulate/simulate_events.h"
#include "apps/soms/simulate/simulate_near_report.h"
#include "apps/soms/simulate/simulate_passage_report.h"
#include "apps/world/route_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace soms::command {

namespace {

std::string row(const std::string& name, const std::string& value, const Terminal& terminal) {
  constexpr std::size_t kValues = 14;
  return wrap_words(fmt::format("{:<14}{}", name, printable(value)), terminal.width, kValues) +
         "\n";
}

std::string whole_number(double number) {
  return with_commas(static_cast<std::uint64_t>(std::llround(number)));
}

/// "1,000 (400 cars of 1,000 triangles, 400 persons of ...)"; a file's name has no plural: "2 (1 of
/// car, 3,460 triangles; 1 of van, 9,995 triangles)".
std::string movers_of(const World& world) {
  std::vector<std::uint64_t> counts(world.models.size(), 0);
  for (const MoverRoute& mover_route : world.routes) {
    ++counts[mover_route.model];
  }
  std::string kinds;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const Model& model = world.models[k];
    const std::string triangles = counted(model.shape.mesh().triangles.size(), "triangle");
    if (model.kind == Kind::model) {
      kinds += fmt::format("{}{} of {}, {}", k == 0 ? "" : "; ", with_commas(counts[k]), model.name,
                           triangles);
    } else {
      kinds +=
          fmt::format("{}{} of {}", k == 0 ? "" : ", ", counted(counts[k], model.name), triangles);
    }
  }
  std::string text = fmt::format("{} ({})", with_commas(world.routes.size()), kinds);
  if (world.routes.size() < world.requested) {
    text +=
        fmt::format("; {} requested, no free position for the rest", with_commas(world.requested));
  }
  return text;
}

std::string contacts_of(const World& world, const Outcome& outcome) {
  const std::uint64_t all = outcome.contacts.contacts().size();
  const std::uint64_t between = outcome.contacts.between_movers();
  if (all == 0) {
    return "none (surfaces only: a mover entirely inside a closed building touches nothing)";
  }
  return fmt::format("{} ({} with triangles of the city, {} between movers) by {} of {}",
                     with_commas(all), with_commas(all - between), with_commas(between),
                     with_commas(outcome.contacts.movers()), counted(world.routes.size(), "mover"));
}

std::string events_in_text(const Outcome& outcome) {
  const std::uint64_t all = outcome.events.spans().size();
  const std::uint64_t between = between_movers(outcome.events.spans());
  return fmt::format("in {} ({} with parts of the city, {} between movers)", counted(all, "event"),
                     with_commas(all - between), with_commas(between));
}

std::string frames_of(const World& world, const Outcome& outcome, const SimulateOptions& options) {
  std::string text = with_commas(outcome.frames);
  if (outcome.ending != Ending::whole) {
    text += fmt::format(" of {}, {}", with_commas(options.frames),
                        outcome.ending == Ending::interrupted ? "interrupted" : "out of time");
  }
  text += fmt::format(" ({:.4g} s of simulated time)",
                      static_cast<double>(outcome.frames) / kFramesASecond);
  if (!options.frames_given && options.frames == longest_poses(world)) {
    text += ", one for each row of the longest route";
  }
  return text;
}

void add_most_touched(Figures& figures, const World& world, const Outcome& outcome) {
  std::string name = "most touched";
  for (const Touched& touched : outcome.contacts.most_touched(kMostTouched)) {
    figures.emplace_back(std::exchange(name, ""),
                         name_of(world, touched) + ": " + counts_of(touched));
  }
}

const char* ending_name(Ending ending) {
  return ending == Ending::whole ? "complete" : "cut";
}

double rounded(double value) {
  return std::round(value * 100) / 100;
}

}  // namespace

std::string name_of(const World& world, const Touched& touched) {
  return fmt::format("triangle {} of {}", world.numbers[touched.part](touched.triangle),
                     part_name(world, touched.part, touched.triangle));
}

std::string counts_of(const Touched& touched) {
  const std::string times = touched.contacts == 1   ? "once"
                            : touched.contacts == 2 ? "twice"
                                                    : with_commas(touched.contacts) + " times";
  return fmt::format("touched {}, for {}{}", times, counted(touched.frames, "frame"),
                     touched.contacts == 1 ? "" : " in all");
}

Figures figures_of(const World& world, const Outcome& outcome, const SimulateOptions& options) {
  Figures figures;
  figures.emplace_back("city",
                       fmt::format("{}, {}", world.title, counted(world.triangles, "triangle")));
  if (!world.georeference.empty()) {
    figures.emplace_back("georeference", printable(describe(world.georeference)));
  }
  figures.emplace_back(
      "built in", fmt::format("{:.0f} ms, after {:.0f} ms to {} it", world.build_ms, world.read_ms,
                              options.world.cities.empty() ? "make" : "read"));
  figures.emplace_back("movers", movers_of(world));
  figures.emplace_back("frames", frames_of(world, outcome, options));
  figures.emplace_back(
      "speed", fmt::format("{} frames a second (worst {}), {} queries a second",
                           whole_number(outcome.median_fps()), whole_number(outcome.worst_fps()),
                           whole_number(outcome.queries_a_second())));
  if (outcome.share_of_others.value_or(0) > kBusyShare) {
    figures.emplace_back(
        "", fmt::format("other programs used {:.0f} % of the processors: times are too long",
                        100 * *outcome.share_of_others));
  }
  figures.emplace_back("contacts", contacts_of(world, outcome));
  if (!outcome.events.spans().empty()) {
    figures.emplace_back("", events_in_text(outcome));
  }
  if (!world.filter.between) {
    figures.emplace_back("not tested", "movers against each other (--no-between-movers)");
  } else if (!world.filter.ignored.empty()) {
    figures.emplace_back(
        "not tested", counted(world.filter.ignored.size(), "pair") + " of movers (--ignore-pair)");
  }
  add_most_touched(figures, world, outcome);
  if (options.clearance > 0) {
    add_near_figures(figures, world, outcome, options);
  }
  if (options.swept) {
    add_passage_figures(figures, world, outcome);
  }
  if (outcome.verified) {
    const Verified& v = *outcome.verified;
    figures.emplace_back(
        "verified", fmt::format("{} of bodies and {} by brute force, {} wrong",
                                counted(v.contacts, "touching pair"), counted(v.free, "free mover"),
                                with_commas(v.wrong)));
  }
  if (outcome.verified_gaps) {
    figures.emplace_back("verified gaps", gaps_verified(*outcome.verified_gaps));
  }
  if (outcome.verified_passages) {
    figures.emplace_back("and between", passages_verified(*outcome.verified_passages));
  }
  return figures;
}

std::string table_of(const World& world, const Outcome& outcome, const SimulateOptions& options,
                     const Terminal& terminal, bool hints) {
  std::string text;
  for (const auto& [name, value] : figures_of(world, outcome, options)) {
    const std::string line = row(name, value, terminal);
    const bool touches = !outcome.contacts.contacts().empty();
    text += name == "contacts" ? terminal.paint(line.substr(0, line.size() - 1),
                                                ink_of(touches, outcome.ending != Ending::whole)) +
                                     "\n"
                               : line;
  }
  if (hints && options.map.empty() && options.report.empty() && options.picture.empty()) {
    text += row("see it", "add -o city.svg to draw the city and its contacts, or --view", terminal);
  }
  for (const auto& [name, path] :
       {Figure("map", options.map), Figure("report", options.report),
        Figure("events", options.events), Figure("contacts in", options.contacts),
        Figure("answer", options.answer), Figure("recording", options.record),
        Figure("picture", options.picture)}) {
    if (!path.empty()) {
      text += row(name, path, terminal);
    }
  }
  return text;
}

std::string json_of(const World& world, const Outcome& outcome, const SimulateOptions& options) {
  Json json;
  json["schema"] = "soms.simulate/1";
  json["city"] = world.title;
  json["triangles"] = world.triangles;
  json["movers"] = world.routes.size();
  json["movers_requested"] = world.requested;
  json["frames"] = outcome.frames;
  json["frames_requested"] = options.frames;
  json["coverage"] = ending_name(outcome.ending);
  json["interrupted"] = outcome.ending == Ending::interrupted;
  json["fps"] = {{"median", rounded(outcome.median_fps())},
                 {"worst", rounded(outcome.worst_fps())}};
  json["share_of_others"] =
      outcome.share_of_others ? Json(rounded(*outcome.share_of_others)) : Json(nullptr);
  json["build_ms"] = rounded(world.build_ms);
  json["read_ms"] = rounded(world.read_ms);
  json["queries"] = outcome.queries;
  json["queries_a_second"] = std::round(outcome.queries_a_second());
  json["cost"] = {{"node_tests", outcome.cost.node_tests},
                  {"triangle_tests", outcome.cost.triangle_tests},
                  {"exact_tests", outcome.cost.exact_tests}};
  json["contacts"] = outcome.contacts.contacts().size();
  json["contacts_between_movers"] = outcome.contacts.between_movers();
  json["events"] = outcome.events.spans().size();
  json["events_between_movers"] = between_movers(outcome.events.spans());
  json["between_movers"] = world.filter.between;
  json["ignored_pairs"] = world.filter.ignored.size();
  json["hash"] = fmt::format("{:016x}", outcome.hash);
  json["most_touched"] = Json::array();
  for (const Touched& touched : outcome.contacts.most_touched(kMostTouched)) {
    json["most_touched"].push_back({{"city", world.city[touched.part].name},
                                    {"part", part_name(world, touched.part, touched.triangle)},
                                    {"triangle", world.numbers[touched.part](touched.triangle)},
                                    {"contacts", touched.contacts},
                                    {"mover_frames", touched.frames}});
  }
  add_georeference(json, world.georeference);
  if (!world.notes.empty()) {
    json["notes"] = world.notes;
  }
  if (!world.warnings.empty()) {
    json["warnings"] = warnings_json(world.warnings);
  }
  if (outcome.verified) {
    json["verified"] = {{"contacts", outcome.verified->contacts},
                        {"free", outcome.verified->free},
                        {"wrong", outcome.verified->wrong}};
  }
  if (outcome.verified_gaps) {
    json["verified_gaps"] = {{"near", outcome.verified_gaps->near},
                             {"free", outcome.verified_gaps->free},
                             {"wrong", outcome.verified_gaps->wrong}};
  }
  if (outcome.verified_passages) {
    json["verified_passages"] = {{"passages", outcome.verified_passages->passages},
                                 {"free", outcome.verified_passages->free},
                                 {"wrong", outcome.verified_passages->wrong}};
  }
  if (options.clearance > 0) {
    add_near_json(json, world, outcome, options);
  }
  if (options.swept) {
    add_passage_json(json, world, outcome);
  }
  return json_line(json);
}

}  // namespace soms::command
