// Every traversal of canonical trees and the library's own on the same trips: counts, times, and
// answers that must be the same everywhere.
#include "apps/draw/chart.h"
#include "thesis/experiments/experiments.h"
#include "thesis/races/traversal_match.h"
#include "thesis/run/steps.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace soms::reproduce {

namespace {

Table empty_table() {
  Table table{
      .id = "traversals",
      .caption = fmt::format(
          "Every traversal on every trip: counts summed over the frames, answers compared, "
          "and microseconds a frame: of the traversal alone, and of a whole frame with "
          "moving the boxes and testing the triangles (of the first object over all frames, in "
          "a quick run and of others over every eighth). Trees of level {}, scenes {} "
          "(fast: the library's own).{}",
          kObjectLevel, kSceneLevel, kThesisOptions),
      .columns = {{"static"},
                  {"moving"},
                  {"rule"},
                  {"test"},
                  {"algorithm"},
                  {"frames"},
                  {"root_overlap_frames"},
                  {"hit_frames"}}};
  add_count_columns(table);
  for (const char* const name :
       {"triangle_tests", "contacts", "equal_frames", "brute_force_frames"}) {
    table.columns.push_back({name});
  }
  table.columns.push_back({"traversal", "us", ColumnKind::timed});
  table.columns.push_back({"frame_time", "us", ColumnKind::timed});
  return table;
}

/// Microseconds of a whole frame by a traversal.
Cell frame_time(const TraversalMatch& match, const TraversalOutcome& outcome) {
  if (!match.other_time) {
    return {};
  }
  return number_cell(match.other_time->microseconds_a_frame() +
                     outcome.time.microseconds_a_frame());
}

void add_rows(Table& table, const TraversalTruth& truth, const TraversalMatch& match) {
  for (const TraversalOutcome& outcome : match.outcomes) {
    const Totals& sum = outcome.sum;
    std::vector<Cell> row{match.trip.still, match.trip.moving, match.trip.rule, match.trip.test,
                          outcome.traversal.name};
    for (const std::uint64_t count : {sum.frames, sum.root_overlap_frames, sum.hit_frames}) {
      row.push_back(count_cell(count));
    }
    add_count_cells(row, sum.counts);
    row.push_back(match.answers ? count_cell(match.answers->triangle_tests) : Cell{});
    row.push_back(match.answers ? count_cell(match.answers->contacts) : Cell{});
    row.push_back(count_cell(sum.frames));
    row.push_back(count_cell(truth.checked.size()));
    row.push_back(number_cell(outcome.time.microseconds_a_frame()));
    row.push_back(frame_time(match, outcome));
    table.rows.push_back(std::move(row));
  }
}

/// The library's own way: its boxes and its triangle tests; it has no pairs of leaves to tell.
void add_fast_row(Table& table, const TraversalTruth& truth) {
  std::uint64_t contacts = 0;
  for (const auto& of_frame : truth.contacts) {
    contacts += of_frame.size();
  }
  std::vector<Cell> row{truth.trip.still, truth.trip.moving, truth.trip.rule, truth.trip.test,
                        word_cell("fast")};
  row.push_back(count_cell(truth.trip.offsets.size()));
  row.resize(8);
  row.push_back(count_cell(truth.cost.node_tests));
  row.resize(14);
  row.push_back(count_cell(truth.cost.triangle_tests));
  row.push_back(count_cell(contacts));
  row.push_back(count_cell(truth.contacts.size()));
  row.push_back(count_cell(truth.checked.size()));
  row.emplace_back();
  row.push_back(number_cell(truth.time.microseconds_a_frame()));
  table.rows.push_back(std::move(row));
}

/// A test and its trips by every build.
struct Test {
  TraversalTruth truth;
  std::vector<TraversalMatch> matches;

