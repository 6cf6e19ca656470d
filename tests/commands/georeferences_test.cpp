// R117, further: files that say where on the Earth their numbers lie.
#include "tests/commands/run.h"

#include <algorithm>

namespace soms::test {
namespace {

/// A model of one cube in a folder, as CityJSON in a reference system, and the same as PLY.
class CityFolder {
 public:
  explicit CityFolder(const std::string& system) {
    write_text(city(),
               R"({"type":"CityJSON","version":"2.0","metadata":{"referenceSystem":")" + system +
                   R"("},"transform":{"scale":[1,1,1],"translate":[85000,447000,0]},)"
                   R"("CityObjects":{"a":{"type":"Building","geometry":[{"type":"Solid","lod":"1",)"
                   R"("boundaries":[[[[0,3,2,1]],[[4,5,6,7]],[[0,1,5,4]],[[1,2,6,5]],[[2,3,7,6]],)"
                   R"([[3,0,4,7]]]]}]}},"vertices":[[0,0,0],[2,0,0],[2,2,0],[0,2,0],[0,0,2],)"
                   R"([2,0,2],[2,2,2],[0,2,2]]})");
    EXPECT_EQ(soms_run({"convert", city(), ply()}).status, 0);
  }

  [[nodiscard]] std::string city() const { return file("a.city.json"); }

  [[nodiscard]] std::string ply() const { return file("a.ply"); }

  [[nodiscard]] std::string file(const char* name) const {
    return (folder_.path() / name).string();
  }

 private:
  TemporaryFolder folder_;
};

constexpr const char* kSystem = "https://www.opengis.net/def/crs/EPSG/0/7415";
constexpr const char* kShort = "EPSG:7415";

/// True if an answer has a warning of this kind.
bool has_warning(const Json& answer, const std::string& kind) {
  const Json warnings = answer.value("warnings", Json::array());
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const Json& warning) { return warning.at("kind") == kind; });
}

TEST(Georeferences, R117AModelWithoutOneIsWarnedOfBesideOneThatHasIt) {
  const CityFolder folder(kSystem);
  const std::vector<std::string> words{"overlap", folder.city(), folder.ply(), "--up-b",
                                       "z",       "--scale-b",   "1"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), words.begin(), words.end());
    return soms_run(more);
  };
  const RunResult text = with({});
  EXPECT_EQ(text.status, 0);
  EXPECT_EQ(text.err, "warning: the georeference is EPSG:7415 in " + folder.city() +
                          ", and unknown in " + folder.ply() +
                          "; soms does not move models by it: bring both into one frame first, or "
                          "give --crs-b EPSG:7415 if a.ply is in it\n");
  const Json answer = json_lines(with({"--json"}).out).at(0);
  EXPECT_TRUE(has_warning(answer, "georeference_unknown"));
  EXPECT_EQ(answer.at("georeference").at("crs"), kShort);
  EXPECT_EQ(with({"--strict"}).status, 3);
  EXPECT_EQ(with({"--strict", "--crs-b", "urn:ogc:def:crs:EPSG::7415"}).status, 0);
  const RunResult other = with({"--crs-b", "EPSG:28992", "--json"});
  EXPECT_TRUE(has_warning(json_lines(other.out).at(0), "georeferences_differ")) << other.out;
  // A pose says where a body lies.
  EXPECT_EQ(with({"--strict", "--pose-b", "0 0 1"}).status, 0);
}

