#include "apps/view/scene/event_finder.h"

#include "soms/io/write_mesh.h"

#include "apps/view/scene/load.h"
#include "apps/view/scene/view_scene.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {
namespace {

/// A block, and a cube that drives through its side in frames 3 to 6 and again in frame 9.
SceneContent drive() {
  SceneContent content = two_bodies(Body(test::box_body({-10, -10, 0}, {10, 10, 10}, 4)),
                                    Body(test::box_body({-1, -1, -1}, {1, 1, 1}, 2)));
  content.city[0].name = "block";
  content.movers[0].body.name = "cube";
  content.movers[0].motion = [](std::uint64_t frame) {
    const bool touches = (frame >= 3 && frame <= 6) || frame == 9;
    return Pose::translation(touches ? 10 + 0.1 * static_cast<double>(frame) : 20, 0.2, 5);
  };
  content.frames = 12;
  return content;
}

void search_all(EventFinder& finder) {
  while (finder.searched() < finder.frames()) {
    const std::uint64_t before = finder.searched();
    finder.search(0);  // no time: one frame
    ASSERT_EQ(finder.searched(), before + 1);
  }
}

TEST(EventFinder, FindsEachStretchOfTimeWithItsPairs) {
  EventFinder finder(drive());
  EXPECT_EQ(finder.frames(), 12U);
  EXPECT_TRUE(finder.spans().empty());
  search_all(finder);
  ASSERT_EQ(finder.spans().size(), 2U);
  ViewScene scene(drive());
  const auto pairs = [&](std::uint64_t frame) {
    scene.go_to(frame);
    return scene.contacts().size();
  };
  const auto expect = [&](const ContactSpan& span, std::uint64_t begin, std::uint64_t end) {
    EXPECT_EQ(span.begin, begin);
    EXPECT_EQ(span.end, end);
    std::size_t most = 0;
    for (std::uint64_t frame = begin; frame <= end; ++frame) {
      most = std::max(most, pairs(frame));
    }
    EXPECT_GT(most, 0U);
    EXPECT_EQ(span.most_pairs, most);
    EXPECT_EQ(pairs(span.most_step), most);
  };
  expect(finder.spans()[0], 3, 6);
  expect(finder.spans()[1], 9, 9);
  EXPECT_EQ(finder.title(finder.spans()[0]), "cube (mover 0) touches block");
}

TEST(EventFinder, SearchesOneFrameWhereNothingMoves) {
  SceneContent content = drive();
  content.movers[0].motion = {};
  content.movers[0].body.pose = Pose::translation(10, 0.2, 5);
  EventFinder finder(std::move(content));
  EXPECT_EQ(finder.frames(), 1U);
  search_all(finder);
  ASSERT_EQ(finder.spans().size(), 1U);
  EXPECT_TRUE(finder.spans()[0].lasts);
}

TEST(EventFinder, StartsOverWithABodyMore) {
  EventFinder finder(drive());
  search_all(finder);
  Body added(test::box_body({9, -1, 4}, {12, 1, 6}, 2));
  added.name = "added";
  finder.add(std::move(added));
  EXPECT_EQ(finder.searched(), 0U);
  EXPECT_TRUE(finder.spans().empty());
  search_all(finder);
  // It touches the block all the time, and the cube whenever that comes.
  ASSERT_EQ(finder.spans().size(), 5U);
  EXPECT_EQ(finder.title(finder.spans()[0]), "added (mover 1) touches block");
  EXPECT_EQ(finder.spans()[0].end, 11U);
}

/// Begin, end and most pairs of triangles of each event, by who touches what.
using Stretches = std::map<std::string, std::vector<std::array<std::uint64_t, 3>>>;

/// The events that the command wrote.
Stretches of_the_command(const std::filesystem::path& csv) {
  Stretches times;
  std::ifstream file(csv);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line,
            "event,mover,model,touched,part,begin,end,frames,contacts,most_pairs,most_frame,x,y,z");
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(fields, cell, ',');) {
      cells.push_back(cell);
    }
    const std::string who = cells[2] + " (mover " + cells[1] + ") touches " + cells[3];
    times[who].push_back({std::stoull(cells[5]), std::stoull(cells[6]), std::stoull(cells[9])});
  }
  return times;
}

TEST(EventFinder, FindsWhatSimulateFinds) {
  const test::TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.begin(), SOMS_COMMAND);
    const test::RunResult result = test::run_program(words);
    EXPECT_EQ(result.status, 0) << result.err;
  };
  run({"generate", "city", "--triangles", "20000", "--extent", "4000", "-o", path("town.ply")});
  run({"generate", "car", "-o", path("car.ply")});
  run({"simulate", path("town.ply"), "--mover", path("car.ply"), "--count", "40", "--frames", "200",
       "-o", path("events.csv"), "--quiet"});
  command::Shared shared;
  shared.quiet = true;
  command::Console console(shared);
  command::WorldOptions options;
  options.cities = {path("town.ply")};
  options.movers = {path("car.ply")};
  options.count = 40;
  SceneContent content = content_of(command::load_world(options, console));
  EXPECT_EQ(content.frames, 600U);
  content.frames = 200;
  EventFinder finder(std::move(content));
  finder.search(1e9);
  Stretches found;
  for (const ContactSpan& span : finder.spans()) {
    found[finder.title(span)].push_back({span.begin, span.end, span.most_pairs});
  }
  EXPECT_FALSE(found.empty());
  EXPECT_EQ(found, of_the_command(path("events.csv")));
}

}  // namespace
}  // namespace soms::view
