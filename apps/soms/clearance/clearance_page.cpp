#include "apps/soms/clearance/clearance_page.h"

#include "apps/cli/text.h"
#include "apps/draw/chart.h"
#include "apps/report/page.h"
#include "apps/soms/answers/page_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

/// Points of a line of the plot, and places in the table, at most.
constexpr std::size_t kPointsOfPlot = 800;
constexpr std::size_t kPlacesInTable = 200;
constexpr std::uint64_t kPosesOfPage = 4000;

report::Plot plot_of_gaps(const ClearanceReport& report) {
  const Clearance& answer = report.answer;
  const std::size_t width = answer.stretches.size() / kPointsOfPlot + 1;
  reproduce::LineChart chart{
      .title = "Gap along the path", .x_label = "chainage", .y_label = "gap", .markers = false};
  reproduce::Line found{.name = "least gap"};
  reproduce::Line proved{.name = "at least, proved"};
  for (std::size_t k = 0; k < answer.stretches.size(); k += width) {
    double least = std::numeric_limits<double>::infinity();
    double bound = least;
    for (std::size_t i = k; i < std::min(answer.stretches.size(), k + width); ++i) {
      least = std::min(least, answer.stretches[i].least.gap.lower);
      bound = std::min(bound, answer.stretches[i].at_least);
    }
    const double from = answer.stations[k].chainage;
    const double to = answer.stations[std::min(answer.stretches.size(), k + width)].chainage;
    for (const auto& [line, y] : {std::pair(&found, least), std::pair(&proved, bound)}) {
      line->x.push_back(0.5 * (from + to));
      line->y.push_back(y);
    }
  }
  const double first = found.x.front();
  const double last = found.x.back();
  chart.lines = {std::move(found), std::move(proved)};
  if (report.options.clearance > 0) {
    chart.lines.push_back({.name = "clearance",
                           .x = {first, last},
                           .y = {report.options.clearance, report.options.clearance},
                           .dashed = true});
  }
  return plot(reproduce::draw(chart),
              width == 1 ? "The least gap from each station to the next: the least that was found, "
                           "and the bound that holds for all the motion."
                         : fmt::format("The least of {} stretches each: the least gap that was "
                                       "found, and the bound that holds for all the motion.",
                                       width));
}

/// Numbers of the stations with the least gaps, the nearest first.
std::vector<std::size_t> nearest_stations(const Clearance& answer, std::size_t most) {
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < answer.stations.size(); ++k) {
    if (answer.stations[k].triangles) {
      numbers.push_back(k);
    }
  }
  std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
    return answer.stations[a].gap.upper < answer.stations[b].gap.upper;
  });
  numbers.resize(std::min(most, numbers.size()));
  return numbers;
}

report::Table table_of_stations(const ClearanceReport& report, const NearestNames& names,
                                const std::vector<std::size_t>& numbers) {
  const Clearance& answer = report.answer;
  report::Table table{.title = "Nearest stations",
                      .columns = {"station", "chainage", "gap", "nearest", "verdict",
                                  "at least to the next", "point on the profile", "nearest point"},
                      .rows = {},
                      .caption = "The nearest come first. -o FILE.csv lists all stations.",
                      .of_gaps = true};
  for (const std::size_t k : numbers) {
    const ClearanceStation& station = answer.stations[k];
    table.rows.push_back(
        {with_commas(k), fmt::format("{:.2f}", station.chainage),
         gap_in_text(station.gap, report.unit), names.text(station),
         std::string(name(verdict(station, report.options.clearance))),
         k < answer.stretches.size() ? four_digits(answer.stretches[k].at_least) : "",
         point_in_text(station.point_a), point_in_text(station.point_b)});
  }
  return table;
}

/// Stations where the profile touches a body, each body as a row.
void add_contacts(report::Scene& scene, const ClearanceReport& report) {
  const Clearance& answer = report.answer;
  const auto profile = static_cast<std::uint32_t>(report.world.city.size());
  std::map<std::size_t, std::size_t> rows;  // by body
  for (std::size_t k = 0; k < answer.stations.size(); ++k) {
    const ClearanceStation& station = answer.stations[k];
    if (!station.overlaps()) {
      continue;
    }
    const auto body = static_cast<std::uint32_t>(*station.body);
    const auto [row, added] = rows.try_emplace(body, scene.rows.size());
    if (added) {
      scene.rows.push_back({.a = profile, .b = body, .begin = k, .first = *station.triangles});
    }
    report::SceneRow& known = scene.rows[row->second];
    ++known.count;
    ++known.steps;
    known.end = k;
    known.box.grow(station.point_a);
    ++scene.contacts_in_all;
    if (scene.contacts.size() < report::SceneLimits().contacts) {
      scene.contacts.push_back({.row = row->second,
                                .a = profile,
                                .b = body,
                                .begin = k,
                                .end = k,
                                .pairs = {*station.triangles},
                                .pairs_in_all = 1});
    }
  }
}