TEST(Georeferences, R117EveryOutputWithCoordinatesHasIt) {
  const CityFolder folder(kSystem);
  const std::string csv = folder.file("out.csv");
  const auto csv_of = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"-o", csv});
    const RunResult result = soms_run(words);
    EXPECT_LE(result.status, 1) << words[0] << ": " << result.err;
    return read_text(csv);
  };
  write_text(folder.file("points.csv"), "x,y,z\n85001,447001,9\n");
  write_text(folder.file("rays.csv"), "ox,oy,oz,dx,dy,dz\n85001,447001.5,9,0,0,-1\n");
  write_text(folder.file("path.csv"), "x,y,z\n85009,447001,1\n85009,447009,1\n");
  const std::string points = folder.file("points.csv");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"distance", folder.city(), folder.city()},
        std::vector<std::string>{"within", folder.city(), folder.city(), "--clearance", "1"},
        std::vector<std::string>{"overlap", folder.city(), folder.city(), "--by", "part"},
        std::vector<std::string>{"closest", folder.city(), "--points", points},
        std::vector<std::string>{"ray", folder.city(), "--rays", folder.file("rays.csv")},
        std::vector<std::string>{"clash", folder.city(), "--against", folder.ply(), "--crs-b",
                                 kShort},
        std::vector<std::string>{"clearance", folder.city(), "--path", folder.file("path.csv"),
                                 "--profile", folder.ply()}}) {
    const std::string text = csv_of(words);
    EXPECT_NE(text.find(",georeference\n"), std::string::npos) << words[0] << ": " << text;
    EXPECT_NE(text.find(",EPSG:7415\n"), std::string::npos) << words[0] << ": " << text;
  }
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"info", folder.city(), "--no-trees"},
        std::vector<std::string>{"closest", folder.city(), "--points", points},
        std::vector<std::string>{"ray", folder.city(), "--rays", folder.file("rays.csv")},
        std::vector<std::string>{"clash", folder.city()},
        std::vector<std::string>{"clearance", folder.city(), "--path", folder.file("path.csv"),
                                 "--profile", folder.ply()},
        std::vector<std::string>{"simulate", folder.city(), "--frames", "1", "--count", "1"},
        std::vector<std::string>{"convert", folder.city(), folder.file("b.glb")}}) {
    std::vector<std::string> json = words;
    json.emplace_back("--json");
    EXPECT_EQ(json_lines(soms_run(json).out).back().at("georeference").at("crs"), kShort)
        << words[0];
  }
  // Without one there is neither.
  EXPECT_EQ(csv_of({"distance", folder.ply(), folder.ply()}).find("georeference"),
            std::string::npos);
  // Points of a model that a pose moves lie elsewhere.
  EXPECT_EQ(csv_of({"closest", folder.city(), "--points", points, "--pose", "1 0 0"})
                .find("georeference"),
            std::string::npos);
}

TEST(Georeferences, R117PagesHaveIt) {
  const CityFolder folder(kSystem);
  const std::string page = folder.file("page.html");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"overlap", folder.city(), folder.city()},
        std::vector<std::string>{"distance", folder.city(), folder.city()},
        std::vector<std::string>{"clash", folder.city()},
        std::vector<std::string>{"simulate", folder.city(), "--frames", "1", "--count", "1"}}) {
    std::vector<std::string> report = words;
    report.insert(report.end(), {"-o", page});
    ASSERT_EQ(soms_run(report).status, 0) << words[0];
    EXPECT_NE(read_text(page).find(kShort), std::string::npos) << words[0];
  }
}

TEST(Georeferences, ConvertKeepsItInGlbAndSaysWhatLosesIt) {
  const CityFolder folder(kSystem);
  const RunResult lost = soms_run({"convert", folder.city(), folder.file("c.obj")});
  EXPECT_NE(lost.err.find("OBJ does not keep the unit (1 m), the up axis (z) and the georeference "
                          "(EPSG:7415)"),
            std::string::npos)
      << lost.err;
  const std::string glb = folder.file("c.glb");
  ASSERT_EQ(soms_run({"convert", folder.city(), glb}).status, 0);
  EXPECT_NE(soms_run({"info", glb, "--no-trees"}).out.find("  georeference EPSG:7415\n"),
            std::string::npos);
  // Scaled numbers lie in the system by their scale.
  ASSERT_EQ(soms_run({"convert", folder.city(), glb, "--scale", "2"}).status, 0);
  const Json info = Json::parse(soms_run({"info", glb, "--no-trees", "--json"}).out);
  EXPECT_EQ(info.at("georeference").at("map_conversion").at("scale"), 0.5);
}

