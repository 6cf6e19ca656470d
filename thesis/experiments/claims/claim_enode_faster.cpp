// E-Node against depth-first traversals that descend the same nodes: work and time.
#include "soms/base/parallel.h"

#include "apps/draw/interval_chart.h"
#include "thesis/claims/thesis_claims.h"
#include "thesis/experiments/experiments.h"
#include "thesis/races/enode_racers.h"
#include "thesis/run/steps.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr Demand kFaster = demand_of("enode_faster");

constexpr std::string_view kSameTests =
    "decided by construction: E-Node tests the boxes that its opponent tests, one for one";
constexpr std::string_view kFewerEntered =
    "decided by construction: the opponent enters each pair that it tests, E-Node only those that "
    "overlap and are to be divided, at most half as many";
constexpr std::string_view kCount = "a count: faster is judged by time";

/// So small a share of a drive, and of an orientation test, is timed in a quick run.
constexpr std::size_t kQuickShareOfDrive = 64;
constexpr std::size_t kQuickShareOfTest = 16;

/// What all racers did on one trip.
struct Raced {
  const Trip* trip = nullptr;
  std::size_t timed_frames = 0;
  std::vector<TraversalCounts> counts = {};  ///< by racer, over all frames
  std::vector<Timing> traversal = {};        ///< by racer; in a quick run on SOMS trees alone
  std::vector<Timing> collision = {};        ///< by racer; on SOMS trees alone

  [[nodiscard]] const TraversalCounts& count(RacerPlace place) const {
    return counts[static_cast<std::size_t>(place)];
  }
};

/// A kind of trip with what was measured.
struct Kind {
  const TripKind* of = nullptr;
  std::vector<Raced> raced = {};
};

using Counter = std::uint64_t TraversalCounts::*;
using TripTimes = std::vector<Timing> Raced::*;

/// Frames to time: all; in a quick run the middle of those in which the roots overlap.
std::vector<std::size_t> timed_frames(const MovedTrip& moved, bool quick) {
  if (!quick) {
    return moved.all_frames();
  }
  std::vector<std::size_t> near;
  for (std::size_t k = 0; k < moved.frames(); ++k) {
    if (overlaps(moved.still().boxes.front(), moved.moving(k).boxes.front())) {
      near.push_back(k);
    }
  }
  return middle_of(near, moved.trip().is_drive() ? kQuickShareOfDrive : kQuickShareOfTest);
}

/// What a racer counts over all frames.
struct RacerCounts {
  TraversalCounts sum = {};
  std::vector<std::uint64_t> leaf_pairs = {};  ///< by frame
};

RacerCounts racer_counts(const MovedTrip& moved, const TripRacer& racer, const Limits& limits) {
  FrameTraversal traversal(moved, racer);
  RacerCounts result;
  for (std::size_t k = 0; k < moved.frames(); ++k) {
    check_stop(limits);
    const TraversalCounts counts = traversal.run(k);
    result.sum += counts;
    result.leaf_pairs.push_back(counts.leaf_pairs);
  }
  return result;
}

/// Counts of all racers. \errors std::logic_error where a frame's leaf pairs differ.
std::vector<TraversalCounts> all_counts(const MovedTrip& moved, const Limits& limits) {
  const std::span<const TripRacer> racers = enode_racers();
  std::vector<RacerCounts> counted(racers.size());
  for_each_chunk(racers.size(), 1, limits, [&](std::size_t i, std::size_t) {
    counted[i] = racer_counts(moved, racers[i], limits);
  });
  std::vector<TraversalCounts> sums;
  for (std::size_t i = 0; i < racers.size(); ++i) {
    require(
        counted[i].leaf_pairs == counted[0].leaf_pairs,
        fmt::format("{} of {} past {}: leaf pairs of a frame by {} and by {}", moved.trip().test,
                    moved.trip().moving, moved.trip().still, racers[i].name, racers[0].name));
    sums.push_back(counted[i].sum);
  }
  return sums;
}

