// How early a traversal comes to the first overlap: "Earlier Node detection".
#include "reproduce/enode_racers.h"
#include "reproduce/experiments/experiments.h"
#include "reproduce/interval_chart.h"
#include "reproduce/steps.h"
#include "reproduce/traversal_tables.h"
#include "reproduce/until_hit.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr Demand kLess{.below = 1};

/// So small a share of the frames of a drive with a hit is timed in a quick run.
constexpr std::size_t kQuickShare = 4;

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
  std::vector<Timing> times = {};       ///< by racer: of the query that stops; empty without a hit
};

struct Raced {
  const Trip* trip = nullptr;
  std::array<UpToHit, kHits.size()> hits = {};
};

struct Kind {
  std::string name;
  std::string rule;
  std::vector<Raced> raced = {};
};

using Counter = std::uint64_t UntilHit::*;
using Regime = std::vector<UntilHit> UpToHit::*;

UpToHit up_to_hit(const MovedTrip& moved, const HitWords& words, const Context& context,
                  const Parallel& quiet) {
  UpToHit result;
  const std::vector<std::size_t> all = moved.all_frames();
  for (const Racer& racer : enode_racers()) {
    const std::vector<std::size_t>& with_hit =
        result.stopped.empty() ? all : result.stopped.front().frames;
    result.stopped.push_back(until_hit(moved, racer, words.hit, true, with_hit, quiet));
    result.whole.push_back(racer.options.traversal == Traversal::e_node_front
                               ? until_hit(moved, racer, words.hit, false, all, quiet)
                               : result.stopped.back());
    require(result.whole.back().frames == result.stopped.front().frames &&
                result.stopped.back().frames == result.stopped.front().frames,
            fmt::format("{} of {} past {}: frames with a hit by {} and by another",
                        moved.trip().test, moved.trip().moving, moved.trip().still, racer.name));
  }
  const std::vector<std::size_t>& hits = result.stopped.front().frames;
  if (!hits.empty()) {
    const bool part = context.quick && moved.trip().moving != moved.trip().still;
    result.timed = part ? middle_of(hits, kQuickShare) : hits;
    const std::size_t passes = 1 + kBoxTestsARound / result.stopped.front().box_tests;
    result.times = race(moved, enode_racers(), words.question, result.timed, enode_rounds(context),
                        quiet, passes);
  }
  return result;
}

Raced raced(const Trip& trip, const Context& context, Steps& steps) {
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
  for (const Raced& trip : kind.raced) {
    const std::vector<Timing>& times = trip.hits[hit].times;
    if (!times.empty()) {
      add_rounds(one, times[static_cast<std::size_t>(pairing.one)].rounds);
      add_rounds(other, times[static_cast<std::size_t>(pairing.other)].rounds);
    }
  }
  return one.empty() ? std::nullopt : std::optional(paired_ratio(one, other));
}

bool starts_from_front(const Pairing& pairing) {
  return enode_racers()[static_cast<std::size_t>(pairing.one)].options.traversal ==
         Traversal::e_node_front;
}

/// From a fresh start a query that stops does the same work up to the hit as one that goes on; from
/// the last front it does not, for what the last query left out is in the front.
void add_count_rows(std::vector<ClaimRow>& rows, const Kind& kind, std::size_t hit,
                    std::string_view what, Counter counter) {
  for (const Pairing& pairing : counted_pairings()) {
    if (pairing.same_tests && counter == &UntilHit::box_tests) {
      continue;
    }
    const auto add = [&](Regime regime, std::string reading) {
      if (const auto ratio = ratio_of(kind, hit, pairing, regime, counter)) {
        rows.push_back(
            counted_row(std::move(reading),
                        fmt::format("{} up to {}, E-Node / opponent", what, kHits[hit].until),
                        kind.name, "", kLess, *ratio));
      }
    };
    const std::string reading(pairing.reading);
    if (starts_from_front(pairing)) {
      add(&UpToHit::whole, reading + "; queries that go on");
      add(&UpToHit::stopped, reading + "; queries that stop");
    } else {
      add(&UpToHit::whole, reading);
    }
  }
}

std::vector<ClaimRow> rows_of(const std::vector<Kind>& kinds) {
  std::vector<ClaimRow> rows;
  for (std::size_t hit = 0; hit < kHits.size(); ++hit) {
    for (const Kind& kind : kinds) {
      add_count_rows(rows, kind, hit, "box tests", &UntilHit::box_tests);
      add_count_rows(rows, kind, hit, "pairs entered", &UntilHit::entered);
      for (const Pairing& pairing : timed_pairings()) {
        if (const auto ratio = time_ratio(kind, hit, pairing)) {
          rows.push_back(measured_row(
              std::string(pairing.reading),
              fmt::format("time of queries that stop at {}, E-Node / opponent", kHits[hit].until),
              kind.name, "", kLess, *ratio));
        }
      }
    }
  }
  return rows;
}

Claim claim_of(const std::vector<Kind>& kinds) {
  return {
      .id = "enode_earlier",
      .statement =
          "Earlier Node detection: E-Node comes to an overlap earlier than Larsson's "
          "depth-first traversal",
      .source = "name of E-Node: heading of section 5.5",
      .rows = rows_of(kinds),
      .nearest = "family test, both nodes",
      .why =
          "A family is tested as a whole before one of its pairs is entered. So by pairs entered "
          "the first overlap may come earlier though by box tests it comes later. The front of "
          "the last frame lies near the first overlap of the next one, so a start from it skips "
          "most of the way down. Sums are over the frames that have a hit; from the front, "
          "counts of queries that go on take in all frames before, and queries that stop go "
          "from one frame with a hit to the next.",
      .settles = "the pseudo code of E-Node in chapter 4: what it does earlier, and than what",
      .revision = Revision{Verdict::does_not_hold, "it counted only box tests from a fresh start"}};
}

Table table_of(const std::vector<Kind>& kinds) {
  Table table{
      .id = "claim_enode_earlier_trips",
      .caption = fmt::format(
          "Each trip by each traversal up to the first hit of a frame, summed over the frames that "
          "have one: counts where the query goes on, counts and median processor time where it "
          "stops (trees of level {}, scenes {}; recursive: by recursion, else by an explicit "
          "stack).{}",
          kObjectLevel, kSceneLevel, kThesisOptions),
      .columns = {{"static"},
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
              {trip.trip->still, trip.trip->moving, trip.trip->rule, trip.trip->test,
               enode_racers()[i].name,
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
          {kind.name, std::string(pairing.reading), std::string(series), *value, interval});
    }
  };
  for (const Kind& kind : kinds) {
    if (kind.rule != "soms") {
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
              "ratio to the depth-first traversal that descends the same nodes, by reading "
              "of E-Node.",
          .svg = draw(chart),
          .timed = true};
}

}  // namespace

Result claim_enode_earlier(const Context& context) {
  EnodeTrips trips = enode_trips(context);
  Steps steps(context.parallel, kHits.size() * trips.trips());
  std::vector<Kind> kinds;
  for (const TripKind& kind : trips.kinds) {
    kinds.push_back({kind.name, kind.rule});
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
