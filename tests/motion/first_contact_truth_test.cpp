// The truth sets of motions: nothing in contact is free, nothing free is in contact, brackets hold.
#include "soms/io/read_mesh.h"
#include "soms/motion/first_contact.h"
#include "soms/query/overlap.h"
#include "soms/tree/rule/rules.h"

#include "tests/motion/known_motion.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"
#include "tests/support/truth/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace soms {
namespace {

using test::MotionTable;

constexpr std::array<Layout, 2> kMotionLayouts{Layout::wide, Layout::compact};

const Shape& motion_shape(const std::string& name, Layout layout, Rule rule = Rule::fast) {
  static std::map<std::tuple<std::string, Layout, Rule>, Shape> shapes;
  const auto known = shapes.find({name, layout, rule});
  if (known != shapes.end()) {
    return known->second;
  }
  const auto file = test::data("motion/meshes/" + name + ".ply");
  const Mesh mesh = std::filesystem::exists(file) ? read_mesh(file) : *test::truth_mesh(name);
  const ShapeOptions options{.build = {.rule = rule}, .layout = layout};
  return shapes.emplace(std::tuple(name, layout, rule), Shape(mesh, options)).first->second;
}

/// What a row says, in the time of the motion.
struct MotionFact {
  std::string answer;
  double lower = 0;
  double upper = 0;
  double tolerance = 0;
};

double greatest_coordinate(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The greatest coordinate met, but for the size of the bodies: for tolerances.
double size_of(const RigidMotion& motion, const Vec3& center) {
  return 8 + std::max({greatest_coordinate(motion.start().shift()),
                       greatest_coordinate(motion.end().shift()), greatest_coordinate(center)});
}

void expect_fact(const FirstContact& found, const MotionFact& fact) {
  ASSERT_EQ(found.coverage, Coverage::complete);
  if (fact.answer == "free") {
    ASSERT_EQ(found.verdict, ContactVerdict::free);
  } else if (fact.answer == "start") {
    ASSERT_EQ(found.verdict, ContactVerdict::started);
  } else {
    ASSERT_EQ(found.verdict, ContactVerdict::contact);
    ASSERT_LE(found.t.lower, fact.upper + fact.tolerance);
    ASSERT_GE(found.t.upper, fact.lower - fact.tolerance);
    ASSERT_LE(found.t.upper - found.t.lower, 100 * fact.tolerance + 1e-9);
    ASSERT_TRUE(found.triangles);
  }
}

/// Rows by the law of paths.
void run_paths(const MotionTable& table) {
  for (std::size_t row = 0; row < table.size(); ++row) {
    SCOPED_TRACE("row " + std::to_string(row) + ", " + table.text(row, "kind"));
    const RigidMotion motion =
        RigidMotion::between(table.pose(row, "a"), table.pose(row, "e"), table.vector(row, "c"));
    const Vec3 by = table.vector(row, "b");
    const double size = size_of(motion, motion.pivot());
    const double speed = std::max(table.number(row, "speed"), 1e-9);
    const MotionFact fact{table.text(row, "answer"), table.number(row, "t_lo"),
                          table.number(row, "t_hi"), 1e-13 * size / speed};
    for (const Layout layout : kMotionLayouts) {
      const Shape& mover = motion_shape(table.text(row, "meshA"), layout);
      const Body fixed(motion_shape(table.text(row, "meshB"), layout),
                       Pose::translation(by.x, by.y, by.z));
      const FirstContact found = first_contact(mover, motion, fixed);
      ASSERT_NO_FATAL_FAILURE(expect_fact(found, fact));
      if (found.verdict == ContactVerdict::contact) {
        ASSERT_TRUE(overlap(Body(mover, motion.pose_at(found.t.upper)), fixed).any);
      }
    }
  }
}

Shape single_triangle(const MotionTable& table, std::size_t row, const std::string& name,
                      Layout layout) {
  Mesh mesh;
  for (const char* corner : {"0", "1", "2"}) {
    mesh.vertices.push_back(table.vector(row, name + corner));
  }
  mesh.triangles = {{0, 1, 2}};
  return Shape(mesh, {.layout = layout});
}

/// Rows of one triangle that shifts: exact times, so no tolerance, and neighboring doubles.
void run_shifts(const MotionTable& table) {
  for (std::size_t row = 0; row < table.size(); ++row) {
    SCOPED_TRACE("row " + std::to_string(row) + ", " + table.text(row, "kind"));
    const bool contact = table.text(row, "contact") == "1";
    const bool start = contact && table.text(row, "free_until").empty();
    const MotionFact fact{start     ? "start"
                          : contact ? "contact"
                                    : "free",
                          table.number(row, "free_until"), table.number(row, "touching_by")};
    const RigidMotion motion = RigidMotion::along(Pose(), table.vector(row, "d"));
    const Layout layout = kMotionLayouts[row % 2];
    const FirstContact found = first_contact(single_triangle(table, row, "b", layout), motion,
                                             Body(single_triangle(table, row, "a", layout)));
    ASSERT_NO_FATAL_FAILURE(expect_fact(found, fact));
    if (contact && !start) {
      ASSERT_LE(found.t.upper, std::nextafter(found.t.lower, 2));
    }
  }
}

TEST(FirstContactTruth, PathsHereHold) {
  const MotionTable table(test::data("motion/motion_path.csv"));
  ASSERT_EQ(table.size(), 107U);
  run_paths(table);
}

TEST(FirstContactTruth, ShiftsHereHold) {
  const MotionTable table(test::data("motion/translation.csv"));
  ASSERT_GT(table.size(), 600U);
  run_shifts(table);
}

// A kiss lasts no time, so no pose that is looked at need be in contact. Next to it, one may be by
// its rounding.
// Exact times, and the least of all pairs that touch first, by trees of every rule.
TEST(FirstContactTruth, ShiftsOfMeshesHold) {
  const MotionTable table(test::data("motion/mesh_sweeps.csv"));
  ASSERT_EQ(table.size(), 500U);
  for (std::size_t row = 0; row < table.size(); ++row) {
    SCOPED_TRACE("row " + std::to_string(row) + ", " + table.text(row, "kind"));
    const RigidMotion motion = RigidMotion::along(table.pose(row, "a"), table.vector(row, "d"));
    const MotionFact fact{table.text(row, "answer"), table.number(row, "t_lo"),
                          table.number(row, "t_hi")};
    const Rule rule = rules()[row % rules().size()].rule;
    for (const Layout layout : kMotionLayouts) {
      const FirstContact found =
          first_contact(motion_shape(table.text(row, "meshA"), layout, rule), motion,
                        Body(motion_shape(table.text(row, "meshB"), layout), table.pose(row, "b")));
      ASSERT_NO_FATAL_FAILURE(expect_fact(found, fact));
      if (fact.answer == "contact") {
        ASSERT_EQ(found.t, (Bracket{fact.lower, fact.upper}));
        ASSERT_EQ(found.triangles->a, table.number(row, "i"));
        ASSERT_EQ(found.triangles->b, table.number(row, "j"));
      }
    }
  }
}

TEST(FirstContactTruth, KissesHold) {
  const MotionTable table(test::data("motion/kisses.csv"));
  ASSERT_EQ(table.size(), 184U);
  int exact = 0;
  for (std::size_t row = 0; row < table.size(); ++row) {
    SCOPED_TRACE("row " + std::to_string(row) + ", " + table.text(row, "kind"));
    const test::KnownMotion known = test::known_motion(table, row);
    const FirstContact found = first_contact(Shape(test::soup_body({known.moving})), known.motion,
                                             Body(Shape(test::soup_body({known.resting}))));
    if (!known.time) {
      ASSERT_EQ(found.verdict, ContactVerdict::free);
      continue;
    }
    ASSERT_EQ(found.verdict, ContactVerdict::contact);
    ASSERT_LE(found.t.lower, known.time->lower);
    ASSERT_NEAR(found.t.lower, known.time->lower, 1e-5);
    ASSERT_NEAR(found.t.upper, known.time->lower, 1e-5);
    exact += found.t == *known.time ? 1 : 0;
  }
  EXPECT_GT(exact, 100);
}

TEST(FirstContactTruth, AllPathsHold) {
  SOMS_NEEDS_OUTSIDE_DATA("107 motions along paths");
  run_paths(MotionTable(*test::outside_data("when/motion_path.csv")));
}

TEST(FirstContactTruth, AllShiftsHold) {
  SOMS_NEEDS_OUTSIDE_DATA("16,000 shifts of a triangle");
  const MotionTable table(*test::outside_data("ccd/translation.csv"));
  ASSERT_EQ(table.size(), 16000U);
  run_shifts(table);
}

/// The part of a turn by `angle` at constant speed that is done where the law has done `t`.
double part_of_turn(double t, double angle) {
  return std::atan2(t * std::sin(angle / 2), 1 - t + t * std::cos(angle / 2)) / (angle / 2);
}

// Rows that only turn have the same way by both laws, at other times.
TEST(FirstContactTruth, TurnsHold) {
  SOMS_NEEDS_OUTSIDE_DATA("turns of the truth set of motions");
  const MotionTable table(*test::outside_data("questions/motion.csv"));
  int turns = 0;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const double angle = table.number(row, "angle");
    const Vec3 center = table.vector(row, "c");
    if (table.vector(row, "s") != Vec3{} || std::abs(angle) > 3) {
      continue;
    }
    SCOPED_TRACE("row " + std::to_string(row) + ", " + table.text(row, "kind"));
    ++turns;
    const Pose start = table.pose(row, "a");
    const RigidMotion motion =
        RigidMotion::between(start, table.pose(row, "e"), start.inverse().apply(center));
    const double size = size_of(motion, center);
    const double speed = std::max(table.number(row, "speed"), 1e-9);
    const MotionFact fact{table.text(row, "answer"), table.number(row, "t_lo"),
                          table.number(row, "t_hi"), 1e-13 * size / speed + 1e-15};
    FirstContact found = first_contact(
        motion_shape(table.text(row, "meshA"), Layout::wide), motion,
        Body(motion_shape(table.text(row, "meshB"), Layout::wide), table.pose(row, "b")));
    if (found.verdict == ContactVerdict::contact) {
      found.t = {part_of_turn(found.t.lower, angle), part_of_turn(found.t.upper, angle)};
    }
    ASSERT_NO_FATAL_FAILURE(expect_fact(found, fact));
  }
  EXPECT_GT(turns, 50);
}

}  // namespace
}  // namespace soms
