#include "tests/commands/run.h"
#include "tests/support/slow_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace soms::test {
namespace {

using Row = std::vector<std::string>;

std::vector<std::string> split(const std::string& line, char mark) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, mark);) {
    cells.push_back(cell);
  }
  return cells;
}

/// Rows of a CSV file by the names in its first line.
std::vector<std::map<std::string, std::string>> csv(const std::filesystem::path& path) {
  const std::vector<Row> lines = read_csv(path);
  std::vector<std::map<std::string, std::string>> rows;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    std::map<std::string, std::string>& row = rows.emplace_back();
    for (std::size_t i = 0; i < lines[k].size(); ++i) {
      row[lines[0].at(i)] = lines[k][i];
    }
  }
  return rows;
}

/// The rows "| `rule` ... | cell | ... |" of the page's table of rules, by rule in snake_case.
std::map<std::string, Row> shown_rows() {
  std::istringstream in(read_text(std::string(SOMS_DOCS) + "/rules.md"));
  std::map<std::string, Row> rows;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    inside = line.starts_with("## ") ? line == "## The rules, side by side" : inside;
    if (!inside || !line.starts_with("| `")) {
      continue;
    }
    Row cells = split(line, '|');
    std::string rule = cells.at(1).substr(2, cells[1].find('`', 2) - 2);
    std::replace(rule.begin(), rule.end(), '-', '_');
    cells.erase(cells.begin(), cells.begin() + 2);
    for (std::string& cell : cells) {
      std::erase_if(cell, [](char c) { return c == ' ' || c == ','; });
    }
    rows[rule] = cells;
  }
  return rows;
}

/// What the table must say, from the files of a run: by rule, single-triangle leaves and visits on
/// three models.
std::map<std::string, Row> measured_rows(const std::filesystem::path& tables) {
  const std::vector<std::string> models{"bunny", "u_plain", "u_mixed"};
  std::map<std::string, Row> rows;
  for (const char* const file : {"table_5_3.csv", "table_5_9.csv"}) {
    for (const auto& row : csv(tables / file)) {
      const std::string own_axis = row.at("rule") == "soms" ? "inner" : "outer";
      const auto model = std::find(models.begin(), models.end(), row.at("model"));
      if (model != models.end() && row.at("empty_side") == "stop" &&
          row.at("axis_from") == own_axis) {
        Row& cells = rows.try_emplace(row.at("rule"), 6).first->second;
        cells[static_cast<std::size_t>(model - models.begin())] = row.at("one");
      }
    }
  }
  for (const auto& row : csv(tables / "modern_visits.csv")) {
    const auto model = std::find(models.begin(), models.end(), row.at("model"));
    if (model != models.end() && row.at("options") == "product" && row.at("side [%]") == "1") {
      const double visits =
          std::stod(row.at("expected_nodes")) + std::stod(row.at("expected_triangles"));
      rows.try_emplace(row.at("rule"), 6)
          .first->second[3 + static_cast<std::size_t>(model - models.begin())] =
          fmt::format("{:.1f}", visits);
    }
  }
  return rows;
}

TEST(ReproduceDocs, EveryItemIsOnThePage) {
  const std::string page = read_text(std::string(SOMS_DOCS) + "/reproduce.md");
  std::istringstream help(soms_run({"reproduce", "--help"}).out);
  int items = 0;
  bool inside = false;
  for (std::string line; std::getline(help, line);) {
    if (inside && line.empty()) {
      break;
    }
    if (inside) {
      const std::string item = line.substr(2, line.find(' ', 2) - 2);
      EXPECT_NE(page.find("| `" + item + "` |"), std::string::npos) << item;
      ++items;
    }
    inside = inside || line == "Items:";
  }
  EXPECT_GT(items, 40);
}

TEST(ReproduceDocs, TableOfRulesIsWhatARunWrites) {
  SOMS_NEEDS_OUTSIDE_DATA("the table of rules: it needs the bunny");
  SOMS_SKIP_IN_SLOW_BUILDS();
  const TemporaryFolder folder;
  const RunResult result = soms_run({"reproduce", "--quick", "--item", "5.3,5.9,modern", "--models",
                                     outside_data("")->string(), "-o", folder.path().string()});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(shown_rows(), measured_rows(folder.path() / "tables"));
}

}  // namespace
}  // namespace soms::test
