// E-Node against the traversal after Larsson: counts and times by frame. What the thesis claims of
// it is tested by the experiments claim-enode-*.
#include "apps/draw/chart.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/steps.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trips/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace soms::reproduce {

namespace {

/// So many times the box tests matter more than the order in which they are made.
constexpr double kFarMore = 2;

/// Larsson's traversal is taken to be the simultaneous one; E-Node descends the same nodes; the
/// third is E-Node as it suits a small object in a city.
enum ComparedPictures : std::size_t { larsson, e_node, e_node_larger, compared };

std::array<NamedTraversal, compared> drawn_traversals() {
  return {{{"larsson", {.traversal = Traversal::larsson}},
           named_traversal("enode_both"),
           named_traversal("enode_larger")}};
}

constexpr std::array<std::string_view, compared> kTitles{"Larsson's DFS (simultaneous)", "E-Node",
                                                         "E-Node, larger node first"};

double ratio(std::uint64_t one, std::uint64_t other) {
  return static_cast<double>(one) / static_cast<double>(std::max<std::uint64_t>(1, other));
}

/// A trip by all traversals.
struct Match {
  Trip trip;
  std::string title;  ///< of the build
  std::array<std::vector<Frame>, compared> frames;
  std::vector<FrameTimes> times;

  [[nodiscard]] Totals sum(std::size_t traversal) const { return totals(frames[traversal]); }

  /// The bodies come near each other at all.
  [[nodiscard]] bool meets() const { return sum(larsson).root_overlap_frames > 0; }

  [[nodiscard]] bool is_drive() const { return trip.is_drive(); }

