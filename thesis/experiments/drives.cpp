// Drives through the scenes: frames in which triangles touch apart from those in which none do.
#include "apps/draw/chart.h"
#include "thesis/experiments/experiments.h"
#include "thesis/races/drive_contenders.h"
#include "thesis/races/touching_drive.h"
#include "thesis/races/traversal_match.h"
#include "thesis/run/steps.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trips/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace soms::reproduce {

namespace {

/// A drive on the trees of one rule, by all traversals.
struct Drive {
  std::string title;  ///< of the rule
  Trip trip;
  std::array<Totals, drive_traversal_count> sums = {};
  std::vector<Frame> frames = {};      ///< with contacts; empty if there are too many pairs
  std::vector<FrameTimes> times = {};  ///< empty likewise, else one a traversal

  [[nodiscard]] bool is_timed() const { return !times.empty(); }

  [[nodiscard]] std::size_t contact_frames() const {
    return static_cast<std::size_t>(std::count_if(
        frames.begin(), frames.end(), [](const Frame& frame) { return !frame.contacts.empty(); }));
  }

  /// Mean milliseconds of a timed frame, of those with contacts or of those without; 0 of none.
  [[nodiscard]] double mean_time(std::size_t traversal, bool contact) const {
    std::vector<double> medians;
    for (std::size_t k = 0; k < frames.size(); ++k) {
      if (!frames[k].contacts.empty() == contact && !times[traversal].frame[k].rounds.empty()) {
        medians.push_back(times[traversal].frame[k].median);
      }
    }
    return mean_of(medians);
  }
};

void run_drive(Drive& ride, const Context& context, const Limits& quiet) {
  const auto traversals = drive_traversals();
  for (std::size_t i = 0; i < drive_traversal_count; ++i) {
    ride.sums[i] = totals(traverse_frames(ride.trip, traversals[i], quiet));
  }
  if (has_too_many_pairs(ride.sums[larsson])) {
    return;
  }
  for (std::size_t i = 0; i < drive_traversal_count; ++i) {
    std::vector<Frame> frames = answer_frames(ride.trip, traversals[i], quiet);
    ride.sums[i] = totals(frames);
    for (std::size_t k = 0; i > 0 && k < frames.size(); ++k) {
      require(frames[k].contacts == ride.frames[k].contacts,
              fmt::format("{} of {} past {}, frame {}: contacts by {} and by {}", ride.trip.test,
                          ride.trip.moving, ride.trip.still, k, traversals[i].name,
                          traversals[0].name));
    }
    ride.frames = std::move(frames);
  }
  ride.times =
      time_frames(ride.trip, traversals, context.repetitions(50), quiet, context.timed_step(true));
}

/// Contacts do not depend on the trees.
void check_same_contacts(const Drive& one, const Drive& other) {
  for (std::size_t k = 0; one.is_timed() && other.is_timed() && k < one.frames.size(); ++k) {
    require(one.frames[k].contacts == other.frames[k].contacts,
            fmt::format("{} of {} past {}, frame {}: contacts by {} and by {}", one.trip.test,
                        one.trip.moving, one.trip.still, k, one.title, other.title));
  }
}

Table drive_table(const std::vector<Drive>& rides, const Context& context) {
  Table table{
      .id = "drives",
      .caption = fmt::format(
          "Drives through the scenes: counts summed over all frames, and milliseconds and frames "
          "a second (1000 / mean ms) of the frames with contact and of those without, each frame "
          "by its median of {} repetitions (the number is ours). A frame is moving the boxes, "
          "traversing the trees and testing the triangles, drawing off. Trees of level {}, scenes "
          "{}. Cells are empty where the leaves that overlap hold over {} million pairs of "
          "triangles.{}{}",
          context.repetitions(50), kObjectLevel, kSceneLevel, kManyTrianglePairs / 1'000'000,
          kThesisOptions, context.timed_step_words()),
      .columns = {{"model"},
                  {"static"},
                  {"moving"},
                  {"rule"},
                  {"test"},
                  {"algorithm"},
                  {"frames"},
                  {"root_overlap_frames"},
                  {"contact_frames"},
                  {"contacts"}}};
  add_count_columns(table);
  table.columns.push_back({"triangle_tests"});
  for (const char* const kind : {"contact", "free"}) {
    table.columns.push_back({fmt::format("{}_frame_time", kind), "ms", ColumnKind::timed});
    table.columns.push_back({fmt::format("{}_fps", kind), "", ColumnKind::timed});
  }
  for (const Drive& ride : rides) {
    for (std::size_t i = 0; i < drive_traversal_count; ++i) {
      const Totals& sum = ride.sums[i];
      std::vector<Cell> row{ride.trip.model,
                            ride.trip.still,
                            ride.trip.moving,
                            ride.trip.rule,
                            ride.trip.test,
                            drive_traversals()[i].name,
                            count_cell(ride.trip.offsets.size())};
      row.push_back(count_cell(sum.root_overlap_frames));
      row.push_back(ride.is_timed() ? count_cell(ride.contact_frames()) : Cell{});
      row.push_back(ride.is_timed() ? count_cell(sum.contacts) : Cell{});
      add_count_cells(row, sum.counts);
      row.push_back(ride.is_timed() ? count_cell(sum.triangle_tests) : Cell{});
      for (const bool contact : {true, false}) {
        const double ms = ride.is_timed() ? ride.mean_time(i, contact) : 0;
        row.push_back(ms > 0 ? number_cell(ms) : Cell{});
        row.push_back(rate_cell(ms));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

/// "bunny, u_mixed, drive": a group of bars.
std::string group_of(const Drive& ride) {
  return fmt::format("{}, {}, {}", ride.trip.model, ride.trip.still,
                     ride.trip.test == "drive" ? "drive" : "touching");
}

Figure time_figure(const std::vector<Drive>& rides, bool contact) {
  const std::string_view kind = contact ? "with contact" : "without contact";
  BarChart chart{.title = fmt::format("Time of a frame {}, by drive", kind),
                 .y_label = "ms a frame, drawing off",
                 .y_scale = Scale::log};
  for (const std::string_view rule : kDriveRules) {
    for (std::size_t i = 0; i < drive_traversal_count; ++i) {
      Bars bars;
      chart.groups.clear();
      for (const Drive& ride : rides) {
        if (ride.trip.rule == rule) {
          const double ms = ride.is_timed() ? ride.mean_time(i, contact) : 0;
          bars.name = fmt::format("{}, {}", ride.title, kDriveTraversalTitles[i]);
          bars.values.push_back(ms > 0 ? ms : std::numeric_limits<double>::quiet_NaN());
          chart.groups.push_back(group_of(ride));
        }
      }
      chart.bars.push_back(std::move(bars));
    }
  }
  return {.id = contact ? "drives_contact" : "drives_free",
          .caption = fmt::format("Milliseconds of a whole frame {}, mean over such frames of a "
                                 "drive; no bar where there are no such frames, or too many pairs "
                                 "of triangles to test.{}",
                                 kind, kThesisOptions),
          .svg = draw(chart),
          .timed = true};
}

/// Drives that were left out, by name.
std::vector<std::string> left_out(const std::vector<Drive>& rides) {
  std::vector<std::string> words;
  for (const Drive& ride : rides) {
    if (!ride.is_timed()) {
      words.push_back(fmt::format(
          "Left out: {} of {} through {} on {} trees, whose overlapping leaves hold {} pairs of "
          "triangles over the drive.",
          ride.trip.test, ride.trip.model, ride.trip.still, ride.title,
          to_text(count_cell(ride.sums[larsson].counts.triangle_pairs))));
    }
  }
  return words;
}

/// Both drives of one object through one scene, on the trees of both rules.
void add_drives(std::vector<Drive>& rides, const Context& context, const Model& object,
                const Model& scene, Steps& steps) {
  const std::vector<Contender> of_object = thesis_rules(kObjectLevel);
  const std::vector<Contender> of_scene = thesis_rules(kSceneLevel);
  const TouchingDrive touching = touching_drive(context, scene, object);
  for (const bool is_touching : {false, true}) {
    const std::size_t first = rides.size();
    for (const std::string_view rule : kDriveRules) {
      const Contender& build = build_named(of_scene, rule);
      const Contender& build_of_object = build_named(of_object, rule);
      Drive ride{.title = build.title,
                 .trip = is_touching
                             ? touching_drive_trip(scene, object, build, build_of_object, touching)
                             : drive_trip(scene, object, build, build_of_object)};
      run_drive(ride, context, steps.quiet());
      rides.push_back(std::move(ride));
      steps.done_one();
    }
    check_same_contacts(rides[first], rides[first + 1]);
  }
}

}  // namespace

Result drives(const Context& context) {
  const Models& models = context.models;
  Steps steps(context.limits,
              models.objects.size() * models.scenes.size() * 2 * kDriveRules.size());
  Result result{.remarks = object_remarks(models.objects)};
  const std::vector<std::string> scenes = scene_remarks(models.scenes);
  result.remarks.insert(result.remarks.end(), scenes.begin(), scenes.end());
  std::vector<Drive> rides;
  for (const Model& object : models.objects) {
    for (const Model& scene : models.scenes) {
      add_drives(rides, context, object, scene, steps);
      result.remarks.push_back(
          touching_drive_remark(scene, object, touching_drive(context, scene, object)));
    }
  }
  const std::vector<std::string> out = left_out(rides);
  result.remarks.insert(result.remarks.end(), out.begin(), out.end());
  result.tables = {drive_table(rides, context)};
  result.figures = {time_figure(rides, true), time_figure(rides, false)};
  return result;
}

}  // namespace soms::reproduce
