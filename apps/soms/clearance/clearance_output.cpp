#include "apps/soms/clearance/clearance_output.h"

#include "soms/base/text.h"

#include "apps/cli/length_unit.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/rows/json_list.h"
#include "apps/soms/pairs/near_output.h"
#include "apps/world/map_page.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace soms::command {

namespace {

/// Lines of the table: as many as a person reads at once.
constexpr std::size_t kLinesInText = 24;
/// Stretches below the clearance that the summary names.
constexpr std::size_t kRunsInText = 5;

/// Some stretches that follow each other.
struct TableLine {
  std::size_t first = 0;
  std::size_t last = 0;
  double at_least = std::numeric_limits<double>::infinity();
  ClearanceStation least;
  ClearanceVerdict verdict = ClearanceVerdict::ok;
};

/// The length of which each line holds the stretches that begin in it: round, and not too short.
double length_of_line(const ClearanceReport& report) {
  double length = report.options.every;
  while (report.length() / length > static_cast<double>(kLinesInText)) {
    length = round_length(2.6 * length);  // 1, 2, 5, 10
  }
  return length;
}

std::vector<TableLine> table_lines(const ClearanceReport& report) {
  const Clearance& answer = report.answer;
  const double length = answer.stretches.size() <= kLinesInText ? 0 : length_of_line(report);
  std::vector<TableLine> lines;
  double end = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < answer.stretches.size(); ++k) {
    const double from = answer.stations[k].chainage - answer.stations.front().chainage;
    if (length == 0 || from >= end) {
      lines.push_back({.first = k, .last = k, .least = answer.stretches[k].least});
      end = length == 0 ? 0 : length * (std::floor(from / length * (1 + 1e-12)) + 1);
    }
    TableLine& line = lines.back();
    const ClearanceStretch& stretch = answer.stretches[k];
    line.last = k;
    line.at_least = std::min(line.at_least, stretch.at_least);
    line.verdict = worse(line.verdict, verdict(stretch, report.options.clearance));
    if (stretch.least.gap.upper < line.least.gap.upper) {
      line.least = stretch.least;
    }
  }
  return lines;
}

std::string chainage_text(double chainage) {
  return fmt::format("{:.2f}", chainage);
}

std::string length_in_words(double length, double unit) {
  return fmt::format("{} {}", four_digits(length), unit_name(unit));
}

std::string table_in_text(const ClearanceReport& report, const NearestNames& names) {
  constexpr const char* kForm = "{:>10} {:>10}  {:>10}  {:>10}  {:>10}  {:<9}  {}";
  std::string text = table_line(fmt::format(kForm, "from", "to", "least gap", "at least",
                                            "at chainage", "verdict", "nearest"));
  for (const TableLine& line : table_lines(report)) {
    const Clearance& answer = report.answer;
    text += table_line(fmt::format(kForm, chainage_text(answer.stations[line.first].chainage),
                                   chainage_text(answer.stations[line.last + 1].chainage),
                                   four_digits(line.least.gap.lower), four_digits(line.at_least),
                                   chainage_text(line.least.chainage), name(line.verdict),
                                   names.text(line.least)));
  }
  return text;
}

/// "contact from 12.5 to 14; below from 3 to 5; and 2 more", the worst first.
std::string runs_in_text(const ClearanceReport& report) {
  std::vector<VerdictRun> runs = verdict_runs(report);
  std::erase_if(runs, [](const VerdictRun& run) { return run.verdict == ClearanceVerdict::ok; });
  std::stable_sort(runs.begin(), runs.end(), [](const VerdictRun& a, const VerdictRun& b) {
    return a.verdict != b.verdict && worse(a.verdict, b.verdict) == a.verdict;
  });
  std::string text;
  for (std::size_t k = 0; k < std::min(runs.size(), kRunsInText); ++k) {
    text += fmt::format("{}{} from {} to {}", k == 0 ? "" : "; ", name(runs[k].verdict),
                        chainage_text(report.answer.stations[runs[k].first].chainage),
                        chainage_text(report.answer.stations[runs[k].last + 1].chainage));
  }
  return runs.size() > kRunsInText
             ? text + fmt::format("; and {} more", with_commas(runs.size() - kRunsInText))
             : text;
}

Json point_as_json(const Vec3& p) {
  return Json::array({p.x, p.y, p.z});
}

