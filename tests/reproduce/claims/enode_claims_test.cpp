// The claims about E-Node: the variant that only the experiments have, exact counts up to the first
// hit, and rows that are the same in two runs.
#include "soms/thesis/traversals.h"

#include "tests/reproduce/trips.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "thesis/races/e_node_chain.h"
#include "thesis/races/enode_racers.h"
#include "thesis/races/moved_trip.h"
#include "thesis/races/until_hit.h"
#include "thesis/run/traversal_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::reproduce {
namespace {

const TripRacer& racer_named(std::string_view name) {
  const auto racers = enode_racers();
  return *std::find_if(racers.begin(), racers.end(),
                       [&](const TripRacer& entry) { return entry.name == name; });
}

/// What a traversal did, in order.
struct Watched {
  TraversalCounts counts;
  std::vector<NodePair> reported;
  std::vector<std::pair<NodePair, bool>> tested;
  std::vector<NodePair> entered;
};

Watched watch(const MovedTrip& moved, std::string_view name, std::size_t frame,
              std::size_t most = 1'000'000) {
  FrameTraversal traversal(moved, racer_named(name));
  Watched seen;
  seen.counts = traversal.run(
      frame, {.leaf_pair =
                  [&](NodePair p) {
                    seen.reported.push_back(p);
                    return seen.reported.size() < most;
                  },
              .tested = [&](NodePair p, bool hit) { seen.tested.emplace_back(p, hit); },
              .entered = [&](NodePair p) { seen.entered.push_back(p); }});
  return seen;
}

EnodeTrips small_trips(const Models& models) {
  return enode_trips({.models = models, .quick = true});
}

TEST(EnodeChain, TestsAndReportsWhatENodeDoesInTheSameOrderAndEntersFewer) {
  const Models models = trips::small_models();
  std::uint64_t saved = 0;
  for (const TripKind& kind : small_trips(models).kinds) {
    for (const Trip& trip : kind.trips) {
      const MovedTrip moved(trip, {});
      for (std::size_t k = 0; k < moved.frames(); ++k) {
        const Watched chain = watch(moved, "enode_both_chain", k);
        const Watched e_node = watch(moved, "enode_both", k);
        ASSERT_EQ(chain.tested, e_node.tested);
        ASSERT_EQ(chain.reported, e_node.reported);
        EXPECT_EQ(chain.counts.first_tests, e_node.counts.first_tests);
        EXPECT_EQ(chain.counts.entered, chain.entered.size());
        saved += e_node.counts.entered - chain.counts.entered;
        std::size_t found = 0;  // what it enters is entered by E-Node in the same order
        for (const NodePair p : e_node.entered) {
          found += found < chain.entered.size() && chain.entered[found] == p ? 1U : 0U;
        }
        EXPECT_EQ(found, chain.entered.size());
      }
    }
  }
  EXPECT_GT(saved, 0U);
}

TEST(EnodeChain, StopsAtTheFirstReportAndTakesEmptyTrees) {
  const Models models = trips::small_models();
  const EnodeTrips trips = small_trips(models);
  const MovedTrip moved(trips.kinds[0].trips[0], {});
  for (std::size_t k = 0; k < moved.frames(); ++k) {
    EXPECT_LE(watch(moved, "enode_both_chain", k, 1).reported.size(), 1U);
    EXPECT_EQ(watch(moved, "enode_both_chain", k, 1).tested,
              watch(moved, "enode_both", k, 1).tested);
  }
  const Tree empty;
  TraversalWorkspace workspace;
  EXPECT_EQ(e_node_chain({&empty, {}}, {&empty, {}}, false, {}, workspace), TraversalCounts{});
}

TEST(EnodeRacers, RecursionMakesTheSameTestsReportsAndEntries) {
  const Models models = trips::small_models();
  for (const TripKind& kind : small_trips(models).kinds) {
    const MovedTrip moved(kind.trips[0], {});
    for (const std::string name : {"simultaneous", "enode_both", "enode_both_chain"}) {
      for (std::size_t k = 0; k < moved.frames(); k += 7) {
        const Watched by_stack = watch(moved, name, k);
        const Watched nested = watch(moved, name + "_recursive", k);
        EXPECT_EQ(by_stack.tested, nested.tested);
        EXPECT_EQ(by_stack.reported, nested.reported);
        EXPECT_EQ(by_stack.entered, nested.entered);
      }
    }
  }
}

TEST(EnodeRacers, AllFindTheSameLeafPairsContactsAndFramesWithAHit) {
  const Models models = trips::small_models();
  for (const TripKind& kind : small_trips(models).kinds) {
    for (const Trip& trip : kind.trips) {
      const Totals truth = totals(answer_frames(trip, named_traversal("larger"), {}));
      const MovedTrip moved(trip, {});
      for (const TripRacer& racer : enode_racers()) {
        SCOPED_TRACE(racer.name);
        FrameTraversal traversal(moved, racer);
        const std::vector<std::size_t> all = moved.all_frames();
        EXPECT_EQ(ask(moved, traversal, Question::leaf_pairs, all), truth.counts.leaf_pairs);
        EXPECT_EQ(ask(moved, traversal, Question::contacts, all), truth.contacts);
        EXPECT_EQ(ask(moved, traversal, Question::first_leaf_pair, all), truth.hit_frames);
      }
    }
  }
}

TEST(UntilHit, FromAFreshStartAQueryThatStopsDoesTheSameWorkUpToTheHit) {
  const Models models = trips::small_models();
  for (const TripKind& kind : small_trips(models).kinds) {
    const MovedTrip moved(kind.trips[0], {});
    const std::vector<std::size_t> all = moved.all_frames();
    for (const TripRacer& racer : enode_racers()) {
      for (const Hit hit : {Hit::leaf_pair, Hit::contact}) {
        const UntilHit whole = until_hit(moved, racer, hit, false, all, {});
        const UntilHit stopped = until_hit(moved, racer, hit, true, all, {});
        EXPECT_EQ(whole.frames, stopped.frames);
        if (racer.options.traversal != Traversal::e_node_front) {
          EXPECT_EQ(whole.box_tests, stopped.box_tests) << racer.name;
          EXPECT_EQ(whole.entered, stopped.entered) << racer.name;
        }
      }
    }
  }
}

/// Box tests and pairs entered up to the first hit of one frame.
UntilHit until_hit_of(const MovedTrip& moved, std::string_view name, Hit hit, std::size_t frame) {
  return until_hit(moved, racer_named(name), hit, true, std::array{frame}, {});
}

TEST(UntilHit, InEachFrameTheFamilyTestEntersFewerPairsThanItsOpponent) {
  const Models models = trips::small_models();
  std::size_t seen = 0;
  for (const TripKind& kind : small_trips(models).kinds) {
    for (const Trip& trip : kind.trips) {
      const MovedTrip moved(trip, {});
      for (const Hit hit : {Hit::leaf_pair, Hit::contact}) {
        for (std::size_t k = 0; k < moved.frames(); ++k) {
          const UntilHit opponent = until_hit_of(moved, "simultaneous", hit, k);
          if (!opponent.frames.empty()) {
            const std::uint64_t entered = until_hit_of(moved, "enode_both", hit, k).entered;
            EXPECT_LT(entered, opponent.entered);
            EXPECT_LE(until_hit_of(moved, "enode_both_chain", hit, k).entered, entered);
            EXPECT_LT(until_hit_of(moved, "enode_larger", hit, k).entered,
                      until_hit_of(moved, "larger", hit, k).entered);
            ++seen;
          }
        }
      }
    }
  }
  EXPECT_GT(seen, 50U);
}

/// A tree of boxes alone: a leaf, or children left and right.
std::uint32_t plant(Tree& tree, const Box& box) {
  tree.nodes.push_back({.bounds = box});
  return static_cast<std::uint32_t>(tree.nodes.size() - 1);
}

std::vector<Box> boxes_of(const Tree& tree) {
  std::vector<Box> boxes;
  for (const Node& node : tree.nodes) {
    boxes.push_back(node.bounds);
  }
  return boxes;
}

// The opponent goes down to four leaves beside a leaf before it comes to the leaf on it.
TEST(UntilHit, BoxTestsUpToTheFirstLeavesMayComeOutEitherWay) {
  const auto slab = [](double from, double to) { return Box{{from, 0, 0}, {to, 1, 1}}; };
  Tree a;
  plant(a, slab(0, 10));
  a.nodes[0].left = plant(a, slab(0, 1));
  a.nodes[0].right = plant(a, slab(9, 10));
  Tree b;
  plant(b, slab(-3, 4));
  b.nodes[0].left = plant(b, slab(-3, 4));
  for (const bool right : {false, true}) {
    const std::uint32_t inner = plant(b, slab(-3, 4));
    (right ? b.nodes[1].right : b.nodes[1].left) = inner;
    b.nodes[inner].left = plant(b, slab(-3, -2));
    b.nodes[inner].right = plant(b, slab(3, 4));
  }
  b.nodes[0].right = plant(b, slab(0, 1));
  const std::vector<Box> of_a = boxes_of(a);
  const std::vector<Box> of_b = boxes_of(b);
  const auto first_tests = [&](std::string_view name) {
    return traverse({&a, of_a}, {&b, of_b}, racer_named(name).options).first_tests;
  };
  EXPECT_EQ(first_tests("enode_both"), 5U);
  EXPECT_EQ(first_tests("simultaneous"), 9U);
}

/// "box tests/pairs entered" up to the first leaf pair, and up to the first contact, of queries
/// that go on.
std::vector<std::string> until_hits(const Trip& trip, std::string_view name) {
  const MovedTrip moved(trip, {});
  std::vector<std::string> counts;
  for (const Hit hit : {Hit::leaf_pair, Hit::contact}) {
    const UntilHit sum = until_hit(moved, racer_named(name), hit, false, moved.all_frames(), {});
    counts.push_back(std::to_string(sum.box_tests) + "/" + std::to_string(sum.entered));
  }
  return counts;
}

using CountColumns = std::vector<std::string>;

TEST(UntilHit, GoldenCountsOnGeneratedShapes) {
  const Models models = trips::small_models();
  const EnodeTrips trips = small_trips(models);
  const Trip& right = trips.kinds[0].trips[0];
  EXPECT_EQ(until_hits(right, "simultaneous"), (CountColumns{"238/238", "1443/1443"}));
  EXPECT_EQ(until_hits(right, "enode_both"), (CountColumns{"435/111", "1540/512"}));
  EXPECT_EQ(until_hits(right, "enode_both_chain"), (CountColumns{"435/86", "1540/393"}));
  EXPECT_EQ(until_hits(right, "enode_start_both"), (CountColumns{"94/12", "84/0"}));
  EXPECT_EQ(until_hits(right, "enode_start"), (CountColumns{"69/18", "82/0"}));
}

TEST(UntilHit, GoldenCountsOnTheBunny) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  SOMS_NEEDS_OUTSIDE_DATA("ply/bun_zipper_res4.ply");
  const Models models = find_models(*soms::test::outside_data(""), {.objects = true});
  const std::vector<Contender> builds = thesis_rules(kObjectLevel);
  const auto trip = [&](Approach from) {
    return orientation_trip(models.objects.front(), from, build_named(builds, "soms"));
  };
  const Trip right = trip(Approach::right);
  EXPECT_EQ(until_hits(right, "simultaneous")[0], "573/573");
  EXPECT_EQ(until_hits(right, "enode_both")[0], "871/230");
  EXPECT_EQ(until_hits(right, "enode_start")[0].substr(0, 4), "189/");
  const Trip top = trip(Approach::top);
  EXPECT_EQ(until_hits(top, "simultaneous")[0], "540/540");
  EXPECT_EQ(until_hits(top, "enode_both")[0], "860/230");
  EXPECT_EQ(until_hits(top, "enode_start")[0].substr(0, 4), "218/");
}

