// A premise: a tree by SOMS is cheaper to query than one by spatial median.
#include "soms/tree/option_names.h"

#include "thesis/claims/thesis_claims.h"
#include "thesis/experiments/experiments.h"
#include "thesis/races/rides.h"
#include "thesis/races/traversal_match.h"
#include "thesis/run/counts.h"
#include "thesis/run/steps.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace soms::reproduce {

namespace {

/// The two that the thesis names: Ericson's generic one and Larsson's.
std::array<NamedTraversal, 2> generic_traversals() {
  return {{{"ericson", {.traversal = Traversal::ericson}},
           {"larsson", {.traversal = Traversal::larsson}}}};
}

/// SOMS, then spatial median with each empty side.
std::vector<BuildPairing> builds_by_empty_side() {
  const std::vector<Contender> scenes = thesis_rules(kSceneLevel);
  const std::vector<Contender> objects = thesis_rules(kObjectLevel);
  std::vector<BuildPairing> list{pairing(scenes, objects, "soms")};
  const BuildPairing spatial = pairing(scenes, objects, "spatial_median");
  for (const EmptySide policy : kAllEmptySides) {
    list.push_back({fmt::format("spatial median ({})", name(policy)),
                    with(spatial.of_scene, policy), with(spatial.of_object, policy)});
  }
  return list;
}

double over(std::uint64_t one, std::uint64_t other) {
  return static_cast<double>(one) / static_cast<double>(other);
}

/// SOMS over one kind of spatial median on one course.
void add_rows(std::vector<ClaimRow>& rows, const Ride& soms, const Ride& spatial,
              std::string_view traversal, EmptySide policy) {
  if (soms.sum.root_overlap_frames == 0) {
    return;
  }
  const Demand less = demand_of("soms_is_cheaper_to_query");
  const std::string reading = fmt::format("empty side {}, traversal {}", name(policy), traversal);
  ClaimRow boxes = counted_row(reading, "box tests, SOMS over spatial median", soms.subject, "",
                               less, over(soms.sum.counts.box_tests, spatial.sum.counts.box_tests));
  boxes.unjudged =
      "box tests alone: a tree with larger leaves makes fewer of them and more triangle tests";
  rows.push_back(std::move(boxes));
  rows.push_back(counted_row(reading,
                             "box tests and pairs of triangles together, SOMS over spatial median",
                             soms.subject, "", less, over(soms.tests(), spatial.tests())));
  if (!soms.rounds.empty() && !spatial.rounds.empty()) {
    rows.push_back(measured_row(reading, "processor time, SOMS over spatial median", soms.subject,
                                "", less,
                                paired_ratio(soms.rounds, spatial.rounds, soms.processes)));
  }
}

/// Which rides are not timed, and what their counts say.
std::string untimed_words(std::span<const Ride> rides) {
  std::vector<std::string> names;
  for (const Ride& ride : rides) {
    const std::string one =
        fmt::format("{}, {}", ride.subject, name(ride.build.of_scene.options.empty_side));
    const bool untimed = ride.rounds.empty() && ride.sum.root_overlap_frames > 0 &&
                         ride.sum.counts.triangle_pairs > kManyTrianglePairs;
    if (untimed && std::find(names.begin(), names.end(), one) == names.end()) {
      names.push_back(one);
    }
  }
  return names.empty() ? std::string()
                       : fmt::format(
                             "No processor time, for the leaves of spatial median hold over {} "
                             "million pairs of triangles; their counts stand for it: {}.",
                             kManyTrianglePairs / 1'000'000, fmt::join(names, "; "));
}

Table cheaper_table(const std::vector<Ride>& rides, const Context& context) {
  Table table{
      .id = "query_cost",
      .caption = fmt::format(
          "Cost of collision detection by rule, empty side and traversal, summed over all "
          "frames; times over the frames in which the roots overlap (trees of level {}, "
          "scenes {}; empty where leaves hold over {} million pairs of triangles).{}",
          kObjectLevel, kSceneLevel, kManyTrianglePairs / 1'000'000, context.timed_step_words()),
      .columns = {{"model"},
                  {"course"},
                  {"rule"},
                  {"empty_side"},
                  {"traversal"},
                  {"frames"},
                  {"root_overlap_frames"}}};
  add_count_columns(table);
  add_estimate_columns(table, "ms");
  for (const Ride& ride : rides) {
    std::vector<Cell> row{ride.model,
                          ride.subject,
                          ride.build.of_scene.name,
                          std::string(name(ride.build.of_scene.options.empty_side)),
                          ride.traversal,
                          count_cell(ride.sum.frames),
                          count_cell(ride.sum.root_overlap_frames)};
    add_count_cells(row, ride.sum.counts);
    add_estimate_cells(row, ride.rounds, ride.processes);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Result claim_cheaper(const Context& context) {
  const std::vector<BuildPairing> pairings = builds_by_empty_side();
  const std::vector<RideCourse> courses = thesis_courses(context);
  const auto traversals = generic_traversals();
  Steps steps(context.limits, courses.size() * traversals.size());
  std::vector<ClaimRow> rows;
  std::vector<Ride> all;
  for (const RideCourse& course : courses) {
    for (const NamedTraversal& traversal : traversals) {
      std::vector<Ride> rides = ride(context, course, pairings, traversal);
      for (std::size_t i = 1; i < rides.size(); ++i) {
        add_rows(rows, rides[0], rides[i], traversal.name, kAllEmptySides[i - 1]);
      }
      std::move(rides.begin(), rides.end(), std::back_inserter(all));
      steps.done_one();
    }
  }
  Claim claim = judged(thesis_claim("soms_is_cheaper_to_query"), std::move(rows));
  claim.why =
      "SOMS divides where spatial median has stopped, so its leaves are smaller and fewer pairs of "
      "triangles are left to test, for which it may test more boxes. What that is worth depends on "
      "how many triangles the leaves of spatial median keep, and so on the empty side.";
  claim.note = untimed_words(all);
  return {.tables = {cheaper_table(all, context)},
          .claims = {std::move(claim)},
          .remarks = object_remarks(context.models.objects)};
}

}  // namespace soms::reproduce
