// A premise: a balanced tree is traversed faster than an unbalanced one.
#include "soms/base/parallel.h"
#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/statistics.h"

#include "thesis/claims/thesis_claims.h"
#include "thesis/experiments/experiments.h"
#include "thesis/races/rides.h"
#include "thesis/run/counts.h"
#include "thesis/run/steps.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trees/uneven_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr const ThesisClaim& kBalancedClaim = thesis_claim("balanced_trees_are_traversed_faster");

constexpr const char* kReason =
    "Balance bounds the depth of a tree; what a traversal tests depends on how well the boxes keep "
    "apart what is apart, which the plane of a rule decides. Of trees that differ in nothing but "
    "where the same order is cut, the more balanced one usually makes fewer box tests.";

/// Shares of a node's triangles that go to the left in trees out of balance.
struct Share {
  double share;
  std::string_view words;
};

constexpr std::array kShares{Share{0.375, "3/8"}, Share{0.25, "1/4"}, Share{0.125, "1/8"}};

NamedTraversal generic_traversal() {
  return {"ericson", {.traversal = Traversal::ericson}};
}

/// Spatial median as the thesis has it, where a node stays whole if a side is empty.
constexpr std::string_view kThesisSpatialMedian = "spatial median (stop)";

/// Rules whose trees differ in balance.
std::vector<BuildPairing> differing_builds() {
  const std::vector<Contender> scenes = all_builds(kSceneLevel);
  const std::vector<Contender> objects = all_builds(kObjectLevel);
  const BuildPairing spatial = pairing(scenes, objects, "spatial_median");
  return {pairing(scenes, objects, "object_median"),
          {std::string(kThesisSpatialMedian), spatial.of_scene, spatial.of_object},
          {"spatial median (next_axis)", with(spatial.of_scene, EmptySide::next_axis),
           with(spatial.of_object, EmptySide::next_axis)},
          pairing(scenes, objects, "soms"),
          pairing(scenes, objects, "sah")};
}

/// Levels of a ride's trees at which every node exists, the still body's first.
std::uint64_t ride_balanced_level(const Ride& ride) {
  return statistics(*ride.trips.front().a.tree(), ride.build.of_scene.options).balanced_level;
}

double tests_over(std::uint64_t one, std::uint64_t other) {
  return static_cast<double>(one) / static_cast<double>(other);
}

/// True if these are SOMS and spatial median with the thesis' options, in either order.
bool are_the_two_rules(const Ride& one, const Ride& other) {
  const auto is_soms = [](const Ride& ride) {
    return ride.build.of_scene.of_thesis && ride.build.of_scene.options.rule == Rule::soms;
  };
  return (is_soms(one) && other.build.title == kThesisSpatialMedian) ||
         (is_soms(other) && one.build.title == kThesisSpatialMedian);
}

/// Of two trees by different rules the more balanced over the less balanced one.
void add_comparison(std::vector<ClaimRow>& rows, const Ride& more, const Ride& less) {
  const Demand cheaper = kBalancedClaim.demands[0].demand;
  const std::size_t before = rows.size();
  const std::string reading =
      fmt::format("{} over the less balanced {}", more.build.title, less.build.title);
  const std::string unjudged =
      more.build.of_scene.of_thesis && less.build.of_scene.of_thesis
          ? ""
          : "SAH is no rule of the thesis; it shows that balance does not decide";
  ClaimRow boxes = counted_row(reading, "box tests", more.subject, "", cheaper,
                               tests_over(more.sum.counts.box_tests, less.sum.counts.box_tests));
  boxes.unjudged = unjudged.empty() ? "box tests alone: a tree with larger leaves makes fewer of "
                                      "them and more triangle tests"
                                    : unjudged;
  rows.push_back(std::move(boxes));
  rows.push_back(counted_row(reading, "box tests and pairs of triangles together", more.subject, "",
                             cheaper, tests_over(more.tests(), less.tests())));
  rows.back().unjudged = unjudged;
  if (!more.rounds.empty() && !less.rounds.empty()) {
    rows.push_back(measured_row(reading, "processor time", more.subject, "", cheaper,
                                paired_ratio(more.rounds, less.rounds, more.processes)));
    rows.back().unjudged = unjudged;
  }
  for (std::size_t i = before; i < rows.size(); ++i) {
    rows[i].is_nearest = are_the_two_rules(more, less);
  }
}

