// What holds for every question, whatever it means: one loop over the table of questions.
#include "tests/support/truth/query_table.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/tree/rule/rules.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/needs_instruction_set.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

namespace soms {
namespace {

using test::Answer;
using test::PairTruth;
using test::QueryRow;
using test::Two;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

using QueryTable = test::NeedsInstructionSet;

/// Every question about the two bodies, at every length that is worth it.
template <class Check>
void for_each_question(const Two& two, const PairTruth& truth, const Check& check) {
  for (const QueryRow& row : test::query_table(two.a, two.b)) {
    for (const double length : test::lengths_around(row, truth.distance.distance)) {
      SCOPED_TRACE(std::string(row.name) + " at " + std::to_string(length));
      ASSERT_NO_FATAL_FAILURE(check(row, test::RowOptions{.length = length}));
    }
  }
}

void expect_right(const Two& two) {
  ASSERT_EQ(test::first_fault(two.a, two.b), "");
}

/// For more and larger bodies: of overlap alone, whose twin is quick.
void expect_right_overlap(const Two& two) {
  ASSERT_EQ(test::first_fault_of_overlap(two.a, two.b), "");
}

TEST_F(QueryTable, EqualsTheTwinsOnBodiesOfUsualSize) {
  test::for_each_case("table/usual", test::some_of(150), [](Rng& rng) {
    expect_right(test::likely_to_meet(rng, 40, 1, rng.uniform(0.1, 1), 0));
  });
  test::for_each_case("overlap/usual", test::some_of(600), [](Rng& rng) {
    expect_right_overlap(test::likely_to_meet(rng, 120, 1, rng.uniform(0.1, 1), 0));
  });
}

TEST_F(QueryTable, EqualsTheTwinsWhereSizesDiffer) {
  test::for_each_case("table/sizes", test::some_of(100), [](Rng& rng) {
    const double small = std::exp2(-rng.uniform(0, 60));
    expect_right(test::likely_to_meet(rng, 40, rng.below(2) ? 1 : small, small, 0));
  });
  test::for_each_case("overlap/sizes", test::some_of(300), [](Rng& rng) {
    const double small = std::exp2(-rng.uniform(0, 60));
    expect_right_overlap(test::likely_to_meet(rng, 100, rng.below(2) ? 1 : small, small, 0));
  });
}

TEST_F(QueryTable, EqualsTheTwinsFarFromTheOrigin) {
  test::for_each_case("table/far", test::some_of(100), [](Rng& rng) {
    expect_right(test::likely_to_meet(rng, 40, 1, 1, std::exp2(rng.uniform(0, 60))));
  });
  test::for_each_case("overlap/far", test::some_of(300), [](Rng& rng) {
    expect_right_overlap(test::likely_to_meet(rng, 80, 1, 1, std::exp2(rng.uniform(0, 60))));
  });
}

TEST_F(QueryTable, EqualsTheTwinsAtEveryScale) {
  const auto two_at_any = [](Rng& rng, int most) {
    const double scale = std::exp2(rng.uniform(-1070, 297));
    const double other = rng.below(2) ? scale : std::exp2(rng.uniform(-1070, 297));
    return test::likely_to_meet(rng, most, scale, other, 0);
  };
  test::for_each_case("table/scales", test::some_of(100),
                      [&](Rng& rng) { expect_right(two_at_any(rng, 25)); });
  test::for_each_case("overlap/scales", test::some_of(300),
                      [&](Rng& rng) { expect_right_overlap(two_at_any(rng, 60)); });
}

TEST_F(QueryTable, EqualsTheTwinsOfTinyBodiesFarAway) {
  const auto tiny_far = [](Rng& rng, int most) {
    const double scale = std::exp2(rng.uniform(-120, 0));
    return test::likely_to_meet(rng, most, scale, scale, std::exp2(rng.uniform(-60, 60)));
  };
  test::for_each_case("table/tiny-far", test::some_of(100),
                      [&](Rng& rng) { expect_right(tiny_far(rng, 15)); });
  test::for_each_case("overlap/tiny-far", test::some_of(200),
                      [&](Rng& rng) { expect_right_overlap(tiny_far(rng, 30)); });
}

/// Bodies that do not touch: the second is moved off by up to 1e9 sizes.
Two apart(Rng& rng, int most) {
  Two two = test::likely_to_meet(rng, most, 1, rng.uniform(0.1, 1), 0);
  const double by = std::exp2(rng.uniform(-3, rng.below(4) == 0 ? 30 : 3));
  const std::array<Vec3, 3> directions{
      Vec3{1, 0, 0}, Vec3{0, -1, 1},
      Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)}};
  const Vec3 shift = directions[rng.below(3)] * by;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    two.b.pose.m[4 * axis + 3] += shift[axis];
  }
  return two;
}

