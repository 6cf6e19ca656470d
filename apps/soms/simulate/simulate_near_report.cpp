#include "apps/soms/simulate/simulate_near_report.h"

#include "soms/base/text.h"

#include "apps/cli/text.h"
#include "apps/model/georeference.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

/// The number in its file of the triangle of the other body.
TriangleId other_triangle(const World& world, const NearEvent& event) {
  return event.between_movers() ? event.j : world.numbers[event.part](event.j);
}

std::string other_name(const World& world, const NearEvent& event) {
  return event.between_movers() ? mover_name(world, event.other)
                                : part_name(world, event.part, event.j);
}

}  // namespace

std::string meters_in_text(double meters) {
  return four_digits(meters) + " m";
}

Json point_json(const Vec3& point) {
  return Json::array({point.x, point.y, point.z});
}

Json bodies_json(const World& world, const NamedBodies& bodies) {
  Json row{{"mover", bodies.mover}, {"model", model_name(world, bodies.mover)}};
  if (bodies.part == Contact::kMover) {
    row["other_mover"] = bodies.other;
    row["other_model"] = model_name(world, bodies.other);
  } else {
    row["city"] = world.city[bodies.part].name;
    row["part"] = part_name(world, bodies.part, bodies.j);
  }
  return row;
}

void add_near_figures(Figures& figures, const World& world, const Outcome& outcome,
                      const SimulateOptions& options) {
  const std::uint64_t all = outcome.near.events().size();
  const std::uint64_t between = outcome.near.between_movers();
  std::string text = fmt::format("none within {}", meters_in_text(options.clearance));
  if (all > 0) {
    text = fmt::format(
        "{} within {} ({} with models of the city, {} between movers), {} of them "
        "without a touch",
        with_commas(all), meters_in_text(options.clearance), with_commas(all - between),
        with_commas(between), with_commas(outcome.near.without_touch()));
  }
  figures.emplace_back("near", std::move(text));
  std::string name = "nearest";
  for (const std::size_t k : outcome.near.nearest(kMostTouched)) {
    const NearEvent& event = outcome.near.events()[k];
    figures.emplace_back(std::exchange(name, ""),
                         fmt::format("{} and {}: {} in frame {}", mover_name(world, event.mover),
                                     other_name(world, event), meters_in_text(event.distance.lower),
                                     with_commas(event.nearest)));
  }
}

std::string gaps_verified(const VerifiedGaps& verified) {
  return fmt::format("{} and {} by brute force, {} wrong", counted(verified.near, "near mover"),
                     counted(verified.free, "other mover"), with_commas(verified.wrong));
}

void add_near_json(Json& json, const World& world, const Outcome& outcome,
                   const SimulateOptions& options) {
  json["clearance"] = options.clearance;
  json["near"] = outcome.near.events().size();
  json["near_between_movers"] = outcome.near.between_movers();
  json["near_without_contact"] = outcome.near.without_touch();
  json["nearest"] = Json::array();
  for (const std::size_t k : outcome.near.nearest(kMostTouched)) {
    const NearEvent& event = outcome.near.events()[k];
    Json row = bodies_json(
        world, {.mover = event.mover, .part = event.part, .other = event.other, .j = event.j});
    row["begin"] = event.begin;
    row["end"] = event.end;
    row["frame"] = event.nearest;
    row["lower"] = event.distance.lower;
    row["upper"] = event.distance.upper;
    row["triangles"] = Json::array({event.i, other_triangle(world, event)});
    row["points"] = Json::array({point_json(event.point_a), point_json(event.point_b)});
    json["nearest"].push_back(std::move(row));
  }
}

void write_bodies(std::ostream& out, const World& world, const CityParts& parts,
                  const NamedBodies& bodies) {
  out << bodies.mover << ',' << csv_field(model_name(world, bodies.mover)) << ',';
  if (bodies.part == Contact::kMover) {
    out << "mover " << bodies.other << ',' << csv_field(model_name(world, bodies.other));
  } else {
    out << csv_field(world.city[bodies.part].name) << ','
        << csv_field(parts.name(bodies.part, bodies.j));
  }
}

void write_near_events(std::ostream& out, const World& world, const Outcome& outcome,
                       std::string_view behind) {
  const CityParts parts(world);
  const GeoreferenceColumn georeference(world.georeference);
  for (const NearEvent& event : outcome.near.events()) {
    out << "near,";
    write_bodies(out, world, parts,
                 {.mover = event.mover, .part = event.part, .other = event.other, .j = event.j});
    out << fmt::format(",{},{},{},,,,,,,{},{},{},{},{}", event.begin, event.end,
                       event.end - event.begin + 1, event.distance.lower, event.distance.upper,
                       event.nearest, event.i, other_triangle(world, event));
    if (event.touches()) {
      out << ",,,,,,";
    } else {
      const Vec3& a = event.point_a;
      const Vec3& b = event.point_b;
      out << fmt::format(",{},{},{},{},{},{}", a.x, a.y, a.z, b.x, b.y, b.z);
    }
    out << behind << georeference.field() << '\n';
  }
}

void add_near(report::Page& page, const World& world, const Outcome& outcome,
              const SimulateOptions& options) {
  const std::uint64_t all = outcome.near.without_touch();
  const std::size_t most = report::SceneLimits().gaps;
  report::Table table{
      .title = fmt::format("Near, within {}, without a touch", meters_in_text(options.clearance)),
      .columns = {"mover", "near to", "least gap", "in frame", "from", "to", "point on the mover",
                  "nearest point"},
      .rows = {},
      .caption = "The nearest first. What touches in these frames is among the contacts.",
      .of_gaps = true};
  if (all > most) {
    table.caption = fmt::format("The nearest {} of {}, the nearest first; -o FILE.csv lists all.",
                                with_commas(most), with_commas(all));
  }
  const CityParts parts(world);
  const auto bodies = static_cast<std::uint32_t>(world.city.size());  // of the city, before movers
  for (const std::size_t k : outcome.near.nearest(most)) {
    const NearEvent& event = outcome.near.events()[k];
    table.rows.push_back(
        {mover_name(world, event.mover),
         event.between_movers() ? mover_name(world, event.other) : parts.name(event.part, event.j),
         meters_in_text(event.distance.lower), with_commas(event.nearest), with_commas(event.begin),
         with_commas(event.end), point_in_text(event.point_a), point_in_text(event.point_b)});
    page.scene.gaps.push_back({.a = bodies + event.mover,
                               .b = event.between_movers() ? bodies + event.other : event.part,
                               .begin = event.begin,
                               .end = event.end,
                               .nearest = event.nearest,
                               .point_a = event.point_a,
                               .point_b = event.point_b,
                               .length = meters_in_text(event.distance.lower)});
  }
  if (page.scene.rows.empty() && !table.rows.empty()) {
    const std::vector<std::string>& nearest = table.rows.front();
    page.lead += fmt::format(" The nearest: {} and {}, {} apart in frame {}.", nearest[0],
                             nearest[1], nearest[2], nearest[3]);
  }
  page.scene.gaps_in_all = all;
  page.tables.push_back(std::move(table));
}

}  // namespace soms::command
