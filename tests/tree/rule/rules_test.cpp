#include "soms/tree/rule/rules.h"

#include "soms/base/error.h"

#include "tests/support/support.h"

#include <cmath>
#include <string>
#include <vector>

namespace soms {
namespace {

/// Primitives that are intervals on the x axis, with the midpoint given.
struct Interval {
  double lower, upper, midpoint;
};

std::vector<Primitive> on_x(const std::vector<Interval>& intervals) {
  std::vector<Primitive> primitives;
  for (const Interval& i : intervals) {
    primitives.push_back({{{i.lower, 0, 0}, {i.upper, 1, 1}},
                          {i.midpoint, 0.5, 0.5},
                          static_cast<TriangleId>(primitives.size())});
  }
  return primitives;
}

SplitNode node_of(const std::vector<Primitive>& primitives) {
  SplitNode node{primitives, {}, {}};
  for (const Primitive& p : primitives) {
    node.outer.grow(p.bounds);
    node.inner.grow(p.midpoint);
  }
  return node;
}

/// Numbers of the primitives that go left, as digits.
std::string left_of(Rule rule, const std::vector<Primitive>& primitives, std::size_t axis = 0) {
  const Split split = entry(rule).split(node_of(primitives), axis);
  std::string left;
  for (const Primitive& p : primitives) {
    if (split.is_left(p)) {
      left += std::to_string(p.id);
    }
  }
  return left;
}

// Three small triangles near 0 and one at 100, as in the thesis' figures of each technique.
const std::vector<Interval> kUneven{{0, 1, 0.5}, {1, 2, 1.5}, {2, 3, 2.5}, {3, 100, 40}};

TEST(Rules, EachPutsItsPlaneWhereItsDefinitionSays) {
  const auto primitives = on_x(kUneven);
  EXPECT_EQ(entry(Rule::object_mean).split(node_of(primitives), 0).value, 44.5 / 4);
  EXPECT_EQ(entry(Rule::spatial_median).split(node_of(primitives), 0).value, 50);
  EXPECT_EQ(entry(Rule::soms).split(node_of(primitives), 0).value, 20.25);
  const Split median = entry(Rule::object_median).split(node_of(primitives), 0);
  EXPECT_EQ(median.value, 2.5);
  EXPECT_EQ(median.id, 2U);
}

TEST(Rules, EachDividesTheUnevenRowAtItsPlane) {
  const auto primitives = on_x(kUneven);
  EXPECT_EQ(left_of(Rule::object_median, primitives), "01");
  EXPECT_EQ(left_of(Rule::object_mean, primitives), "012");
  EXPECT_EQ(left_of(Rule::spatial_median, primitives), "0123");  // fails: one large triangle
  EXPECT_EQ(left_of(Rule::soms, primitives), "012");
  EXPECT_EQ(left_of(Rule::sah, primitives), "012");
}

TEST(Rules, AMidpointOnThePlaneGoesRight) {
  const auto primitives = on_x({{0, 1, 0}, {0, 1, 1}, {0, 2, 2}});
  EXPECT_EQ(left_of(Rule::soms, primitives), "0");
  EXPECT_EQ(left_of(Rule::object_mean, primitives), "0");
  EXPECT_EQ(left_of(Rule::spatial_median, primitives), "0");
}

TEST(Rules, ObjectMedianCutsTiesByNumberAndOddCountsBelowTheMiddle) {
  EXPECT_EQ(left_of(Rule::object_median, on_x({{0, 1, 5}, {0, 1, 5}, {0, 1, 5}})), "0");
  EXPECT_EQ(left_of(Rule::object_median, on_x({{0, 1, 9}, {0, 1, 5}, {0, 1, 5}, {0, 1, 1}})), "13");
  EXPECT_EQ(left_of(Rule::object_median, on_x({{0, 1, 0.0}, {0, 1, -0.0}})), "0");
}

TEST(Rules, SomsDividesNeighboringDoubles) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_EQ(left_of(Rule::soms, on_x({{0, 2, next}, {0, 2, 1}})), "1");
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(left_of(Rule::soms, on_x({{0, 2, 0}, {0, 2, tiny}})), "0");
  EXPECT_EQ(left_of(Rule::sah, on_x({{0, 2, 0}, {0, 2, tiny}})), "0");
  EXPECT_EQ(left_of(Rule::sah, on_x({{0, 2, next}, {0, 2, 1}})), "1");
}

TEST(Rules, AllButObjectMedianFailWhereAllMidpointsAreEqual) {
  const auto primitives = on_x({{0, 4, 2}, {1, 3, 2}, {2, 2, 2}});
  for (const RuleEntry& e : rules()) {
    SCOPED_TRACE(e.name);
    const std::string left = left_of(e.rule, primitives);
    EXPECT_EQ(left, e.rule == Rule::object_median ? "0" : "");
  }
}

TEST(Rules, SahSeparatesTheLargeFromTheSmallOnAnyAxis) {
  // Two clusters apart on y; a rule on the longest axis (x) would mix them.
  std::vector<Primitive> primitives;
  for (unsigned i = 0; i < 8; ++i) {
    const double x = 20.0 * (i / 2);
    const double y = i % 2 == 0 ? 0 : 50;
    primitives.push_back({{{x, y, 0}, {x + 40, y + 1, 1}}, {x + 20, y + 0.5, 0.5}, i});
  }
  EXPECT_EQ(left_of(Rule::sah, primitives, 0), "0246");
}

TEST(Rules, SahIsSoundAtTheEndsOfTheRangeOfDoubles) {
  for (const double scale : {0x1p-1060, 0x1p-600, 0x1p-300, 1.0, 0x1p300}) {
    SCOPED_TRACE(scale);
    std::vector<Primitive> primitives;
    for (unsigned i = 0; i < 6; ++i) {
      const double x = scale * (i < 3 ? i : 100 + i);
      primitives.push_back({{{x, 0, 0}, {x + scale, scale, scale}}, {x, 0, 0}, i});
    }
    EXPECT_EQ(left_of(Rule::sah, primitives), "012");
  }
}

TEST(Rules, AreFoundByBothSpellingsOfTheirNames) {
  EXPECT_EQ(rules().size(), 5U);
  for (const RuleEntry& e : rules()) {
    EXPECT_EQ(&entry(e.rule), &e);
    EXPECT_EQ(&rule_named(e.name), &e);
    EXPECT_EQ(&rule_named(e.kebab), &e);
    EXPECT_FALSE(e.description.empty());
  }
  EXPECT_EQ(rule_named("spatial-median").rule, Rule::spatial_median);
}

TEST(Rules, UnknownNamesListTheKnownOnes) {
  try {
    static_cast<void>(rule_named("median"));
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_EQ(error.remedy(),
              "choose one of object-median, object-mean, spatial-median, soms, sah");
  }
}

}  // namespace
}  // namespace soms
