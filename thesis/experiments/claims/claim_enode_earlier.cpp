// How early a traversal comes to the first overlap: "Earlier Node detection".
#include "soms/base/parallel.h"

#include "apps/draw/interval_chart.h"
#include "thesis/claims/thesis_claims.h"
#include "thesis/experiments/experiments.h"
#include "thesis/races/enode_racers.h"
#include "thesis/races/until_hit.h"
#include "thesis/run/steps.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr Demand kLess = demand_of("enode_earlier");

constexpr std::string_view kFewerEntered =
    "decided by construction: E-Node comes to the hit that its opponent finds first, or to another "
    "one before it, having entered only pairs that the opponent entered too, and not all of them";

/// So small a share of the frames with a hit is timed in a quick run.
constexpr std::size_t kQuickShare = 16;

/// So much work between two readings of the clock takes far longer than a reading.
constexpr std::uint64_t kBoxTestsARound = 10'000;

/// What counts as a hit, in words.
struct HitWords {
  Hit hit;
  Question question;
  std::string_view until;  ///< of a metric: "box tests up to ..."
};

constexpr std::array<HitWords, 2> kHits{
    {{Hit::leaf_pair, Question::first_leaf_pair, "the first overlapping leaves"},
     {Hit::contact, Question::first_contact, "the first triangles that touch"}}};

/// What all racers did on one trip up to a hit.
struct UpToHit {
  /// By racer: the query goes on to the end, which from a fresh start changes nothing up to the
  /// hit.
  std::vector<UntilHit> whole = {};
  std::vector<UntilHit> stopped = {};   ///< by racer: the query stops at the hit
  std::vector<std::size_t> timed = {};  ///< frames with a hit that were timed
  /// By racer: of the query that stops. Empty without a hit, and on other trees than SOMS'.
  std::vector<Timing> times = {};
};

struct Raced {
  const Trip* trip = nullptr;
  std::array<UpToHit, kHits.size()> hits = {};
};

struct Kind {
  const TripKind* of = nullptr;
  std::vector<Raced> raced = {};
};

using Counter = std::uint64_t UntilHit::*;
using Regime = std::vector<UntilHit> UpToHit::*;

/// Counts of all racers. \errors std::logic_error where their frames with a hit differ.
UpToHit counts_up_to_hit(const MovedTrip& moved, const HitWords& words, const Limits& limits) {
  const std::span<const TripRacer> racers = enode_racers();
  const std::vector<std::size_t> all = moved.all_frames();
  UpToHit result;
  result.stopped.resize(racers.size());
  result.whole.resize(racers.size());
  result.stopped[0] = until_hit(moved, racers[0], words.hit, true, all, limits);
  const std::vector<std::size_t>& hits = result.stopped[0].frames;
  for_each_chunk(racers.size(), 1, limits, [&](std::size_t i, std::size_t) {
    const bool goes_on = racers[i].options.traversal == Traversal::e_node_front;
    if (i > 0) {
      result.stopped[i] = until_hit(moved, racers[i], words.hit, true, hits, limits);
    }
    result.whole[i] =
        goes_on ? until_hit(moved, racers[i], words.hit, false, all, limits) : result.stopped[i];
  });
  for (std::size_t i = 0; i < racers.size(); ++i) {
    require(
        result.whole[i].frames == hits && result.stopped[i].frames == hits,
        fmt::format("{} of {} past {}: frames with a hit by {} and by another", moved.trip().test,
                    moved.trip().moving, moved.trip().still, racers[i].name));
  }
  return result;
}

/// What is to be timed, as processes tell it to one another: passes, then frames; empty if nothing
/// is.
Decision to_time(const UpToHit& counts, const Context& context) {
  const UntilHit& first = counts.stopped.front();
  if (first.frames.empty()) {
    return {};
  }
  const std::vector<std::size_t> frames =
      context.quick ? middle_of(first.frames, kQuickShare) : first.frames;
  Decision decision{static_cast<double>(1 + kBoxTestsARound / first.box_tests)};
  decision.insert(decision.end(), frames.begin(), frames.end());
  return decision;
}

UpToHit up_to_hit(const MovedTrip& moved, const HitWords& words, const Context& context,
                  const Limits& quiet) {
  if (moved.trip().rule != kEnodeRule) {
    return counts_up_to_hit(moved, words, context.counting());
  }
  UpToHit result;
  const Decision decision = context.races->decide(fmt::format("frames up to {}", words.until), [&] {
    result = counts_up_to_hit(moved, words, context.counting());
    return to_time(result, context);
  });
  if (!decision.empty()) {
    result.timed.assign(decision.begin() + 1, decision.end());
    result.times = race(*context.races, moved,
                        {.racers = enode_racers(),
                         .question = words.question,
                         .frames = result.timed,
                         .rounds = enode_rounds(context),
                         .passes = static_cast<std::size_t>(decision.front())},
                        quiet);
  }
  return result;
}

