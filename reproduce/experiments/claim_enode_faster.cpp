// E-Node against depth-first traversals that descend the same nodes: work and time.
#include "reproduce/enode_racers.h"
#include "reproduce/experiments/experiments.h"
#include "reproduce/interval_chart.h"
#include "reproduce/steps.h"
#include "reproduce/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr Demand kLess{.below = 1};

/// So small a share of a drive is timed in a quick run.
constexpr std::size_t kQuickShare = 16;

/// What all racers did on one trip.
struct Raced {
  const Trip* trip = nullptr;
  std::size_t timed_frames = 0;
  std::vector<TraversalCounts> counts = {};  ///< by racer, over all frames
  std::vector<Timing> traversal = {};        ///< by racer
  std::vector<Timing> collision = {};        ///< by racer; on SOMS trees alone

  [[nodiscard]] const TraversalCounts& count(RacerPlace place) const {
    return counts[static_cast<std::size_t>(place)];
  }
};

/// A kind of trip with what was measured.
struct Kind {
  std::string name;
  std::vector<Raced> raced = {};
};

using Counter = std::uint64_t TraversalCounts::*;
using Timed = std::vector<Timing> Raced::*;

/// Frames to time: all; of a drive in a quick run the middle of those in which the roots overlap.
std::vector<std::size_t> timed_frames(const MovedTrip& moved, bool quick) {
  if (!quick || moved.trip().moving == moved.trip().still) {
    return moved.all_frames();
  }
  std::vector<std::size_t> near;
  for (std::size_t k = 0; k < moved.frames(); ++k) {
    if (overlaps(moved.still().boxes.front(), moved.moving(k).boxes.front())) {
      near.push_back(k);
    }
  }
  return middle_of(near, kQuickShare);
}

/// Counts of all frames. \errors std::logic_error where a frame's leaf pairs differ.
TraversalCounts counts_of(const MovedTrip& moved, const Racer& racer,
                          std::vector<std::uint64_t>& leaf_pairs, const Parallel& parallel) {
  FrameTraversal traversal(moved, racer);
  TraversalCounts sum;
  const bool first = leaf_pairs.empty();
  for (std::size_t k = 0; k < moved.frames(); ++k) {
    check_stop(parallel);
    const TraversalCounts counts = traversal.run(k);
    sum += counts;
    if (first) {
      leaf_pairs.push_back(counts.leaf_pairs);
    }
    require(counts.leaf_pairs == leaf_pairs[k],
            fmt::format("{} of {} past {}, frame {}: leaf pairs by {} and by another",
                        moved.trip().test, moved.trip().moving, moved.trip().still, k, racer.name));
  }
  return sum;
}

Raced raced(const Trip& trip, const Context& context, Steps& steps) {
  const Parallel quiet = steps.quiet();
  const MovedTrip moved(trip, quiet);
  const std::vector<std::size_t> frames = timed_frames(moved, context.quick);
  Raced result{&trip, frames.size()};
  std::vector<std::uint64_t> leaf_pairs;
  for (const Racer& racer : enode_racers()) {
    result.counts.push_back(counts_of(moved, racer, leaf_pairs, quiet));
  }
  const int rounds = enode_rounds(context);
  result.traversal = race(moved, enode_racers(), Question::leaf_pairs, frames, rounds, quiet);
  steps.done_one();
  if (trip.rule == "soms") {
    result.collision = race(moved, enode_racers(), Question::contacts, frames, rounds, quiet);
  }
  steps.done_one();
  return result;
}

ClaimRow count_row(const Kind& kind, const Pairing& pairing, std::string metric, Counter counter) {
  std::uint64_t one = 0;
  std::uint64_t other = 0;
  for (const Raced& trip : kind.raced) {
    one += trip.count(pairing.one).*counter;
    other += trip.count(pairing.other).*counter;
  }
  return counted_row(std::string(pairing.reading), std::move(metric), kind.name, "", kLess,
                     static_cast<double>(one) / static_cast<double>(other));
}

/// The ratio of the sums over trips.
Estimate ratio_of(std::span<const Raced> trips, const Pairing& pairing, Timed timed) {
  std::vector<double> one;
  std::vector<double> other;
  for (const Raced& trip : trips) {
    add_rounds(one, (trip.*timed)[static_cast<std::size_t>(pairing.one)].rounds);
    add_rounds(other, (trip.*timed)[static_cast<std::size_t>(pairing.other)].rounds);
  }
  return paired_ratio(one, other);
}