TEST_F(QueryTable, EqualsTheTwinsOnBodiesApart) {
  test::for_each_case("table/apart", test::some_of(200),
                      [](Rng& rng) { expect_right(apart(rng, 40)); });
}

/// Two closed bodies that are likely to meet: each triangle with the three that join its edges to
/// one point. Small ones, since exact decisions about faces in a plane take their time.
Two likely_to_meet_closed(Rng& rng, double size, double far) {
  Two two = test::likely_to_meet(rng, 5, 1, size, far);
  for (Body* body : {&two.a, &two.b}) {
    const Vec3 apex = test::point_in(rng, body->shape.bounds());
    *body = Body(test::coned(Mesh(body->shape.mesh()), apex), body->pose);
  }
  return two;
}

TEST_F(QueryTable, EqualsTheTwinsOnClosedBodies) {
  test::for_each_case("table/closed", test::some_of(25), [](Rng& rng) {
    const double size = rng.below(2) == 0 ? 1 : std::exp2(-rng.uniform(0, 60));
    const double far = rng.below(2) == 0 ? 0 : std::exp2(rng.uniform(0, 40));
    expect_right(likely_to_meet_closed(rng, size, far));
  });
}

// Costs, too, where the whole question was answered.
TEST_F(QueryTable, IsTheSameForAnyNumberOfThreads) {
  test::for_each_case("table/threads", test::some_of(60), [](Rng& rng) {
    Two two = rng.below(3) == 0 ? apart(rng, 300) : test::likely_to_meet(rng, 300, 1, 0.5, 0);
    if (rng.below(6) == 0) {
      two = likely_to_meet_closed(rng, 0.5, 0);
    }
    const PairTruth facts = {{}, distance(two.a, two.b)};
    for_each_question(two, facts, [&](const QueryRow& row, const test::RowOptions& options) {
      const Answer one = row.ask(two.a, two.b, options, {});
      for (const int threads : {2, 3, 8}) {
        const Answer many = row.ask(two.a, two.b, options, {.threads = threads});
        ASSERT_EQ(row.promised(many), row.promised(one)) << row.text(many);
        if (test::coverage_of(one) == Coverage::complete) {
          ASSERT_EQ(test::cost_of(many), test::cost_of(one)) << row.text(many);
        }
      }
    });
  });
}

TEST_F(QueryTable, IsTheSameForEveryRuleAndLayout) {
  test::for_each_case("table/layouts", test::some_of(25), [](Rng& rng) {
    Two two = rng.below(2) == 0 ? apart(rng, 100) : test::likely_to_meet(rng, 100, 1, 0.5, 0);
    if (rng.below(6) == 0) {
      two = likely_to_meet_closed(rng, 0.5, 0);
    }
    const PairTruth facts = {{}, distance(two.a, two.b)};
    for (const RuleEntry& rule : rules()) {
      for (const Layout layout : {Layout::wide, Layout::compact}) {
        const auto built = [&](const Body& old, int per_leaf) {
          const BuildOptions build{.rule = rule.rule, .per_leaf = per_leaf};
          return Body(Shape(old.shape.shared_mesh(), {.build = build, .layout = layout}), old.pose);
        };
        const Two other{built(two.a, 4), built(two.b, 1)};
        for_each_question(two, facts, [&](const QueryRow& row, const test::RowOptions& options) {
          const Answer expected = row.promised(row.ask(two.a, two.b, options, {}));
          const Answer answer = row.ask(other.a, other.b, options, {});
          ASSERT_EQ(row.promised(answer), expected) << rule.name << ' ' << row.text(answer);
        });
      }
    }
  });
}