Raced raced(const Trip& trip, const Context& context, Steps& steps) {
  if (context.races->times_only() && trip.rule != kEnodeRule) {
    return {&trip};
  }
  const MovedTrip moved(trip, steps.quiet());
  Raced result{&trip};
  for (std::size_t i = 0; i < kHits.size(); ++i) {
    result.hits[i] = up_to_hit(moved, kHits[i], context, steps.quiet());
    steps.done_one();
  }
  return result;
}

/// The ratio of sums over trips; nothing if no frame has a hit.
std::optional<double> ratio_of(const Kind& kind, std::size_t hit, const Pairing& pairing,
                               Regime regime, Counter counter) {
  std::uint64_t one = 0;
  std::uint64_t other = 0;
  for (const Raced& trip : kind.raced) {
    const std::vector<UntilHit>& counts = trip.hits[hit].*regime;
    one += counts[static_cast<std::size_t>(pairing.one)].*counter;
    other += counts[static_cast<std::size_t>(pairing.other)].*counter;
  }
  return other == 0 ? std::nullopt
                    : std::optional(static_cast<double>(one) / static_cast<double>(other));
}

std::optional<Estimate> time_ratio(const Kind& kind, std::size_t hit, const Pairing& pairing) {
  std::vector<double> one;
  std::vector<double> other;
  int processes = 1;
  for (const Raced& trip : kind.raced) {
    const std::vector<Timing>& times = trip.hits[hit].times;
    if (!times.empty()) {
      processes = times.front().processes;
      add_rounds(one, times[static_cast<std::size_t>(pairing.one)].rounds);
      add_rounds(other, times[static_cast<std::size_t>(pairing.other)].rounds);
    }
  }
  return one.empty() ? std::nullopt : std::optional(paired_ratio(one, other, processes));
}

/// E-Node in three readings by a count. From a fresh start a query that stops does the same work up
/// to the hit as one that goes on; from the last front it does not, for what the last query left
/// out is in the front.
void add_count_rows(std::vector<ClaimRow>& rows, const Kind& kind, std::size_t hit,
                    std::string_view what, Counter counter) {
  const auto add = [&](const Pairing& pairing, Regime regime, std::string_view query,
                       std::string_view unjudged) {
    if (const auto ratio = ratio_of(kind, hit, pairing, regime, counter)) {
      rows.push_back(
          counted_row(reading_of(pairing) + std::string(query),
                      fmt::format("{} up to {}, E-Node / opponent", what, kHits[hit].until),
                      kind.of->subject(), "", kLess, *ratio));
      rows.back().unjudged = unjudged;
    }
  };
  const bool tests = counter == &UntilHit::box_tests;
  for (const Pairing& pairing : counted_pairings()) {
    if (pairing.one == RacerPlace::e_node_start) {
      add(pairing, &UpToHit::whole, ": queries that go on", {});
      add(pairing, &UpToHit::stopped, ": queries that stop", {});
    } else if (pairing.one == RacerPlace::e_node) {
      add(pairing, &UpToHit::whole, {}, tests ? std::string_view() : kFewerEntered);
    }
  }
}

void add_time_rows(std::vector<ClaimRow>& rows, const Kind& kind, std::size_t hit) {
  for (const Pairing& pairing : timed_pairings()) {
    if (const auto ratio = time_ratio(kind, hit, pairing)) {
      rows.push_back(measured_row(
          reading_of(pairing),
          fmt::format("time of queries that stop at {}, E-Node / opponent", kHits[hit].until),
          kind.of->subject(), "", kLess, *ratio));
    }
  }
}

/// What is not judged, up to the first hit: box tests, which are the same by stack and by
/// recursion.
void add_rows_aside(std::vector<ClaimRow>& rows, const Kind& kind) {
  for (Pairing pairing : pairings_aside()) {
    pairing.manner = {};
    if (pairing.one == RacerPlace::e_node_larger_start || pairing.other != RacerPlace::larger) {
      continue;  // in the table of trips
    }
    if (const auto ratio = ratio_of(kind, 0, pairing, &UpToHit::whole, &UntilHit::box_tests)) {
      rows.push_back(counted_row(
          reading_of(pairing), fmt::format("box tests up to {}, E-Node / opponent", kHits[0].until),
          kind.of->subject(), "", kLess, *ratio));
      rows.back().unjudged = pairing.unjudged;
    }
  }
}

std::vector<ClaimRow> rows_of(const std::vector<Kind>& kinds) {
  std::vector<ClaimRow> rows;
  for (std::size_t hit = 0; hit < kHits.size(); ++hit) {
    for (const Kind& kind : kinds) {
      if (kind.of->rule == kEnodeRule) {
        add_count_rows(rows, kind, hit, "box tests", &UntilHit::box_tests);
        add_count_rows(rows, kind, hit, "pairs entered", &UntilHit::entered);
        add_time_rows(rows, kind, hit);
      }
    }
  }
  for (const Kind& kind : kinds) {
    if (kind.of->rule == kEnodeRule) {
      add_rows_aside(rows, kind);
    }
  }
  return rows;
}

