#include "apps/soms/simulate/simulate_passage_report.h"

#include "soms/base/words.h"

#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/soms/simulate/simulate_near_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

/// How many of the first passages are in the table and in JSON.
constexpr std::size_t kFirstPassages = 5;

/// The first of them, in order.
std::vector<PassageEvent> first_of(const std::vector<PassageEvent>& events) {
  return {events.begin(),
          events.begin() + static_cast<std::ptrdiff_t>(std::min(kFirstPassages, events.size()))};
}

/// The number in its file of the triangle that is passed.
TriangleId passed_triangle(const World& world, const PassageEvent& event) {
  const EnvironmentPassage& passage = event.passage;
  return event.between_movers() ? passage.j : world.numbers[passage.part](passage.j);
}

}  // namespace

void add_passage_figures(Figures& figures, const World& world, const Outcome& outcome) {
  const std::vector<PassageEvent>& events = outcome.passages.events();
  const std::uint64_t between = outcome.passages.between_movers();
  figures.emplace_back(
      "passages", events.empty()
                      ? std::string("none")
                      : fmt::format("{} on the way from frame to frame ({} with "
                                    "models of the city, {} between movers)",
                                    with_commas(events.size()),
                                    with_commas(events.size() - between), with_commas(between)));
  std::string name = "first of them";
  for (const PassageEvent& event : first_of(events)) {
    const EnvironmentPassage& passage = event.passage;
    figures.emplace_back(
        std::exchange(name, ""),
        fmt::format("{} and {}: {} after {:.4g} of the way to frame {}",
                    mover_name(world, passage.mover),
                    event.between_movers() ? mover_name(world, event.other)
                                           : part_name(world, passage.part, passage.j),
                    soms::name(passage.verdict), passage.t.lower, with_commas(event.frame)));
  }
}

std::string passages_verified(const VerifiedPassages& verified) {
  return fmt::format("{} and {} without one by brute force, {} wrong",
                     counted(verified.passages, "passage"), counted(verified.free, "pair"),
                     with_commas(verified.wrong));
}

void add_passage_json(Json& json, const World& world, const Outcome& outcome) {
  const std::vector<PassageEvent>& events = outcome.passages.events();
  json["swept"] = true;
  json["passages"] = events.size();
  json["passages_between_movers"] = outcome.passages.between_movers();
  json["first_passages"] = Json::array();
  for (const PassageEvent& event : first_of(events)) {
    const EnvironmentPassage& passage = event.passage;
    Json row = bodies_json(
        world,
        {.mover = passage.mover, .part = passage.part, .other = event.other, .j = passage.j});
    row["frame"] = event.frame;
    row["verdict"] = soms::name(passage.verdict);
    row["lower"] = passage.t.lower;
    row["upper"] = passage.t.upper;
    row["triangles"] = Json::array({passage.i, passed_triangle(world, event)});
    row["point"] = point_json(passage.point);
    json["first_passages"].push_back(std::move(row));
  }
}

void write_passages(std::ostream& out, const World& world, const Outcome& outcome,
                    std::string_view empty) {
  const CityParts parts(world);
  const GeoreferenceColumn georeference(world.georeference);
  for (const PassageEvent& event : outcome.passages.events()) {
    const EnvironmentPassage& passage = event.passage;
    out << "passage,";
    write_bodies(
        out, world, parts,
        {.mover = passage.mover, .part = passage.part, .other = event.other, .j = passage.j});
    out << fmt::format(",{0},{0},1,,,,{1},{2},{3}", event.frame, passage.point.x, passage.point.y,
                       passage.point.z)
        << empty
        << fmt::format(",{},{},{},{},{}", soms::name(passage.verdict), passage.t.lower,
                       passage.t.upper, passage.i, passed_triangle(world, event))
        << georeference.field() << '\n';
  }
}

}  // namespace soms::command