TEST_F(QueryTable, AnswersABatchAsItAnswersSingleQueries) {
  test::for_each_case("table/batch", test::some_of(40), [](Rng& rng) {
    Two two = test::likely_to_meet(rng, 80, 1, rng.below(2) ? 0.2 : 3, 0);
    if (rng.below(6) == 0) {
      two = likely_to_meet_closed(rng, 0.5, 0);
    }
    std::vector<Pose> poses;
    for (std::uint64_t i = rng.below(300); i > 0; --i) {
      poses.push_back(
          test::moving(test::awkward_rotation(rng), {}, test::point_in(rng, two.b.shape.bounds())));
      poses.back().m[3] += rng.below(3) == 0 ? 2 : 0;
    }
    const int threads = rng.below(2) == 0 ? 1 : 2;
    // A surface may be closed at one pose and not at another.
    std::span<const QueryRow> rows = test::query_table(two.a, two.b);
    for (const Pose& pose : poses) {
      const std::span<const QueryRow> here = test::query_table(Body(two.a.shape, pose), two.b);
      rows = here.size() < rows.size() ? here : rows;
    }
    for (const QueryRow& row : rows) {
      for (const double length : {kNoLimit, 0.0, 0.25}) {
        if (!row.takes_length && length < kNoLimit) {
          break;
        }
        const test::BatchAnswer batch =
            row.ask_batch(two.a.shape, poses, two.b, {.length = length}, {.threads = threads});
        ASSERT_EQ(batch.answers.size(), poses.size());
        Cost cost;
        for (std::size_t k = 0; k < poses.size(); ++k) {
          const Answer single = row.ask(Body(two.a.shape, poses[k]), two.b, {.length = length}, {});
          ASSERT_EQ(batch.answers[k], single) << row.text(batch.answers[k]) << '\n'
                                              << row.text(single);
          cost += test::cost_of(single);
        }
        ASSERT_EQ(batch.cost, cost) << row.name;
      }
    }
  });
}

TEST_F(QueryTable, AnswersForEmptyMeshes) {
  const Body nothing;
  const Body one{generate_sphere(80)};
  const std::vector<Pose> poses(3);
  for (const auto& [a, b] : {Two{nothing, one}, Two{one, nothing}, Two{nothing, nothing}}) {
    expect_right({a, b});
    for (const QueryRow& row : test::query_table()) {
      for (const Answer& answer :
           row.ask_batch(a.shape, poses, b, {.length = 1}, {.threads = 2}).answers) {
        EXPECT_EQ(row.promised(answer), row.promised(row.ask(a, b, {.length = 1}, {})));
      }
    }
  }
}