Json finite_or_null(double x) {
  return std::isfinite(x) ? Json(x) : Json();
}

/// Gap, nearest and points of a place.
void add_gap(Json& json, const ClearanceStation& station, const NearestNames& names) {
  json["lower"] = finite_or_null(station.gap.lower);
  json["upper"] = finite_or_null(station.gap.upper);
  json["overlap"] = station.overlaps();
  json["nearest"] = names.json(station);
  if (station.triangles) {
    json["triangles"] = Json::array({station.triangles->a, names.triangle(station)});
    json["points"] = Json::array({point_as_json(station.point_a), point_as_json(station.point_b)});
  }
}

/// The row of the file that a station is of, or none.
std::optional<std::size_t> row_of(const ClearanceReport& report, const ClearanceStation& station) {
  if (station.t > 0 && station.t < 1) {
    return std::nullopt;
  }
  return report.path.rows[station.segment + (station.t >= 1 ? 1 : 0)];
}

Vec3 place_of(const ClearanceReport& report, const ClearanceStation& station) {
  return station.pose.apply(report.path.motion.pivot);
}

Json stretch_as_json(const ClearanceReport& report, std::size_t k, const NearestNames& names) {
  const ClearanceStretch& stretch = report.answer.stretches[k];
  Json least{{"chainage", stretch.least.chainage}};
  add_gap(least, stretch.least, names);
  Json json{{"at_least", finite_or_null(stretch.at_least)},
            {"verdict", name(verdict(stretch, report.options.clearance))},
            {"least", std::move(least)}};
  if (report.options.clearance > 0) {
    json["below"] = Json::array({stretch.below.lower, stretch.below.upper});
  }
  json["queries"] = stretch.queries;
  return json;
}

Json station_as_json(const ClearanceReport& report, std::size_t k, const NearestNames& names) {
  const ClearanceStation& station = report.answer.stations[k];
  const std::optional<std::size_t> row = row_of(report, station);
  Json json{{"schema", "soms.clearance/1"},
            {"station", k},
            {"chainage", station.chainage},
            {"at", point_as_json(place_of(report, station))},
            {"row", row ? Json(*row) : Json()}};
  add_gap(json, station, names);
  json["verdict"] = name(verdict(station, report.options.clearance));
  json["to_next"] = k < report.answer.stretches.size() ? stretch_as_json(report, k, names) : Json();
  return json;
}

Json totals_of_clearance(const ClearanceReport& report, const NearestNames& names) {
  const Clearance& answer = report.answer;
  const ClearanceOptions& options = report.options;
  Json least{{"chainage", answer.least.chainage}};
  add_gap(least, answer.least, names);
  Json json{{"schema", "soms.clearance/1"},
            {"profile", report.profile().shape.mesh().source},
            {"path", report.path_file},
            {"only", report.only},
            {"ignored", report.ignored},
            {"stations", answer.stations.size()},
            {"length", report.length()},
            {"every", options.every},
            {"accuracy", options.accuracy},
            {"clearance", options.clearance > 0 ? Json(options.clearance) : Json()},
            {"verdict", name(report.verdict())},
            {"least", std::move(least)},
            {"at_least", finite_or_null(answer.at_least)},
            {"first_contact", nullptr}};
  if (answer.first_contact) {
    Json contact{{"free_until", answer.first_contact->free_until},
                 {"chainage", answer.first_contact->station.chainage}};
    add_gap(contact, answer.first_contact->station, names);
    json["first_contact"] = std::move(contact);
  }
  if (options.clearance > 0) {
    json["below"] = Json::array({answer.below.lower, answer.below.upper});
  }
  json["runs"] = Json::array();
  for (const VerdictRun& run : verdict_runs(report)) {
    json["runs"].push_back({{"verdict", name(run.verdict)},
                            {"from", answer.stations[run.first].chainage},
                            {"to", answer.stations[run.last + 1].chainage}});
  }
  json["queries"] = answer.queries;
  json["coverage"] = name(answer.coverage);
  json["cost"] = {{"node_tests", answer.cost.node_tests},
                  {"triangle_tests", answer.cost.triangle_tests},
                  {"exact_tests", answer.cost.exact_tests}};
  for (const auto& [key, value] :
       {std::pair{"verified", report.verified}, std::pair{"timed_out", report.timed_out},
        std::pair{"interrupted", report.interrupted}}) {
    if (value) {
      json[key] = true;
    }
  }
  add_georeference(json, report.world.georeference);
  json["notes"] = report.world.notes;
  json["warnings"] = warnings_json(report.world.warnings);
  return json;
}

}  // namespace

