#include "tests/commands/run.h"

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
      "non_manifold_edges":0,"flipped_edges":0,"unused_vertices":0,"closed":true})"));
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
    EXPECT_EQ(tree.at("leaves"), tree.at("one"));  // one triangle a leaf
    EXPECT_EQ(tree.at("leaves"), report.at("triangles"));
    EXPECT_EQ(tree.at("nodes"), 2 * report.at("triangles").get<int>() - 1);
    EXPECT_GE(tree.at("levels"), tree.at("balanced_level"));
    EXPECT_GT(tree.at("sah").get<double>(), 0);
    EXPECT_GE(tree.at("build_ms").get<double>(), 0);
  }
  EXPECT_EQ(rules, (std::vector<std::string>{"object-median", "object-mean", "spatial-median",
                                             "soms", "sah", "soms-sah", "fast", "quality"}));
}

// The bunny of the thesis at 15 levels: golden counts of the design, soms and thesis options.
TEST(Info, CountsTheTreeOfTheThesis) {
  SOMS_NEEDS_OUTSIDE_DATA("1 tree of the thesis");
  const Json report =
      info({outside_data("ply/bun_zipper_res4.ply")->string(), "--rule", "soms", "--levels", "15",
            "--midpoint", "thesis", "--empty-side", "stop", "--leaf", "1"});
  ASSERT_EQ(report.at("triangles"), 948);
  const Json& tree = report.at("trees").at(0);
  EXPECT_EQ(report.at("trees").size(), 1U);
  EXPECT_EQ(tree.at("nodes"), 1847);
  EXPECT_EQ(tree.at("leaves"), 924);
  EXPECT_EQ(tree.at("one"), 904);
  EXPECT_EQ(tree.at("balanced_level"), 6);
  EXPECT_LE(tree.at("levels"), 15);
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

TEST(Info, AcceptsAnEmptyModelWhenAsked) {
  const Json report = info({test::data("nasty/empty_mesh.ply").string(), "--allow-empty"});
  EXPECT_EQ(report.at("triangles"), 0);
  EXPECT_EQ(report.at("bounds"), nullptr);
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
