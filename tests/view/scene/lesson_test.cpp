#include "apps/view/scene/lesson.h"

#include "soms/generate/shapes.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/build.h"

#include "apps/view/scene/load.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soms::view {
namespace {

std::size_t steps(const std::vector<LessonTest>& tests, LessonStep step) {
  return static_cast<std::size_t>(std::count_if(
      tests.begin(), tests.end(), [step](const LessonTest& t) { return t.step == step; }));
}

ViewScene block_and_cube(double x) {
  Body block(test::box_body({-10, -10, 0}, {10, 10, 10}, 4));
  block.name = "block";
  Body cube(test::box_body({-1, -1, -1}, {1, 1, 1}, 2), Pose::translation(x, 0.3, 5));
  cube.name = "cube";
  return ViewScene(two_bodies(std::move(block), std::move(cube)));
}

TEST(Lesson, HasTheTestsOfEveryTraversalInTheirOrder) {
  const Mesh mesh = generate_knot(200);
  const Tree tree = build(mesh, thesis_options(Rule::soms, 24));
  PosedBoxes still(mesh, tree);
  PosedBoxes moving(mesh, tree);
  still.move(Pose::identity());
  moving.move(Pose::translation(0.4, 0.1, 0));
  for (const TraversalEntry& row : traversals()) {
    if (row.traversal == Traversal::fast) {
      continue;
    }
    const TraversalOptions options{.traversal = row.traversal};
    const TraversalCounts counts = traverse(still.view(), moving.view(), options);
    const auto tests = lesson_tests(still.view(), moving.view(), options, 1'000'000);
    EXPECT_EQ(tests.size(), counts.box_tests) << row.name;
    EXPECT_EQ(steps(tests, LessonStep::leaves), counts.leaf_pairs) << row.name;
    EXPECT_EQ(steps(tests, LessonStep::passes), 0U);
    EXPECT_EQ(tests.front().nodes, (NodePair{0, 0})) << row.name;
    const auto first = lesson_tests(still.view(), moving.view(), options, 5);
    EXPECT_EQ(first, std::vector(tests.begin(), tests.begin() + 5)) << row.name;
  }
}

TEST(Lesson, WithoutPruningBranchesGoOn) {
  ViewScene scene = block_and_cube(10);
  TreeChoice choice;
  choice.traversal = {.traversal = Traversal::simultaneous, .prune = false};
  scene.set_trees(choice);
  Lesson lesson;
  lesson.update(scene);
  EXPECT_GT(steps(lesson.tests(), LessonStep::passes), 0U);
}

TEST(Lesson, EachTestIsExplainedInWords) {
  ViewScene scene = block_and_cube(10);
  TreeChoice choice;
  choice.traversal = {.traversal = Traversal::simultaneous};
  scene.set_trees(choice);
  Lesson lesson;
  lesson.update(scene);
  ASSERT_GT(lesson.tests().size(), 10U);
  bool touches = false;
  for (std::size_t i = 0; i < lesson.tests().size(); ++i) {
    const auto sentences = lesson.sentences(scene, i);
    ASSERT_EQ(sentences.size(), 2U);
    const std::string head = "Test " + std::to_string(i + 1) + " of ";
    EXPECT_EQ(sentences[0].rfind(head, 0), 0U) << sentences[0];
    switch (lesson.tests()[i].step) {
      case LessonStep::ends:
        EXPECT_NE(sentences[1].find("are apart along"), std::string::npos) << sentences[1];
        break;
      case LessonStep::enters:
        EXPECT_NE(sentences[1].find("up to four pairs"), std::string::npos) << sentences[1];
        break;
      case LessonStep::leaves:
        EXPECT_NE(sentences[1].find("triangles are compared"), std::string::npos) << sentences[1];
        touches = touches || sentences[1].find(": none touch") == std::string::npos;
        break;
      case LessonStep::passes:
        ADD_FAILURE() << "pruning is on";
    }
  }
  EXPECT_TRUE(touches);
}

TEST(Lesson, IsTakenApartAgainWhereAPoseChanges) {
  ViewScene scene = block_and_cube(30);
  Lesson lesson;
  lesson.update(scene);
  ASSERT_EQ(lesson.tests().size(), 1U);  // the roots are apart
  EXPECT_EQ(lesson.sentences(scene, 0)[0],
            "Test 1 of 1: node 0 of block (level 1, 192 triangles) against node 0 of cube "
            "(level 1, 48 triangles).");
  EXPECT_EQ(lesson.sentences(scene, 0)[1],
            "Their boxes are apart along x by 19. No triangle below one can touch a triangle below "
            "the other: this branch ends here.");
  scene.set_pose(0, Pose::translation(10, 0.3, 5));
  lesson.update(scene);
  EXPECT_GT(lesson.tests().size(), 1U);
  TreeChoice fast;
  fast.traversal = {.traversal = Traversal::fast};
  scene.set_trees(fast);
  lesson.update(scene);
  EXPECT_TRUE(lesson.tests().empty());
  EXPECT_NE(in_a_sentence(fast.traversal).find("answers queries"), std::string::npos);
}

}  // namespace
}  // namespace soms::view