double ClearanceReport::length() const {
  return answer.stations.empty()
             ? 0
             : answer.stations.back().chainage - answer.stations.front().chainage;
}

ClearanceVerdict ClearanceReport::verdict() const {
  ClearanceVerdict all = ClearanceVerdict::ok;
  for (const ClearanceStation& station : answer.stations) {
    all = worse(all, soms::verdict(station, options.clearance));
  }
  for (const ClearanceStretch& stretch : answer.stretches) {
    all = worse(all, soms::verdict(stretch, options.clearance));
  }
  return all;
}

ClearanceVerdict worse(ClearanceVerdict a, ClearanceVerdict b) {
  for (const ClearanceVerdict worst :
       {ClearanceVerdict::contact, ClearanceVerdict::below, ClearanceVerdict::undecided}) {
    if (a == worst || b == worst) {
      return worst;
    }
  }
  return ClearanceVerdict::ok;
}

std::vector<VerdictRun> verdict_runs(const ClearanceReport& report) {
  std::vector<VerdictRun> runs;
  for (std::size_t k = 0; k < report.answer.stretches.size(); ++k) {
    const ClearanceVerdict found = verdict(report.answer.stretches[k], report.options.clearance);
    if (runs.empty() || runs.back().verdict != found) {
      runs.push_back({found, k, k});
    }
    runs.back().last = k;
  }
  return runs;
}

const Part* NearestNames::part(const ClearanceStation& station) const {
  const auto body = static_cast<EnvironmentId>(*station.body);
  const std::uint32_t number = parts_.number(body, station.triangles->b);
  return number == Part::kNoParent ? nullptr : &world_.city[body].shape.mesh().parts[number];
}

std::string NearestNames::text(const ClearanceStation& station) const {
  if (!station.body) {
    return {};
  }
  const Body& body = world_.city[*station.body];
  const Part* const found = part(station);
  std::string label = found == nullptr ? "" : found->name.empty() ? found->id : found->name;
  if (label.empty()) {
    return printable(body.name);
  }
  if (!found->type.empty()) {
    label = found->type + " " + label;
  }
  return printable(label + " of " + body.name);
}

Json NearestNames::json(const ClearanceStation& station) const {
  if (!station.body) {
    return nullptr;
  }
  const Part* const found = part(station);
  const auto text_of = [&](const std::string Part::*field) {
    return found == nullptr || (found->*field).empty() ? Json() : Json(found->*field);
  };
  return {{"file", world_.city[*station.body].shape.mesh().source},
          {"part", text_of(&Part::name)},
          {"id", text_of(&Part::id)},
          {"type", text_of(&Part::type)}};
}

std::string NearestNames::csv(const ClearanceStation& station) const {
  if (!station.body) {
    return ",,,";
  }
  const Part* const found = part(station);
  return fmt::format("{},{},{},{}", csv_field(world_.city[*station.body].shape.mesh().source),
                     found == nullptr ? "" : csv_field(found->name),
                     found == nullptr ? "" : csv_field(found->id), triangle(station));
}

std::string gap_in_text(const Bracket& gap, double unit) {
  if (!std::isfinite(gap.lower)) {
    return "nothing near";
  }
  return gap.upper == 0 ? "contact" : length_in_words(gap.lower, unit);
}

