#include "soms/scene/contact_spans.h"

#include "soms/base/error.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/scene/print.h"
#include "soms/scene/reference/contact_spans.h"
#include "soms/scene/scene.h"

#include "tests/scene/random_bodies.h"
#include "tests/scene/scenes.h"
#include "tests/support/bodies.h"
#include "tests/support/host_arithmetic.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace soms {

namespace {

SceneBody mover(std::uint32_t id) {
  return {SceneBodyKind::mover, id};
}

SceneBody environment(std::uint32_t id) {
  return {SceneBodyKind::environment, id};
}

/// The bodies of a scene as they are now, also after it has changed.
ContactBodies bodies_now(const Scene& scene, bool divided) {
  std::map<SceneBody, Body> bodies;
  for (const MoverId id : scene.movers()) {
    bodies[mover(id)] = scene.mover(id);
  }
  for (const EnvironmentId id : scene.environments()) {
    bodies[environment(id)] = scene.environment(id);
  }
  ContactBodies now{.triangle = [bodies](const SceneBody& body, TriangleId triangle) {
    return detail::moved_triangle(bodies.at(body), triangle);
  }};
  if (divided) {
    now.part = [](const SceneBody&, TriangleId triangle) {
      return triangle % 3 == 2 ? Part::kNoParent : triangle % 3;
    };
  }
  return now;
}

void change_some(Scene& scene, Rng& rng) {
  for (const MoverId id : scene.movers()) {
    const std::uint64_t chance = rng.below(40);
    if (chance < 8) {
      scene.set_pose(id, test::random_pose(rng, 6));
    } else if (chance == 8) {
      scene.remove_mover(id);
    } else if (chance == 9) {
      scene.ignore_environment(id, scene.environments().front());
    }
  }
}

/// A report as a scene makes it, in which the movers touch triangles of part 0.
StepReport touching(std::vector<EnvironmentContact> contacts) {
  StepReport report;
  report.environment = std::move(contacts);
  return report;
}

/// Bodies whose triangles are all the same.
ContactBodies plain_bodies() {
  return {.triangle = [](const SceneBody&, TriangleId) {
    return Triangle{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
  }};
}

bool refused(ContactSpans& spans, std::uint64_t step, const StepReport& report) {
  try {
    spans.follow(step, report, plain_bodies());
  } catch (const Error& error) {
    return error.kind() == ErrorKind::usage;
  }
  return false;
}

// The triangles that share the place are moved again: as the step moved them, whatever rounding the
// host has set. To nearest 0.1 + 0.2 lies in the plane of the other triangle, downward before it.
TEST(ContactSpans, APlaceIsThatOfTheStepUnderAnyArithmeticOfTheHost) {
  constexpr double kPlane = 0.1 + 0.2;
  Scene scene;
  scene.add_environment(
      Body(test::soup_body({{{kPlane, -1, -1}, {kPlane, 1, -1}, {kPlane, 0, 1}}})));
  scene.add_mover(Body(Shape(test::soup_body({{{0.1, 0, 0}, {-1, -0.1, 0}, {-1, 0.1, 0}}})),
                       Pose::translation(0.2, 0, 0)));
  const StepReport report = scene.step({.mode = OverlapMode::all});
  ASSERT_EQ(report.environment.size(), 1U);
  for (const test::HostMode& mode : test::host_modes()) {
    ContactSpans spans;
    {
      const test::HostArithmetic host(mode);
      spans.follow(0, report, contact_bodies(scene));
    }
    ASSERT_EQ(spans.spans().size(), 1U);
    EXPECT_EQ(spans.spans()[0].place, (Vec3{kPlane, 0, 0})) << mode.name;
    EXPECT_FALSE(spans.spans()[0].box.empty()) << mode.name;
  }
}

// Against what `ContactBodies` promises.
TEST(ContactSpans, APlaceIsANumberThoughTheTrianglesGivenDoNotTouch) {
  ContactSpans spans;
  spans.follow(0, touching({{0, 0, 0, 0}}), {.triangle = [](const SceneBody& body, TriangleId) {
                 const double x = body.kind == SceneBodyKind::mover ? 0 : 5;
                 return Triangle{{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}};
               }});
  const Vec3& place = spans.spans().at(0).place;
  EXPECT_EQ(place, place);
}

TEST(ContactSpans, EqualThoseFoundInAllReportsAtOnce) {
  std::map<std::string, std::size_t> seen;
  test::for_each_case("scene/contact-spans", 40, [&](Rng& rng) {
    Scene scene = test::random_scene(rng, 6, 20, 5);
    const bool divided = rng.below(2) == 0;
    std::vector<reference::ContactStep> steps;
    ContactSpans spans;
    std::uint64_t number = rng.below(5);
    for (int k = 0; k < 12; ++k) {
      number += rng.below(5) == 0 ? 1 + rng.below(9) : 1;
      steps.push_back(
          {number, scene.step({.mover_mover = rng.below(5) != 0}), bodies_now(scene, divided)});
      spans.follow(number, steps.back().report, steps.back().bodies);
      change_some(scene, rng);
    }
    ASSERT_EQ(spans.spans(), reference::contact_spans(steps));
    for (const ContactSpan& span : spans.spans()) {
      ++seen[span.lasts ? "lasts" : "has ended"];
      seen["went on over steps that did not compare"] += span.steps <= span.end - span.begin;
      seen["most later than the first step"] += span.most_step > span.begin;
      seen["of a part"] += span.b.part != Part::kNoParent;
      seen["of two movers"] += span.b.body.kind == SceneBodyKind::mover;
    }
  });
  EXPECT_EQ(seen.size(), 6U);
  for (const auto& [what, count] : seen) {
    EXPECT_GT(count, 50U) << what;
  }
}

// A caller may have joined lists of its own.
TEST(ContactSpans, DoNotDependOnTheOrderOfAReportsLists) {
  std::size_t unsorted = 0;
  test::for_each_case("scene/contact-spans-order", 20, [&](Rng& rng) {
    Scene scene = test::random_scene(rng, 6, 20, 5);
    const bool divided = rng.below(2) == 0;
    ContactSpans expected;
    ContactSpans spans;
    for (std::uint64_t step = 0; step < 4; ++step) {
      StepReport report = scene.step();
      const ContactBodies bodies = bodies_now(scene, divided);
      expected.follow(step, report, bodies);
      const auto mix = [&rng](auto& list) {
        for (std::size_t i = list.size(); i > 1; --i) {
          std::swap(list[i - 1], list[rng.below(i)]);
        }
      };
      mix(report.environment);
      mix(report.movers);
      unsorted += std::is_sorted(report.environment.begin(), report.environment.end()) ? 0U : 1U;
      spans.follow(step, report, bodies);
      change_some(scene, rng);
    }
    ASSERT_EQ(spans.spans(), expected.spans());
  });
  EXPECT_GT(unsorted, 20U);
}

TEST(ContactSpans, DoNotDependOnThreads) {
  test::for_each_case("scene/contact-spans-threads", 5, [&](Rng& rng) {
    Scene scene = test::random_scene(rng, 6, 30, 5);
    ContactSpans one;
    ContactSpans four;
    for (std::uint64_t step = 0; step < 6; ++step) {
      one.follow(step, scene.step({}, {.threads = 1}), contact_bodies(scene));
      four.follow(step, scene.step({}, {.threads = 4}), contact_bodies(scene));
      for (const MoverId id : scene.movers()) {
        if (rng.below(3) == 0) {
          scene.set_pose(id, test::random_pose(rng, 6));
        }
      }
    }
    EXPECT_EQ(one, four);
    EXPECT_FALSE(one.spans().empty());
  });
}

TEST(ContactSpans, EndWhereAStepBetweenFindsNoTouch) {
  ContactSpans spans;
  for (const std::uint64_t step : {3U, 4U, 9U}) {  // 5 to 8 are left out
    spans.follow(step, touching({{0, 0, 1, 1}}), plain_bodies());
  }
  ASSERT_EQ(spans.spans().size(), 1U);
  EXPECT_EQ(spans.spans()[0].begin, 3U);
  EXPECT_EQ(spans.spans()[0].end, 9U);
  EXPECT_EQ(spans.spans()[0].steps, 3U);
  EXPECT_TRUE(spans.spans()[0].lasts);
  spans.follow(10, touching({}), plain_bodies());
  EXPECT_EQ(spans.spans()[0].end, 9U);
  EXPECT_FALSE(spans.spans()[0].lasts);
  spans.follow(11, touching({{0, 0, 1, 1}}), plain_bodies());
  ASSERT_EQ(spans.spans().size(), 2U);
  EXPECT_EQ(spans.spans()[1].begin, 11U);
}

TEST(ContactSpans, OfMoversGoOnWhereMoversAreNotCompared) {
  StepReport together;
  together.environment = {{0, 0, 1, 1}};
  together.movers = {{0, 1, 2, 3}};
  ContactSpans spans;
  spans.follow(0, together, plain_bodies());
  StepReport city_alone = touching({});
  city_alone.mover_mover = false;
  spans.follow(1, city_alone, plain_bodies());
  ASSERT_EQ(spans.spans().size(), 2U);
  EXPECT_FALSE(spans.spans()[0].lasts);
  EXPECT_TRUE(spans.spans()[1].lasts);
  spans.follow(2, together, plain_bodies());
  ASSERT_EQ(spans.spans().size(), 3U);
  EXPECT_EQ(spans.spans()[1].begin, 0U);
  EXPECT_EQ(spans.spans()[1].end, 2U);
  EXPECT_EQ(spans.spans()[1].steps, 2U);
}

TEST(ContactSpans, TheMostPairsAreThoseOfTheFirstStepThatHasThem) {
  ContactSpans spans;
  spans.follow(0, touching({{0, 0, 1, 1}}), plain_bodies());
  spans.follow(1, touching({{0, 0, 1, 1}, {0, 0, 1, 2}}), plain_bodies());
  spans.follow(2, touching({{0, 0, 4, 1}, {0, 0, 5, 2}}), plain_bodies());
  spans.follow(3, touching({{0, 0, 6, 6}}), plain_bodies());
  ASSERT_EQ(spans.spans().size(), 1U);
  EXPECT_EQ(spans.spans()[0].most_pairs, 2U);
  EXPECT_EQ(spans.spans()[0].most_step, 1U);
  EXPECT_EQ(spans.spans()[0].pair, (TrianglePair{1, 1}));
}

TEST(ContactSpans, KeepTheirIndex) {
  ContactSpans spans;
  spans.follow(0, touching({{1, 0, 0, 0}}), plain_bodies());
  spans.follow(1, touching({{0, 0, 0, 0}, {1, 0, 0, 0}, {2, 0, 0, 0}}), plain_bodies());
  ASSERT_EQ(spans.spans().size(), 3U);
  EXPECT_EQ(spans.spans()[0].a, (ContactSide{mover(1)}));
  EXPECT_EQ(spans.spans()[1].a, (ContactSide{mover(0)}));
  EXPECT_EQ(spans.spans()[2].a, (ContactSide{mover(2)}));
}

TEST(ContactSpans, RefuseStepsOutOfOrderAndReportsThatLackPairs) {
  Rng rng(2);
  Scene scene = test::random_scene(rng, 4, 10, 3);
  ContactSpans spans;
  spans.follow(7, touching({{0, 0, 1, 1}}), plain_bodies());
  const ContactSpans before = spans;
  EXPECT_TRUE(refused(spans, 7, touching({})));
  EXPECT_TRUE(refused(spans, 6, touching({})));
  EXPECT_TRUE(refused(spans, 8, scene.step({.scope = StepScope::first_contact})));
  EXPECT_TRUE(refused(spans, 8, scene.step({.mode = OverlapMode::any})));
  EXPECT_EQ(spans, before);
  EXPECT_FALSE(refused(spans, 8, touching({})));
}

TEST(ContactSpans, ChangeNothingWhereBodiesFail) {
  ContactSpans spans;
  spans.follow(0, touching({{0, 0, 1, 1}}), plain_bodies());
  const ContactSpans before = spans;
  const ContactBodies failing{.triangle = [](const SceneBody& body, TriangleId) -> Triangle {
    if (body == mover(3)) {
      throw Error(ErrorKind::usage, "no such mover", "");
    }
    return {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
  }};
  const StepReport report = touching({{1, 0, 0, 0}, {3, 0, 1, 1}});
  EXPECT_THROW(spans.follow(1, report, failing), Error);
  EXPECT_EQ(spans, before);
}

TEST(ContactSpans, AreText) {
  ContactSpans spans;
  spans.follow(0, touching({{4, 2, 7, 8}}), plain_bodies());
  std::ostringstream text;
  text << spans.spans().front() << '\n' << ContactSide{environment(1), 3};
  EXPECT_EQ(text.str(),
            "ContactSpan{a: ContactSide{body: SceneBody{kind: mover, id: 4}}, "
            "b: ContactSide{body: SceneBody{kind: environment, id: 2}}, begin: 0, end: 0, "
            "steps: 1, most_pairs: 1, most_step: 0, i: 7, j: 8, place: Vec3{1, 1, 0}, "
            "box: Box{(0, 0, 0) to (3, 3, 0)}, lasts: true}\n"
            "ContactSide{body: SceneBody{kind: environment, id: 1}, part: 3}");
}

}  // namespace

}  // namespace soms