report::Scene scene_of_path(const ClearanceReport& report,
                            const std::vector<std::size_t>& nearest) {
  const Clearance& answer = report.answer;
  report::Scene scene;
  for (const Body& body : report.world.city) {
    scene.bodies.push_back({.model = scene.models.size(), .name = body.name, .moves = false});
    const FileNumbers& numbers = report.world.numbers[scene.models.size()];
    scene.models.push_back({body.shape.mesh(), body.name, numbers.list()});
  }
  const auto profile = static_cast<std::uint32_t>(scene.bodies.size());
  const Model& model = report.profile();
  scene.bodies.push_back({.model = scene.models.size(), .name = model.name, .moves = true});
  scene.models.push_back({model.shape.mesh(), model.name});
  scene.contact = {"station with contact", "stations with contact"};
  scene.complete = answer.coverage == Coverage::complete;
  add_contacts(scene, report);
  const std::uint64_t count = answer.stations.size();
  scene.steps = {
      .count = count, .noun = "station", .kept = report::spread_steps(count, kPosesOfPage)};
  for (const std::size_t k : nearest) {
    const ClearanceStation& station = answer.stations[k];
    scene.gaps.push_back({.a = profile,
                          .b = static_cast<std::uint32_t>(*station.body),
                          .begin = k,
                          .end = k,
                          .nearest = k,
                          .point_a = station.point_a,
                          .point_b = station.point_b,
                          .length = gap_in_text(station.gap, report.unit)});
    scene.steps.kept.push_back(k);
  }
  std::sort(scene.steps.kept.begin(), scene.steps.kept.end());
  scene.steps.kept.erase(std::unique(scene.steps.kept.begin(), scene.steps.kept.end()),
                         scene.steps.kept.end());
  scene.gaps_in_all = count;
  scene.pose = [&report](std::uint32_t body, std::uint64_t step) {
    return body < report.world.city.size() ? report.world.city[body].pose
                                           : report.answer.stations[step].pose;
  };
  return scene;
}

}  // namespace

namespace {

/// The verdict, and the least gap with its place.
std::string lead_of_path(const ClearanceReport& report, const NearestNames& names) {
  const Clearance& answer = report.answer;
  if (answer.stations.empty()) {
    return "No station was reached.";
  }
  if (answer.first_contact) {
    return fmt::format(
        "Verdict: {}. {} first touches {} at chainage {:.2f}; free until {:.2f}, proved.",
        name(report.verdict()), report.profile().name, names.text(answer.first_contact->station),
        answer.first_contact->station.chainage, answer.first_contact->free_until);
  }
  const std::string nearest = names.text(answer.least);
  const std::string gap = gap_in_text(answer.least.gap, report.unit);
  return fmt::format(
      "Verdict: {}. {} comes as near as {}{} at chainage {:.2f}; at least {} is proved everywhere.",
      name(report.verdict()), report.profile().name, gap,
      nearest.empty() ? std::string() : " to " + nearest, answer.least.chainage,
      four_digits(answer.at_least));
}

}  // namespace

void write_clearance_page(std::ostream& out, const ClearanceReport& report,
                          const NearestNames& names) {
  report::Page page{
      .title = fmt::format("{} along a path in {}", report.profile().name, report.world.title),
      .lead = lead_of_path(report, names),
      .facts = {},
      .plots = {},
      .notes = {}};
  for (const auto& [name, value] : clearance_figures(report, names)) {
    page.facts.push_back({name, value});
  }
  if (report.verified) {
    page.facts.push_back({"verified", "stations and bounds, by brute force"});
  }
  for (const std::string& note : report.world.notes) {
    page.facts.push_back({"note", note});
  }
  for (const FrameWarning& warning : report.world.warnings) {
    page.warnings.push_back(warning.text());
  }
  if (report.answer.coverage == Coverage::cut) {
    page.notes.emplace_back("This run ended early; the page shows the stations that were done.");
  }
  page.notes.emplace_back(
      "Gaps are exact at each station; between stations a bound is proved. Only surfaces are "
      "compared: a profile entirely inside a closed building touches nothing. "
      "The picture may be simplified; the answers never are.");
  if (!report.answer.stretches.empty()) {
    page.beside.push_back(plot_of_gaps(report));
  }
  const std::vector<std::size_t> nearest = nearest_stations(report.answer, kPlacesInTable);
  if (!nearest.empty()) {
    page.tables.push_back(table_of_stations(report, names, nearest));
  }
  if (!report.answer.stations.empty()) {
    page.scene = scene_of_path(report, nearest);
  }
  report::write_page(out, page);
}

}  // namespace soms::command
