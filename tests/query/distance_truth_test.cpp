// The truth set of distances, for `distance` and `within`, by every rule, layout, number of threads
// and instruction set, alone and in batches.
#include "tests/support/truth/distance_truth.h"

#include "soms/base/error.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/needs_instruction_set.h"
#include "tests/support/shortest_segment.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/query_table.h"
#include "tests/support/truth/truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace soms {
namespace {

using test::Answer;
using test::PairTruth;
using test::QueryRow;

/// Each ninth case and each fourth row of the others under a sanitizer, where all take minutes.
constexpr std::size_t kCaseStride = test::kSlowBuild ? 9 : 1;
constexpr std::size_t kStride = test::kSlowBuild ? 4 : 1;

/// How a row is queried beside the default.
struct Setup {
  Rule rule = Rule::soms;
  Layout layout = Layout::wide;
  int threads = 1;
  bool batch = false;
};

std::string text(const Setup& setup) {
  return std::string(entry(setup.rule).name) + (setup.layout == Layout::wide ? "" : ", compact") +
         ", " + std::to_string(setup.threads) + " threads" + (setup.batch ? ", batch" : "");
}

const std::vector<Setup>& setups() {
  static const std::vector<Setup> all = [] {
    std::vector<Setup> list;
    for (const RuleEntry& rule : rules()) {
      for (const Layout layout : {Layout::wide, Layout::compact}) {
        for (const int threads : {1, 2}) {
          list.push_back({rule.rule, layout, threads, false});
          list.push_back({rule.rule, layout, threads, true});
        }
      }
    }
    return list;
  }();
  return all;
}

/// Hands out setups so that the rows of each kind together run all, and each row four at least.
class SetupsByKind {
 public:
  template <class Row>
  explicit SetupsByKind(const std::vector<Row>& rows) {
    for (const Row& row : rows) {
      ++rows_[row.kind];
    }
  }

  std::vector<Setup> next(const std::string& kind) {
    constexpr std::size_t kLeast = 4;
    const std::size_t share = (setups().size() + rows_[kind] - 1) / rows_[kind];
    std::vector<Setup> some;
    for (std::size_t i = 0; i < std::max(kLeast, share); ++i) {
      some.push_back(setups()[next_[kind]++ % setups().size()]);
    }
    return some;
  }

