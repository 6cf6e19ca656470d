#include "reproduce/report.h"

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
                    {"triangles", model.mesh->triangles.size()}});
  }
  return list;
}

Json files_of(const Entry& entry) {
  Json files = Json::array();
  for (const Table& table : entry.result.tables) {
    Json timed = Json::array();
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (table.columns[i].kind == ColumnKind::timed) {
        timed.push_back(i);
      }
    }
    files.push_back({{"file", file_of(table).generic_string()}, {"timed_columns", timed}});
  }
  for (const Figure& figure : entry.result.figures) {
    files.push_back({{"file", file_of(figure).generic_string()}, {"timed", figure.timed}});
  }
  return files;
}

Json findings_of(const Result& result) {
  Json list = Json::array();
  for (const Finding& finding : result.findings) {
    list.push_back({{"claim", finding.claim},
                    {"source", finding.source},
                    {"measured", finding.measured},
                    {"verdict", name(finding.verdict)},
                    {"reason", finding.reason},
                    {"timed", finding.timed}});
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
                     {"files", files_of(entry)},
                     {"findings", findings_of(entry.result)}});
  }
  Json missing = Json::array();
  for (const Experiment* experiment : report.missing) {
    missing.push_back(experiment->item);
  }
  const Machine& machine = report.machine;
  const Json json{{"schema", "soms.reproduce/1"},
                  {"version", machine.version},
                  {"date", report.date},
                  {"quick", report.quick},
                  {"machine",
                   {{"processor", machine.processor},
                    {"processors", machine.processors},
                    {"system", machine.system},
                    {"compiler", machine.compiler}}},
                  {"models",
                   {{"objects", models_of(report.models.objects)},
                    {"scenes", models_of(report.models.scenes)},
                    {"cities", models_of(report.models.cities)},
                    {"remarks", report.models.remarks},
                    {"files", report.model_files}}},
                  {"items", items},
                  {"golden", golden_of(report.golden)},
                  {"not_run", missing}};
  // File names may be any bytes.
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace soms::reproduce
