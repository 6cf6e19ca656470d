// Steps that are given a method find by it what they find without.
#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/scene/scene.h"
#include "soms/thesis/overlap.h"

#include "tests/support/support.h"

#include <atomic>
#include <cstdint>

namespace soms {
namespace {

/// Counts the poses that it is queried about.
class Counting final : public OverlapMethod {
 public:
  [[nodiscard]] OverlapBatch ask(const Shape& mover, std::span<const Pose* const> poses,
                                 const Body& fixed, const OverlapOptions& options,
                                 const Limits& limits) const override {
    queried += poses.size();
    return by_.ask(mover, poses, fixed, options, limits);
  }

  mutable std::atomic<std::uint64_t> queried = 0;

 private:
  thesis::TraversalMethod by_{{.traversal = Traversal::larger}};
};

/// Balls of one shape among two others.
Scene crowded(Rng& rng, std::uint64_t movers, bool keep_tree) {
  const ShapeOptions options{.keep_tree = keep_tree};
  const Shape ball(generate_sphere(60), options);
  Scene scene;
  const auto place = [&] {
    return Pose::about_z(rng.uniform(0, 6),
                         {rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(-2, 2)});
  };
  scene.add_environment(Body(Shape(generate_knot(200), options)));
  scene.add_environment(Body(ball, place()));
  for (std::uint64_t k = 0; k < movers; ++k) {
    scene.add_mover(Body(ball, place()));
  }
  return scene;
}

TEST(StepMethod, AnswersEveryPairOfBodies) {
  test::for_each_case("scene/method", 20, [](Rng& rng) {
    Scene scene = crowded(rng, 1 + rng.below(30), true);  // few pairs are queried one by one
    for (const OverlapMode mode : {OverlapMode::all, OverlapMode::first}) {
      for (const StepScope scope : {StepScope::every_pair, StepScope::first_contact}) {
        StepOptions options{.mode = mode, .scope = scope};
        const StepReport expected = scene.step(options);
        Cost cost;
        for (const int threads : {1, 3}) {
          const Counting method;
          options.method = &method;
          const StepReport report = scene.step(options, {.threads = threads});
          EXPECT_EQ(report.environment, expected.environment);
          EXPECT_EQ(report.movers, expected.movers);
          EXPECT_EQ(report.queries, expected.queries);
          EXPECT_EQ(method.queried, report.queries);
          EXPECT_TRUE(threads == 1 || report.cost == cost);
          cost = report.cost;
        }
      }
    }
  });
}

TEST(StepMethod, CostsWhatItsQueriesCost) {
  Scene scene;
  const Body knot(Shape(generate_knot(200), {.keep_tree = true}));
  const Body ball(Shape(generate_sphere(60), {.keep_tree = true}), Pose::translation(1, 0, 0));
  scene.add_environment(knot);
  scene.add_mover(ball);
  const TraversalOptions traversal{.traversal = Traversal::simultaneous};
  const thesis::TraversalMethod method(traversal);
  const thesis::CountedOverlap expected = thesis::overlap(ball, knot, traversal);
  const StepReport report = scene.step({.method = &method});
  EXPECT_EQ(report.cost, expected.answer.cost);
  EXPECT_EQ(report.environment.size(), expected.answer.pairs.size());
}

TEST(StepMethod, SaysWhatItNeeds) {
  Rng rng(1);
  EXPECT_THROW(thesis::TraversalMethod({}), Error);
  EXPECT_THROW(thesis::TraversalMethod({.descent = Descent::cross}), Error);
  Scene scene = crowded(rng, 9, false);
  const thesis::TraversalMethod method({.traversal = Traversal::e_node});
  try {
    static_cast<void>(scene.step({.method = &method}));
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
  }
}

}  // namespace
}  // namespace soms