Raced raced(const Trip& trip, const Context& context, Steps& steps) {
  const bool timed = trip.rule == kEnodeRule || !context.quick;
  if (context.races->times_only() && !timed) {
    return {&trip};
  }
  const Limits quiet = steps.quiet();
  const MovedTrip moved(trip, quiet);
  const std::vector<std::size_t> frames = timed_frames(moved, context.quick);
  Raced result{&trip, frames.size()};
  if (!context.races->times_only()) {
    result.counts = all_counts(moved, context.counting());
  }
  TripRace task{.racers = enode_racers(),
                .question = Question::leaf_pairs,
                .frames = frames,
                .rounds = enode_rounds(context)};
  if (timed) {
    result.traversal = race(*context.races, moved, task, quiet);
  }
  steps.done_one();
  task.question = Question::contacts;
  if (trip.rule == kEnodeRule) {
    result.collision = race(*context.races, moved, task, quiet);
  }
  steps.done_one();
  return result;
}

ClaimRow count_row(const Kind& kind, const Pairing& pairing, std::string metric, Counter counter,
                   std::string_view unjudged) {
  std::uint64_t one = 0;
  std::uint64_t other = 0;
  for (const Raced& trip : kind.raced) {
    one += trip.count(pairing.one).*counter;
    other += trip.count(pairing.other).*counter;
  }
  ClaimRow row = counted_row(reading_of(pairing), std::move(metric), kind.of->subject(), "",
                             kFaster, static_cast<double>(one) / static_cast<double>(other));
  row.unjudged = unjudged;
  return row;
}

/// The ratio of the sums over trips.
Estimate ratio_of(std::span<const Raced> trips, const Pairing& pairing, TripTimes timed) {
  std::vector<double> one;
  std::vector<double> other;
  int processes = 1;
  for (const Raced& trip : trips) {
    const std::vector<Timing>& timings = trip.*timed;
    add_rounds(one, timings[static_cast<std::size_t>(pairing.one)].rounds);
    add_rounds(other, timings[static_cast<std::size_t>(pairing.other)].rounds);
    processes = timings.front().processes;
  }
  return paired_ratio(one, other, processes);
}

ClaimRow time_row(const Kind& kind, const Pairing& pairing, std::string_view what,
                  TripTimes timed) {
  ClaimRow row =
      measured_row(reading_of(pairing), fmt::format("time of {}, E-Node / opponent", what),
                   kind.of->subject(), "", kFaster, ratio_of(kind.raced, pairing, timed));
  row.unjudged = pairing.unjudged;
  return row;
}

void add_counts(std::vector<ClaimRow>& rows, const Kind& kind) {
  for (const Pairing& pairing : counted_pairings()) {
    if (pairing.one != RacerPlace::e_node_chain) {  // tests what the family test does
      rows.push_back(count_row(kind, pairing, "box tests, E-Node / opponent",
                               &TraversalCounts::box_tests,
                               pairing.one == RacerPlace::e_node ? kSameTests : kCount));
    }
  }
  for (const Pairing& pairing : counted_pairings()) {
    rows.push_back(count_row(kind, pairing, "pairs entered, E-Node / opponent",
                             &TraversalCounts::entered, kFewerEntered));
  }
}

std::vector<ClaimRow> rows_of(const std::vector<Kind>& kinds) {
  std::vector<ClaimRow> rows;
  for (const Kind& kind : kinds) {
    if (kind.of->rule != kEnodeRule) {
      continue;
    }
    for (const Pairing& pairing : timed_pairings()) {
      rows.push_back(time_row(kind, pairing, "the traversal", &Raced::traversal));
    }
    for (const Pairing& pairing : timed_pairings()) {
      rows.push_back(time_row(kind, pairing, "traversal and triangles", &Raced::collision));
    }
    for (const Pairing& pairing : pairings_aside()) {
      rows.push_back(time_row(kind, pairing, "the traversal", &Raced::traversal));
    }
    add_counts(rows, kind);
  }
  return rows;
}