Claim claim_of(const std::vector<Kind>& kinds) {
  Claim claim = judged(thesis_claim("enode_earlier"), rows_of(kinds));
  claim.why =
      "The text has neither E-Node nor its opponent: we take Larsson's traversal to descend "
      "both nodes at once. A family is tested as a whole before one of its pairs is entered. "
      "So up to the first hit fewer pairs are entered, while boxes are tested that a traversal "
      "which goes down at once has not come to; by box tests it can come out either way. "
      "Descending on makes the box tests of the family test in the same "
      "order, so it has rows of time alone. The front of the last frame lies near the first "
      "overlap of the next one, so a start from it may skip most of the way down; it may also "
      "enter other pairs first. Sums are "
      "over the frames that have a hit; from the front, counts of queries that go on take in "
      "all frames before, and queries that stop go from one frame with a hit to the next. All "
      "rows are of SOMS trees, which E-Node is designed for; the table of trips has counts on "
      "other trees, and the larger node from the last front.";
  claim.note = ericson_words(claim.rows, fmt::format("box tests up to {}", kHits.front().until));
  claim.revision = revision_of(
      claim.rows,
      [](const ClaimRow& row) {
        return row.metric.starts_with("box tests") && row.reading == kNearestEnode;
      },
      "it counted only box tests from a fresh start");
  return claim;
}

Table table_of(const std::vector<Kind>& kinds) {
  Table table{
      .id = "claim_enode_earlier_trips",
      .caption = fmt::format(
          "Each trip by each traversal up to the first hit of a frame, summed over the frames that "
          "have one: counts where the query goes on, counts and median processor time where it "
          "stops (trees of level {}, scenes {}; recursive: by recursion, else by an explicit "
          "stack); times on SOMS trees alone.{}",
          kObjectLevel, kSceneLevel, kThesisOptions),
      .columns = {{"model"},
                  {"static"},
                  {"moving"},
                  {"rule"},
                  {"test"},
                  {"algorithm"},
                  {"hit"},
                  {"hit_frames"},
                  {"box_tests"},
                  {"entered"},
                  {"box_tests_stopped"},
                  {"entered_stopped"},
                  {"timed_frames"},
                  {"query", "ms", ColumnKind::timed}}};
  for (const Kind& kind : kinds) {
    for (const Raced& trip : kind.raced) {
      for (std::size_t hit = 0; hit < kHits.size(); ++hit) {
        const UpToHit& of_hit = trip.hits[hit];
        for (std::size_t i = 0; i < of_hit.whole.size(); ++i) {
          table.rows.push_back(
              {trip.trip->model, trip.trip->still, trip.trip->moving, trip.trip->rule,
               trip.trip->test, enode_racers()[i].name,
               std::string(kHits[hit].hit == Hit::leaf_pair ? "leaf_pair" : "contact"),
               count_cell(of_hit.whole[i].frames.size()), count_cell(of_hit.whole[i].box_tests),
               count_cell(of_hit.whole[i].entered), count_cell(of_hit.stopped[i].box_tests),
               count_cell(of_hit.stopped[i].entered), count_cell(of_hit.timed.size()),
               of_hit.times.empty() ? Cell{} : number_cell(of_hit.times[i].median)});
        }
      }
    }
  }
  return table;
}

Figure figure_of(const std::vector<Kind>& kinds) {
  IntervalChart chart{.title = "Up to the first overlapping leaves: E-Node to its opponent",
                      .x_label = "ratio; shaded: E-Node is earlier",
                      .below = 1};
  const auto add = [&](const Kind& kind, const Pairing& pairing, std::string_view series,
                       std::optional<double> value, std::optional<Interval> interval) {
    if (value) {
      chart.marks.push_back(
          {kind.of->subject(), std::string(pairing.e_node), std::string(series), *value, interval});
    }
  };
  for (const Kind& kind : kinds) {
    if (kind.of->rule != kEnodeRule) {
      continue;
    }
    for (const Pairing& pairing : counted_pairings()) {
      add(kind, pairing, "box tests",
          ratio_of(kind, 0, pairing, &UpToHit::whole, &UntilHit::box_tests), std::nullopt);
      add(kind, pairing, "pairs entered",
          ratio_of(kind, 0, pairing, &UpToHit::whole, &UntilHit::entered), std::nullopt);
      if (const auto time = time_ratio(kind, 0, pairing)) {
        add(kind, pairing, "time of a query that stops there (both by stack)", time->value,
            time->interval);
      }
    }
  }
  return {.id = "claim_enode_earlier",
          .caption =
              "Work and time up to the first pair of overlapping leaves on SOMS trees, as a "
              "ratio to the simultaneous traversal, which we take Larsson's to be, by "
              "reading of E-Node; from the last front, counts of queries that go on.",
          .svg = draw(chart),
          .timed = true};
}

}  // namespace

Result claim_enode_earlier(const Context& context) {
  EnodeTrips trips = enode_trips(context);
  Steps steps(context.limits, kHits.size() * trips.trips());
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
