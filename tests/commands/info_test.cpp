#include "apps/soms/models/info_trees.h"
#include "tests/commands/run.h"

#include <algorithm>
#include <utility>

namespace soms::test {
namespace {

Json info(std::vector<std::string> words) {
  words.insert(words.begin(), {"info", "--json"});
  const RunResult result = soms_run(words);
  EXPECT_EQ(result.status, 0) << result.err;
  return json_lines(result.out).at(0);
}

TEST(Info, TellsCountsBoundsAndDefects) {
  const Json box = info({test::data("truth/meshes/box2.ply").string(), "--no-trees"});
  EXPECT_EQ(box.at("schema"), "soms.info/1");
  EXPECT_EQ(box.at("triangles"), 12);
  EXPECT_EQ(box.at("vertices"), 8);
  EXPECT_EQ(box.at("bounds"), Json::parse("[[-1,-1,-1],[1,1,1]]"));
  EXPECT_EQ(box.at("defects"), Json::parse(R"({"degenerate":0,"duplicate":0,"open_edges":0,
      "non_manifold_edges":0,"flipped_edges":0,"unused_vertices":0,"closed":true,"repeated_corner":0,
      "collinear":0,"doubled":0,"repeated_vertices":0,"closed_by_index":true})"));
  EXPECT_EQ(box.at("trees"), Json::array());
  const Json same = info({test::data("nasty/two_triangles_same.ply").string(), "--no-trees"});
  EXPECT_EQ(same.at("defects").at("duplicate"), 1);
  EXPECT_EQ(same.at("defects").at("closed"), false);
}

TEST(Info, BuildsATreeByEveryRule) {
  const Json report = info({test::data("truth/meshes/torus.ply").string()});
  std::vector<std::string> rules;
  for (const Json& tree : report.at("trees")) {
    rules.push_back(tree.at("rule"));
    EXPECT_EQ(tree.at("leaves"), tree.at("single_triangle_leaves"));  // by default one a leaf
    EXPECT_EQ(tree.at("leaves"), report.at("triangles"));
    EXPECT_EQ(tree.at("nodes"), 2 * report.at("triangles").get<int>() - 1);
    EXPECT_GE(tree.at("levels"), tree.at("full_levels"));
    EXPECT_GT(tree.at("sah_cost").get<double>(), 0);
    EXPECT_GE(tree.at("build_ms").get<double>(), 0);
    EXPECT_EQ(tree.at("build_runs").get<int>() % 2, 1);
    EXPECT_LE(tree.at("build_runs").get<int>(), 9);
  }
  EXPECT_EQ(rules,
            (std::vector<std::string>{"object-median", "object-mean", "spatial-median", "soms",
                                      "sah", "soms-sah", "fast", "quality", "quick"}));
}

// The bunny of the thesis at 15 levels: golden counts of the design, soms and thesis options.
TEST(Info, CountsTheTreeOfTheThesis) {
  SOMS_NEEDS_OUTSIDE_DATA("1 tree of the thesis");
  const Json report = info({outside_data("ply/bun_zipper_res4.ply")->string(), "--tree",
                            "rule=soms", "--tree", "levels=15", "--tree", "midpoint=thesis",
                            "--tree", "empty-side=stop", "--tree", "leaf=1"});
  ASSERT_EQ(report.at("triangles"), 948);
  const Json& tree = report.at("trees").at(0);
  EXPECT_EQ(report.at("trees").size(), 1U);
  EXPECT_EQ(tree.at("nodes"), 1847);
  EXPECT_EQ(tree.at("leaves"), 924);
  EXPECT_EQ(tree.at("single_triangle_leaves"), 904);
  EXPECT_EQ(tree.at("full_levels"), 6);
  EXPECT_EQ(tree.at("undividable"), 20);
  EXPECT_LE(tree.at("levels"), 15);
}

// Scripts that were written for version 0.1 find what they look for during this one.
TEST(Info, KeepsTheOldKeysBesideTheNewOnes) {
  const Json report = info({test::data("formats/mirrored_node.gltf").string(), "--tree", "leaf=2"});
  for (const auto& [before, now] :
       {std::pair("unit", "meters_per_unit"), std::pair("up", "up_axis"),
        std::pair("bytes_ready", "memory_bytes")}) {
    EXPECT_FALSE(report.at(now).is_null()) << now;
    EXPECT_EQ(report.at(before), report.at(now)) << now;
  }
  const Json& part = report.at("parts").at(1);
  EXPECT_EQ(part.at("first"), part.at("first_triangle"));
  EXPECT_EQ(part.at("count"), part.at("triangles"));
  ASSERT_FALSE(report.at("trees").empty());
  for (const Json& tree : report.at("trees")) {
    for (const auto& [before, now] :
         {std::pair("one", "single_triangle_leaves"), std::pair("lt5", "leaves_below_5_triangles"),
          std::pair("balanced_level", "full_levels"),
          std::pair("largest_leaf", "largest_leaf_triangles"), std::pair("sah", "sah_cost")}) {
      EXPECT_EQ(tree.at(before), tree.at(now)) << now;
    }
  }
}

TEST(Info, TimesAsManyBuildsAsFitIntoATenthOfASecond) {
  EXPECT_EQ(command::builds_to_time(0), 9);
  EXPECT_EQ(command::builds_to_time(11), 9);
  EXPECT_EQ(command::builds_to_time(12), 7);
  EXPECT_EQ(command::builds_to_time(33), 3);
  EXPECT_EQ(command::builds_to_time(34), 1);
  EXPECT_EQ(command::builds_to_time(1e9), 1);
}

TEST(Info, SaysOfHowManyBuildsATimeIsTheMedian) {
  const RunResult text = soms_run({"info", test::data("truth/meshes/box2.ply").string()});
  EXPECT_NE(text.out.find("    rule           levels  full      leaves   1-triangle  undividable  "
                          "SAH cost  build ms  builds\n"),
            std::string::npos)
      << text.out;
}

// Two equal triangles have one midpoint: no plane parts them.
TEST(Info, CountsNodesThatARuleCannotDivide) {
  const std::string path = test::data("nasty/two_triangles_same.ply").string();
  const Json report = info({path, "--tree", "rule=soms", "--tree", "empty-side=stop"});
  EXPECT_EQ(report.at("trees").at(0).at("undividable"), 1);
}

TEST(Info, TellsPartsInJsonAndInText) {
  const std::string path = test::data("formats/two_objects.3ds").string();
  const Json report = info({path, "--no-trees"});
  ASSERT_EQ(report.at("parts").size(), 2U);
  const RunResult text = soms_run({"info", path});
  EXPECT_NE(text.out.find(report.at("parts").at(0).at("name").get<std::string>()),
            std::string::npos);
  EXPECT_NE(text.out.find("object-median"), std::string::npos);
}

TEST(Info, NumbersPartsWithoutAName) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.obj").string();
  write_text(path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\no\nf 1 2 3\no b\nf 2 4 3\nf 1 1 2\n");
  const std::string text = soms_run({"info", path, "--no-trees"}).out;
  EXPECT_NE(text.find("2: number 0 (1, open), b (2, open)"), std::string::npos) << text;
}

/// The blocks of a page that are fenced as text.
std::vector<std::string> blocks_of(const std::string& page) {
  const std::string fence = "```text\n";
  std::vector<std::string> blocks;
  for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
    at += fence.size();
    blocks.push_back(page.substr(at, page.find("```\n", at) - at));
  }
  return blocks;
}

TEST(Info, NamesTheDefectsOfItsPage) {
  const std::vector<std::string> blocks = blocks_of(read_text(std::string(SOMS_DOCS) + "/info.md"));
  ASSERT_EQ(blocks.size(), 2U);
  const TemporaryFolder folder;
  write_text(folder.path() / "box.off", blocks[0]);
  const RunResult result =
      shell("cd " + folder.path().string() + " && $soms info box.off --no-trees");
  EXPECT_EQ(result.out, blocks[1]);
}

TEST(Info, NamesPlacesAsManyAsAreRequested) {
  const std::string path = test::data("nasty/zero_area_mixed.ply").string();
  for (const auto& [words, most] : std::vector<std::pair<std::vector<std::string>, std::size_t>>{
           {{}, 10}, {{"--list", "0"}, 0}, {{"--list", "2"}, 2}, {{"--list", "all"}, 100000}}) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {path, "--no-trees"});
    const Json report = info(all);
    EXPECT_EQ(report.at("places").size(), 9U);
    for (const auto& [kind, places] : report.at("places").items()) {
      const auto count = report.at("defects").at(kind).get<std::size_t>();
      EXPECT_EQ(places.size(), std::min(count, most)) << kind;
    }
    EXPECT_GT(report.at("defects").at("duplicate").get<std::size_t>(), 10U);
  }
  EXPECT_EQ(soms_run({"info", path, "--list", "some"}).status, 2);
}

