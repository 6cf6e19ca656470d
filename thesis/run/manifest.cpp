#include "thesis/claims/nearest_verdict.h"
#include "thesis/page/latex.h"
#include "thesis/page/report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace soms::reproduce {

namespace {

using Json = nlohmann::ordered_json;

Json models_of(const std::vector<Model>& models) {
  Json list = Json::array();
  for (const Model& model : models) {
    list.push_back({{"name", model.name},
                    {"title", model.title},
                    {"file", model.file.empty() ? Json(nullptr) : Json(model.file)},
                    {"stand_in", model.stand_in},
                    {"trouble", model.trouble.empty() ? Json(nullptr) : Json(model.trouble)},
                    {"triangles", model.mesh->triangles.size()},
                    {"corner_hash", fmt::format("{:016x}", model.hash)},
                    {"bytes", model.bytes == 0 ? Json(nullptr) : Json(model.bytes)},
                    {"sha256", model.sha256.empty() ? Json(nullptr) : Json(model.sha256)}});
  }
  return list;
}

Json averages_of(const LoadAverages& averages) {
  return averages ? Json(*averages) : Json(nullptr);
}

Json load_of(const Load& load) {
  const std::vector<std::string> signs = signs_of_load(load);
  return {{"busy", !signs.empty()},
          {"signs", signs},
          {"start", averages_of(load.start)},
          {"end", averages_of(load.end)},
          {"processors", load.processors},
          {"timed_seconds", load.timed_seconds},
          {"timed_processor_seconds", load.timed_processor_seconds}};
}

Json machine_of(const Machine& machine) {
  return {{"processor", machine.processor},
          {"processors", machine.processors},
          {"usable_processors", machine.usable_processors},
          {"instruction_set", machine.instruction_set},
          {"memory", machine.memory == 0 ? Json(nullptr) : Json(machine.memory)},
          {"system", machine.system},
          {"compiler", machine.compiler}};
}

Json files_of(const Entry& entry, bool latex) {
  Json files = Json::array();
  for (const Table& table : entry.result.tables) {
    Json timed = Json::array();
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (table.columns[i].kind == ColumnKind::timed) {
        timed.push_back(i);
      }
    }
    files.push_back({{"file", file_of(table).generic_string()}, {"timed_columns", timed}});
    if (latex) {
      files.back()["latex"] = latex_file_of(table).generic_string();
    }
  }
  for (const Figure& figure : entry.result.figures) {
    files.push_back({{"file", file_of(figure).generic_string()}, {"timed", figure.timed}});
  }
  return files;
}

Json part_json(const NearestPart& part) {
  return {{"verdict", name(part.stand)},
          {"rows", part.rows.judged()},
          {"hold", part.rows.hold},
          {"subjects", part.rows.subjects}};
}

Json nearest_json(const NearestVerdict& nearest) {
  const NearestRows& rows = nearest.rows;
  return {{"options", nearest.options},
          {"why", nearest.why},
          {"verdict", name(nearest.stand)},
          {"rows", rows.judged()},
          {"hold", rows.hold},
          {"undecided", rows.open},
          {"fail", rows.fail},
          {"subjects", rows.subjects},
          {"counted", part_json(nearest.counted)},
          {"measured", part_json(nearest.measured)},
          {"share", rows.judged() == 0 ? Json(nullptr)
                                       : Json::array({nearest.share.low, nearest.share.high})}};
}

Json claims_of(const Result& result) {
  Json list = Json::array();
  for (const Claim& claim : result.claims) {
    const OnStandIns stand_ins = on_stand_ins(claim);
    const JudgedRows rows = judged_rows(claim);
    list.push_back({{"id", claim.id},
                    {"claim", claim.statement},
                    {"source", claim.source},
                    {"scope", name(claim.scope)},
                    {"nearest", nearest_json(nearest_of(claim))},
                    {"verdict", name(verdict_of(claim))},
                    {"where", where(claim)},
                    {"on_stand_ins", {{"rows", stand_ins.rows}, {"hold", stand_ins.hold}}},
                    {"rows", claim.rows.size()},
                    {"judged", rows.judged},
                    {"hold", rows.hold},
                    {"matrix", file_of(claim_table(claim)).generic_string()},
                    {"timed", is_timed(claim)}});
  }
  return list;
}

Json golden_of(const std::optional<GoldenComparison>& golden) {
  if (!golden) {
    return nullptr;
  }
  Json files = Json::array();
  for (const GoldenFile& file : golden->files) {
    files.push_back({{"file", file.file},
                     {"rows", file.rows},
                     {"compared", file.compared},
                     {"equal", file.compared - file.different},
                     {"different", file.different}});
  }
  Json differences = Json::array();
  for (const GoldenDifference& difference : golden->differences) {
    differences.push_back({{"file", difference.file},
                           {"line", difference.line},
                           {"row", difference.row},
                           {"difference", difference.what}});
  }
  Json not_given = Json::array();
  for (const NotGiven& model : golden->not_given) {
    not_given.push_back({{"model", model.model}, {"rows", model.rows}});
  }
  return {{"files", files},
          {"differences", differences},
          {"models_not_given", not_given},
          {"whole", golden->whole},
          {"seconds", golden->seconds}};
}

}  // namespace

std::string manifest(const Report& report) {
  Json items = Json::array();
  for (const Entry& entry : report.entries) {
    items.push_back({{"item", entry.experiment->item},
                     {"title", entry.experiment->title},
                     {"seconds", entry.seconds},
                     {"processor_seconds", entry.processor_seconds},
                     {"files", files_of(entry, report.latex)},
                     {"claims", claims_of(entry.result)}});
  }
  Json missing = Json::array();
  for (const Experiment* experiment : report.missing) {
    missing.push_back(experiment->item);
  }
  const Machine& machine = report.machine;
  const Json json{{"schema", "soms.reproduce/1"},
                  {"version", machine.version},
                  {"commit", machine.commit},
                  {"command", report.command},
                  {"date", report.date},
                  {"ended", report.ended},
                  {"seconds", report.seconds},
                  {"processor_seconds", report.processor_seconds},
                  {"quick", report.quick},
                  {"build", {{"type", machine.build_type}, {"flags", machine.flags}}},
                  {"machine", machine_of(machine)},
                  {"load", load_of(report.load)},
                  {"models",
                   {{"objects", models_of(report.models.objects)},
                    {"scenes", models_of(report.models.scenes)},
                    {"cities", models_of(report.models.cities)},
                    {"remarks", report.models.remarks},
                    {"files", report.model_files}}},
                  {"latex", report.latex ? Json(kLatexOfAll) : Json(nullptr)},
                  {"items", items},
                  {"golden", golden_of(report.golden)},
                  {"not_run", missing}};
  // File names may be any bytes.
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace soms::reproduce