Claim claim_of(const std::vector<Kind>& kinds) {
  Claim claim = judged(thesis_claim("enode_faster"), rows_of(kinds));
  claim.why =
      "The text has neither E-Node nor its opponent: we take Larsson's traversal to descend "
      "both nodes at once. The family test makes the same box tests, one for one. It saves "
      "entering pairs that are apart, and pays with gathering a family before it enters one "
      "of it; so the ratio depends on what entering a pair costs, a step of an explicit stack "
      "or a call of a function. The reading nearest to the text races in all four ways to "
      "program both, the others like against like. A start from the last front keeps a list "
      "of pairs from frame to frame, which costs time whether it saves box tests or not, and "
      "has no recursive form. All rows are of SOMS trees, which E-Node is designed for; a "
      "subject is all trips of a kind, summed. The table has each trip, and other trees.";
  claim.note = ericson_words(claim.rows, "time of the traversal");
  claim.revision = revision_of(
      claim.rows, [](const ClaimRow& row) { return row.reading.ends_with("stack / stack"); },
      "it raced explicit stacks alone");
  return claim;
}

Table table_of(const std::vector<Kind>& kinds) {
  Table table{
      .id = "claim_enode_faster_trips",
      .caption = fmt::format(
          "Each trip by each traversal: counts over all frames, and medians of the processor time "
          "of the frames that were timed, without moving boxes (trees of level {}, scenes {}; "
          "recursive: by recursion, else by an explicit stack). On other trees than SOMS' the "
          "traversal is timed in a whole run alone, triangles never.{}",
          kObjectLevel, kSceneLevel, kThesisOptions),
      .columns = {
          {"model"}, {"static"}, {"moving"}, {"rule"}, {"test"}, {"algorithm"}, {"frames"}}};
  add_count_columns(table);
  table.columns.push_back({"timed_frames"});
  table.columns.push_back({"traversal", "ms", ColumnKind::timed});
  table.columns.push_back({"collision", "ms", ColumnKind::timed});
  for (const Kind& kind : kinds) {
    for (const Raced& trip : kind.raced) {
      for (std::size_t i = 0; i < trip.counts.size(); ++i) {
        std::vector<Cell> row{trip.trip->model,
                              trip.trip->still,
                              trip.trip->moving,
                              trip.trip->rule,
                              trip.trip->test,
                              enode_racers()[i].name,
                              count_cell(trip.trip->offsets.size())};
        add_count_cells(row, trip.counts[i]);
        row.push_back(count_cell(trip.timed_frames));
        row.push_back(trip.traversal.empty() ? Cell{} : number_cell(trip.traversal[i].median));
        row.push_back(trip.collision.empty() ? Cell{} : number_cell(trip.collision[i].median));
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

Figure figure_of(const std::vector<Kind>& kinds) {
  constexpr std::array<std::string_view, 4> kSeries{
      "E-Node by stack / stack", "E-Node by stack / recursion", "E-Node by recursion / stack",
      "E-Node by recursion / recursion"};
  IntervalChart chart{
      .title = "E-Node's time to that of the simultaneous traversal",
      .x_label = "ratio of processor times of the traversal; shaded: E-Node is faster",
      .below = 1};
  for (const Kind& kind : kinds) {
    if (kind.of->rule != kEnodeRule) {
      continue;
    }
    for (const Raced& trip : kind.raced) {
      for (std::size_t i = 0; i < kSeries.size(); ++i) {
        const Estimate ratio =
            ratio_of(std::span(&trip, 1), timed_pairings()[i], &Raced::traversal);
        chart.marks.push_back({kind.of->subject(), label_in_kind(*trip.trip),
                               std::string(kSeries[i]), ratio.value, ratio.interval});
      }
    }
  }
  return {.id = "claim_enode_faster",
          .caption =
              "E-Node (family test, both nodes) against the simultaneous traversal, which we "
              "take Larsson's to be, by explicit stack and by recursion: ratio of the times "
              "of each trip on SOMS trees, with 95 % intervals.",
          .svg = draw(chart),
          .timed = true};
}

}  // namespace

Result claim_enode_faster(const Context& context) {
  EnodeTrips trips = enode_trips(context);
  Steps steps(context.limits, 2 * trips.trips());
  std::vector<Kind> kinds;
  for (const TripKind& kind : trips.kinds) {
    kinds.push_back({&kind});
    for (const Trip& trip : kind.trips) {
      kinds.back().raced.push_back(raced(trip, context, steps));
    }
  }
  Result result;
  result.tables = {table_of(kinds)};
  result.figures = {figure_of(kinds)};
  result.claims = {claim_of(kinds)};
  result.remarks = std::move(trips.remarks);
  return result;
}

}  // namespace soms::reproduce