std::vector<std::pair<std::string, std::string>> clearance_figures(const ClearanceReport& report,
                                                                   const NearestNames& names) {
  const Clearance& answer = report.answer;
  const ClearanceOptions& options = report.options;
  std::vector<std::pair<std::string, std::string>> figures;
  figures.emplace_back(
      "path",
      fmt::format("{} {} long, {}, one every {}; {} places queried", chainage_text(report.length()),
                  unit_name(report.unit), counted(answer.stations.size(), "station"),
                  length_with_unit(options.every, report.unit), with_commas(answer.queries)));
  if (!report.world.georeference.empty()) {
    figures.emplace_back("georeference", printable(describe(report.world.georeference)));
  }
  if (!report.only.empty()) {
    figures.emplace_back("only", printable(fmt::format("{}", fmt::join(report.only, ", "))));
  }
  if (!report.ignored.empty()) {
    figures.emplace_back("left out", printable(fmt::format("{}", fmt::join(report.ignored, ", "))));
  }
  if (answer.stations.empty()) {
    return figures;
  }
  const std::string nearest = names.text(answer.least);
  figures.emplace_back(
      "least gap",
      fmt::format("{} at chainage {}{}; proved: at least {} everywhere",
                  gap_in_text(answer.least.gap, report.unit), chainage_text(answer.least.chainage),
                  nearest.empty() ? "" : ", " + nearest, four_digits(answer.at_least)));
  if (answer.first_contact) {
    figures.emplace_back("first contact",
                         fmt::format("at chainage {}, {}; proved free until {}",
                                     chainage_text(answer.first_contact->station.chainage),
                                     names.text(answer.first_contact->station),
                                     chainage_text(answer.first_contact->free_until)));
  } else {
    figures.emplace_back("first contact",
                         answer.at_least > 0
                             ? "none on the way, proved"
                             : fmt::format("none found; a gap of less than {} is not excluded",
                                           length_with_unit(options.accuracy, report.unit)));
  }
  if (options.clearance > 0) {
    figures.emplace_back(
        fmt::format("below {}", length_with_unit(options.clearance, report.unit)),
        fmt::format("{} to {} of {}", chainage_text(answer.below.lower),
                    chainage_text(answer.below.upper), chainage_text(report.length())));
  }
  figures.emplace_back("verdict", name(report.verdict()));
  if (const std::string runs = runs_in_text(report); !runs.empty()) {
    figures.back().second += ": " + runs;
  }
  return figures;
}

std::string clearance_in_text(const ClearanceReport& report, const NearestNames& names) {
  std::string text = report.answer.stretches.empty() ? "" : table_in_text(report, names) + "\n";
  for (const auto& [name, value] : clearance_figures(report, names)) {
    text += fmt::format("{:<16} {}\n", name, value);
  }
  return text;
}

void write_clearance_as_json(const ClearanceReport& report, const NearestNames& names,
                             JsonListWriter& list) {
  for (std::size_t k = 0; k < report.answer.stations.size(); ++k) {
    list.add(station_as_json(report, k, names));
  }
  list.finish(totals_of_clearance(report, names));
}

std::string clearance_as_csv(const ClearanceReport& report, const NearestNames& names) {
  const GeoreferenceColumn georeference(report.world.georeference);
  std::string text =
      "station,chainage,row,x,y,z,lower,upper,verdict,file,part,id,triangle,profile_triangle,"
      "ax,ay,az,bx,by,bz,next_at_least,next_verdict,next_least,next_least_chainage,"
      "next_least_file,next_least_part,next_least_id,next_least_triangle";
  text.append(georeference.head()).append("\n");
  const Clearance& answer = report.answer;
  const auto point = [](const ClearanceStation& station, const Vec3& p) {
    return station.triangles ? fmt::format("{},{},{}", p.x, p.y, p.z) : std::string(",,");
  };
  for (std::size_t k = 0; k < answer.stations.size(); ++k) {
    const ClearanceStation& station = answer.stations[k];
    const std::optional<std::size_t> row = row_of(report, station);
    const Vec3 at = place_of(report, station);
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}", k, station.chainage,
                        row ? std::to_string(*row) : "", at.x, at.y, at.z,
                        shortest(station.gap.lower), shortest(station.gap.upper),
                        name(verdict(station, report.options.clearance)), names.csv(station),
                        station.triangles ? std::to_string(station.triangles->a) : "",
                        point(station, station.point_a), point(station, station.point_b));
    if (k < answer.stretches.size()) {
      const ClearanceStretch& stretch = answer.stretches[k];
      text += fmt::format(",{},{},{},{},{}", shortest(stretch.at_least),
                          name(verdict(stretch, report.options.clearance)),
                          shortest(stretch.least.gap.lower), stretch.least.chainage,
                          names.csv(stretch.least));
    } else {
      text += ",,,,,,,,";
    }
    text.append(georeference.field()).append("\n");
  }
  return text;
}

}  // namespace soms::command
