#include "soms/tree/rule/rules.h"

#include "soms/base/error.h"

#include "tests/support/support.h"

#include <cmath>
#include <string>
#include <vector>

namespace soms {
namespace {

/// Primitives that are intervals on the x axis (and 0 to 1 on the others), with the midpoint given.
struct Interval {
  double lower, upper, midpoint;
};

/// A node that keeps its primitives.
struct TestNode {
  std::vector<Primitive> primitives;
  SplitNode node;

  void add(const Box& box, const Vec3& m) {
    Primitive p;
    p.midpoint = {m.x, m.y, m.z};
    p.id = static_cast<TriangleId>(primitives.size());
    for (std::size_t k = 0; k < 3; ++k) {
      p.below[k] = static_cast<float>((m[k] - box.lower[k]) / node.unit);
      p.above[k] = static_cast<float>((box.upper[k] - m[k]) / node.unit);
    }
    primitives.push_back(p);
    node.inner.grow(m);
    node.outer.grow(box);
  }
};

TestNode on_x(const std::vector<Interval>& intervals) {
  TestNode result;
  for (const Interval& i : intervals) {
    result.add({{i.lower, 0, 0}, {i.upper, 1, 1}}, {i.midpoint, 0.5, 0.5});
  }
  return result;
}

Split split(Rule rule, const TestNode& test, std::size_t axis = 0) {
  SplitNode node = test.node;
  node.primitives = test.primitives;
  return entry(rule).split(node, axis);
}

/// Numbers of the primitives that go left, as digits.
std::string left_of(Rule rule, const TestNode& test, std::size_t axis = 0) {
  const Split found = split(rule, test, axis);
  std::string left;
  for (const Primitive& p : test.primitives) {
    if (found.is_left(p)) {
      left += std::to_string(p.id);
    }
  }
  return left;
}

// Three small triangles near 0 and one at 100, as in the thesis' figures of each technique.
const std::vector<Interval> kUneven{{0, 1, 0.5}, {1, 2, 1.5}, {2, 3, 2.5}, {3, 100, 40}};

TEST(Rules, EachPutsItsPlaneWhereItsDefinitionSays) {
  const auto primitives = on_x(kUneven);
  EXPECT_EQ(split(Rule::object_mean, primitives).value, 44.5 / 4);
  EXPECT_EQ(split(Rule::spatial_median, primitives).value, 50);
  EXPECT_EQ(split(Rule::soms, primitives).value, 20.25);
  const Split median = split(Rule::object_median, primitives);
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
  TestNode node;
  for (unsigned i = 0; i < 8; ++i) {
    const unsigned column = i / 2;
    const double x = 20.0 * column;
    const double y = i % 2 == 0 ? 0 : 50;
    node.add({{x, y, 0}, {x + 40, y + 1, 1}}, {x + 20, y + 0.5, 0.5});
  }
  EXPECT_EQ(left_of(Rule::sah, node, 0), "0246");
}

TEST(Rules, SahIsSoundAtTheEndsOfTheRangeOfDoubles) {
  for (const double scale : {0x1p-1060, 0x1p-600, 0x1p-300, 1.0, 0x1p300}) {
    SCOPED_TRACE(scale);
    TestNode node;
    node.node.unit = std::max(scale, 0x1p-1000);
    for (unsigned i = 0; i < 6; ++i) {
      const double x = scale * (i < 3 ? i : 100 + i);
      node.add({{x, 0, 0}, {x + scale, scale, scale}}, {x, 0, 0});
    }
    EXPECT_EQ(left_of(Rule::sah, node), "012");
  }
}

// Areas relative to the inner box overflow: the rule divides all the same.
TEST(Rules, SahDividesHugeBoxesWithNearlyEqualMidpoints) {
  for (const double size : {0x1p20, 0x1p60, 0x1p100, 0x1p290}) {
    SCOPED_TRACE(size);
    TestNode node;
    node.node.unit = size;
    for (unsigned i = 0; i < 6; ++i) {
      node.add({{-size, -size, -size}, {size, size, size}}, {0x1p-40 * i, 0, 0x1p-200 * i});
    }
    const std::string left = left_of(Rule::sah, node);
    EXPECT_FALSE(left.empty());
    EXPECT_LT(left.size(), 6U);
  }
}

TEST(Rules, SomsSahIsSomsWhereTrianglesAreSmallAgainstTheNode) {
  const auto primitives =
      on_x({{0, 1, 0.5}, {1, 2, 1.5}, {2, 3, 2.5}, {8, 9, 8.5}, {20, 21, 20.5}});
  EXPECT_EQ(split(Rule::soms, primitives).value, 10.5);
  EXPECT_EQ(split(Rule::soms_sah, primitives).value, 10.5);
  EXPECT_NE(split(Rule::sah, primitives).value, 10.5);
}

TEST(Rules, SomsSahIsSahWhereATriangleIsWiderThanHalfTheInnerBox) {
  const auto row = [](double width) {
    return on_x({{0, 1, 0}, {1, 2, 1}, {2, 3, 2}, {8, 8 + width, 8}, {20, 21, 20}});
  };
  EXPECT_EQ(split(Rule::soms_sah, row(10)).value, split(Rule::soms, row(10)).value);
  EXPECT_EQ(split(Rule::soms_sah, row(10.5)).value, split(Rule::sah, row(10.5)).value);
  EXPECT_NE(split(Rule::soms, row(10.5)).value, split(Rule::sah, row(10.5)).value);
}

// The width counts on the axis alone: a triangle wide elsewhere is not cut by the plane.
TEST(Rules, SomsSahLooksAtWidthsOnTheAxisItSplits) {
  TestNode node;
  for (unsigned i = 0; i < 5; ++i) {
    const double x = i * i;
    node.add({{x, 0, 0}, {x + 1, 100, 1}}, {x + 0.5, 50, 0.5});
  }
  EXPECT_EQ(split(Rule::soms_sah, node, 0).value, split(Rule::soms, node, 0).value);
  EXPECT_NE(split(Rule::sah, node, 0).value, split(Rule::soms, node, 0).value);
}

TEST(Rules, AreFoundByBothSpellingsOfTheirNames) {
  EXPECT_EQ(rules().size(), 9U);
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
              "choose one of object-median, object-mean, spatial-median, soms, sah, soms-sah, "
              "fast, quality, quick");
  }
}

}  // namespace
}  // namespace soms
