#include "tests/commands/run.h"

namespace soms::test {
namespace {

Json info_of(const std::string& path) {
  const RunResult result = soms_run({"info", path, "--no-trees", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  return json_lines(result.out).at(0);
}

TEST(Convert, KeepsTrianglesAndBoundsThroughEveryFormat) {
  const TemporaryFolder folder;
  const std::string input = test::data("truth/meshes/terrain.ply").string();
  const Json before = info_of(input);
  for (const char* name : {"a.ply", "a.obj", "a.off"}) {
    const std::string output = (folder.path() / name).string();
    const RunResult result = soms_run({"convert", input, output});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json after = info_of(output);
    for (const char* key : {"triangles", "vertices", "bounds", "defects"}) {
      EXPECT_EQ(after.at(key), before.at(key)) << name << " " << key;
    }
  }
}

TEST(Convert, WritesTheSameAnswersIntoEveryFormat) {
  const TemporaryFolder folder;
  const std::string input = test::data("truth/meshes/torus.ply").string();
  const auto hash = [&](const std::string& path) {
    const RunResult result = soms_run({"overlap", path, path, "--pose", "0.25 0 0", "--json"});
    return json_lines(result.out).at(0).at("hash");
  };
  for (const char* format : {"ply", "ply-ascii", "obj", "off", "3ds"}) {
    const std::string output = (folder.path() / "copy").string();
    ASSERT_EQ(soms_run({"convert", input, output, "--format", format}).status, 0);
    const std::string named = output + "." + std::string(format).substr(0, 3);
    std::filesystem::rename(output, named);
    EXPECT_EQ(hash(named), hash(input)) << format;
  }
}

TEST(Convert, TellsThatStlAnd3dsRound) {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.off", triangle_off("0.1 0 0", "1 0 0", "0 1 0"));
  const std::string input = (folder.path() / "a.off").string();
  for (const auto& [name, words] : {std::pair("a.stl", "binary STL stores floats: 1 of 3 vertices"),
                                    std::pair("a.3ds", "were rounded, by at most 1.5e-09")}) {
    const std::string output = (folder.path() / name).string();
    const RunResult result = soms_run({"convert", input, output});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(soms_run({"convert", input, output, "--quiet"}).err, "");
  }
  EXPECT_EQ(soms_run({"convert", input, (folder.path() / "a.ply").string()}).err.find("rounded"),
            std::string::npos);
}

TEST(Convert, SaysOnceWhatAFormatDoesNotKeep) {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  write_text(path("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\ng roof\nf 1 2 3\n");
  ASSERT_EQ(soms_run({"convert", path("a.obj"), path("a.glb"), "--up", "y", "--quiet"}).status, 0);
  EXPECT_EQ(soms_run({"convert", path("a.glb"), path("b.glb")}).err.find("not keep"),
            std::string::npos);
  EXPECT_NE(soms_run({"convert", path("a.glb"), path("b.obj")})
                .err.find("b.obj: OBJ does not keep the up axis (z)\n"),
            std::string::npos);
  EXPECT_NE(soms_run({"convert", path("a.glb"), path("b.off")})
                .err.find("OFF does not keep the up axis (z) and the names of 1 part\n"),
            std::string::npos);
  // A unit, an axis, and two parts without names.
  EXPECT_NE(soms_run({"convert", test::data("formats/mirrored_node.gltf").string(), path("b.ply")})
                .err.find("PLY does not keep the unit (1 m) and the up axis (y)\n"),
            std::string::npos);
}

TEST(Convert, SaysHowManyNames3dsChanges) {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  write_text(path("a.obj"),
             "v 0 0 0\nv 1 0 0\nv 0 1 0\ng Pipe:CW-101\nf 1 2 3\ng Pipe:CW-102\nf 1 2 3\n"
             "g ten_chars_\nf 1 2 3\ng roof\nf 1 2 3\ng d\xC3\xBC\nf 1 2 3\n");
  const RunResult result = soms_run({"convert", path("a.obj"), path("a.3ds")});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("a.3ds: 3DS does not keep 3 of 5 names (cut or changed to fit 10 "
                            "characters)\n"),
            std::string::npos)
      << result.err;
  const RunResult again = soms_run({"convert", path("a.3ds"), path("b.3ds")});
  EXPECT_EQ(again.err.find("not keep"), std::string::npos) << again.err;
}

TEST(Convert, ScalesAndTurns) {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.off", triangle_off("1 2 3", "1 0 0", "0 1 0"));
  const std::string output = (folder.path() / "b.off").string();
  ASSERT_EQ(
      soms_run({"convert", (folder.path() / "a.off").string(), output, "--scale", "2", "--up", "y"})
          .status,
      0);
  // y up: (x, y, z) becomes (x, -z, y).
  EXPECT_EQ(info_of(output).at("bounds"), Json::parse("[[0,-6,0],[2,0,4]]"));
}

TEST(Convert, KeepsAxesOfGlbUnlessTheyAreTurned) {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  write_text(path("a.off"), triangle_off("1 2 3", "1 0 0", "0 1 0"));
  EXPECT_NE(
      soms_run({"convert", path("a.off"), path("a.glb")})
          .err.find(
              "a.glb: in GLB other programs take y as up; this model does not state its up axis"),
      std::string::npos);
  const Json read = info_of(path("a.glb"));
  EXPECT_EQ(read.at("bounds"), Json::parse("[[0,0,0],[1,2,3]]"));
  EXPECT_TRUE(read.at("up").is_null());
  EXPECT_TRUE(read.at("unit").is_null());
  const RunResult turned = soms_run({"convert", path("a.glb"), path("b.glb"), "--up", "y"});
  EXPECT_NE(turned.err.find("b.glb: in GLB other programs take y as up"), std::string::npos)
      << turned.err;
  EXPECT_EQ(info_of(path("b.glb")).at("bounds"), Json::parse("[[0,-3,0],[1,0,2]]"));
  // What needs an up axis turns the one that a file states, and says so.
  const std::string stated = test::data("formats/nodes_trs.gltf").string();
  const std::string note = "nodes_trs.gltf: the up axis is y; rotated to z";
  const std::vector<std::string> words = {"simulate", stated, "--frames", "1", "--count", "1"};
  EXPECT_NE(soms_run(words).err.find(note), std::string::npos);
  std::vector<std::string> as_is = words;
  as_is.insert(as_is.end(), {"--up", "z"});
  EXPECT_EQ(soms_run(as_is).err.find(note), std::string::npos);
}

TEST(Convert, ReadsStandardInputAndWritesStandardOutput) {
  const std::string text = triangle_off("0 0 0", "1 0 0", "0 1 0");
  const RunResult result = soms_run({"convert", "-", "-", "--format", "obj"}, text);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("v 1 0 0"), std::string::npos) << result.out;
  EXPECT_EQ(soms_run({"convert", "-", "-", "--json"}, text).status, 2);
}

TEST(Convert, MayReplaceItsInput) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.off").string();
  write_text(path, triangle_off("0 0 0", "1 0 0", "0 1 0"));
  ASSERT_EQ(soms_run({"convert", path, path, "--scale", "4"}).status, 0);
  EXPECT_EQ(info_of(path).at("bounds"), Json::parse("[[0,0,0],[4,4,0]]"));
}

TEST(Convert, RefusesAnEmptyModelUnlessItIsAccepted) {
  const TemporaryFolder folder;
  const std::string input = test::data("nasty/no_faces.ply").string();
  const std::string output = (folder.path() / "a.ply").string();
  const RunResult refused = soms_run({"convert", input, output});
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("no_faces.ply"), std::string::npos) << refused.err;
  EXPECT_TRUE(files_in(folder.path()).empty());
  EXPECT_EQ(soms_run({"convert", input, output, "--allow-empty"}).status, 0);
}

TEST(Convert, SaysWhatItWroteAsJson) {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.off", triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const std::string input = (folder.path() / "a.off").string();
  const std::string output = (folder.path() / "b.ply").string();
  EXPECT_EQ(json_lines(soms_run({"convert", input, output, "--json"}).out).at(0),
            (Json{{"schema", "soms.convert/1"},
                  {"from", input},
                  {"file", output},
                  {"format", "ply"},
                  {"triangles", 1},
                  {"vertices", 3}}));
}

TEST(Convert, RefusesANameThatSaysAnotherFormat) {
  const TemporaryFolder folder;
  const std::string input = test::data("truth/meshes/torus.ply").string();
  const auto convert = [&](const std::string& name, const std::string& format) {
    return soms_run({"convert", input, (folder.path() / name).string(), "--format", format});
  };
  const RunResult wrong = convert("a.stl", "obj");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.err,
            "soms convert: --format obj does not match the extension .stl; use the extension .obj, "
            "or leave "
            "--format out\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.stl"));
  for (const auto& [name, format] :
       {std::pair("a.stl", "stl-ascii"), std::pair("a.ply", "ply-ascii"), std::pair("a", "obj"),
        std::pair("a.txt", "off"), std::pair("a.GLB", "glb")}) {
    EXPECT_EQ(convert(name, format).status, 0) << name;
  }
}

