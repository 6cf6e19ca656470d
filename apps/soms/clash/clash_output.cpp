#include "apps/soms/clash/clash_output.h"

#include "soms/base/text.h"

#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/rows/json_list.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace soms::command {

namespace {

Json json_point(const Vec3& v) {
  return {v.x, v.y, v.z};
}

/// Parts of a clash that are not closed: "a", "b".
Json open_sides(const ClashModels& models, const Clash& clash) {
  Json sides = Json::array();
  if (!models.a.parts[clash.a].closed) {
    sides.push_back("a");
  }
  if (!models.second().parts[clash.b].closed) {
    sides.push_back("b");
  }
  return sides;
}

Json by_class_as_json(const ClashCounts& counts) {
  Json by_class = Json::object();
  for (std::size_t k = 0; k < kClashKinds; ++k) {
    by_class[std::string(name(static_cast<ClashKind>(k)))] = counts[k];
  }
  return by_class;
}

std::uint64_t sum_of(const ClashCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

/// How often each pair of sets clashes: the matrix of disciplines, without its empty cells.
Json by_sets_as_json(const ClashReport& report) {
  Json cells = Json::array();
  for (const auto& [sets, counts] : counts_by_sets(report)) {
    cells.push_back({{"a", sets.first},
                     {"b", sets.second},
                     {"pairs", sum_of(counts)},
                     {"by_class", by_class_as_json(counts)}});
  }
  return cells;
}

Json by_group_as_json(const ClashReport& report) {
  Json groups = Json::array();
  for (const auto& [group, counts] : counts_by_group(report)) {
    groups.push_back(
        {{"group", group}, {"pairs", sum_of(counts)}, {"by_class", by_class_as_json(counts)}});
  }
  return groups;
}

Json totals_as_json(const ClashReport& report) {
  Json removed = Json::object();
  for (const auto& [what, count] : report.removed) {
    removed[what] = count;
  }
  Json json = {{"schema", "soms.clash/1"},
               {"pairs", report.rows.size()},
               {"by_class", by_class_as_json(report.by_kind)},
               {"removed", removed}};
  if (report.removed_by_tolerance) {
    json["unknown_depth"] = report.unknown_depth;
  }
  json["by_sets"] = by_sets_as_json(report);
  if (report.grouped) {
    json["by_group"] = by_group_as_json(report);
  }
  if (report.has_baseline) {
    json["by_status"] = {{"new", count_status(report, ClashStatus::fresh)},
                         {"active", count_status(report, ClashStatus::active)},
                         {"resolved", report.complete() ? Json(report.resolved.size()) : Json()}};
  }
  json["parts"] = {report.models.a.parts.size(), report.models.b.parts.size()};
  json["pairs_of_parts"] = report.models.pairs();
  json["compared"] = report.compared;
  if (report.resumed != 0) {
    json["resumed"] = report.resumed;
  }
  json["coverage"] = report.complete() ? "complete" : "cut";
  json["cost"] = {{"node_tests", report.cost.node_tests},
                  {"triangle_tests", report.cost.triangle_tests},
                  {"exact_tests", report.cost.exact_tests}};
  if (report.timed_out) {
    json["timed_out"] = true;
  }
  if (report.interrupted) {
    json["interrupted"] = true;
  }
  add_georeference(json, report.models.georeference);
  json["notes"] = report.models.notes;
  json["warnings"] = warnings_json(report.models.warnings);
  return json;
}

std::string number_of(const Json& row, const char* key) {
  return row.contains(key) && row[key].is_number() ? json_text(row[key]) : std::string();
}

/// A side of a row as fields of CSV: file, set, part, id, type, path.
std::string side_fields(const Json& side) {
  const auto text = [&](const char* key) {
    return side.contains(key) && side[key].is_string() ? csv_field(side[key].get<std::string>())
                                                       : std::string();
  };
  std::string path;
  if (side.contains("path") && side["path"].is_array()) {
    for (const Json& step : side["path"]) {
      path.append(path.empty() ? "" : "/");
      path.append(step.is_string() ? step.get<std::string>() : std::string());
    }
  }
  return fmt::format("{},{},{},{},{},{}", text("file"), text("set"), text("part"), text("id"),
                     text("type"), csv_field(path));
}

std::string numbers_of(const Json& row, const char* key, std::size_t count) {
  std::string text;
  for (std::size_t k = 0; k < count; ++k) {
    text += k == 0 ? "" : ",";
    if (row.contains(key) && row[key].is_array() && row[key].size() == count &&
        row[key][k].is_number()) {
      text += json_text(row[key][k]);
    }
  }
  return text;
}

std::string corners_of(const Json& row) {
  if (!row.contains("box") || !row["box"].is_array() || row["box"].size() != 2) {
    return ",,,,,";
  }
  const Json corners = {{"lower", row["box"][0]}, {"upper", row["box"][1]}};
  return numbers_of(corners, "lower", 3) + "," + numbers_of(corners, "upper", 3);
}

/// A row of CSV from one of JSON, which may be of an older list.
std::string csv_row(const Json& row, std::string_view status) {
  const auto text = [&](const char* key) {
    return row.contains(key) && row[key].is_string() ? row[key].get<std::string>() : std::string();
  };
  const Json none = Json::object();
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}", csv_field(text("class")), status,
                     csv_field(text("group")), side_fields(row.contains("a") ? row["a"] : none),
                     side_fields(row.contains("b") ? row["b"] : none), csv_field(text("relation")),
                     numbers_of(row, "gap", 2), number_of(row, "depth"),
                     number_of(row, "triangle_pairs"), numbers_of(row, "place", 3), corners_of(row),
                     csv_field(text("key")));
}

}  // namespace

