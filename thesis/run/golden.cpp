#include "thesis/run/golden.h"

#include "soms/base/error.h"
#include "soms/base/text.h"

#include "thesis/run/counts.h"
#include "thesis/run/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace soms::reproduce {

namespace {

/// "leaves 9, here 8; one 3, here 4" for the counts that differ. \shape `counts` as the columns
/// after the keys.
std::string difference_of(const GoldenRow& row, const GoldenLayout& layout,
                          const std::vector<std::string>& counts) {
  std::string words;
  for (std::size_t k = layout.keys; k < layout.columns.size(); ++k) {
    const std::string& here = counts[k - layout.keys];
    if (row.cells[k] != here) {
      words += fmt::format("{}{} {}, here {}", words.empty() ? "" : "; ", layout.columns[k],
                           row.cells[k], here);
    }
  }
  return words;
}

/// What was counted, in words.
std::string model_name(const GoldenRow& row, const GoldenLayout& layout) {
  std::string words;
  for (std::size_t k = 0; k < layout.keys; ++k) {
    words += fmt::format("{}{}{}", words.empty() ? "" : " ",
                         layout.columns[k] == "level" ? "level " : "", row.cells[k]);
  }
  return words;
}

/// The models that are there, by their golden names.
class Present {
 public:
  explicit Present(const Models& models) {
    for (const auto& [name, hash] : kGoldenHashes) {
      for (const auto* const kind : {&models.objects, &models.scenes, &models.cities}) {
        for (const Model& model : *kind) {
          if (model.hash == hash) {
            models_.emplace(name, &model);
          }
        }
      }
    }
  }

  /// nullptr if it is not there.
  [[nodiscard]] const Model* operator()(const std::string& name) const {
    const auto found = models_.find(name);
    return found == models_.end() ? nullptr : found->second;
  }

 private:
  std::map<std::string, const Model*, std::less<>> models_;
};

/// Models that are not there, with their rows, in the order of kGoldenHashes.
std::vector<NotGiven> missing(const GoldenTables& tables, const Present& present) {
  std::map<std::string, std::size_t, std::less<>> rows;
  for (const GoldenTree& tree : tables.trees) {
    rows[tree.model] += present(tree.model) == nullptr ? 1U : 0U;
  }
  for (const GoldenTraversal& traversal : tables.traversals) {
    const GoldenTrip& trip = traversal.trip;
    const std::string& lacking = present(trip.still) == nullptr ? trip.still : trip.moving;
    rows[lacking] += present(lacking) == nullptr ? 1U : 0U;
  }
  std::vector<NotGiven> found;
  for (const auto& [name, hash] : kGoldenHashes) {
    const auto of_model = rows.find(name);
    if (of_model != rows.end() && of_model->second > 0) {
      found.push_back({of_model->first, of_model->second});
    }
  }
  return found;
}

std::vector<std::string> golden_counts(const Counted& counted) {
  const GoldenLayout& layout = golden_trees();
  std::vector<std::string> counts;
  for (const Cell& cell : cells_of(counted, std::span(layout.columns).subspan(layout.keys))) {
    counts.push_back(std::to_string(std::get<std::int64_t>(cell)));
  }
  return counts;
}

std::vector<std::string> golden_counts(const Totals& sums) {
  std::vector<std::string> counts;
  for (const std::uint64_t count :
       {sums.frames, sums.root_overlap_frames, sums.hit_frames, sums.counts.box_tests,
        sums.counts.entered, sums.counts.leaf_pairs, sums.counts.triangle_pairs,
        sums.counts.first_tests}) {
    counts.push_back(std::to_string(count));
  }
  return counts;
}

/// Counts rows and notes what differs.
class Comparer {
 public:
  Comparer(const GoldenTables& tables, const Models& models, const Limits& limits,
           GoldenComparison& found)
      : tables_(tables),
        present_(models),
        steps_(limits, tables.trees.size() + tables.traversals.size()),
        found_(found) {
    found_.files = {{std::string(golden_trees().file), tables.trees.size()},
                    {std::string(golden_traversals().file), tables.traversals.size()}};
    found_.not_given = missing(tables, present_);
  }

  void compare() {
    for (const GoldenTree& tree : tables_.trees) {
      if (const Model* const model = present_(tree.model)) {
        judge(0, golden_trees(), tree.row,
              golden_counts(count(*model, tree.build, steps_.quiet())));
      }
      steps_.done_one();
    }
    std::map<GoldenTrip, std::vector<const GoldenTraversal*>> trips;
    for (const GoldenTraversal& traversal : tables_.traversals) {
      trips[traversal.trip].push_back(&traversal);
    }
    for (const auto& [key, traversals] : trips) {
      compare_trip(key, traversals);
    }
  }