  /// How many times the box tests of E-Node that descends the larger node Larsson's DFS makes.
  [[nodiscard]] double tests_over_larger() const {
    return ratio(sum(larsson).counts.box_tests, sum(e_node_larger).counts.box_tests);
  }
};

/// Ways of the thesis' own rule pair: spatial median and SOMS are compared throughout; drives by
/// spatial median are left out, for where it stops early triangles are all that is left to time.
void add_matches(std::vector<Match>& matches, const Context& context, const Model& object) {
  const std::vector<Contender> builds = thesis_rules(kObjectLevel);
  const std::vector<Contender> of_scene = thesis_rules(kSceneLevel);
  for (const auto& [from, name] : kApproaches) {
    for (const char* const rule : {"spatial_median", "soms"}) {
      const Contender& build = build_named(builds, rule);
      matches.push_back({orientation_trip(object, from, build), build.title, {}, {}});
    }
  }
  for (const Model& scene : context.models.scenes) {
    for (const char* const rule : {"object_median", "soms"}) {
      const Contender& build = build_named(of_scene, rule);
      matches.push_back(
          {drive_trip(scene, object, build, build_named(builds, rule)), build.title, {}, {}});
    }
  }
}

std::vector<Match> trips(const Context& context) {
  std::vector<Match> matches;
  for (const Model& object : context.models.objects) {
    add_matches(matches, context, object);
  }
  return matches;
}

void run_match(Match& match, const Context& context) {
  const auto traversals = drawn_traversals();
  for (std::size_t i = 0; i < compared; ++i) {
    match.frames[i] = answer_frames(match.trip, traversals[i], context.limits);
    for (std::size_t k = 0; k < match.frames[i].size(); ++k) {
      require(match.frames[i][k].contacts == match.frames[larsson][k].contacts,
              fmt::format("{} of {} past {}, frame {}: contacts by {} and by {}", match.trip.test,
                          match.trip.moving, match.trip.still, k, traversals[i].name,
                          traversals[larsson].name));
    }
  }
  match.times = time_frames(match.trip, traversals, context.repetitions(match.is_drive() ? 20 : 50),
                            context.limits, context.timed_step(match.is_drive()));
}

std::vector<Cell> name_cells(const Match& match, std::size_t traversal) {
  return {match.trip.model, match.trip.still, match.trip.moving,
          match.trip.rule,  match.trip.test,  drawn_traversals()[traversal].name};
}

const std::vector<Column> kNameColumns{{"model"}, {"static"}, {"moving"},
                                       {"rule"},  {"test"},   {"algorithm"}};

Table sum_table(const std::vector<Match>& matches, const Context& context) {
  Table table{
      .id = "figure_5_10",
      .caption = fmt::format("E-Node against Larsson's DFS: counts summed over all frames, "
                             "and milliseconds of collision detection over the frames in "
                             "which the roots overlap (trees of level {}, scenes {}); the "
                             "numbers of repetitions are ours.{}{}",
                             kObjectLevel, kSceneLevel, kThesisOptions, context.timed_step_words()),
      .columns = kNameColumns};
  for (const char* const name : {"frames", "root_overlap_frames", "hit_frames"}) {
    table.columns.push_back({name});
  }
  add_count_columns(table);
  table.columns.push_back({"contacts"});
  add_statistics_columns(table);
  for (auto column = table.columns.end() - 4; column != table.columns.end(); ++column) {
    column->unit = "ms";
  }
  for (const Match& match : matches) {
    for (std::size_t i = 0; i < compared; ++i) {
      const Totals sum = match.sum(i);
      std::vector<Cell> row = name_cells(match, i);
      for (const std::uint64_t count : {sum.frames, sum.root_overlap_frames, sum.hit_frames}) {
        row.push_back(count_cell(count));
      }
      add_count_cells(row, sum.counts);
      row.push_back(count_cell(sum.contacts));
      add_statistics_cells(row,
                           medians_where_roots_overlap(match.times[i].collision, match.frames[i]));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table frame_table(const std::vector<Match>& matches, const Context& context) {
  Table table{.id = "figure_5_10_frames",
              .caption = fmt::format(
                  "E-Node against Larsson's DFS, every frame on SOMS trees (level {}, scenes {}); "
                  "times are medians of collision detection.{}{}",
                  kObjectLevel, kSceneLevel, kThesisOptions, context.timed_step_words()),
              .columns = kNameColumns};
  table.columns.push_back({"frame"});
  table.columns.push_back({"root_overlap"});
  add_count_columns(table);
  table.columns.push_back({"contacts"});
  table.columns.push_back({"collision", "ms", ColumnKind::timed});
  for (const Match& match : matches) {
    if (match.trip.rule != "soms") {
      continue;
    }
    for (std::size_t i = 0; i < compared; ++i) {
      for (std::size_t k = 0; k < match.frames[i].size(); ++k) {
        const Frame& frame = match.frames[i][k];
        std::vector<Cell> row = name_cells(match, i);
        row.push_back(count_cell(k));
        row.push_back(yes_cell(frame.roots_overlap));
        add_count_cells(row, frame.counts);
        row.push_back(count_cell(frame.contacts.size()));
        const Timing& time = match.times[i].collision[k];
        row.push_back(time.rounds.empty() ? Cell{} : number_cell(time.median));
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

Figure chart(const std::string& id, const Match& match) {
  LineChart chart{.title = fmt::format("{}: {} past {}, {} trees", match.trip.test,
                                       match.trip.moving, match.trip.still, match.title),
                  .x_label = "frame",
                  .y_label = "ms a frame, collision only",
                  .markers = match.trip.offsets.size() < 60};
  for (std::size_t i = 0; i < compared; ++i) {
    Line line{.name = std::string(kTitles[i])};
    for (std::size_t k = 0; k < match.frames[i].size(); ++k) {
      if (match.times[i].collision[k].rounds.empty()) {
        continue;
      }
      const double ms = match.times[i].collision[k].median;
      line.x.push_back(static_cast<double>(k));
      line.y.push_back(match.frames[i][k].roots_overlap ? ms
                                                        : std::numeric_limits<double>::quiet_NaN());
    }
    chart.lines.push_back(std::move(line));
  }
  return {
      .id = id,
      .caption = fmt::format("Milliseconds of collision detection by frame, {} past {} on {} "
                             "trees: E-Node follows Larsson's DFS, for it makes the same box "
                             "tests{}.{}",
                             match.trip.moving, match.trip.still, match.title,
                             match.is_drive() && match.tests_over_larger() >= kFarMore
                                 ? fmt::format("; descending the larger node first makes {:.1f} "
                                               "times fewer",
                                               match.tests_over_larger())
                                 : "",
                             kThesisOptions),
      .svg = draw(chart),
      .timed = true};
}

/// Least and greatest of a number over the trips.
template <class Number>
std::pair<double, double> range(const std::vector<Match>& matches, const Number& number) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Match& match : matches) {
    const double value = number(match);
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return {least, most};
}

/// Least and greatest number of times that Larsson's DFS makes the box tests of E-Node that opens
/// the larger node, in the drives; nothing where there are none.
std::optional<std::pair<double, double>> range_in_drives(const std::vector<Match>& matches) {
  std::vector<Match> drives;
  std::copy_if(matches.begin(), matches.end(), std::back_inserter(drives),
               [](const Match& match) { return match.is_drive(); });
  if (drives.empty()) {
    return std::nullopt;
  }
  return range(drives, [](const Match& match) { return match.tests_over_larger(); });
}

std::vector<std::string> remarks(const Context& context, const std::vector<Match>& matches) {
  std::vector<std::string> words = object_remarks(context.models.objects);
  const std::vector<std::string> scenes = scene_remarks(context.models.scenes);
  words.insert(words.end(), scenes.begin(), scenes.end());
  if (const auto times = range_in_drives(matches)) {
    words.push_back(
        fmt::format("A small object in a city: descending both nodes at once, as Larsson's "
                    "DFS and E-Node do, costs {:.1f} to {:.1f} times the box tests of "
                    "E-Node that descends the larger node.",
                    times->first, times->second));
  }
  words.push_back(
      "Larsson's DFS is named in captions only; we take it to be the simultaneous traversal.");
  return words;
}

}  // namespace

Result figure_5_10(const Context& context) {
  std::vector<Match> matches = trips(context);
  Steps steps(context.limits, matches.size());
  for (Match& match : matches) {
    run_match(match, context);
    steps.done_one();
  }
  Result result;
  result.tables = {sum_table(matches, context), frame_table(matches, context)};
  result.remarks = remarks(context, matches);
  // A scene of the user's may lie off the path of the drive: then there is nothing to compare.
  std::erase_if(matches, [](const Match& match) { return !match.meets(); });
  for (const Match& match : matches) {
    if (match.trip.rule == "soms" && (match.trip.test == "drive" || match.trip.test == "right")) {
      const std::string still = id_word(match.trip.still, result.figures.size());
      const bool first = match.trip.model == context.models.objects.front().name;
      const std::string own = first || !match.is_drive() ? still : match.trip.model + "_" + still;
      result.figures.push_back(
          chart(fmt::format("figure_5_10_{}_{}", own, match.trip.test), match));
    }
  }
  return result;
}

}  // namespace soms::reproduce
