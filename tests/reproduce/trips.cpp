#include "tests/reproduce/trips.h"

#include "soms/generate/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

namespace soms::reproduce::trips {

namespace {

Model model(std::string name, Mesh mesh) {
  Model model;
  model.name = name;
  model.title = name + " (stand-in)";
  model.stand_in = true;
  model.hash = corner_hash(mesh);
  model.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return model;
}

}  // namespace

std::vector<std::string_view> traversal_items() {
  return {"table-3.2",        "figure-3.8",         "figure-4.35",        "figure-5.6",
          "figure-5.7",       "figure-5.8",         "figure-5.9",         "figure-5.10",
          "traversals",       "orientation-bottom", "orientation-front",  "orientation-back",
          "drives",           "drives-drawn",       "claim-enode-faster", "claim-enode-earlier",
          "claim-enode-time", "readings-e-node"};
}

Models small_models() {
  // The drive goes along y = 2000 from x = -200 to 4200; the mover is 500 times as large.
  Mesh ball = transformed(generate_sphere(80), 400, UpAxis::z);
  for (Vec3& v : ball.vertices) {
    v += {2000, 2300, 0};
  }
  Models models;
  models.objects.push_back(model("bunny", transformed(generate_knot(60), 0.25, UpAxis::z)));
  models.scenes.push_back(model("ball", std::move(ball)));
  return models;
}

Models two_objects() {
  Models models = small_models();
  models.objects.push_back(model("venus", generate_sphere(40)));
  fit_drives(models.objects);
  return models;
}

Result run_quick(std::string_view item, const Models& models) {
  const std::vector<const Experiment*> named = experiments_named(std::span(&item, 1));
  return named.front()->run({.models = models, .quick = true});
}

const Table& table_of(const Result& result, std::string_view id) {
  const auto table = std::find_if(result.tables.begin(), result.tables.end(),
                                  [&](const Table& entry) { return entry.id == id; });
  if (table == result.tables.end()) {
    throw std::runtime_error("no table " + std::string(id));
  }
  return *table;
}

std::string cell(const Table& table, std::size_t row, std::string_view column) {
  const auto place = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& entry) { return entry.name == column; });
  if (place == table.columns.end()) {
    throw std::runtime_error("no column " + std::string(column));
  }
  const Cell& found =
      table.rows.at(row).at(static_cast<std::size_t>(place - table.columns.begin()));
  if (const auto* words = std::get_if<std::string>(&found)) {
    return *words;
  }
  const auto* count = std::get_if<std::int64_t>(&found);
  return count == nullptr ? "" : std::to_string(*count);
}

std::string masked_csv(Table table) {
  for (auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (table.columns[i].kind == ColumnKind::timed) {
        row[i] = std::monostate{};
      }
    }
  }
  return to_csv(table);
}

}  // namespace soms::reproduce::trips