 private:
  void compare_trip(const GoldenTrip& key, const std::vector<const GoldenTraversal*>& traversals) {
    const Model* const still = present_(key.still);
    const Model* const moving = present_(key.moving);
    std::optional<Trip> trip;
    if (still != nullptr && moving != nullptr) {
      trip = made(key, *still, *moving);
    }
    for (const GoldenTraversal* const traversal : traversals) {
      if (trip) {
        judge(1, golden_traversals(), traversal->row,
              golden_counts(totals(traverse_frames(*trip, traversal->traversal, steps_.quiet()))));
      }
      steps_.done_one();
    }
  }

  void judge(std::size_t file, const GoldenLayout& layout, const GoldenRow& row,
             const std::vector<std::string>& counts) {
    ++found_.files[file].compared;
    std::string what = difference_of(row, layout, counts);
    if (what.empty()) {
      return;
    }
    ++found_.files[file].different;
    if (found_.differences.size() < kMostDifferences) {
      found_.differences.push_back(
          {std::string(layout.file), row.line, model_name(row, layout), std::move(what)});
    }
  }

  const GoldenTables& tables_;
  Present present_;
  Steps steps_;
  GoldenComparison& found_;
};

std::size_t sum(const std::vector<GoldenFile>& files, std::size_t GoldenFile::*part) {
  return std::accumulate(
      files.begin(), files.end(), std::size_t{0},
      [&](std::size_t so_far, const GoldenFile& file) { return so_far + file.*part; });
}

/// "venus (1,248), teapot (1,248)".
std::string list_of(const std::vector<NotGiven>& models) {
  std::string list;
  for (const NotGiven& model : models) {
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", model.model, words(model.rows));
  }
  return list;
}

}  // namespace

std::size_t GoldenComparison::rows() const {
  return sum(files, &GoldenFile::rows);
}

std::size_t GoldenComparison::compared() const {
  return sum(files, &GoldenFile::compared);
}

std::size_t GoldenComparison::different() const {
  return sum(files, &GoldenFile::different);
}

GoldenComparison compare_with_golden(const GoldenTables& tables, const Models& models,
                                     const Limits& limits) {
  GoldenComparison found;
  const auto start = std::chrono::steady_clock::now();
  try {
    Comparer(tables, models, limits, found).compare();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::cancelled) {
      throw;
    }
    found.whole = false;
  }
  found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return found;
}

std::string sentence_of(const GoldenDifference& difference) {
  return fmt::format("{}, line {}: {}: {}", difference.file, difference.line, difference.row,
                     difference.what);
}

std::string summary_of(const GoldenComparison& comparison) {
  std::string text =
      fmt::format("{} of {} rows compared", words(comparison.compared()), words(comparison.rows()));
  if (comparison.different() > 0) {
    text += fmt::format(", {} different", words(comparison.different()));
  } else if (comparison.compared() > 0) {
    text += ", all equal";
  }
  if (!comparison.not_given.empty()) {
    text += "; models not given, with their rows: " + list_of(comparison.not_given);
  }
  return comparison.whole ? text : text + "; stopped before the last row";
}

std::string markup_of(const GoldenComparison& comparison) {
  const bool trouble = comparison.different() > 0 || !comparison.whole;
  std::string html = fmt::format(
      "<h2 id=\"golden\">Compared with the golden tables</h2>\n<p{}>{}.</p>\n<p class=\"note\">An "
      "independent program wrote these tables. Every row whose models are here, by the hash of "
      "their corners, was counted again in this run, in {:.1f} s.</p>\n<details>\n<summary>Rows by "
      "file</summary>\n<div class=\"scroll\">\n<table>\n<thead><tr><th>file</th>"
      "<th class=\"number\">rows</th><th class=\"number\">compared</th>"
      "<th class=\"number\">equal</th><th class=\"number\">different</th></tr></thead>\n<tbody>\n",
      trouble ? " class=\"warn\"" : "", xml_text(summary_of(comparison)), comparison.seconds);
  for (const GoldenFile& file : comparison.files) {
    html += fmt::format("<tr><td>{}</td>", xml_text(file.file));
    for (const std::size_t number :
         {file.rows, file.compared, file.compared - file.different, file.different}) {
      html += fmt::format("<td class=\"number\">{}</td>", words(number));
    }
    html += "</tr>\n";
  }
  html += "</tbody>\n</table>\n</div>\n</details>\n";
  if (!comparison.differences.empty()) {
    html += fmt::format("<details open=\"\">\n<summary>{}</summary>\n<ul>\n",
                        comparison.different() > comparison.differences.size()
                            ? fmt::format("The first {} differences", comparison.differences.size())
                            : "The differences");
    for (const GoldenDifference& difference : comparison.differences) {
      html += fmt::format("<li>{}</li>\n", xml_text(sentence_of(difference)));
    }
    html += "</ul>\n</details>\n";
  }
  return html;
}

}  // namespace soms::reproduce