 private:
  std::map<std::string, std::size_t> rows_;
  std::map<std::string, std::size_t> next_;
};

/// The facts of a row as the twins would state them.
PairTruth truth_of(const Bracket& d, const TrianglePair& pair) {
  return {{}, {.distance = d, .triangles = pair}};
}

const std::array<const QueryRow*, 2>& questions() {
  static const std::array<const QueryRow*, 2> rows{&test::query_row("distance"),
                                                   &test::query_row("within")};
  return rows;
}

Distance without_cost(Distance answer) {
  answer.cost = {};
  return answer;
}

void expect_right(const QueryRow& row, const Answer& answer, const PairTruth& truth, const Body& a,
                  const Body& b, double length) {
  ASSERT_EQ(row.fault(answer, truth, a, b, length), "")
      << row.name << " at " << length << ": " << row.text(answer);
}

/// Both questions at every length that is worth it.
void expect_right_at_all_lengths(const PairTruth& truth, const Body& a, const Body& b) {
  for (const QueryRow* row : questions()) {
    for (const double length : test::lengths_around(*row, truth.distance.distance)) {
      ASSERT_NO_FATAL_FAILURE(
          expect_right(*row, row->ask(a, b, {.length = length}, {}), truth, a, b, length));
    }
  }
  ASSERT_EQ(overlap(a, b, {.mode = OverlapMode::any}).any, truth.distance.distance.upper == 0);
}

/// The same by one setup, at the lengths where an answer turns. `before` is the pose of another
/// row, so that something is left from it.
void expect_right_by(const Setup& setup, const PairTruth& truth, const Body& a, const Body& b,
                     const Pose& before) {
  const Bracket& d = truth.distance.distance;
  const Limits limits{.threads = setup.threads};
  const double below = std::max(0.0, std::nextafter(d.lower, -1));
  for (const QueryRow* row : questions()) {
    for (const double length : {d.upper, below, std::numeric_limits<double>::infinity()}) {
      const test::RowOptions options{.length = length};
      const Answer single = row->ask(a, b, options, {});
      std::vector<Answer> answers;
      if (setup.batch) {
        const std::array poses{before, a.pose, a.pose};
        answers = row->ask_batch(a.shape, poses, b, options, limits).answers;
        answers.erase(answers.begin());
      } else {
        answers = {row->ask(a, b, options, limits)};
      }
      for (const Answer& answer : answers) {
        ASSERT_NO_FATAL_FAILURE(expect_right(*row, answer, truth, a, b, length));
        ASSERT_EQ(row->promised(answer), row->promised(single));
        ASSERT_EQ(test::cost_of(answer), test::cost_of(single)) << row->text(answer);
      }
    }
  }
}

const Shape& shape_of(const std::string& name, const ShapeOptions& options) {
  static std::map<std::tuple<std::string, Rule, Layout>, Shape> shapes;
  const auto [found, is_new] = shapes.try_emplace({name, options.build.rule, options.layout});
  if (is_new) {
    found->second = Shape(*test::truth_mesh(name), options);
  }
  return found->second;
}

void run(const std::vector<test::DistanceCase>& cases) {
  SetupsByKind by_kind(cases);
  Pose before;
  for (std::size_t i = 0; i < cases.size(); i += kCaseStride) {
    const test::DistanceCase& row = cases[i];
    SCOPED_TRACE("case " + std::to_string(row.number) + ", " + row.kind);
    const auto body = [](const std::string& mesh, const Pose& pose, const ShapeOptions& options) {
      return Body(shape_of(mesh, options), pose);
    };
    const Body a = body(row.mesh_a, row.pose_a, {});
    const Body b = body(row.mesh_b, row.pose_b, {});
    const PairTruth truth = truth_of(row.d, row.pair);
    const PairTruth exchanged = truth_of(row.d, row.pair_if_exchanged);
    ASSERT_NO_FATAL_FAILURE(expect_right_at_all_lengths(truth, a, b));
    ASSERT_NO_FATAL_FAILURE(expect_right_at_all_lengths(exchanged, b, a));
    ASSERT_EQ(within(a, b, row.d.lower).within, row.within_lower);
    ASSERT_EQ(within(a, b, row.d.upper).within, row.within_upper);
    if (row.within_below) {
      ASSERT_EQ(within(a, b, std::nextafter(row.d.lower, 0)).within, *row.within_below);
    }
    for (const Setup& setup : by_kind.next(row.kind)) {
      SCOPED_TRACE(text(setup));
      const ShapeOptions options{.build = {.rule = setup.rule}, .layout = setup.layout};
      const Body x = body(row.mesh_a, row.pose_a, options);
      const Body y = body(row.mesh_b, row.pose_b, options);
      ASSERT_NO_FATAL_FAILURE(expect_right_by(setup, truth, x, y, before));
      ASSERT_EQ(without_cost(distance(x, y)), without_cost(distance(a, b)));
    }
    before = row.pose_a;
  }
}

/// Corners in one of six orders.
Triangle reordered(const Triangle& t, std::size_t order) {
  std::array corners{t.a, t.b, t.c};
  std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(order % 3),
              corners.end());
  if (order % 6 >= 3) {
    std::swap(corners[0], corners[1]);
  }
  return {corners[0], corners[1], corners[2]};
}

/// The row scaled by 2^k, or nothing where a number would leave the range in which that is exact.
std::optional<test::TriangleDistanceRow> scaled(const test::TriangleDistanceRow& row, int k) {
  test::TriangleDistanceRow result = row;
  bool exact = true;
  const auto scale = [&](double& x) {
    const double y = std::ldexp(x, k);
    exact = exact && (x == 0 || (std::abs(y) >= 0x1p-1000 && std::abs(y) <= kMaxCoordinate));
    x = y;
  };
  for (Triangle* t : {&result.a, &result.b}) {
    for (Vec3* corner : {&t->a, &t->b, &t->c}) {
      scale(corner->x);
      scale(corner->y);
      scale(corner->z);
    }
  }
  scale(result.distance.lower);
  scale(result.distance.upper);
  return exact ? std::optional(result) : std::nullopt;
}

void run(const std::vector<test::TriangleDistanceRow>& rows) {
  SetupsByKind by_kind(rows);
  std::size_t number = 0;
  std::size_t scalable = 0;
  for (std::size_t i = 0; i < rows.size(); i += kStride) {
    const test::TriangleDistanceRow& row = rows[i];
    SCOPED_TRACE("row " + std::to_string(i) + ", " + row.kind);
    const Body a = test::body_of(row.a);
    const Body b = test::body_of(row.b);
    const PairTruth truth = truth_of(row.distance, {0, 0});
    ASSERT_EQ(row.zero, row.distance.upper == 0);
    ASSERT_NO_FATAL_FAILURE(expect_right_at_all_lengths(truth, a, b));
    ASSERT_NO_FATAL_FAILURE(expect_right_at_all_lengths(truth, b, a));
    const Body x = test::body_of(reordered(row.a, number));
    const Body y = test::body_of(reordered(row.b, number / 6));
    ASSERT_EQ(distance(x, y).distance, row.distance);
    ASSERT_EQ(distance(y, x).distance, row.distance);
    if (const auto other = scaled(row, number % 2 == 0 ? 37 : -41)) {
      ++scalable;
      ASSERT_EQ(distance(test::body_of(other->a), test::body_of(other->b)).distance,
                other->distance);
    }
    for (const Setup& setup : by_kind.next(row.kind)) {
      SCOPED_TRACE(text(setup));
      const ShapeOptions options{.build = {.rule = setup.rule}, .layout = setup.layout};
      ASSERT_NO_FATAL_FAILURE(expect_right_by(setup, truth,
                                              Body(Shape(a.shape.shared_mesh(), options)),
                                              Body(Shape(b.shape.shared_mesh(), options)), {}));
    }
    ++number;
  }
  EXPECT_GT(scalable, rows.size() / kStride / 2);
}