class EnodeClaims : public testing::TestWithParam<std::string_view> {};

TEST_P(EnodeClaims, HaveTheSameCountsInTwoRunsAndWholeIntervals) {
  const Models models = trips::small_models();
  const Result one = trips::run_quick(GetParam(), models);
  const Result other = trips::run_quick(GetParam(), models);
  ASSERT_EQ(one.claims.size(), 1U);
  const std::vector<ClaimRow>& rows = one.claims[0].rows;
  ASSERT_EQ(rows.size(), other.claims.at(0).rows.size());
  EXPECT_FALSE(rows.empty());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ClaimRow& again = other.claims[0].rows[i];
    EXPECT_EQ(rows[i].metric + rows[i].reading + rows[i].subject,
              again.metric + again.reading + again.subject);
    EXPECT_TRUE(std::isfinite(rows[i].value)) << rows[i].metric << ", " << rows[i].reading;
    if (rows[i].interval) {
      EXPECT_LE(rows[i].interval->low, rows[i].value);
      EXPECT_GE(rows[i].interval->high, rows[i].value);
      EXPECT_GE(rows[i].rounds, 10);
    } else {
      EXPECT_EQ(rows[i].value, again.value) << rows[i].metric << ", " << rows[i].reading;
    }
  }
}

TEST_P(EnodeClaims, DoWithoutScenesAndOffTheirPath) {
  Models models = trips::small_models();
  Mesh away = *models.scenes[0].mesh;
  for (Vec3& v : away.vertices) {
    v += {0, 90000, 0};
  }
  models.scenes[0].mesh = std::make_shared<const Mesh>(std::move(away));
  for (const bool scene : {true, false}) {
    if (!scene) {
      models.scenes.clear();
    }
    const Result result = trips::run_quick(GetParam(), models);
    EXPECT_EQ(result.claims.size(), 1U);
    for (const Figure& figure : result.figures) {
      EXPECT_EQ(figure.svg.find("nan"), std::string::npos);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Reproduce, EnodeClaims,
                         testing::Values("claim-enode-faster", "claim-enode-earlier",
                                         "claim-enode-time"),
                         [](const auto& test) {
                           std::string name(test.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(EnodeClaim, FasterJudgesTimesAlone) {
  const Result result = trips::run_quick("claim-enode-faster", trips::small_models());
  std::size_t seen = 0;
  for (const ClaimRow& row : result.claims[0].rows) {
    const bool larsson = row.reading.find("both nodes, against Larsson") != std::string::npos;
    EXPECT_EQ(row.unjudged.empty(), row.interval && larsson) << row.metric << ", " << row.reading;
    if (row.reading == kNearestEnode) {
      EXPECT_FALSE(row.interval);
      EXPECT_TRUE(row.metric.starts_with("box tests") ? row.value == 1 : row.value <= 0.5)
          << row.metric;
      ++seen;
    }
  }
  EXPECT_EQ(seen, 6U);
}

TEST(EnodeClaim, EarlierJudgesAllThatIsNotDecidedByConstruction) {
  const Result result = trips::run_quick("claim-enode-earlier", trips::small_models());
  for (const ClaimRow& row : result.claims[0].rows) {
    const bool larsson = row.reading.find("both nodes, against Larsson") != std::string::npos;
    const bool decided = row.metric.starts_with("pairs entered") && row.reading == kNearestEnode;
    EXPECT_EQ(row.unjudged.empty(), larsson && !decided) << row.metric << ", " << row.reading;
  }
}

TEST(EnodeClaim, StandsOnSomsTreesInAllFourWaysToProgramIt) {
  for (const std::string_view item : {"claim-enode-faster", "claim-enode-earlier"}) {
    const Result result = trips::run_quick(item, trips::small_models());
    EXPECT_EQ(subjects_of(result.claims[0]),
              (std::vector<std::string>{"bunny, orientation tests", "bunny, drives",
                                        "bunny, touching drives"}));
    std::set<std::string> ways;
    for (const ClaimRow& row : result.claims[0].rows) {
      if (is_nearest(result.claims[0], row) && row.interval) {
        ways.insert(row.reading.substr(kNearestEnode.size()));
      }
    }
    EXPECT_EQ(ways, (std::set<std::string>{": stack / stack", ": stack / recursion",
                                           ": recursion / stack", ": recursion / recursion"}));
  }
}

TEST(EnodeTrips, ComeFromAllFourSidesOnSomsTreesAndOthers) {
  const Models models = trips::small_models();
  std::vector<std::string> names;
  for (const TripKind& kind : small_trips(models).kinds) {
    names.push_back(kind.tests + ", " + kind.rule + ":");
    for (const Trip& trip : kind.trips) {
      names.back() += " " + label_in_kind(trip);
    }
  }
  EXPECT_EQ(names, (std::vector<std::string>{
                       "orientation tests, soms: right left top bottom",
                       "orientation tests, spatial_median: right left top bottom",
                       "drives, soms: ball", "touching drives, soms: ball",
                       "drives, object_median: ball", "touching drives, object_median: ball"}));
}

TEST(EnodeClaim, TheOtherOpponentStandsBesideTheVerdict) {
  const std::string reading = "family test, both nodes, against Ericson's (larger node)";
  const std::vector<ClaimRow> rows{
      counted_row(reading, "tests, a / b", "s", "", {}, 2),
      counted_row(reading, "tests, a / b", "t", "", {}, 0.5),
      counted_row(reading, "time, a / b", "s", "", {}, 9),
      counted_row(std::string(kNearestEnode), "tests", "s", "", {}, 8)};
  EXPECT_EQ(ericson_words(rows, "tests"),
            "Against Ericson's traversal, which descends the larger node: ratio of tests from 0.5 "
            "to 2 (not judged).");
  EXPECT_EQ(ericson_words(rows, "pairs"), "");
}

TEST(EnodeClaim, WhatChangedAVerdictIsSaidOnlyIfItDid) {
  const auto all = [](const ClaimRow&) { return true; };
  const std::vector<ClaimRow> fails{counted_row("r", "m", "s", "", {.below = 1}, 2)};
  const std::vector<ClaimRow> holds{counted_row("r", "m", "s", "", {.below = 1}, 0.5)};
  EXPECT_EQ(revision_of(fails, all, "of this").reason, "of this");
  EXPECT_NE(revision_of(holds, all, "of this").reason, "of this");
}

TEST(EnodeClaim, TheTimeOfAnotherSceneAndMachineIsNotJudged) {
  const Result result = trips::run_quick("claim-enode-time", trips::small_models());
  EXPECT_EQ(verdict_of(result.claims[0]), Verdict::cannot_be_checked);
}

TEST(MiddleOf, TakesNeighborsFromTheMiddle) {
  std::vector<std::size_t> frames(10);
  std::iota(frames.begin(), frames.end(), 100U);
  EXPECT_EQ(middle_of(frames, 5), (std::vector<std::size_t>{104, 105}));
  EXPECT_EQ(middle_of(frames, 100), (std::vector<std::size_t>{104}));
  EXPECT_TRUE(middle_of({}, 4).empty());
}

}  // namespace
}  // namespace soms::reproduce