TEST(Info, NamesPlacesByTriangleFacePartAndPoint) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "parts.obj").string();
  write_text(path,
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 0 0 0\n"
             "o plate\nf 1 2 3 4\no fin\nf 6 2 5\nf 1 2 5\n");
  const Json report = info({path, "--no-trees"});
  const Json& places = report.at("places");
  EXPECT_EQ(places.at("duplicate"), Json::parse(R"([{"triangle":3,"original":2,"face":2,"part":1,
      "vertices":[0,1,4],"points":[[0,0,0],[1,0,0],[0,0,1]]}])"));
  EXPECT_EQ(places.at("non_manifold_edges"), Json::parse(R"([{"triangle":0,"other":2,"uses":3,
      "face":0,"part":0,"vertices":[0,1],"points":[[0,0,0],[1,0,0]]}])"));
  EXPECT_EQ(places.at("repeated_vertices"),
            Json::parse(R"([{"vertex":5,"original":0,"points":[[0,0,0]]}])"));
  EXPECT_EQ(places.at("open_edges").at(0).at("other"), nullptr);
  EXPECT_EQ(report.at("parts").at(0).at("closed"), false);
  const RunResult text = soms_run({"info", path, "--no-trees"});
  EXPECT_NE(text.out.find(
                "triangle 0: vertex 0 (0, 0, 0) to vertex 1 (1, 0, 0); 3 triangles; part plate\n"),
            std::string::npos)
      << text.out;
  EXPECT_NE(
      text.out.find("by position: 1 of 6 vertices repeat an earlier one; by number not closed"),
      std::string::npos);
}

