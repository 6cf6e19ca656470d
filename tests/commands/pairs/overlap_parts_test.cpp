#include "tests/commands/fins.h"
#include "tests/commands/run.h"
#include "tests/report/reading.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace soms {

namespace {

constexpr std::size_t kWordsOfRow = 19;
constexpr std::size_t kWordsOfContact = 28;

/// A row of a page's list, as the page holds it.
struct PageRow {
  std::string part_a;
  std::string part_b;
  std::uint64_t count = 0;
  std::uint32_t steps = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::size_t held = 0;  ///< contacts of it that the page holds
};

std::vector<PageRow> rows_on(const std::string& page) {
  const test::Json scene = test::scene_of(page);
  const std::vector<std::uint32_t> words = test::words_of(test::element(page, "rows"));
  const std::vector<std::uint32_t> contacts = test::words_of(test::element(page, "contacts"));
  const auto name = [&](std::uint32_t part) {
    return part == 0xffffffffU ? std::string() : scene["parts"][part].get<std::string>();
  };
  EXPECT_EQ(words.size(), kWordsOfRow * scene["rows"].get<std::size_t>());
  std::vector<PageRow> rows;
  for (std::size_t at = 0; at < words.size(); at += kWordsOfRow) {
    rows.push_back({.part_a = name(words[at + 2]),
                    .part_b = name(words[at + 3]),
                    .count = words[at + 4] + (std::uint64_t{words[at + 5]} << 32),
                    .steps = words[at + 6],
                    .begin = words[at + 7],
                    .end = words[at + 8]});
  }
  for (std::size_t at = 0; at < contacts.size(); at += kWordsOfContact) {
    ++rows.at(contacts[at + 27]).held;
  }
  return rows;
}

class OverlapParts : public ::testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  std::string write(const std::string& name, const std::string& text) {
    test::write_text(at(name), text);
    return at(name);
  }

  /// Beams along x and ducts along y, all of which cross.
  std::vector<std::string> fins(int parts, int fins) {
    return {write("beams.obj", test::fins_obj("beam ", parts, fins, true)),
            write("ducts.obj", test::fins_obj("duct ", parts, fins, false))};
  }

  std::string page_of(std::vector<std::string> words) {
    words.insert(words.begin(), "overlap");
    words.insert(words.end(), {"-o", at("page.html"), "--quiet"});
    const test::RunResult run = test::soms_run(words);
    EXPECT_EQ(run.status, 0) << run.err;
    return test::read_text(at("page.html"));
  }

  test::TemporaryFolder folder_;
};

TEST_F(OverlapParts, R116PageListsEveryPairOfPartsWithItsCount) {
  const std::string page = page_of(fins(8, 20));
  const std::vector<PageRow> rows = rows_on(page);
  ASSERT_EQ(rows.size(), 64U);
  std::uint64_t sum = 0;
  std::set<std::pair<std::string, std::string>> names;
  for (const PageRow& row : rows) {
    EXPECT_EQ(row.count, 400U) << row.part_a << ", " << row.part_b;
    EXPECT_GE(row.held, 60U) << "a fair share of the 10,000 that find room";
    sum += row.count;
    names.emplace(row.part_a, row.part_b);
  }
  const test::Json scene = test::scene_of(page);
  EXPECT_EQ(scene["contacts"]["all"], sum);
  EXPECT_LE(scene["contacts"]["listed"], 10'000);
  EXPECT_EQ(names.size(), 64U);
  EXPECT_TRUE(names.contains({"beam 7", "duct 0"}));
  EXPECT_NE(page.find("<dt>pairs of parts</dt><dd>64</dd>"), std::string::npos);
}

TEST_F(OverlapParts, R116PageSaysWhenEachPairOfPartsTouches) {
  const std::vector<std::string> files = fins(2, 1);
  // Poses 0, 3 and 4 lift the beams to where the ducts are; the others far above them.
  const std::string poses =
      write("poses.csv", "x,y,z\n0,0,0\n0,0,20000\n0,0,20000\n0,0,1\n0,0,2\n");
  const std::vector<PageRow> rows = rows_on(page_of({files[0], files[1], "--pose", poses}));
  ASSERT_EQ(rows.size(), 4U);
  for (const PageRow& row : rows) {
    EXPECT_EQ(row.count, 3U);
    EXPECT_EQ(row.steps, 3U);
    EXPECT_EQ(row.begin, 0U);
    EXPECT_EQ(row.end, 4U);
  }
}

TEST_F(OverlapParts, R116PageOfModelsWithoutPartsHasARowOfTheBodies) {
  std::string a = test::fins_obj("x", 1, 30, true);
  std::string b = test::fins_obj("y", 1, 30, false);
  a.erase(0, a.find('\n') + 1);
  b.erase(0, b.find('\n') + 1);
  const std::vector<PageRow> rows = rows_on(page_of({write("a.obj", a), write("b.obj", b)}));
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].part_a, "");
  EXPECT_EQ(rows[0].count, 900U);
  EXPECT_EQ(rows[0].held, 900U);
}

