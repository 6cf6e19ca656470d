#include "thesis/run/traversal_tables.h"

#include "thesis/trips/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace soms::reproduce {

Cell count_cell(std::uint64_t count) {
  return static_cast<std::int64_t>(count);
}

Cell number_cell(double number) {
  return number;
}

Cell word_cell(std::string_view words) {
  return std::string(words);
}

Cell yes_cell(bool yes) {
  return word_cell(yes ? "yes" : "no");
}

const Contender& build_named(std::span<const Contender> builds, std::string_view name) {
  return *std::find_if(builds.begin(), builds.end(),
                       [&](const Contender& build) { return build.name == name; });
}

void add_count_columns(Table& table) {
  for (const char* const name :
       {"box_tests", "entered", "leaf_pairs", "triangle_pairs", "first_tests", "max_stack"}) {
    table.columns.push_back({name});
  }
}

void add_count_cells(std::vector<Cell>& row, const TraversalCounts& counts) {
  for (const std::uint64_t count : {counts.box_tests, counts.entered, counts.leaf_pairs,
                                    counts.triangle_pairs, counts.first_tests, counts.max_stack}) {
    row.push_back(count_cell(count));
  }
}

void add_statistics_columns(Table& table) {
  for (const char* const name : {"mean", "median", "min", "max"}) {
    table.columns.push_back({name, "", ColumnKind::timed});
  }
}

void add_statistics_cells(std::vector<Cell>& row, const std::vector<double>& numbers) {
  if (numbers.empty()) {
    row.resize(row.size() + 4);
    return;
  }
  const Timing summary = summarize(numbers);
  for (const double number : {summary.mean, summary.median, summary.min, summary.max}) {
    row.emplace_back(number);
  }
}

Cell rate_cell(double milliseconds) {
  return milliseconds > 0 ? number_cell(1000 / milliseconds) : Cell{};
}

void add_rate_cells(std::vector<Cell>& row, const std::vector<double>& milliseconds) {
  if (milliseconds.empty()) {
    row.resize(row.size() + 4);
    return;
  }
  const Timing summary = summarize(milliseconds);
  for (const double ms : {summary.mean, summary.median, summary.max, summary.min}) {
    row.push_back(rate_cell(ms));
  }
}

void add_estimate_columns(Table& table, std::string_view unit) {
  for (const char* const name : {"median", "low", "high"}) {
    table.columns.push_back({name, std::string(unit), ColumnKind::timed});
  }
}

void add_estimate_cells(std::vector<Cell>& row, std::span<const double> rounds, int processes) {
  if (rounds.empty()) {
    row.resize(row.size() + 3);
    return;
  }
  const Estimate time = estimate(rounds, processes);
  for (const double number : {time.value, time.interval.low, time.interval.high}) {
    row.emplace_back(number);
  }
}

std::vector<double> medians_where_roots_overlap(std::span<const Timing> timings,
                                                std::span<const Frame> frames) {
  std::vector<double> medians;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (frames[k].roots_overlap && !timings[k].rounds.empty()) {
      medians.push_back(timings[k].median);
    }
  }
  return medians;
}

std::string id_word(std::string_view name, std::size_t number) {
  const bool fit = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
  return fit ? std::string(name) : fmt::format("model{}", number);
}

double mean_of(std::span<const double> numbers) {
  return numbers.empty() ? 0
                         : std::accumulate(numbers.begin(), numbers.end(), 0.0) /
                               static_cast<double>(numbers.size());
}

std::string object_remark(const Model& object) {
  return object.stand_in
             ? fmt::format(
                   "The moving object is {}, a stand-in for that of the thesis: its counts are "
                   "not those of the bunny.",
                   object.title)
             : fmt::format("The moving object is the {}.", object.title);
}

std::vector<std::string> object_remarks(std::span<const Model> objects) {
  std::vector<std::string> remarks;
  for (const Model& object : objects) {
    remarks.push_back(
        object.stand_in
            ? fmt::format("{}: {}, a stand-in for that of the thesis, whose counts are others.",
                          object.name, object.title)
            : fmt::format("{}: the {}.", object.name, object.title));
  }
  if (objects.size() > 1) {
    remarks.push_back(fmt::format(
        "In the orientation tests each object comes at its like, as it is stored, y upwards. In "
        "drives {} is {:g} times as large as its file; the others are as long as it is then, above "
        "the same place (ours: the thesis says of one object only that it drives).",
        objects.front().name, kDriveScale));
  }
  return remarks;
}

std::vector<std::string> scene_remarks(std::span<const Model> scenes) {
  std::vector<std::string> remarks;
  for (const Model& scene : scenes) {
    remarks.push_back(
        fmt::format("{}: {}, {} triangles, put in the place of the urban scene of "
                    "the thesis, which is not available.",
                    scene.name, scene.title, scene.mesh->triangles.size()));
  }
  return remarks;
}

void require(bool agree, std::string_view what) {
  if (!agree) {
    throw std::logic_error(fmt::format("{} disagree: a fault of soms, please report it", what));
  }
}

}  // namespace soms::reproduce