std::pair<const PartBody&, const PartBody&> bodies_in(const ClashModels& models,
                                                      const Clash& clash) {
  const PartBody& a = models.a.parts[clash.a];
  const PartBody& b = models.second().parts[clash.b];
  return {body_in(clash, a, b), body_in(clash, b, a)};
}

std::uint64_t count_status(const ClashReport& report, ClashStatus status) {
  return static_cast<std::uint64_t>(
      std::count_if(report.rows.begin(), report.rows.end(),
                    [&](const ClashRow& row) { return row.status == status; }));
}

Json row_as_json(const ClashReport& report, const ClashRow& row) {
  const Clash& clash = row.clash;
  const auto [a, b] = bodies_in(report.models, clash);
  Json json = {{"schema", "soms.clash/1"},
               {"a", clash_side(report.models.a, clash.a, a)},
               {"b", clash_side(report.models.second(), clash.b, b)},
               {"class", name(clash.kind)},
               {"relation", name(clash.relation)}};
  if (clash.kind == ClashKind::undecided) {
    json["why"] = name(clash.why);
  }
  if (const Json open = open_sides(report.models, clash); !open.empty()) {
    json["open"] = open;
  }
  json["gap"] = {clash.gap.lower, clash.gap.upper};
  if (clash.penetration) {
    json["depth"] = clash.penetration->depth;
    json["direction"] = json_point(clash.penetration->direction);
  }
  json["place"] = json_point(clash.place);
  json["box"] = json_box(clash.box);
  json["triangle_pairs"] = clash.triangle_pairs;
  if (report.grouped) {
    json["group"] = row.group;
  }
  if (row.status != ClashStatus::unknown) {
    json["status"] = status_name(row.status);
  }
  json["key"] = key_text(row.key);
  return json;
}

void write_clashes_as_json(const ClashReport& report, bool verified, JsonListWriter& list) {
  for (const ClashRow& row : report.rows) {
    list.add(row_as_json(report, row));
  }
  for (Json row : report.resolved) {
    row["status"] = kResolved;
    list.add(row);
  }
  Json totals = totals_as_json(report);
  if (verified) {
    totals["verified"] = true;
  }
  list.finish(std::move(totals));
}

void write_clashes_as_csv(const ClashReport& report, std::ostream& out) {
  const GeoreferenceColumn georeference(report.models.georeference);
  out << "class,status,group,file_a,set_a,part_a,id_a,type_a,path_a,file_b,set_b,part_b,id_b,type_"
         "b,"
         "path_b,relation,gap_lower,gap_upper,depth,triangle_pairs,x,y,z,x_min,y_min,z_min,x_max,"
         "y_max,z_max,key"
      << georeference.head() << '\n';
  for (const ClashRow& row : report.rows) {
    out << csv_row(row_as_json(report, row), status_name(row.status)) << georeference.field()
        << '\n';
  }
  for (const Json& row : report.resolved) {
    out << csv_row(row, kResolved) << georeference.field() << '\n';
  }
}

}  // namespace soms::command