TEST_F(OverlapParts, R116PageOfManyRowsHoldsThemAll) {
  const std::string page = page_of(fins(120, 1));
  const std::vector<PageRow> rows = rows_on(page);
  EXPECT_EQ(rows.size(), 14'400U);
  EXPECT_EQ(test::scene_of(page)["contacts"]["listed"], 10'000);
  EXPECT_LT(page.size(), 10'000'000U);
}

TEST_F(OverlapParts, R116PageOfASimulationListsWhoTouchesWhat) {
  std::string town = "v -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\no ground\nf 1 2 3\nf 1 3 4\n";
  for (int k = 0; k < 25; ++k) {  // five by five posts of four triangles each
    const int x = -40 + 20 * (k % 5);
    const int y = -40 + 20 * (k / 5);
    town += fmt::format("o post {}\n", k);
    for (int n = 0; n < 4; ++n) {
      town += fmt::format("v {0} {1} -1\nv {0} {2} -1\nv {0} {1} {3}\nf -3 -2 -1\n", x, y, y + 4,
                          10 + n);
    }
  }
  const std::string city = write("town.obj", town);
  const test::RunResult run =
      test::soms_run({"simulate", city, "--count", "30", "--frames", "300", "-o", at("page.html"),
                      "--contacts", at("events.csv"), "--json", "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string page = test::read_text(at("page.html"));
  std::map<std::tuple<std::string, std::string, std::string>, PageRow> expected;
  std::istringstream events(test::read_text(at("events.csv")));
  std::string line;
  std::getline(events, line);
  while (std::getline(events, line)) {
    std::vector<std::string> cells;
    std::istringstream cut(line);
    for (std::string cell; std::getline(cut, cell, ',');) {
      cells.push_back(cell);
    }
    const bool between = cells[2].starts_with("mover ");
    PageRow& row = expected[{cells[7], cells[2], between ? "" : cells[3]}];
    const auto begin = static_cast<std::uint32_t>(std::stoul(cells[5]));
    const auto end = static_cast<std::uint32_t>(std::stoul(cells[6]));
    row.begin = row.count == 0 ? begin : std::min(row.begin, begin);
    row.end = std::max(row.end, end);
    ++row.count;
  }
  ASSERT_GT(expected.size(), 5U);
  const std::vector<PageRow> rows = rows_on(page);
  EXPECT_EQ(rows.size(), expected.size());
  std::multiset<std::tuple<std::string, std::uint64_t, std::uint32_t, std::uint32_t>> on_page;
  std::multiset<std::tuple<std::string, std::uint64_t, std::uint32_t, std::uint32_t>> in_events;
  for (const PageRow& row : rows) {
    on_page.emplace(row.part_b, row.count, row.begin, row.end);
    EXPECT_EQ(row.held, row.count) << "all find room";
    EXPECT_LE(row.steps, row.end - row.begin + 1);
  }
  for (const auto& [key, row] : expected) {
    in_events.emplace(std::get<2>(key), row.count, row.begin, row.end);
  }
  EXPECT_EQ(on_page, in_events);
}

TEST_F(OverlapParts, ByPartNamesThemInJson) {
  const std::vector<std::string> files = fins(3, 4);
  const test::RunResult run =
      test::soms_run({"overlap", files[0], files[1], "--by", "part", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const test::Json answer = test::Json::parse(run.out);
  EXPECT_EQ(answer["schema"], "soms.overlap/2");
  EXPECT_FALSE(answer.contains("pairs"));
  ASSERT_EQ(answer["parts"].size(), 9U);
  std::uint64_t sum = 0;
  for (const test::Json& row : answer["parts"]) {
    sum += row["count"].get<std::uint64_t>();
  }
  EXPECT_EQ(answer["count"], sum);
  const test::Json& row = answer["parts"][5];
  EXPECT_EQ(row["a"], (test::Json{{"id", 1}, {"name", "beam 1"}, {"path", {"beam 1"}}}));
  EXPECT_EQ(row["b"]["name"], "duct 2");
  EXPECT_EQ(row["count"], 16);
  EXPECT_EQ(row["first"], (test::Json{4, 8}));
  // Fins of beam 1 stand at y from 1 to 1.375, those of duct 2 at x from 2 to 2.375.
  EXPECT_EQ(row["box"][0][0], 2);
  EXPECT_EQ(row["box"][0][1], 1);
  EXPECT_EQ(row["box"][0][2], 0);
  EXPECT_EQ(row["box"][1][0], 2.375);
  EXPECT_EQ(row["box"][1][1], 1.375);
}

TEST_F(OverlapParts, ByPartSaysNullWhereNoPartIs) {
  std::string nameless = test::fins_obj("x", 1, 1, true);
  nameless.erase(0, nameless.find('\n') + 1);
  const std::string a = write("a.obj", nameless);
  const std::string b = write("b.obj", test::fins_obj("duct ", 1, 1, false));
  const test::Json answer =
      test::Json::parse(test::soms_run({"overlap", a, b, "--by", "part", "--json"}).out);
  ASSERT_EQ(answer["parts"].size(), 1U);
  EXPECT_EQ(answer["parts"][0]["a"],
            (test::Json{{"id", nullptr}, {"name", nullptr}, {"path", test::Json::array()}}));
  EXPECT_EQ(answer["parts"][0]["b"]["id"], 0);
}

TEST_F(OverlapParts, ByPartListsAllInText) {
  const std::vector<std::string> files = fins(6, 1);
  const test::RunResult run = test::soms_run({"overlap", files[0], files[1], "--by", "part"});
  EXPECT_EQ(run.out.substr(0, run.out.find('\n')),
            "36 pairs of triangles overlap, in 36 pairs of parts:");
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 37);
  EXPECT_NE(run.out.find("beam 5 and duct 5: 1 pair of triangles around (5, 5, "),
            std::string::npos)
      << run.out;
}

TEST_F(OverlapParts, ByPartSaysAtLeastOfPartsWhereTheListIsCut) {
  const std::vector<std::string> files = fins(6, 1);
  const test::RunResult run =
      test::soms_run({"overlap", files[0], files[1], "--by", "part", "--limit", "5"});
  const std::string line = run.out.substr(0, run.out.find('\n'));
  EXPECT_EQ(line.find("at least 5 pairs of triangles overlap, in at least "), 0U) << line;
}

TEST_F(OverlapParts, PageSaysWhereTheSearchEndedEarly) {
  const std::vector<std::string> files = fins(6, 1);

  struct Case {
    std::vector<std::string> options;
    bool complete;
    std::string pairs;
  };

  for (const Case& c : std::vector<Case>{{{}, true, "36"},
                                         {{"--limit", "36"}, true, "36"},
                                         {{"--limit", "5"}, false, "at least 5"},
                                         {{"--any"}, false, "at least 1"},
                                         {{"--first"}, false, "at least 1"},
                                         {{"--any", "--pose", "0 0 20000"}, true, "0"}}) {
    std::vector<std::string> words{files[0], files[1]};
    words.insert(words.end(), c.options.begin(), c.options.end());
    const std::string page = page_of(words);
    EXPECT_EQ(test::scene_of(page)["complete"], c.complete) << testing::PrintToString(c.options);
    EXPECT_NE(page.find("<dt>pairs found</dt><dd>" + c.pairs + "</dd>"), std::string::npos)
        << testing::PrintToString(c.options);
  }
}

TEST_F(OverlapParts, PlotsKeepPartsOfOneNameApart) {
  std::string walls;
  for (const char* name : {"wall", "wall", ""}) {
    walls += fmt::format("o {}\nv -10 0 -10\nv 20 0 -10\nv 0 0 40\nf -3 -2 -1\n", name);
  }
  const std::string page =
      page_of({write("a.obj", walls), write("b.obj", test::fins_obj("duct", 1, 1, false))});
  std::size_t labels = 0;
  for (std::size_t at = page.find(">wall<"); at != std::string::npos;
       at = page.find(">wall<", at + 1)) {
    ++labels;
  }
  EXPECT_EQ(labels, 2U);
  EXPECT_NE(page.find(">part 2<"), std::string::npos);
}

TEST_F(OverlapParts, PageSetsWarningsApartAndSaysHowModelsWereRead) {
  const std::vector<std::string> files = fins(1, 1);
  const std::string page =
      page_of({files[0], files[1], "--pose", "0 0 9000000", "--scale", "0.5", "--up-b", "y"});
  EXPECT_NE(page.find("<strong>Warning:</strong> "), std::string::npos);
  EXPECT_EQ(page.find("<dt>warning</dt>"), std::string::npos);
  EXPECT_NE(page.find("<dd>beams, 1 triangle, --scale 0.5</dd>"), std::string::npos);
  EXPECT_NE(page.find("<dd>ducts, 1 triangle, --up-b y</dd>"), std::string::npos);
}

TEST_F(OverlapParts, CsvHasARowForEachPairOfPartsAndPose) {
  const std::vector<std::string> files = fins(3, 2);
  const std::string poses = write("poses.csv", "x,y,z\n0,0,0\n0,0,1\n");
  ASSERT_EQ(test::soms_run({"overlap", files[0], files[1], "--pose", poses, "--by", "part", "-o",
                            at("parts.csv")})
                .status,
            0);
  const std::string text = test::read_text(at("parts.csv"));
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "pose,part_a,name_a,path_a,part_b,name_b,path_b,count,triangle_a,triangle_b,x,y,z,"
            "x_min,y_min,z_min,x_max,y_max,z_max");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 2 * 9);
  EXPECT_NE(text.find("\n1,2,beam 2,beam 2,1,duct 1,duct 1,4,4,2,1.125,2.125,"), std::string::npos)
      << text;
}

TEST_F(OverlapParts, CsvHasARowForEachPairOfTrianglesOtherwise) {
  const std::vector<std::string> files = fins(2, 2);
  ASSERT_EQ(test::soms_run({"overlap", files[0], files[1], "-o", at("pairs.csv")}).status, 0);
  const std::string text = test::read_text(at("pairs.csv"));
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "pose,triangle_a,part_a,name_a,triangle_b,part_b,name_b");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 17);
  EXPECT_NE(text.find("\n0,3,1,beam 1,0,0,duct 0\n"), std::string::npos) << text;
}

TEST_F(OverlapParts, RefusesWhatByPartCannotMean) {
  const std::vector<std::string> files = fins(1, 1);
  for (const char* other : {"--any", "--first", "--no-pairs"}) {
    EXPECT_EQ(test::soms_run({"overlap", files[0], files[1], "--by", "part", other}).status, 2)
        << other;
  }
  EXPECT_EQ(test::soms_run({"overlap", files[0], files[1], "--by", "pole"}).status, 2);
  EXPECT_EQ(test::soms_run({"overlap", files[0], files[1], "-o", at("x.txt")}).status, 2);
  EXPECT_EQ(test::soms_run({"overlap", files[0], files[1], "-o", files[0]}).status, 2);
}

TEST_F(OverlapParts, R116ClashesOfABuildingAreAllOnThePage) {
  const std::string page = page_of({test::data("clash/structure.obj").string(),
                                    test::data("clash/services.gltf").string(), "--up-b", "y"});
  const std::vector<PageRow> rows = rows_on(page);
  EXPECT_EQ(rows.size(), 260U);
  std::uint64_t sum = 0;
  for (const PageRow& row : rows) {
    EXPECT_GE(row.held, 1U);
    sum += row.count;
  }
  EXPECT_EQ(sum, 13'252U);
}

}  // namespace

}  // namespace soms