TEST(Info, TellsWhichPartsAreClosed) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "parts.obj").string();
  write_text(path,
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no whole\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
             "o sheet\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 5 6 7\n");
  const Json report = info({path, "--no-trees"});
  EXPECT_EQ(report.at("parts").at(0).at("closed"), true);
  EXPECT_EQ(report.at("parts").at(1).at("closed"), false);
  EXPECT_EQ(report.at("defects").at("closed"), false);
  EXPECT_NE(
      soms_run({"info", path, "--no-trees"}).out.find("2: whole (4, closed), sheet (1, open)"),
      std::string::npos);
}

TEST(Info, CallsNothingClosedThatHasNoArea) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "parts.obj").string();
  write_text(path,
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no whole\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
             "o line\nf 1 2 1\n");
  const Json report = info({path, "--no-trees"});
  EXPECT_EQ(report.at("defects").at("closed"), true);
  EXPECT_EQ(report.at("parts").at(1).at("closed"), false);
  EXPECT_NE(soms_run({"info", path, "--no-trees"})
                .out.find("2: whole (4, closed), line (1, without area)"),
            std::string::npos);
  write_text(path, "v 0 0 0\nv 1 0 0\nf 1 2 1\n");
  EXPECT_NE(soms_run({"info", path, "--no-trees"})
                .out.find("defects    1 triangle without area (1 repeat a corner); not closed\n"),
            std::string::npos);
}

TEST(Info, SaysWhetherInsideIsDefined) {
  const auto line = [](const std::string& path) {
    const std::string out = soms_run({"info", path, "--no-trees"}).out;
    const std::size_t at = out.find("  inside     ");
    return at == std::string::npos ? out : out.substr(at + 13, out.find('\n', at) - at - 13);
  };
  const auto mesh = [](const std::string& name) {
    return test::data("questions/meshes/" + name + ".ply").string();
  };
  EXPECT_EQ(line(mesh("randflip")), "defined: every edge belongs to an even number of triangles");
  EXPECT_EQ(line(mesh("tjunction")),
            "defined: 3 edges belong to an odd number of triangles, but together they cancel out");
  EXPECT_EQ(line(mesh("onegone")), "not defined: 3 edges belong to an odd number of triangles");
  EXPECT_EQ(line(mesh("openandclosed")),
            "not defined: 3 edges belong to an odd number of triangles; 1 of 2 connected parts are "
            "closed");
  const Json open = info({mesh("openandclosed"), "--no-trees", "--list", "2"}).at("closedness");
  EXPECT_EQ(open.at("closed"), false);
  EXPECT_EQ(open.at("odd_edges"), 3);
  EXPECT_EQ(open.at("odd_proper_edges"), 3);
  EXPECT_EQ(open.at("connected_parts"), 2);
  EXPECT_EQ(open.at("closed_connected_parts"), 1);
  EXPECT_EQ(open.at("places").size(), 2U);
  EXPECT_EQ(open.at("places").at(0).at("uses"), 1);
  EXPECT_EQ(info({mesh("tfilled"), "--no-trees"}).at("closedness").at("odd_proper_edges"), 3);
}

