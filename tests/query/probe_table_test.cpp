// What holds for every question about points and rays, whatever it means: loops over their tables.
#include "tests/support/truth/probe_table.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/tree/rule/rules.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/needs_instruction_set.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::Answer;
using test::ProbeRow;
using test::Probes;

constexpr double kBoundless = std::numeric_limits<double>::infinity();

using ProbeTable = test::NeedsInstructionSet;

/// `check(row, probes)` for every question that the body may be queried for, with its probes.
template <class Check>
void for_each_probe_row(const Body& body, const Probes& probes, const Check& check) {
  for (const auto& row : test::probe_table<Vec3>(body)) {
    SCOPED_TRACE(row.name);
    ASSERT_NO_FATAL_FAILURE(check(row, probes.points));
  }
  for (const auto& row : test::probe_table<Ray>(body)) {
    SCOPED_TRACE(row.name);
    ASSERT_NO_FATAL_FAILURE(check(row, probes.rays));
  }
}

/// Limits to try where a question takes one: none, and some of about the size of the body.
std::vector<double> limits_of(const test::AnswerRow& row, const Body& body) {
  const Vec3 size = body.shape.bounds().extent();
  return row.takes_length ? std::vector{kBoundless, 0.0, std::max(0.0, 0.25 * size.x)}
                          : std::vector{kBoundless};
}

/// A body of an awkward mesh, one in two closed, at an awkward pose.
Body awkward_body(Rng& rng, int most, double scale, double far) {
  const test::Two two = test::likely_to_meet(rng, most, scale, scale, far);
  if (rng.below(2) == 0) {
    return two.a;
  }
  const Vec3 apex = test::point_in(rng, two.a.shape.bounds());
  return Body(test::coned(Mesh(two.a.shape.mesh()), apex), two.a.pose);
}

void expect_twins(const Body& body, const Probes& probes) {
  for_each_probe_row(body, probes, [&](const auto& row, const auto& kind) {
    for (const double length : limits_of(row, body)) {
      for (const auto& probe : kind) {
        const Answer answer = row.ask(body, probe, {.length = length});
        const Answer truth = row.twin(body, probe, {.length = length});
        ASSERT_EQ(row.promised(answer), truth)
            << "at most " << length << ": " << row.text(answer) << '\n'
            << row.text(truth);
      }
    }
  });
}

TEST_F(ProbeTable, EqualsTheTwins) {
  test::for_each_case("probes/usual", 25, [](Rng& rng) {
    const Body body = awkward_body(rng, 20, 1, 0);
    expect_twins(body, test::probes_of(body, 3));
  });
}

TEST_F(ProbeTable, EqualsTheTwinsOfTinyBodiesFarAway) {
  test::for_each_case("probes/tiny-far", 20, [](Rng& rng) {
    const double scale = std::exp2(rng.uniform(-120, 0));
    const Body body = awkward_body(rng, 12, scale, std::exp2(rng.uniform(-60, 60)));
    expect_twins(body, test::probes_of(body, 3));
  });
}

TEST_F(ProbeTable, EqualsTheTwinsAtEveryScale) {
  test::for_each_case("probes/scales", 20, [](Rng& rng) {
    const Body body = awkward_body(rng, 12, std::exp2(rng.uniform(-1070, 270)), 0);
    expect_twins(body, test::probes_of(body, 3));
  });
}

// Costs, too: threads share the rows of a batch.
TEST_F(ProbeTable, AnswersABatchAsItAnswersSingleQueries) {
  test::for_each_case("probes/batch", 10, [](Rng& rng) {
    const Body body = awkward_body(rng, 40, 1, 0);
    for_each_probe_row(body, test::probes_of(body, 8), [&](const auto& row, const auto& kind) {
      for (const double length : limits_of(row, body)) {
        for (const int threads : {1, 2, 8}) {
          const test::BatchAnswer batch =
              row.ask_batch(body, kind, {.length = length}, {.threads = threads});
          ASSERT_EQ(batch.answers.size(), kind.size());
          Cost cost;
          for (std::size_t k = 0; k < kind.size(); ++k) {
            const Answer single = row.ask(body, kind[k], {.length = length});
            ASSERT_EQ(batch.answers[k], single) << row.text(batch.answers[k]) << '\n'
                                                << row.text(single);
            cost += test::cost_of(single);
          }
          ASSERT_EQ(batch.cost, cost);
        }
      }
    });
  });
}