  [[nodiscard]] const TraversalMatch& soms() const {
    return *std::find_if(matches.begin(), matches.end(),
                         [](const TraversalMatch& match) { return match.trip.rule == "soms"; });
  }
};

/// Traversals that the charts show: those in the order of the tree, and the library's own.
std::vector<std::string> charted_traversals() {
  std::vector<std::string> names;
  for (const NamedTraversal& traversal : all_traversals()) {
    if (traversal.options.order == EntryOrder::tree) {
      names.push_back(traversal.name);
    }
  }
  names.emplace_back("fast");
  return names;
}

/// Bars of the charted traversals in the drives and one approach, on SOMS trees.
template <class Own, class Number>
BarChart chart(const std::vector<Test>& tests, const Own& own, const Number& number) {
  BarChart chart;
  chart.y_scale = Scale::log;
  chart.groups = charted_traversals();
  for (const Test& test : tests) {
    const TraversalMatch& match = test.soms();
    if (match.trip.model != tests.front().truth.trip.model ||
        (match.trip.test != "drive" && match.trip.test != "right")) {
      continue;
    }
    Bars bars{.name = fmt::format("{}, {}", match.trip.still, match.trip.test)};
    for (const std::string& name : chart.groups) {
      bars.values.push_back(name == "fast" ? own(test.truth) : number(match, match.outcome(name)));
    }
    chart.bars.push_back(std::move(bars));
  }
  return chart;
}

Figure box_test_figure(const std::vector<Test>& tests) {
  BarChart bars = chart(
      tests,
      [](const TraversalTruth& truth) {
        return static_cast<double>(std::max<std::uint64_t>(1, truth.cost.node_tests));
      },
      [](const TraversalMatch&, const TraversalOutcome& outcome) {
        return static_cast<double>(outcome.sum.counts.box_tests);
      });
  bars.title = "Box tests of a trip, by traversal";
  bars.y_label = "box tests";
  return {.id = "traversals_box_tests",
          .caption =
              "Box tests of whole trips on SOMS trees (fast: on the library's own trees). For "
              "a small object in a city it decides which node is descended: b_first and the "
              "simultaneous traversals pay for boxes far from the object." +
              std::string(kThesisOptions),
          .svg = draw(bars)};
}

Figure time_figure(const std::vector<Test>& tests) {
  BarChart bars = chart(
      tests, [](const TraversalTruth& truth) { return truth.time.microseconds_a_frame(); },
      [](const TraversalMatch& match, const TraversalOutcome& outcome) {
        const Cell cell = frame_time(match, outcome);
        const double* const time = std::get_if<double>(&cell);
        return time == nullptr ? std::numeric_limits<double>::quiet_NaN() : *time;
      });
  bars.title = "Time of a whole frame, by traversal";
  bars.y_label = "us a frame";
  return {.id = "traversals_time",
          .caption =
              "Microseconds of a whole frame on SOMS trees: moving the boxes, the traversal, the "
              "triangle tests (fast: the library's own query, which moves no boxes)." +
              std::string(kThesisOptions),
          .svg = draw(bars),
          .timed = true};
}

std::uint64_t box_tests(const TraversalMatch& match, std::string_view traversal) {
  return match.outcome(traversal).sum.counts.box_tests;
}

/// Least and greatest ratio of the box tests of two traversals in the drives on SOMS trees.
std::string ratio_in_drives(const std::vector<Test>& tests, std::string_view one,
                            std::string_view other) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const Test& test : tests) {
    if (test.truth.trip.test == "drive") {
      const double ratio =
          static_cast<double>(box_tests(test.soms(), one)) /
          static_cast<double>(std::max<std::uint64_t>(1, box_tests(test.soms(), other)));
      least = std::min(least, ratio);
      most = std::max(most, ratio);
    }
  }
  return fmt::format("{:.2f} to {:.2f}", least, most);
}

/// All objects; in a quick run the first.
std::span<const Model> moved_objects(const Context& context) {
  const std::span<const Model> objects = context.models.objects;
  return context.quick ? objects.first(1) : objects;
}

std::vector<std::string> remarks(const Context& context, const std::vector<Test>& tests) {
  std::vector<std::string> words = object_remarks(moved_objects(context));
  const std::vector<std::string> scenes = scene_remarks(context.models.scenes);
  words.insert(words.end(), scenes.begin(), scenes.end());
  words.push_back(
      "In every frame all traversals on a tree report the same pairs of overlapping leaves, and "
      "the "
      "contacts of triangles are those of the library's own query; in the frames counted under "
      "brute_force_frames every traversal was also compared with all pairs of triangles. A "
      "difference "
      "would have ended the run.");
  if (!scenes.empty()) {
    words.push_back(fmt::format(
        "Drives on SOMS trees, box tests against larger: simultaneous {} times, b_first {} times, "
        "enode_fewest {} times, enode_start {} times.",
        ratio_in_drives(tests, "simultaneous", "larger"),
        ratio_in_drives(tests, "b_first", "larger"),
        ratio_in_drives(tests, "enode_fewest", "larger"),
        ratio_in_drives(tests, "enode_start", "larger")));
  }
  words.push_back(
      "The time of a whole frame is the traversal's own and, the same for all traversals on a "
      "tree, that of "
      "moving the boxes and testing the triangles, measured with traversal larger. A tree with "
      "larger "
      "leaves makes fewer box tests and more triangle tests: compare whole frames.");
  if (context.quick) {
    words.push_back(
        "Quick run: left out are all objects but the first, four of "
        "the six approaches, E-Node in the order of shared volumes, and the triangles of trips "
        "whose leaves hold over 20 million pairs of them.");
  }
  return words;
}

std::vector<TraversalTest> courses(const Context& context) {
  std::vector<TraversalTest> list;
  for (const Model& object : moved_objects(context)) {
    for (const auto& [from, name] : kAllApproaches) {
      if (!context.quick || from == Approach::right || from == Approach::top) {
        list.push_back({&object, nullptr, from});
      }
    }
    for (const Model& scene : context.models.scenes) {
      list.push_back({&object, &scene});
    }
  }
  return list;
}

}  // namespace

Result traversals(const Context& context) {
  const std::vector<Contender> of_object = all_builds(kObjectLevel);
  const std::vector<Contender> of_scene = all_builds(kSceneLevel);
  std::vector<TreesOfMatch> trees;
  for (std::size_t i = 0; i < of_object.size(); ++i) {
    if (of_object[i].of_thesis || of_object[i].name == "sah") {
      trees.push_back({&of_scene[i], &of_object[i]});
    }
  }
  const std::vector<TraversalTest> list = courses(context);
  Steps steps(context.limits, list.size());
  Result result{.tables = {empty_table()}};
  std::vector<Test> tests;
  for (const TraversalTest& course : list) {
    Test test{truth_of(context, course), {}};
    test.matches = matches_of(context, course, trees, test.truth);
    for (const TraversalMatch& match : test.matches) {
      add_rows(result.tables[0], test.truth, match);
    }
    steps.done_one();
    add_fast_row(result.tables[0], test.truth);
    tests.push_back(std::move(test));
  }
  result.figures = {box_test_figure(tests), time_figure(tests)};
  result.remarks = remarks(context, tests);
  return result;
}

}  // namespace soms::reproduce