TEST(Info, GoesOnAfterABadFile) {
  const std::string good = test::data("truth/meshes/box2.ply").string();
  const std::string bad = test::data("bad/ply_wrong_magic.ply").string();
  const RunResult result = soms_run({"info", "--json", "--no-trees", good, bad, "missing", good});
  EXPECT_EQ(result.status, 3);
  const std::vector<Json> lines = json_lines(result.out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].at("triangles"), 12);
  EXPECT_EQ(lines[1].at("file"), bad);
  EXPECT_NE(lines[1].at("error").at("message").get<std::string>().find("ply_wrong_magic.ply"),
            std::string::npos);
  EXPECT_EQ(lines[2].at("error").at("kind"), "cannot_open");
  EXPECT_EQ(lines[3].at("triangles"), 12);
  EXPECT_NE(result.err.find("soms info: missing"), std::string::npos) << result.err;
}

TEST(Info, NamesTheFileThatIsWrong) {
  for (const char* name :
       {"bad/no_such_file.ply", "bad/directory.ply", "nasty/empty_mesh.ply", "bad/3ds_nan.3ds"}) {
    const RunResult result = soms_run({"info", test::data(name).string()});
    EXPECT_EQ(result.status, 3) << name << result.err;
    EXPECT_NE(result.err.find(name), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
  }
}

TEST(Info, SaysThatNothingCameByStandardInput) {
  EXPECT_EQ(shell("$soms info - </dev/null").err,
            "soms info: standard input is empty; pipe a model into it, or name a file\n");
  EXPECT_EQ(shell("$soms info - <&-").status, 3);
  EXPECT_NE(
      shell("printf '' | $soms info -").err.find("soms info: standard input: the file is empty"),
      std::string::npos);
  EXPECT_NE(soms_on_terminal({"info", "-"}).out.find("standard input is a terminal; pipe a model"),
            std::string::npos);
}

TEST(Info, SaysWhatARecordingIsAndWhoReadsIt) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "run.somsrec").string();
  ASSERT_EQ(soms_run({"simulate", test::data("truth/meshes/terrain.ply").string(), "--count", "1",
                      "--frames", "1", "--record", path})
                .status,
            0);
  for (const RunResult& result : {soms_run({"info", path}), soms_run({"overlap", path, path})}) {
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.err.find(path + ": a recording of soms simulate, not a model; play it with "
                                     "soms view, or draw a frame with soms render\n"),
              std::string::npos)
        << result.err;
  }
}

TEST(Info, PrintsNumbersToBeReadAndWholeOnesAsJson) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.off").string();
  write_text(path, triangle_off("0.1 0.30000000000000004 4470253.1234567", "1e-300 -2 0", "9 8 7"));
  EXPECT_NE(soms_run({"info", path, "--no-trees"})
                .out.find("  bounds     (1e-300, -2, 0) to (9, 8, 4470253.12)\n"),
            std::string::npos);
  EXPECT_NE(soms_run({"info", path, "--no-trees"})
                .out.find("vertex 0 (0.1, 0.3, 4470253.12) to vertex 1 (1e-300, -2, 0)"),
            std::string::npos);
  EXPECT_EQ(info({path, "--no-trees"}).at("bounds").at(1).at(2), 4470253.1234567);
  write_text(path, triangle_off("-0.0 -0 0", "-1 -1 0", "0 -1 -0"));
  EXPECT_NE(soms_run({"info", path, "--no-trees"}).out.find("(-1, -1, 0) to (0, 0, 0)\n"),
            std::string::npos);
}

TEST(Info, AcceptsAnEmptyModelWhenRequested) {
  const Json report = info({test::data("nasty/empty_mesh.ply").string(), "--allow-empty"});
  EXPECT_EQ(report.at("triangles"), 0);
  EXPECT_EQ(report.at("bounds"), nullptr);
  EXPECT_EQ(report.at("defects").at("closed"), false);
  EXPECT_EQ(report.at("trees").at(0).at("levels"), 0);
}

TEST(Info, PrintsFileNamesThatAreNoText) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a \x1b[31m\xff b.off").string();
  write_text(path, triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const RunResult text = soms_run({"info", path});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_EQ(text.out.find('\x1b'), std::string::npos);
  EXPECT_EQ(info({path}).at("triangles"), 1);
}

}  // namespace
}  // namespace soms::test
