#include "soms/base/limits.h"

#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/generate/shapes.h"
#include "soms/query/ray.h"
#include "soms/query/winding.h"
#include "soms/scene/scene.h"
#include "soms/tree/refit.h"
#include "soms/tree/shape.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

namespace soms {
namespace {

using std::chrono::steady_clock;

const Limits kLate{.deadline = steady_clock::time_point::min()};

std::optional<ErrorKind> error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.kind();
  }
  return std::nullopt;
}

TEST(Limits, AreLateFromTheirDeadlineOn) {
  EXPECT_FALSE(Limits{}.late());
  EXPECT_TRUE(kLate.late());
  EXPECT_TRUE(Limits{.deadline = steady_clock::now()}.late());
  EXPECT_FALSE(Limits{.deadline = steady_clock::now() + std::chrono::hours(1)}.late());
}

TEST(Limits, PartsOfThemKeepWhatEndsTheWork) {
  StopSource source;
  const auto deadline = steady_clock::now();
  const Limits limits{
      .threads = 3, .stop = source.get_token(), .deadline = deadline, .progress = [](double) {}};
  EXPECT_EQ(limits.alone().threads, 1);
  EXPECT_EQ(limits.alone().stop, limits.stop);
  EXPECT_EQ(limits.alone().deadline, deadline);
  EXPECT_FALSE(limits.alone().progress);
  EXPECT_EQ(limits.silent().threads, 3);
  EXPECT_EQ(limits.silent().stop, limits.stop);
  EXPECT_EQ(limits.silent().deadline, deadline);
  EXPECT_FALSE(limits.silent().progress);
  EXPECT_EQ(limits.without_deadline().threads, 3);
  EXPECT_EQ(limits.without_deadline().stop, limits.stop);
  EXPECT_EQ(limits.without_deadline().deadline, std::nullopt);
  EXPECT_TRUE(limits.without_deadline().progress);
}

TEST(Limits, AStopIsSeenBeforeADeadline) {
  EXPECT_EQ(error_of([] { check(Limits{}); }), std::nullopt);
  EXPECT_EQ(error_of([] { check(kLate); }), ErrorKind::timed_out);
  EXPECT_EQ(error_of([] { check_stop(kLate); }), std::nullopt);
  StopSource source;
  source.request_stop();
  Limits stopped = kLate;
  stopped.stop = source.get_token();
  EXPECT_EQ(error_of([&] { check(stopped); }), ErrorKind::cancelled);
}

// A call whose answer cannot say that it is a part ends with an error.
TEST(Limits, EndWhatHasNoCoverage) {
  const Mesh mesh = generate_sphere(2000);
  EXPECT_EQ(error_of([&] { for_each_chunk(2, 1, kLate, [](std::size_t, std::size_t) {}); }),
            ErrorKind::timed_out);
  EXPECT_EQ(error_of([&] { static_cast<void>(Shape(mesh, {}, kLate)); }), ErrorKind::timed_out);
  EXPECT_EQ(error_of([&] { static_cast<void>(refit(Shape(mesh), mesh.vertices, kLate)); }),
            ErrorKind::timed_out);
  EXPECT_EQ(error_of([&] { static_cast<void>(WindingIndex(Body(mesh), kLate)); }),
            ErrorKind::timed_out);
  Scene scene;
  scene.add_environment(Body(mesh));
  const MoverId mover = scene.add_mover(Body(mesh));
  EXPECT_EQ(error_of([&] { static_cast<void>(scene.step({}, kLate)); }), ErrorKind::timed_out);
  // The scene is as it was.
  scene.set_pose(mover, Pose::translation(1.5, 0, 0));
  EXPECT_FALSE(scene.step().environment.empty());
}

// In the middle of a step no pair may be cut: the report could not say so.
TEST(Limits, EndAStepAsAWhole) {
  Scene scene;
  const Shape shape(generate_sphere(5000));
  scene.add_environment(Body(shape));
  for (int k = 0; k < 40; ++k) {
    scene.add_mover(Body(shape, Pose::translation(0.01 * k, 0, 0)));
  }
  const StepReport whole = scene.step();
  int ended = 0;
  for (auto time = std::chrono::microseconds(1); time < std::chrono::seconds(10); time *= 2) {
    StepReport report;
    const auto error = error_of(
        [&] { report = scene.step({}, {.threads = 2, .deadline = steady_clock::now() + time}); });
    if (!error) {
      EXPECT_EQ(report.environment, whole.environment);
      EXPECT_EQ(report.movers, whole.movers);
      break;
    }
    EXPECT_EQ(*error, ErrorKind::timed_out);
    ++ended;
  }
  EXPECT_GT(ended, 0);
}

TEST(Limits, OfASingleRay) {
  const Body body(generate_sphere(2000));
  const Ray ray{{0, 0, 5}, {0, 0, -1}};
  EXPECT_EQ(closest_hit(body, ray, {}, kLate).coverage, Coverage::cut);
  EXPECT_EQ(any_hit(body, ray, {}, kLate).coverage, Coverage::cut);
}

}  // namespace
}  // namespace soms
