// Batches of motions: the answers of single ones, for any number of threads.
#include "soms/base/error.h"
#include "soms/base/stop_token.h"
#include "soms/generate/shapes.h"
#include "soms/motion/first_contact.h"
#include "soms/motion/print_motion.h"

#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::box_body;

/// Shifts and turns beside, into and out of a body at the origin; more than a thread takes at once.
std::vector<RigidMotion> many_motions() {
  std::vector<RigidMotion> motions;
  for (int k = 0; k < 40; ++k) {
    const double angle = 0.157 * k;
    const Pose start =
        Pose::about_z(angle, {0.2 * k * std::cos(angle), 0.2 * k * std::sin(angle), 0.1});
    motions.push_back(RigidMotion::along(start, {-4, 0, 0}));
    motions.push_back(RigidMotion::between(start, Pose::about_z(angle + 1, {0, -5, 0}), {1, 0, 0}));
  }
  return motions;
}

void expect_singles(const FirstContactBatch& batch, const Shape& mover,
                    const std::vector<RigidMotion>& motions, const Body& fixed,
                    const FirstContactOptions& options) {
  ASSERT_EQ(batch.size(), motions.size());
  Cost cost;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const FirstContact one = first_contact(mover, motions[k], fixed, options);
    ASSERT_EQ(batch.at(k), one) << "motion " << k;
    cost += one.cost;
  }
  EXPECT_EQ(batch.cost, cost);
}

TEST(FirstContactBatch, SaysWhichMotionOfAPathIsTheFirstThatIsBlocked) {
  const Shape mover(box_body({0, 0, 0}, {1, 1, 1}));
  const Body fixed(box_body({5, -9, -9}, {6, 9, 9}));
  std::vector<RigidMotion> path{RigidMotion::along(Pose(), {0, 3, 0}),
                                RigidMotion::along(Pose::translation(0, 3, 0), {2, 0, 0})};
  EXPECT_EQ(first_contact(mover, path, fixed).first_blocked(), std::nullopt);
  EXPECT_EQ(FirstContactBatch().first_blocked(), std::nullopt);
  path.push_back(RigidMotion::along(Pose::translation(2, 3, 0), {9, 0, 0}));
  path.push_back(RigidMotion::along(Pose::translation(5.5, 3, 0), {1, 0, 0}));
  EXPECT_EQ(first_contact(mover, path, fixed).first_blocked(), 2U);
  // What time leaves is not proved to be free.
  Limits late;
  late.deadline = std::chrono::steady_clock::time_point::min();
  EXPECT_EQ(first_contact(mover, path, fixed, {}, late).first_blocked(), 0U);
}

TEST(FirstContactBatch, HoldsTheAnswersOfSingleMotions) {
  const Shape mover(generate_knot(500));
  const Body fixed(Shape(generate_knot(500)), Pose::about_z(0.4));
  const std::vector<RigidMotion> motions = many_motions();
  for (const double within : {0.0, 0.25}) {
    const FirstContactOptions options{.within = within};
    const FirstContactBatch one = first_contact(mover, motions, fixed, options);
    expect_singles(one, mover, motions, fixed, options);
    EXPECT_EQ(first_contact(mover, motions, fixed, options, {.threads = 2}), one);
    const std::set<ContactVerdict> verdicts(one.verdict.begin(), one.verdict.end());
    EXPECT_TRUE(verdicts.contains(ContactVerdict::free));
    EXPECT_TRUE(verdicts.contains(ContactVerdict::contact));
    EXPECT_TRUE(verdicts.contains(ContactVerdict::started));
  }
}

TEST(FirstContactBatch, OfNothingIsFree) {
  const Shape box(box_body({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(first_contact(box, std::vector<RigidMotion>(), Body(box)).size(), 0U);
  const std::vector<RigidMotion> motions(20, RigidMotion::along(Pose(), {9, 0, 0}));
  for (const FirstContactBatch& batch :
       {first_contact(box, motions, Body()), first_contact(Shape(), motions, Body(box))}) {
    ASSERT_EQ(batch.size(), 20U);
    EXPECT_EQ(batch.at(19), (FirstContact{.t = {1, std::numeric_limits<double>::infinity()}}));
  }
}

template <class Ask>
Error error_of(const Ask& ask) {
  try {
    static_cast<void>(ask());
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorKind::unsupported, "no error", "");
}

TEST(FirstContactBatch, NamesTheFirstMotionAtFault) {
  const Shape mover(box_body({0, 0, 0}, {1, 1, 1}));
  const Body fixed(box_body({3, 0, 0}, {4, 1, 1}));
  std::vector<RigidMotion> motions(30, RigidMotion::along(Pose(), {9, 0, 0}));
  motions[21] = motions[17] = RigidMotion::along(Pose(), {0x1p301, 0, 0});
  for (const int threads : {1, 2}) {
    const Error far =
        error_of([&] { return first_contact(mover, motions, fixed, {}, {.threads = threads}); });
    EXPECT_EQ(far.kind(), ErrorKind::out_of_range);
    EXPECT_EQ(far.place().find("motion 17: "), 0U) << far.place();
  }
  const Pose start = Pose::translation(0x1p299, 0, 0);
  motions[3] = RigidMotion::between(start, Pose::about_z(3, {-0x1p299, 0, 0}), {0x1p299, 0, 0});
  const Error way = error_of([&] { return first_contact(mover, motions, fixed); });
  EXPECT_EQ(way.kind(), ErrorKind::out_of_range);
  EXPECT_EQ(way.place().find("motion 3: "), 0U) << way.place();
  EXPECT_EQ(error_of([&] { return first_contact(mover, motions, fixed, {.within = -1}); }).kind(),
            ErrorKind::usage);
  StopSource stop;
  stop.request_stop();
  motions.resize(3);
  EXPECT_EQ(error_of([&] {
              return first_contact(mover, motions, fixed, {}, {.stop = stop.get_token()});
            }).kind(),
            ErrorKind::cancelled);
}

// Everything is begun, so every entry says what is proved: nothing yet.
TEST(FirstContactBatch, ADeadlineThatPassedLeavesAllCut) {
  const Shape mover(generate_knot(500));
  const Body fixed(Shape(generate_knot(500)), Pose::translation(3, 0, 0));
  const std::vector<RigidMotion> motions(
      20, RigidMotion::along(Pose::translation(-9, 0, 0), {20, 0, 0}));
  const FirstContactBatch batch = first_contact(
      mover, motions, fixed, {}, {.deadline = std::chrono::steady_clock::time_point::min()});
  for (std::size_t k = 0; k < motions.size(); ++k) {
    EXPECT_EQ(batch.coverage[k], Coverage::cut);
    EXPECT_EQ(batch.verdict[k], ContactVerdict::grazing);
    EXPECT_EQ(batch.upper[k], std::numeric_limits<double>::infinity());
  }
}

TEST(FirstContactBatch, IsPrinted) {
  const Shape box(box_body({0, 0, 0}, {1, 1, 1}));
  const std::vector<RigidMotion> motions{RigidMotion::along(Pose(), {9, 0, 0}),
                                         RigidMotion::along(Pose(), {0, 9, 0})};
  std::ostringstream out;
  out << first_contact(box, motions, Body(box_body({3, 0, 0}, {4, 1, 1})));
  EXPECT_EQ(out.str().find("FirstContactBatch{1 of 2 motions free, cost"), 0U) << out.str();
}

}  // namespace
}  // namespace soms
