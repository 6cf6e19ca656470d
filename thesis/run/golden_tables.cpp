#include "thesis/run/golden_tables.h"

#include "soms/base/error.h"
#include "soms/thesis/thesis_frames.h"
#include "soms/tree/option_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>

namespace soms::reproduce {

namespace {

constexpr std::string_view kDrive = "drive";
constexpr int kDeepest = 24;

/// What is wrong with a row; the reader adds the place.
Error wrong(std::string what) {
  return Error(ErrorKind::bad_file, std::move(what), "");
}

Error wrong_line(const std::filesystem::path& path, std::size_t line, const std::string& what) {
  return Error(ErrorKind::bad_file, fmt::format("{}, line {}: {}", path.string(), line, what),
               "take the golden tables of this version of soms, from its tests/data/thesis");
}

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> cells;
  for (std::size_t comma = line.find(','); comma != std::string_view::npos;
       comma = line.find(',')) {
    cells.emplace_back(line.substr(0, comma));
    line.remove_prefix(comma + 1);
  }
  cells.emplace_back(line);
  return cells;
}

/// Calls `take` for each row after the first, which has the names of the columns.
template <class Take>
void read_rows(const std::filesystem::path& folder, const GoldenLayout& layout, const Take& take) {
  const std::filesystem::path path = folder / layout.file;
  std::ifstream in(path);
  if (!in || !std::filesystem::is_regular_file(path)) {
    throw Error(ErrorKind::cannot_open, fmt::format("cannot open {}", path.string()),
                fmt::format("give a folder with {} and {}, such as tests/data/thesis",
                            golden_trees().file, golden_traversals().file));
  }
  GoldenRow row;
  for (std::string line; std::getline(in, line);) {
    ++row.line;
    row.cells = split(line.substr(0, line.find('\r')));
    if (row.line == 1 && !std::equal(row.cells.begin(), row.cells.end(), layout.columns.begin(),
                                     layout.columns.end())) {
      throw wrong_line(path, row.line,
                       fmt::format("the columns are not {}", fmt::join(layout.columns, ",")));
    }
    if (row.cells.size() != layout.columns.size()) {
      throw wrong_line(
          path, row.line,
          fmt::format("{} cells in place of {}", row.cells.size(), layout.columns.size()));
    }
    try {
      if (row.line > 1) {
        take(row);
      }
    } catch (const Error& error) {
      throw wrong_line(path, row.line, error.place());
    }
  }
  if (row.line == 0) {
    throw wrong_line(path, 1, "the file is empty");
  }
}

int level_of(const std::string& cell) {
  int level = 0;
  const char* const end = cell.data() + cell.size();
  const auto [stop, fault] = std::from_chars(cell.data(), end, level);
  if (fault != std::errc() || stop != end || level < 1 || level > kDeepest) {
    throw wrong(fmt::format("level \"{}\" is not a number from 1 to {}", cell, kDeepest));
  }
  return level;
}

Contender rule_of_thesis(std::string_view name, int level) {
  for (const Contender& rule : thesis_rules(level)) {
    if (rule.name == name) {
      return rule;
    }
  }
  throw wrong(fmt::format("no rule of the thesis is named \"{}\"", name));
}

void check_model(std::string_view name) {
  if (std::none_of(kGoldenHashes.begin(), kGoldenHashes.end(),
                   [&](const auto& entry) { return entry.first == name; })) {
    throw wrong(fmt::format("no golden model is named \"{}\"", name));
  }
}

std::optional<Approach> approach_named(std::string_view name) {
  const auto* const found =
      std::find_if(kAllApproaches.begin(), kAllApproaches.end(),
                   [&](const auto& approach) { return approach.second == name; });
  return found == kAllApproaches.end() ? std::nullopt : std::optional(found->first);
}

GoldenTree tree_of(const GoldenRow& row) {
  const std::string& model = row.cells[0];
  check_model(model);
  Contender build = rule_of_thesis(row.cells[2], level_of(row.cells[6]));
  build.options.midpoint = midpoint_named(row.cells[3]);
  build.options.axis_from = axis_from_named(row.cells[4]);
  build.options.empty_side = empty_side_named(row.cells[5]);
  return {row, model, std::move(build)};
}

GoldenTraversal traversal_of(const GoldenRow& row) {
  GoldenTrip trip{row.cells[0], row.cells[1], row.cells[2], row.cells[3]};
  const std::string enlarged = fmt::format("{:g}", kDriveScale);  // "bunny500" drives
  if (trip.test == kDrive && trip.moving.ends_with(enlarged)) {
    trip.moving.resize(trip.moving.size() - enlarged.size());
  }
  check_model(trip.still);
  check_model(trip.moving);
  static_cast<void>(rule_of_thesis(trip.rule, kObjectLevel));
  if (trip.test != kDrive && (!approach_named(trip.test) || trip.still != trip.moving)) {
    throw wrong(fmt::format("no test \"{}\" of {} past {}", trip.test, trip.moving, trip.still));
  }
  const std::vector<NamedTraversal> known = all_traversals();
  const auto named = std::find_if(known.begin(), known.end(), [&](const NamedTraversal& one) {
    return one.name == row.cells[4];
  });
  if (named == known.end()) {
    throw wrong(fmt::format("no traversal is named \"{}\"", row.cells[4]));
  }
  return {row, std::move(trip), *named};
}

}  // namespace

const GoldenLayout& golden_trees() {
  static const GoldenLayout layout{
      "thesis_counts.csv",
      {"model", "triangles", "rule", "midpoint", "axis_from", "empty_side", "level", "nodes",
       "leaves", "one", "lt5", "undividable", "capped", "empty", "depth", "min_leaf_depth",
       "max_leaf_depth", "largest_leaf", "balanced_level"},
      7};
  return layout;
}

const GoldenLayout& golden_traversals() {
  static const GoldenLayout layout{
      "thesis_traversal.csv",
      {"static", "moving", "rule", "test", "algorithm", "frames", "root_overlap_frames",
       "hit_frames", "box_tests", "entered", "leaf_pairs", "triangle_pairs", "first_tests"},
      5};
  return layout;
}

GoldenTables read_golden(const std::filesystem::path& folder) {
  GoldenTables tables;
  read_rows(folder, golden_trees(),
            [&](const GoldenRow& row) { tables.trees.push_back(tree_of(row)); });
  read_rows(folder, golden_traversals(),
            [&](const GoldenRow& row) { tables.traversals.push_back(traversal_of(row)); });
  return tables;
}

Trip made(const GoldenTrip& trip, const Model& still, const Model& moving) {
  const Contender of_object = rule_of_thesis(trip.rule, kObjectLevel);
  return trip.test == kDrive
             ? drive_trip(still, moving, rule_of_thesis(trip.rule, kSceneLevel), of_object)
             : orientation_trip(moving, approach_named(trip.test).value(), of_object);
}

}  // namespace soms::reproduce