/// The kind and the place of the error that a query ends with.
template <class Query>
Error error_of(const Query& query) {
  try {
    query();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "it was answered";
  return {ErrorKind::usage, "", ""};
}

TEST_F(QueryTable, NamesThePoseAtFault) {
  const Body one{generate_sphere(80)};
  for (const QueryRow& row : test::query_table()) {
    SCOPED_TRACE(row.name);
    const auto error_at = [&](std::size_t k, const Pose& pose) {
      std::vector<Pose> poses(5);
      poses[k] = pose;
      const Error single = error_of(
          [&] { static_cast<void>(row.ask(Body(one.shape, pose), one, {.length = 1}, {})); });
      const Error fixed = error_of(
          [&] { static_cast<void>(row.ask(one, Body(one.shape, pose), {.length = 1}, {})); });
      const Error batch = error_of([&] {
        static_cast<void>(row.ask_batch(one.shape, poses, one, {.length = 1}, {.threads = 2}));
      });
      EXPECT_EQ(single.kind(), batch.kind());
      EXPECT_EQ(fixed.kind(), batch.kind());
      EXPECT_NE(batch.place().find("pose " + std::to_string(k)), std::string::npos)
          << batch.place();
      return batch.kind();
    };
    Pose stretched;
    stretched.m[5] = 2;
    EXPECT_EQ(error_at(3, stretched), ErrorKind::not_rigid);
    EXPECT_EQ(error_at(4, Pose::translation(0x1p301, 0, 0)), ErrorKind::out_of_range);
    EXPECT_EQ(error_at(0, Pose::translation(0, std::numeric_limits<double>::quiet_NaN(), 0)),
              ErrorKind::not_finite);
  }
}

TEST_F(QueryTable, RefusesALengthThatIsNegativeOrNotANumber) {
  const Body one{generate_sphere(80)};
  const std::vector<Pose> poses(2, Pose::translation(3, 0, 0));
  const std::array lengths{-0.1, -0x1p-1074, -kNoLimit, std::numeric_limits<double>::quiet_NaN()};
  for (const QueryRow& row : test::query_table()) {
    if (!row.takes_length) {
      continue;
    }
    for (const double length : lengths) {
      SCOPED_TRACE(std::string(row.name) + " at " + std::to_string(length));
      const test::RowOptions options{.length = length};
      const Error single = error_of([&] { static_cast<void>(row.ask(one, one, options, {})); });
      EXPECT_EQ(single.kind(), ErrorKind::usage);
      EXPECT_FALSE(single.place().empty());
      EXPECT_EQ(error_of([&] {
                  static_cast<void>(row.ask_batch(one.shape, poses, one, options, {}));
                }).kind(),
                ErrorKind::usage);
      EXPECT_EQ(error_of([&] {
                  static_cast<void>(row.ask_batch(one.shape, {}, one, options, {}));
                }).kind(),
                ErrorKind::usage);
      EXPECT_EQ(error_of([&] { static_cast<void>(row.ask(Body(), one, options, {})); }).kind(),
                ErrorKind::usage);
    }
    EXPECT_EQ(row.promised(row.ask(one, one, {.length = -0.0}, {})),
              row.promised(row.ask(one, one, {.length = 0.0}, {})));
  }
}

// A cut answer says so, and says nothing that is wrong. A question that the root boxes decide may
// be answered all the same.
TEST_F(QueryTable, EndsAtADeadline) {
  const Body knot{generate_knot(600)};
  for (const double x : {0.125, 2.5}) {
    const Body other(knot.shape, Pose::from_quaternion(0.8, 0.36, 0.48, 0, {x, 0.25, 0.125}));
    const PairTruth truth = test::truth_of(knot, other);
    for_each_question({knot, other}, truth, [&](const QueryRow& row, test::RowOptions options) {
      options.late = true;
      std::vector<Answer> answers =
          row.ask_batch(knot.shape, std::vector<Pose>(3), other, options, {}).answers;
      answers.push_back(row.ask(knot, other, options, {}));
      answers.push_back(row.ask(knot, other, options, {.threads = 2}));
      for (const Answer& answer : answers) {
        const bool must_be_cut = row.takes_length ? row.name == "distance" && options.length > 2
                                                  : row.name != "overlap any" && truth.overlap.any;
        ASSERT_TRUE(test::coverage_of(answer) == Coverage::cut || !must_be_cut) << row.text(answer);
        ASSERT_EQ(row.fault(answer, truth, knot, other, options.length), "") << row.text(answer);
      }
    });
  }
}

TEST_F(QueryTable, EndsWhenAStopIsRequested) {
  const Body knot{generate_knot(600)};
  const std::vector<Pose> poses(600);
  std::stop_source source;
  source.request_stop();
  const Limits stopped{.stop = source.get_token()};
  for (const QueryRow& row : test::query_table()) {
    EXPECT_EQ(
        error_of([&] { static_cast<void>(row.ask(knot, knot, {.length = 1}, stopped)); }).kind(),
        ErrorKind::cancelled);
    EXPECT_EQ(error_of([&] {
                static_cast<void>(row.ask_batch(knot.shape, poses, knot, {.length = 1}, stopped));
              }).kind(),
              ErrorKind::cancelled);
  }
}

// The check of the table itself: each kind of wrong answer is found.
TEST(QueryTableFault, IsFoundInPairs) {
  const Body a{generate_sphere(80)};
  const Body b(a.shape, Pose::translation(0, 0, 1.5));
  const PairTruth truth{overlap(a, b), {}};
  const auto fault = [&](std::string_view name, const Overlap& answer) {
    return test::query_row(name).fault(answer, truth, a, b, kNoLimit);
  };
  const Overlap all = truth.overlap;
  ASSERT_GT(all.pairs.size(), 2U);
  EXPECT_EQ(fault("overlap", all), "");
  EXPECT_NE(fault("overlap", {}), "");
  Overlap wrong = all;
  wrong.pairs.pop_back();
  EXPECT_NE(fault("overlap", wrong), "");
  wrong.coverage = Coverage::cut;
  EXPECT_EQ(fault("overlap", wrong), "");
  wrong.pairs.front().b += 80;
  EXPECT_NE(fault("overlap", wrong), "");
  wrong = all;
  wrong.any = false;
  EXPECT_NE(fault("overlap", wrong), "");
  for (const std::string_view name : {"overlap any", "overlap first"}) {
    Overlap one{.any = true, .pairs = {all.pairs.front()}, .coverage = Coverage::first, .cost = {}};
    EXPECT_EQ(fault(name, one), "") << name;
    one.coverage = Coverage::complete;
    EXPECT_NE(fault(name, one), "") << name;
    EXPECT_NE(fault(name, {}), "") << name;
    one.coverage = Coverage::first;
    one.pairs = {all.pairs.back()};
    EXPECT_EQ(fault(name, one).empty(), name == "overlap any");
    one.pairs = {all.pairs[0], all.pairs[1]};
    EXPECT_NE(fault(name, one), "") << name;
  }
}

TEST(QueryTableFault, IsFound) {
  const Body a{generate_sphere(80)};
  const Body b(a.shape, Pose::translation(0, 0, 3));
  const PairTruth truth = test::truth_of(a, b);
  const QueryRow& row = test::query_row("distance");
  const auto fault = [&](const Distance& answer, double length = kNoLimit) {
    return row.fault(answer, truth, a, b, length);
  };
  const Distance right = distance(a, b);
  EXPECT_EQ(right.distance, (Bracket{1, 1}));
  EXPECT_EQ(fault(right), "");
  Distance wrong = right;
  wrong.distance.upper = std::nextafter(wrong.distance.upper, 2);
  EXPECT_NE(fault(wrong), "");
  wrong = right;
  ++wrong.triangles->b;
  EXPECT_NE(fault(wrong), "");
  wrong = right;
  wrong.point_b.z -= 0x1p-40;
  EXPECT_NE(fault(wrong), "");
  EXPECT_NE(fault(right, 0.5), "");
  Distance far{.distance = {0.75, kNoLimit}, .farther = true};
  EXPECT_EQ(fault(far, 0.5), "");
  EXPECT_NE(fault(far, 1), "");
  far.distance.lower = 1.25;
  EXPECT_NE(fault(far, 0.5), "");
  const QueryRow& near = test::query_row("within");
  EXPECT_EQ(near.fault(within(a, b, 1), truth, a, b, 1), "");
  EXPECT_NE(near.fault(within(a, b, 1), truth, a, b, 0.875), "");
  EXPECT_EQ(near.fault(Within{.at_least = 0.9375}, truth, a, b, 0.875), "");
  EXPECT_NE(near.fault(Within{.at_least = 1.0625}, truth, a, b, 0.875), "");
  Within other = within(a, b, 1);
  other.triangles->a = 40;
  EXPECT_NE(near.fault(other, truth, a, b, 1), "");
}

}  // namespace
}  // namespace soms