std::vector<ClaimRow> rows_of(const std::vector<Kind>& kinds) {
  std::vector<ClaimRow> rows;
  for (const Kind& kind : kinds) {
    for (const Pairing& pairing : counted_pairings()) {
      rows.push_back(
          count_row(kind, pairing, "pairs entered, E-Node / opponent", &TraversalCounts::entered));
    }
    for (const Pairing& pairing : counted_pairings()) {
      if (!pairing.same_tests) {
        rows.push_back(
            count_row(kind, pairing, "box tests, E-Node / opponent", &TraversalCounts::box_tests));
      }
    }
    for (const Pairing& pairing : timed_pairings()) {
      rows.push_back(measured_row(std::string(pairing.reading),
                                  "time of the traversal, E-Node / opponent", kind.name, "", kLess,
                                  ratio_of(kind.raced, pairing, &Raced::traversal)));
    }
    if (kind.raced.front().collision.empty()) {
      continue;
    }
    for (const Pairing& pairing : timed_pairings()) {
      rows.push_back(measured_row(std::string(pairing.reading),
                                  "time of traversal and triangles, E-Node / opponent", kind.name,
                                  "", kLess, ratio_of(kind.raced, pairing, &Raced::collision)));
    }
  }
  return rows;
}

Claim claim_of(const std::vector<Kind>& kinds) {
  return {
      .id = "enode_faster",
      .statement = "E-Node is faster than Larsson's depth-first traversal",
      .source = "abstract (\"more efficient and faster\"); the opponent: caption of figure 5.10",
      .rows = rows_of(kinds),
      .nearest = "family test, both nodes",
      .why =
          "The family test makes the same box tests as the depth-first traversal that descends "
          "the same nodes, one for one. It saves entering pairs that are apart, and pays with "
          "gathering a family before it enters one of it; so the ratio depends on what entering "
          "a pair costs, a step of an explicit stack or a call of a function. A start from the "
          "last front keeps a list of pairs from frame to frame, which costs time whether it "
          "saves box tests or not. A subject is all trips of a kind: counts and times are summed "
          "over them; the table has each trip.",
      .settles =
          "the pseudo code of E-Node and of Larsson's traversal in chapter 4, and whether "
          "the program of the thesis recurses",
      .revision =
          Revision{Verdict::does_not_hold, "it raced only a traversal by an explicit stack"}};
}

Table table_of(const std::vector<Kind>& kinds) {
  Table table{
      .id = "claim_enode_faster_trips",
      .caption = fmt::format(
          "Each trip by each traversal: counts over all frames, and medians of the processor time "
          "of the frames that were timed, without moving boxes (trees of level {}, scenes {}; "
          "recursive: by recursion, else by an explicit stack); with triangles on SOMS trees "
          "alone.{}",
          kObjectLevel, kSceneLevel, kThesisOptions),
      .columns = {{"static"}, {"moving"}, {"rule"}, {"test"}, {"algorithm"}, {"frames"}}};
  add_count_columns(table);
  table.columns.push_back({"timed_frames"});
  table.columns.push_back({"traversal", "ms", ColumnKind::timed});
  table.columns.push_back({"collision", "ms", ColumnKind::timed});
  for (const Kind& kind : kinds) {
    for (const Raced& trip : kind.raced) {
      for (std::size_t i = 0; i < trip.counts.size(); ++i) {
        std::vector<Cell> row{trip.trip->still,       trip.trip->moving,
                              trip.trip->rule,        trip.trip->test,
                              enode_racers()[i].name, count_cell(trip.trip->offsets.size())};
        add_count_cells(row, trip.counts[i]);
        row.push_back(count_cell(trip.timed_frames));
        row.push_back(number_cell(trip.traversal[i].median));
        row.push_back(trip.collision.empty() ? Cell{} : number_cell(trip.collision[i].median));
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

Figure figure_of(const std::vector<Kind>& kinds) {
  constexpr std::array<std::string_view, 3> kSeries{
      "E-Node by stack / stack", "E-Node by stack / recursion", "E-Node by recursion / recursion"};
  IntervalChart chart{
      .title = "E-Node's time to that of the simultaneous traversal",
      .x_label = "ratio of processor times of the traversal; shaded: E-Node is faster",
      .below = 1};
  for (const Kind& kind : kinds) {
    for (const Raced& trip : kind.raced) {
      for (std::size_t i = 0; i < kSeries.size(); ++i) {
        const Estimate ratio =
            ratio_of(std::span(&trip, 1), timed_pairings()[i], &Raced::traversal);
        chart.marks.push_back({kind.name, label_in_kind(*trip.trip), std::string(kSeries[i]),
                               ratio.value, ratio.interval});
      }
    }
  }
  return {.id = "claim_enode_faster",
          .caption =
              "E-Node (family test, both nodes) against the simultaneous traversal, which we "
              "take Larsson's to be, by explicit stack and by recursion: ratio of the times "
              "of each trip, with 95 % intervals.",
          .svg = draw(chart),
          .timed = true};
}

}  // namespace

Result claim_enode_faster(const Context& context) {
  EnodeTrips trips = enode_trips(context);
  Steps steps(context.parallel, 2 * trips.trips());
  std::vector<Kind> kinds;
  for (const TripKind& kind : trips.kinds) {
    kinds.push_back({kind.name});
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
