#include "tests/commands/run.h"

namespace soms::test {
namespace {

std::string generate(const TemporaryFolder& folder, const std::string& kind,
                     const std::string& triangles, const std::string& name) {
  const std::string path = (folder.path() / name).string();
  std::vector<std::string> words{"generate", kind, "-o", path};
  if (!triangles.empty()) {
    words.insert(words.end(), {"--triangles", triangles});
  }
  const RunResult result = soms_run(words);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "");
  return path;
}

std::uint64_t triangles_of(const std::string& path) {
  const RunResult result = soms_run({"info", path, "--no-trees", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  return json_lines(result.out).at(0).at("triangles");
}

TEST(Generate, MakesExactlyTheTrianglesRequestedFor) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"knot", "18"},   {"knot", "2000"},  {"sphere", "8"}, {"sphere", "1002"},
      {"city", "1000"}, {"city", "20011"}, {"car", "1500"}, {"urban-mixed", "5672"}};
  for (const auto& [kind, triangles] : cases) {
    EXPECT_EQ(triangles_of(generate(folder, kind, triangles, "model.ply")), std::stoul(triangles))
        << kind;
  }
}

TEST(Generate, HasItsOwnNumberForEveryKind) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::uint64_t>> cases{
      {"knot", 10'000},      {"sphere", 10'000},    {"statue", 948}, {"teapot", 6320},
      {"car", 1000},         {"person", 600},       {"drone", 308},  {"urban-mixed", 5672},
      {"urban-boxes", 5672}, {"urban-plain", 5672}, {"sedan", 700},  {"van", 700}};
  for (const auto& [kind, triangles] : cases) {
    EXPECT_EQ(triangles_of(generate(folder, kind, "", "model.ply")), triangles) << kind;
  }
}

TEST(Generate, NamesTheNearestCountsOfATeapot) {
  const auto words = [](const char* triangles) {
    const RunResult result =
        soms_run({"generate", "teapot", "--triangles", triangles, "-o", "/nowhere/teapot.ply"});
    EXPECT_EQ(result.status, 2);
    return result.err;
  };
  EXPECT_NE(words("6000").find("--triangles 6000: a teapot has 64 n^2 - 8 n triangles"),
            std::string::npos);
  EXPECT_NE(words("6000").find("use 5112 or 6320"), std::string::npos);
  EXPECT_NE(words("3").find("use 240\n"), std::string::npos);
  EXPECT_NE(words("5000000").find("use 4192256\n"), std::string::npos);
}

TEST(Generate, WritesTheSameBytesForTheSameSeedAndOthersForAnother) {
  const TemporaryFolder folder;
  const auto city = [&](const std::string& seed, const std::string& threads) {
    return soms_run({"generate", "city", "--triangles", "3000", "--seed", seed, "--threads",
                     threads, "-o", "-"})
        .out;
  };
  EXPECT_EQ(city("5", "1"), city("5", "3"));
  EXPECT_NE(city("5", "1"), city("6", "1"));
}

// The first picture of one's own is of such a town.
TEST(Generate, ACityIsAsLargeAsItsTrianglesFillUnlessItsExtentIsStated) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "town.ply").string();
  const auto width = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"generate", "city", "-o", path});
    EXPECT_EQ(soms_run(words).status, 0);
    const RunResult info = soms_run({"info", path, "--no-trees", "--json"});
    const auto bounds = json_lines(info.out).at(0).at("bounds");
    return bounds.at(1).at(0).get<double>() - bounds.at(0).at(0).get<double>();
  };
  EXPECT_NEAR(width({"--triangles", "20000"}), 245, 2);
  EXPECT_NEAR(width({"--triangles", "3000"}), 200, 2);
  EXPECT_NEAR(width({"--triangles", "3000", "--extent", "4000"}), 4000, 2);
  const std::string paved = read_text(path);
  EXPECT_NEAR(width({"--triangles", "3000", "--extent", "200", "--streets", "bare"}), 200, 2);
  EXPECT_NE(read_text(path), paved);
  EXPECT_EQ(soms_run({"generate", "city", "--extent", "10", "-o", path}).status, 2);
  EXPECT_EQ(soms_run({"generate", "car", "--streets", "bare", "-o", path}).status, 2);
}

TEST(Generate, WritesTheFormatOfTheNameOrOfTheOption) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_text(generate(folder, "sphere", "80", "a.off")).starts_with("OFF"));
  EXPECT_TRUE(read_text(generate(folder, "sphere", "80", "a.PLY")).starts_with("ply"));
  EXPECT_TRUE(read_text(generate(folder, "sphere", "80", "a.3ds")).starts_with("MM"));
  EXPECT_EQ(triangles_of((folder.path() / "a.3ds").string()), 80U);
  const std::string path = (folder.path() / "model.txt").string();
  ASSERT_EQ(soms_run({"generate", "sphere", "--format", "stl-ascii", "-o", path}).status, 0);
  EXPECT_TRUE(read_text(path).starts_with("solid"));
  const RunResult unknown = soms_run({"generate", "sphere", "-o", path});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find(".ply"), std::string::npos) << unknown.err;
}

TEST(Generate, WritesPlyToStandardOutput) {
  const RunResult result = soms_run({"generate", "sphere", "--triangles", "80", "-o", "-"});
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(result.out.starts_with("ply"));
  const RunResult info = soms_run({"info", "-", "--json", "--no-trees"}, result.out);
  EXPECT_EQ(json_lines(info.out).at(0).at("triangles"), 80);
}

TEST(Generate, SaysWhatItMadeAsJson) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "ball.obj").string();
  const RunResult result =
      soms_run({"generate", "sphere", "--triangles", "80", "--json", "-o", path});
  EXPECT_EQ(json_lines(result.out).at(0), (Json{{"schema", "soms.generate/1"},
                                                {"kind", "sphere"},
                                                {"file", path},
                                                {"format", "obj"},
                                                {"triangles", 80},
                                                {"vertices", 42},
                                                {"seed", 1}}));
  EXPECT_EQ(soms_run({"generate", "sphere", "--json", "-o", "-"}).status, 2);
}

TEST(Generate, RefusesCountsThatAKindCannotHave) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "model.ply").string();
  const std::vector<std::pair<std::string, std::string>> cases{
      {"city", "3"},          {"city", "999"}, {"knot", "16"},
      {"knot", "13"},         {"sphere", "7"}, {"car", "1"},
      {"urban-mixed", "100"}, {"city", "0"},   {"city", "-5"},
      {"city", "2147483648"}, {"city", "1e6"}, {"knot", "99999999999999999999"}};
  for (const auto& [kind, triangles] : cases) {
    const RunResult result = soms_run({"generate", kind, "--triangles", triangles, "-o", path});
    EXPECT_EQ(result.status, 2) << kind << " " << triangles << ": " << result.err;
    EXPECT_TRUE(result.err.starts_with("soms generate: --triangles " + triangles)) << result.err;
    EXPECT_TRUE(files_in(folder.path()).empty());
  }
}

TEST(Generate, WantsAKindAndAPlace) {
  EXPECT_NE(soms_run({"generate", "-o", "a.ply"}).err.find("KIND is required"), std::string::npos);
  EXPECT_NE(soms_run({"generate", "sphere"}).err.find("--output is required"), std::string::npos);
  const RunResult unknown = soms_run({"generate", "spere", "-o", "a.ply"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("did you mean sphere? choose one of knot, sphere, statue"),
            std::string::npos)
      << unknown.err;
}

}  // namespace
}  // namespace soms::test