TEST(Georeferences, WhatTheCommandLineSaysIsFollowedAndNoted) {
  const CityFolder folder(kSystem);
  const RunResult noted = soms_run({"info", folder.city(), "--no-trees", "--crs", "EPSG:28992"});
  EXPECT_NE(noted.out.find("  georeference EPSG:28992\n"), std::string::npos) << noted.out;
  EXPECT_NE(noted.out.find("the file declares EPSG:7415, but the command line says EPSG:28992"),
            std::string::npos)
      << noted.out;
  EXPECT_EQ(
      soms_run({"info", folder.city(), "--no-trees", "--crs", "EPSG:28992", "--strict"}).status, 3);
  EXPECT_EQ(soms_run({"info", folder.city(), "--no-trees", "--crs", kSystem, "--strict"}).status,
            0);
  const RunResult feet = soms_run({"info", folder.ply(), "--no-trees", "--crs", "EPSG:2222"});
  EXPECT_NE(feet.out.find("  unit       0.3048 m\n"), std::string::npos) << feet.out;
  EXPECT_EQ(soms_run({"info", folder.ply(), "--no-trees", "--crs", " "}).status, 2);
}

TEST(Georeferences, ASystemThatHasNoModelIsRefused) {
  const CityFolder folder(kSystem);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"clash", folder.city(), "--crs-b", kShort},
        std::vector<std::string>{"simulate", "--crs", kShort},
        std::vector<std::string>{"info", folder.city(), "--crs", "7415"},
        std::vector<std::string>{"robot", data("robots/arm.urdf").string(), "--random", "1",
                                 "--crs", kShort}}) {
    const RunResult refused = soms_run(words);
    EXPECT_EQ(refused.status, 2) << words[0] << ": " << refused.err;
    EXPECT_NE(refused.err.find("--crs"), std::string::npos) << refused.err;
  }
}

TEST(Georeferences, ArraysHaveTheCharactersOfAName) {
  const CityFolder folder("\xc3\x84\xe5\xba\xa7");
  write_text(folder.file("points.csv"), "x,y,z\n85001,447001,9\n");
  ASSERT_EQ(soms_run({"closest", folder.city(), "--points", folder.file("points.csv"), "-o",
                      folder.file("near.npz")})
                .status,
            0);
  const std::string bytes = read_text(folder.file("near.npz"));
  EXPECT_NE(bytes.find("<U2"), std::string::npos);
  EXPECT_NE(bytes.find(std::string("\xc4\0\0\0\xa7\x5e\0\0", 8)), std::string::npos);
}

TEST(Georeferences, ConversionsOfUnitsThatCancelAreNotWarnedOf) {
  const CityFolder folder(kSystem);
  const std::string glb = folder.file("mm.glb");
  ASSERT_EQ(soms_run({"convert", folder.city(), glb, "--scale", "1000"}).status, 0);
  EXPECT_TRUE(has_warning(json_lines(soms_run({"overlap", glb, folder.city(), "--json"}).out).at(0),
                          "units_differ"));
  const RunResult right =
      soms_run({"overlap", glb, folder.city(), "--scale", "0.001", "--json", "--strict"});
  EXPECT_EQ(right.status, 0) << right.err;
}

TEST(Georeferences, R117FilesOfACityAreComparedAndMoversAreNot) {
  const CityFolder folder(kSystem);
  const CityFolder other("urn:ogc:def:crs:EPSG::28992");
  const std::vector<std::string> run{"--frames", "1", "--count", "1", "--json"};
  const auto simulate = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "simulate");
    words.insert(words.end(), run.begin(), run.end());
    return Json::parse(soms_run(words).out);
  };
  EXPECT_TRUE(has_warning(simulate({folder.city(), other.city()}), "georeferences_differ"));
  EXPECT_FALSE(
      has_warning(simulate({folder.city(), "--mover", other.city()}), "georeferences_differ"));
  EXPECT_FALSE(has_warning(simulate({folder.city()}), "georeference_unknown"));
}

}  // namespace
}  // namespace soms::test