TEST_F(ProbeTable, IsTheSameForEveryRuleAndLayout) {
  test::for_each_case("probes/layouts", 5, [](Rng& rng) {
    const Body body = awkward_body(rng, 40, 1, 0);
    const Probes probes = test::probes_of(body, 4);
    for (const RuleEntry& rule : rules()) {
      for (const Layout layout : {Layout::wide, Layout::compact}) {
        const BuildOptions build{.rule = rule.rule, .per_leaf = layout == Layout::wide ? 1 : 4};
        const Body other(Shape(body.shape.shared_mesh(), {.build = build, .layout = layout}),
                         body.pose);
        for_each_probe_row(body, probes, [&](const auto& row, const auto& kind) {
          const auto expected = row.ask_batch(body, kind, {}, {}).answers;
          const auto answers = row.ask_batch(other, kind, {}, {}).answers;
          for (std::size_t k = 0; k < kind.size(); ++k) {
            ASSERT_EQ(row.promised(answers[k]), row.promised(expected[k]))
                << rule.name << ' ' << row.text(answers[k]);
          }
        });
      }
    }
  });
}

TEST_F(ProbeTable, AnswersForEmptyMeshes) {
  const Body nothing;
  expect_twins(nothing, {{{0, 0, 0}, {1, 2, 3}}, {{{0, 0, 0}, {1, 0, 0}}}});
}

/// The kind and the place of the error that a query ends with.
template <class Query>
Error error_thrown(const Query& query) {
  try {
    query();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "it was answered";
  return {ErrorKind::usage, "", ""};
}

void put_first_coordinate(Vec3& point, double x) {
  point.x = x;
}

void put_first_coordinate(Ray& ray, double x) {
  ray.origin.x = x;
}

TEST_F(ProbeTable, NamesTheRowAtFault) {
  const Body ball{generate_sphere(80)};
  for_each_probe_row(ball, test::probes_of(ball, 2), [&](const auto& row, auto kind) {
    for (const auto& [x, expected] :
         {std::pair(kBoundless, ErrorKind::not_finite), std::pair(0x1p301, ErrorKind::out_of_range),
          std::pair(std::numeric_limits<double>::quiet_NaN(), ErrorKind::not_finite)}) {
      put_first_coordinate(kind[3], x);
      const Error single = error_thrown([&] { static_cast<void>(row.ask(ball, kind[3], {})); });
      const Error batch =
          error_thrown([&] { static_cast<void>(row.ask_batch(ball, kind, {}, {.threads = 2})); });
      EXPECT_EQ(single.kind(), expected);
      EXPECT_EQ(batch.kind(), expected);
      EXPECT_NE(batch.place().find(" 3"), std::string::npos) << batch.place();
    }
  });
}

// A cut answer says so, and says nothing that is wrong.
TEST_F(ProbeTable, EndsAtADeadline) {
  const Body knot(Shape(generate_knot(600)),
                  Pose::from_quaternion(0.8, 0.36, 0.48, 0, {0.125, 0.25, 0.125}));
  std::size_t cut = 0;
  for_each_probe_row(knot, test::probes_of(knot, 5), [&](const auto& row, const auto& kind) {
    const test::RowOptions late{.late = true};
    const auto batch = row.ask_batch(knot, kind, late, {.threads = 2}).answers;
    for (std::size_t k = 0; k < kind.size(); ++k) {
      const Answer truth = row.twin(knot, kind[k], {});
      for (const Answer& answer : {row.ask(knot, kind[k], late), batch[k]}) {
        if (test::coverage_of(answer) == Coverage::cut) {
          ++cut;
          ASSERT_TRUE(row.holds(answer, truth)) << row.text(answer) << '\n' << row.text(truth);
        } else {
          ASSERT_EQ(row.promised(answer), truth) << row.text(answer);
        }
      }
    }
  });
  EXPECT_GT(cut, 100U);
}

TEST_F(ProbeTable, EndsWhenAStopIsRequested) {
  const Body knot{generate_knot(600)};
  std::stop_source source;
  source.request_stop();
  const Limits stopped{.stop = source.get_token()};
  for_each_probe_row(knot, test::probes_of(knot, 50), [&](const auto& row, const auto& kind) {
    EXPECT_EQ(
        error_thrown([&] { static_cast<void>(row.ask_batch(knot, kind, {}, stopped)); }).kind(),
        ErrorKind::cancelled);
  });
}

}  // namespace
}  // namespace soms
