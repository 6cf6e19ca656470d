#include "apps/view/sight/rich_frame.h"

#include "soms/base/error.h"

#include "apps/view/scene/contact_look.h"
#include "apps/view/scene/event_finder.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace soms::view {
namespace {

/// A block at the origin; mover k touches it from frame `first` to `last` of its pair.
SceneContent blocks(const std::vector<std::pair<std::uint64_t, std::uint64_t>>& touching) {
  const Shape block(test::box_body({0, 0, 0}, {1, 1, 1}));
  SceneContent content;
  content.city.emplace_back(block);
  for (std::size_t k = 0; k < touching.size(); ++k) {
    const auto [first, last] = touching[k];
    content.movers.push_back(
        {Body(block, Pose::translation(0, 0, 10.0 * static_cast<double>(k) + 10)),
         [first = first, last = last, k](std::uint64_t frame) {
           const double away =
               first <= frame && frame <= last ? 0.5 : 10 + 5 * static_cast<double>(k);
           return Pose::translation(away, 0.3 * static_cast<double>(k), away);
         }});
  }
  return content;
}

RichFrame richest(SceneContent content, std::uint64_t most = 600) {
  const std::uint64_t frames = frames_to_search(content);
  ViewScene scene(std::move(content));
  const RichFrame found = go_to_richest(scene, frames, most);
  EXPECT_EQ(scene.frame(), found.frame);
  EXPECT_EQ(touching_movers(scene.contacts()).size(), found.touching_movers);
  return found;
}

TEST(RichFrame, IsOneInWhichMostMoversTouch) {
  const RichFrame found = richest(blocks({{100, 400}, {250, 330}}));
  EXPECT_EQ(found.touching_movers, 2U);
  EXPECT_EQ(found.frames, 600U);
  EXPECT_LT(found.searched, 80U);
}

TEST(RichFrame, FindsWhatTouchesInASingleFrame) {
  for (const std::uint64_t frame : {0U, 1U, 77U, 338U, 599U}) {
    EXPECT_EQ(richest(blocks({{frame, frame}})).frame, frame);
  }
}

TEST(RichFrame, EndsWhereNothingTouchesAndAtItsBound) {
  const RichFrame none = richest(blocks({{700, 700}}));
  EXPECT_EQ(none.touching_movers, 0U);
  EXPECT_EQ(none.frame, 0U);
  EXPECT_EQ(none.searched, 600U) << "each once";
  EXPECT_EQ(richest(blocks({{700, 700}}), 90).searched, 90U);
}

TEST(RichFrame, OfASceneThatStandsStillIsTheOnlyOne) {
  SceneContent content = blocks({{0, 5}});
  content.movers[0].motion = {};
  EXPECT_EQ(frames_to_search(content), 1U);
}

TEST(RichFrame, EndsAtTheDeadline) {
  ViewScene scene(blocks({{3, 5}}));
  Limits late;
  late.deadline.emplace();  // the beginning of time
  EXPECT_THROW((void)go_to_richest(scene, 600, 600, late), Error);
  EXPECT_THROW((void)nearest_touching_frame(scene, 600, late), Error);
}

TEST(NearestTouchingFrame, IsTheFirstOnEitherSide) {
  SceneContent content = blocks({{200, 210}, {320, 330}});
  ViewScene scene(std::move(content));
  for (const auto& [from, nearest] :
       {std::pair(0U, 200U), std::pair(250U, 210U), std::pair(300U, 320U), std::pair(599U, 330U)}) {
    scene.go_to(from);
    EXPECT_EQ(nearest_touching_frame(scene, 600), nearest);
    EXPECT_EQ(scene.frame(), from);
  }
  ViewScene never(blocks({{700, 700}}));
  EXPECT_EQ(nearest_touching_frame(never, 600), std::nullopt);
}

TEST(ContactPairs, AreOrderedByTheirTriangles) {
  Mesh walls = test::joined(test::box_body({0, 0, 0}, {1, 1, 1}, 1),
                            test::box_body({5, 0, 0}, {6, 1, 1}, 4));
  const auto all = static_cast<std::uint32_t>(walls.triangles.size());
  walls.parts = {{"coarse", Part::kNoParent, 0, 12}, {"fine", Part::kNoParent, 12, all - 12}};
  SceneContent content;
  content.city.emplace_back(std::move(walls));
  content.movers.push_back({Body(test::box_body({0.5, 0.5, 0.5}, {5.5, 0.7, 0.7}, 1)), {}});
  content.movers[0].body.name = "beam";
  const ViewScene scene(std::move(content));
  const std::vector<ContactPair> pairs = contact_pairs(scene);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_GE(pairs[0].touches.size(), pairs[1].touches.size());
  EXPECT_EQ(name_of_part(scene, pairs[0].parts.b, pairs[0].parts.part_b), "fine");
  EXPECT_EQ(name_of_part(scene, pairs[1].parts.b, pairs[1].parts.part_b), "coarse");
  EXPECT_EQ(name_of_part(scene, pairs[0].parts.a, pairs[0].parts.part_a), "beam");
}

}  // namespace
}  // namespace soms::view