TEST(Convert, WritesOverAnotherNameOfItsInputAndSaysSo) {
  const TemporaryFolder folder;
  const std::string input = (folder.path() / "in.off").string();
  const std::string output = (folder.path() / "out.off").string();
  write_text(input, triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const std::string before = read_text(input);
  std::filesystem::create_hard_link(input, output);
  const RunResult result = soms_run({"convert", input, output, "--scale", "2"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find(output + ": the replaced file had 1 other name (a hard link), which "
                                     "keeps the old content\n"),
            std::string::npos)
      << result.err;
  EXPECT_EQ(read_text(input), before);
  EXPECT_EQ(info_of(output).at("bounds"), Json::parse("[[0,0,0],[2,2,0]]"));
  // The link is gone, so a second time there is nothing to say.
  const RunResult again = soms_run({"convert", input, output});
  EXPECT_EQ(again.err.find("other name"), std::string::npos) << again.err;
}

TEST(Convert, SaysHowManyOtherNamesKeepTheOldFile) {
  const TemporaryFolder folder;
  const std::string input = test::data("truth/meshes/torus.ply").string();
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  write_text(path("out.ply"), "old");
  std::filesystem::create_hard_link(path("out.ply"), path("a"));
  std::filesystem::create_hard_link(path("out.ply"), path("b"));
  EXPECT_EQ(soms_run({"convert", input, path("out.ply"), "--quiet"}).err, "");
  EXPECT_EQ(read_text(path("a")), "old");
  EXPECT_EQ(read_text(path("b")), "old");
  std::filesystem::create_hard_link(path("out.ply"), path("c"));
  std::filesystem::create_hard_link(path("out.ply"), path("d"));
  EXPECT_NE(soms_run({"generate", "sphere", "-o", path("out.ply")})
                .err.find("had 2 other names (hard links), which keep the old content"),
            std::string::npos);
}

TEST(Convert, WritesOverItsInputItself) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.off").string();
  write_text(path, triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const RunResult result = soms_run({"convert", path, path, "--scale", "2"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err.find("other name"), std::string::npos) << result.err;
  EXPECT_EQ(info_of(path).at("bounds"), Json::parse("[[0,0,0],[2,2,0]]"));
}

}  // namespace
}  // namespace soms::test