/// Within 4 ulp of the largest coordinate of the pair.
void expect_near(const Vec3& nearest, const test::ClosestPointRow& row, const MeshView& mesh) {
  const Triangle t = mesh.triangle(row.triangle);
  double size = 0;
  for (const Vec3& corner : {t.a, t.b, t.c, row.point}) {
    size = std::max({size, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
  }
  const double ulp = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  const Vec3 off = nearest - row.nearest;
  EXPECT_LE(std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}), 4 * ulp);
}

/// A point is a body of one triangle whose corners are equal.
void run(const std::vector<test::ClosestPointRow>& rows) {
  SetupsByKind by_kind(rows);
  for (std::size_t i = 0; i < rows.size(); i += kStride) {
    const test::ClosestPointRow& row = rows[i];
    SCOPED_TRACE(row.kind + ", " + row.mesh + ", triangle " + std::to_string(row.triangle));
    const Body point = test::body_of({row.point, row.point, row.point});
    const Body body(shape_of(row.mesh, {}));
    const PairTruth truth = truth_of(row.distance, {0, row.triangle});
    ASSERT_NO_FATAL_FAILURE(expect_right_at_all_lengths(truth, point, body));
    ASSERT_NO_FATAL_FAILURE(
        expect_right_at_all_lengths(truth_of(row.distance, {row.triangle, 0}), body, point));
    const Distance answer = distance(point, body);
    ASSERT_EQ(answer.point_a, row.point);
    expect_near(answer.point_b, row, body.shape.mesh());
    for (const Setup& setup : by_kind.next(row.kind)) {
      SCOPED_TRACE(text(setup));
      const ShapeOptions options{.build = {.rule = setup.rule}, .layout = setup.layout};
      ASSERT_NO_FATAL_FAILURE(
          expect_right_by(setup, truth, point, Body(shape_of(row.mesh, options)), {}));
    }
  }
}

using DistanceTruth = test::NeedsInstructionSet;

TEST_F(DistanceTruth, HoldsForTheCasesHere) {
  const auto cases = test::read_distance_cases(test::data("distance/cases.csv"));
  ASSERT_EQ(cases.size(), 190U);
  run(cases);
}

TEST_F(DistanceTruth, HoldsForTheTrianglesHere) {
  const auto rows = test::read_triangle_distances(test::data("distance/tridist.csv"));
  ASSERT_EQ(rows.size(), 313U);
  run(rows);
}

TEST_F(DistanceTruth, HoldsForThePointsHere) {
  const auto rows = test::read_closest_points(test::data("distance/closest.csv"));
  ASSERT_EQ(rows.size(), 345U);
  run(rows);
}

TEST_F(DistanceTruth, HoldsForAllCases) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const auto file = test::outside_distance("cases.csv");
  if (!file) {
    GTEST_SKIP() << "SOMS_DATA has no distance/cases.csv: skipped 1,010 cases";
  }
  const auto cases = test::read_distance_cases(*file);
  ASSERT_EQ(cases.size(), 1010U);
  run(cases);
}

TEST_F(DistanceTruth, HoldsForAllTriangles) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const auto file = test::outside_distance("tridist.csv");
  if (!file) {
    GTEST_SKIP() << "SOMS_DATA has no distance/tridist.csv: skipped 8,200 pairs of triangles";
  }
  const auto rows = test::read_triangle_distances(*file);
  ASSERT_EQ(rows.size(), 8200U);
  run(rows);
}

TEST_F(DistanceTruth, HoldsForAllPoints) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const auto file = test::outside_distance("closest.csv");
  if (!file) {
    GTEST_SKIP() << "SOMS_DATA has no distance/closest.csv: skipped 10,164 points";
  }
  const auto rows = test::read_closest_points(*file);
  ASSERT_EQ(rows.size(), 10'164U);
  run(rows);
}

}  // namespace
}  // namespace soms