/// Box tests of trips on trees that are cut off the middle, both bodies alike.
std::uint64_t count_uneven(std::span<const Trip> trips, double share, const Limits& limits) {
  std::uint64_t box_tests = 0;
  std::map<const MeshView*, Tree> trees;
  const auto tree_of = [&](const MeshView& mesh) -> const Tree& {
    const auto found = trees.find(&mesh);
    return found != trees.end() ? found->second
                                : trees.emplace(&mesh, uneven_tree(mesh, share)).first->second;
  };
  for (const Trip& trip : trips) {
    PosedBoxes a(trip.a.mesh(), tree_of(trip.a.mesh()));
    PosedBoxes b(trip.b.mesh(), tree_of(trip.b.mesh()));
    a.move(Pose::identity());
    for (std::size_t k = 0; k < trip.offsets.size(); ++k) {
      check_stop(limits);
      b.move(trip.pose(k));
      box_tests += traverse(a.view(), b.view(), generic_traversal().options).box_tests;
    }
  }
  return box_tests;
}

/// The same order, cut in the middle and beside it: nothing differs but balance. Each leaf holds
/// one triangle, so that all trees leave the same pairs of triangles.
void compare_shares(std::vector<ClaimRow>& rows, const Ride& ride, const Limits& limits) {
  std::array<std::uint64_t, kShares.size() + 1> tests{};  // the last: of nodes cut in the middle
  for_each_chunk(tests.size(), 1, limits, [&](std::size_t i, std::size_t) {
    tests[i] = count_uneven(ride.trips, i < kShares.size() ? kShares[i].share : 0.5, limits);
  });
  for (std::size_t i = 0; i < kShares.size(); ++i) {
    const std::string reading =
        fmt::format("nodes cut at 1/2 over cut at {}, all else alike (ours)", kShares[i].words);
    rows.push_back(counted_row(reading, "box tests, one triangle a leaf", ride.subject, "",
                               kBalancedClaim.demands[0].demand,
                               tests_over(tests.back(), tests[i])));
  }
}

Table pairs_table(const std::vector<Ride>& rides, const Context& context) {
  Table table{
      .id = "balance_and_cost",
      .caption = fmt::format(
          "Balance of trees and what they cost to traverse: balanced level of the tree of "
          "the static body, counts of the generic traversal over all frames, "
          "times over the frames in which the roots overlap (trees of level {}, scenes {}).{}",
          kObjectLevel, kSceneLevel, context.timed_step_words()),
      .columns = {{"model"}, {"course"}, {"build"}, {"balanced_level"}}};
  add_count_columns(table);
  add_estimate_columns(table, "ms");
  for (const Ride& ride : rides) {
    std::vector<Cell> row{ride.model, ride.subject, ride.build.title,
                          count_cell(ride_balanced_level(ride))};
    add_count_cells(row, ride.sum.counts);
    add_estimate_cells(row, ride.rounds, ride.processes);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Result claim_balanced(const Context& context) {
  const std::vector<BuildPairing> pairings = differing_builds();
  const std::vector<RideCourse> courses = thesis_courses(context);
  Steps steps(context.limits, 2 * courses.size());
  std::vector<ClaimRow> rows;
  std::vector<Ride> all;
  for (const RideCourse& course : courses) {
    std::vector<Ride> rides = ride(context, course, pairings, generic_traversal());
    if (rides[0].sum.root_overlap_frames > 0 && !context.races->times_only()) {
      std::vector<std::uint64_t> levels;
      std::transform(rides.begin(), rides.end(), std::back_inserter(levels), ride_balanced_level);
      for (std::size_t more = 0; more < rides.size(); ++more) {
        for (std::size_t less = 0; less < rides.size(); ++less) {
          if (levels[more] > levels[less]) {
            add_comparison(rows, rides[more], rides[less]);
          }
        }
      }
    }
    steps.done_one();
    if (rides[0].sum.root_overlap_frames > 0 && !context.races->times_only()) {
      compare_shares(rows, rides[0], context.counting());
    }
    std::move(rides.begin(), rides.end(), std::back_inserter(all));
    steps.done_one();
  }
  Claim claim = judged(kBalancedClaim, std::move(rows));
  claim.why = kReason;
  return {.tables = {pairs_table(all, context)},
          .claims = {std::move(claim)},
          .remarks = object_remarks(context.models.objects)};
}

}  // namespace soms::reproduce
