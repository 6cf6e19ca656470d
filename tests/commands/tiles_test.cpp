// soms tile, and the verbs that take a folder of tiles in place of a model.
#include "tests/commands/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

namespace soms::test {
namespace {

/// A city in one file and in tiles, and rows to ask about.
class Tiles : public testing::Test {
 protected:
  void SetUp() override {
    run({"generate", "city", "--triangles", "6000", "--extent", "4000", "-o", "city.ply"});
    run({"generate", "car", "-o", "car.ply"});
    run({"generate", "sphere", "--triangles", "80", "-o", "ball.ply"});
    run({"tile", "city.ply", "--most", "900", "-o", "tiles"});
    std::ofstream poses(path("poses.csv"));
    std::ofstream rays(path("rays.csv"));
    poses << "x,y,z\n";
    rays << "ox,oy,oz,dx,dy,dz\n";
    for (int k = 0; k < 200; ++k) {
      const int x = 37 * k % 4000 - 2000;
      const int y = 1013 * k % 4000 - 2000;
      poses << x << ',' << y << ',' << k % 20 - 5 << '\n';
      rays << x << ',' << y << ",60," << k % 7 - 3 << ',' << k % 5 - 2 << ",-1\n";
    }
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  /// Names of files are those in the folder.
  [[nodiscard]] RunResult result_of(std::vector<std::string> words) const {
    for (std::string& word : words) {
      const bool is_file = word.find('.') != std::string::npos || word == "tiles" || word == "out";
      if (is_file && word.front() != '-') {
        word = path(word);
      }
    }
    return soms_run(words);
  }

  RunResult run(const std::vector<std::string>& words) const {
    RunResult result = result_of(words);
    EXPECT_EQ(result.status, 0) << result.err;
    return result;
  }

  [[nodiscard]] std::string bytes(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  TemporaryFolder folder_;
};

TEST_F(Tiles, GiveTheBytesOfTheModel) {
  const std::vector<std::vector<std::string>> questions{
      {"overlap", "car.ply", "MODEL", "--pose", "poses.csv"},
      {"overlap", "car.ply", "MODEL", "--pose", "poses.csv", "--first"},
      {"distance", "car.ply", "MODEL", "--pose", "poses.csv"},
      {"distance", "car.ply", "MODEL", "--pose", "poses.csv", "--at-most", "4"},
      {"closest", "MODEL", "--points", "poses.csv"},
      {"ray", "MODEL", "--rays", "rays.csv"},
      {"ray", "MODEL", "--rays", "rays.csv", "--any"},
      {"ray", "MODEL", "--rays", "rays.csv", "--skip", "17"}};
  for (const std::vector<std::string>& question : questions) {
    std::map<std::string, std::string> answers;
    std::map<std::string, std::string> said;
    for (const std::string model : {"city.ply", "tiles"}) {
      std::vector<std::string> words = question;
      std::replace(words.begin(), words.end(), std::string("MODEL"), model);
      for (const std::string limit : {"", "64M"}) {
        std::vector<std::string> limited = words;
        limited.insert(limited.end(), {"-o", "answer.npz"});
        if (!limit.empty() && model == "tiles") {
          limited.insert(limited.end(), {"--max-memory", limit});
        }
        said[model] = run(limited).out;
        if (model == "tiles" && answers.contains(model)) {
          EXPECT_EQ(answers[model], bytes("answer.npz"));
        }
        answers[model] = bytes("answer.npz");
      }
    }
    EXPECT_EQ(answers["tiles"], answers["city.ply"]) << question[0];
    EXPECT_FALSE(answers["tiles"].empty());
  }
}

TEST_F(Tiles, DecideWithinAsTheModel) {
  for (const char* const clearance : {"0", "2", "9"}) {
    std::vector<std::vector<bool>> found;
    for (const std::string model : {"city.ply", "tiles"}) {
      found.emplace_back();
      for (const Json& row : json_lines(run({"within", "car.ply", model, "--pose", "poses.csv",
                                             "--clearance", clearance, "--json"})
                                            .out)) {
        found.back().push_back(row.at("within").get<bool>());
      }
    }
    EXPECT_EQ(found[0].size(), 200U);
    EXPECT_EQ(found[0], found[1]) << clearance;
  }
}

TEST_F(Tiles, GiveSharesThatAreJoined) {
  for (const char* const share : {"1/3", "2/3", "3/3"}) {
    run({"distance", "car.ply", "tiles", "--pose", "poses.csv", "--shard", share, "-o",
         "out/shard.npz"});
  }
  const RunResult again = run({"distance", "car.ply", "tiles", "--pose", "poses.csv", "--shard",
                               "2/3", "-o", "out/shard.npz"});
  EXPECT_NE(again.err.find("is there and whole"), std::string::npos) << again.err;
  run({"join", "out", "-o", "joined.npz"});
  run({"distance", "car.ply", "city.ply", "--pose", "poses.csv", "-o", "whole.npz"});
  EXPECT_EQ(bytes("joined.npz"), bytes("whole.npz"));
  // Other tiles are another question.
  EXPECT_EQ(result_of({"tile", "city.ply", "--most", "400", "-o", "tiles"}).status, 2);
  std::filesystem::remove_all(path("tiles"));
  run({"tile", "city.ply", "--most", "400", "-o", "tiles"});
  EXPECT_EQ(result_of({"distance", "car.ply", "tiles", "--pose", "poses.csv", "--shard", "2/3",
                       "-o", "out/shard.npz"})
                .status,
            3);
}

TEST_F(Tiles, AreCutOnceAndDescribed) {
  const Json again =
      json_lines(run({"tile", "city.ply", "--most", "900", "-o", "tiles", "--json"}).out)[0];
  EXPECT_EQ(again.at("schema"), "soms.tile/1");
  EXPECT_EQ(again.at("cut"), 0);
  EXPECT_EQ(again.at("triangles"), 6000);
  const Json info = json_lines(run({"info", "tiles", "--json", "--verify"}).out)[0];
  EXPECT_EQ(info.at("triangles"), 6000);
  EXPECT_EQ(info.at("tiles"), again.at("tiles"));
  EXPECT_EQ(info.at("sources")[0].at("first"), 0);
  EXPECT_NE(run({"info", "tiles"}).out.find("numbered from 0"), std::string::npos);
}

TEST_F(Tiles, NumberSeveralModelsInTheirOrder) {
  run({"tile", "ball.ply", "city.ply", "-o", "out", "--compact"});
  const Json first =
      json_lines(run({"distance", "car.ply", "out", "--pose", "0 0 3", "--json"}).out)[0];
  EXPECT_LT(first.at("triangles")[1].get<int>(), 80);  // the ball is at the origin
  const Json far =
      json_lines(run({"distance", "car.ply", "out", "--pose", "900 900 3", "--json"}).out)[0];
  EXPECT_GE(far.at("triangles")[1].get<int>(), 80);
}

TEST_F(Tiles, AreRefusedWithTheReasonWhereWholeSurfacesAreNeeded) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"solid", "ball.ply", "tiles"}, "a folder of tiles, where whole surfaces are needed"},
      {{"contains", "tiles", "--points", "poses.csv"}, "a folder of tiles"},
      {{"clash", "tiles"}, "a folder of tiles"},
      {{"overlap", "tiles", "car.ply"}, "take tiles as B"},
      {{"overlap", "car.ply", "tiles", "--by", "part"}, "a part may lie in several of them"},
      {{"overlap", "car.ply", "tiles", "--limit", "3"}, "the first pairs are not known"},
      {{"overlap", "car.ply", "tiles", "-o", "page.html"}, "a page shows the whole model"},
      {{"overlap", "car.ply", "tiles", "--verify"}, "brute force needs the whole model"},
      {{"overlap", "car.ply", "tiles", "--tree", "rule=sah"}, "trees are built"},
      {{"overlap", "car.ply", "tiles", "--tree", "traversal=larger"}, "the binary tree"},
      {{"distance", "car.ply", "tiles", "--scale-b", "2"}, "triangles were cut as they are"},
      {{"closest", "tiles", "--points", "poses.csv", "--signed"}, "whole surfaces"},
      {{"closest", "tiles", "--points", "poses.csv", "--nearest", "3"}, "several of them"},
      {{"ray", "tiles", "--rays", "rays.csv", "--all"}, "a crossing through an edge"}};
  for (const auto& [words, reason] : cases) {
    const RunResult result = result_of(words);
    EXPECT_EQ(result.status, 2) << words[0] << ": " << result.err;
    EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
  }
}

TEST_F(Tiles, NameWhatIsDamaged) {
  std::ofstream(path("tiles") + "/tile-000001.somst", std::ios::trunc) << "no tree";
  const RunResult result =
      result_of({"overlap", "car.ply", "tiles", "--pose", "poses.csv", "--no-pairs"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("tile-000001.somst"), std::string::npos) << result.err;
  EXPECT_EQ(result_of({"tile", "missing.ply", "-o", "out/shard.npz"}).status, 3);
  EXPECT_FALSE(std::filesystem::exists(path("out")));
  EXPECT_EQ(result_of({"tile", "city.ply", "-o", "city.ply"}).status, 5);
  EXPECT_EQ(result_of({"tile", "-", "-", "-o", "out/shard.npz"}).status, 2);
  std::filesystem::remove(path("tiles") + "/tiles.json");
  const RunResult incomplete = result_of({"overlap", "car.ply", "tiles"});
  EXPECT_EQ(incomplete.status, 2);
  EXPECT_NE(incomplete.err.find("not complete"), std::string::npos) << incomplete.err;
}

}  // namespace
}  // namespace soms::test
