#include "tests/commands/run.h"
#include "tests/support/support.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace soms::test {
namespace {

std::string clash_data(const std::string& name) {
  return test::data("clash/" + name).string();
}

/// Runs `clash` on the special cases, one set against the other.
RunResult special(std::vector<std::string> words) {
  words.insert(words.begin(),
               {"clash", clash_data("special.obj"), "--against", clash_data("special_b.obj")});
  return soms_run(words);
}

/// Rows of a list and its last line.
struct ClashLines {
  std::vector<Json> rows;
  Json totals;
};

ClashLines lines_of(const std::string& text) {
  ClashLines lines{json_lines(text), {}};
  lines.totals = lines.rows.back();
  lines.rows.pop_back();
  return lines;
}

/// "Slab - In slab: inside", in the order of the list.
std::vector<std::string> in_short(const ClashLines& lines) {
  std::vector<std::string> rows;
  for (const Json& row : lines.rows) {
    rows.push_back(row.at("a").at("part").get<std::string>() + " - " +
                   row.at("b").at("part").get<std::string>() + ": " +
                   row.at("class").get<std::string>());
  }
  return rows;
}

TEST(ClashVerb, ListsEveryClass) {
  const RunResult result = special({"--clearance", "0.01", "--json", "--verify"});
  EXPECT_EQ(result.status, 0) << result.err;
  const ClashLines lines = lines_of(result.out);
  EXPECT_EQ(in_short(lines),
            (std::vector<std::string>{"Slab - Crosses slab: crossing", "Slab - In slab: inside",
                                      "Twin - Twin again: same", "Slab - Stands on slab: touching",
                                      "Post - Near post: near"}));
  EXPECT_EQ(lines.totals.at("verified"), true);
  EXPECT_EQ(lines.totals.at("pairs"), 5);
  EXPECT_EQ(lines.totals.at("pairs_of_parts"), 18);
  EXPECT_EQ(lines.totals.at("by_class").at("touching"), 1);
  EXPECT_EQ(lines.totals.at("coverage"), "complete");
}

TEST(ClashVerb, AnswersInTheSchema) {
  const ClashLines lines = lines_of(special({"--clearance", "0.01", "--json"}).out);
  for (const Json& row : lines.rows) {
    EXPECT_EQ(row.at("schema"), "soms.clash/1");
    EXPECT_EQ(row.at("key").get<std::string>().size(), 16U);
    EXPECT_EQ(row.at("place").size(), 3U);
    EXPECT_EQ(row.at("box").size(), 2U);
    EXPECT_EQ(row.at("a").at("path"), Json::array({row.at("a").at("part")}));
    EXPECT_TRUE(row.at("a").at("id").is_null());
    EXPECT_FALSE(row.contains("status"));
  }
  EXPECT_EQ(lines.rows[1].at("relation"), "b_in_a");
  EXPECT_EQ(lines.rows[4].at("gap"), Json::array({31.001 - 31, 31.001 - 31}));
  EXPECT_EQ(lines.rows[3].at("gap"), Json::array({0.0, 0.0}));
}

TEST(ClashVerb, SaysItInWords) {
  const RunResult result = special({"--clearance", "0.01"});
  EXPECT_NE(result.out.find("5 clashes: 1 crossing, 1 inside, 1 same, 1 touching, 1 near\n"),
            std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("Slab and In slab at "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find(", the second in the first\n"), std::string::npos) << result.out;
}

TEST(ClashVerb, FindsAllPairsOfABuilding) {
  const RunResult result = soms_run({"clash", clash_data("structure.obj"), "--against",
                                     clash_data("services.gltf"), "--json", "--threads", "2"});
  EXPECT_EQ(result.status, 0) << result.err;
  const ClashLines lines = lines_of(result.out);
  EXPECT_EQ(std::count_if(lines.rows.begin(), lines.rows.end(),
                          [](const Json& row) { return row.at("triangle_pairs") > 0; }),
            260);
  EXPECT_EQ(lines.totals.at("parts"), Json::array({166, 72}));
  EXPECT_NE(result.err.find("rotated to z"), std::string::npos) << result.err;
  std::set<std::string> keys;
  for (const Json& row : lines.rows) {
    keys.insert(row.at("key").get<std::string>());
  }
  EXPECT_EQ(keys.size(), lines.rows.size());
}

TEST(ClashVerb, OfOneSetComparesEachPairOnce) {
  const std::string walls =
      "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
      "o b\nv 0.1 0.1 0.1\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n";
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "walls.obj").string();
  write_text(file, walls);
  const ClashLines lines = lines_of(soms_run({"clash", file, "--json", "--verify"}).out);
  EXPECT_EQ(in_short(lines), std::vector<std::string>{"a - b: crossing"});
  EXPECT_EQ(lines.totals.at("pairs_of_parts"), 1);
}

TEST(ClashVerb, TakesAFolderForItsModels) {
  const TemporaryFolder folder;
  for (const char* const name : {"special.obj", "special_b.obj"}) {
    std::filesystem::copy_file(clash_data(name), folder.path() / name);
  }
  write_text(folder.path() / "readme.txt", "no model");
  const ClashLines lines = lines_of(soms_run({"clash", folder.path().string(), "--json"}).out);
  EXPECT_EQ(lines.totals.at("parts"), Json::array({9, 0}));
  EXPECT_EQ(lines.totals.at("by_class").at("same"), 1);
  std::filesystem::create_directory(folder.path() / "more");
  const RunResult both =
      soms_run({"clash", folder.path().string(), clash_data("special.obj"), "--json"});
  EXPECT_EQ(both.status, 0);
  EXPECT_NE(both.err.find("1 subfolder not read"), std::string::npos) << both.err;
  std::filesystem::remove(folder.path() / "special.obj");
  std::filesystem::remove(folder.path() / "special_b.obj");
  const RunResult none = soms_run({"clash", folder.path().string()});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("without models"), std::string::npos) << none.err;
}

TEST(ClashVerb, TakesATilesetForItsTiles) {
  const TemporaryFolder folder;
  const std::string tile = test::data("formats/batched.b3dm").string();
  std::filesystem::copy_file(tile, folder.path() / "tile.b3dm");
  write_text(
      folder.path() / "tileset.json",
      R"({"asset":{"version":"1.0"},"geometricError":1,"root":{"geometricError":0,)"
      R"("boundingVolume":{"box":[0,0,0,9,0,0,0,9,0,0,0,9]},"content":{"uri":"tile.b3dm"}}})");
  const auto parts = [](const std::string& model) {
    const RunResult result = soms_run({"clash", model, "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    return json_lines(result.out).back().at("parts");
  };
  EXPECT_EQ(parts(folder.path().string()), parts(tile));
}

TEST(ClashVerb, RefusesAModelThatIsGivenTwice) {
  const RunResult result =
      soms_run({"clash", clash_data("special.obj"), "--against", clash_data("special.obj")});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("given twice"), std::string::npos) << result.err;
}

TEST(ClashVerb, CountsWhatIsIgnored) {
  const TemporaryFolder folder;
  const std::string pairs = (folder.path() / "pairs.csv").string();
  write_text(pairs, "# known\n\nIn*,Sl?b\r\n\"Twin\",\"Twin again\"\n");
  const RunResult result =
      special({"--ignore-class", "touching", "--ignore-pairs", pairs, "--json"});
  const ClashLines lines = lines_of(result.out);
  EXPECT_EQ(in_short(lines), std::vector<std::string>{"Slab - Crosses slab: crossing"});
  EXPECT_EQ(lines.totals.at("removed"), (Json{{"touching", 1}, {"ignore-pairs", 2}}));
}

TEST(ClashVerb, NamesALineThatIsNoPair) {
  const TemporaryFolder folder;
  const std::string pairs = (folder.path() / "pairs.csv").string();
  write_text(pairs, "Slab,Twin\nSlab\n");
  const RunResult result = special({"--ignore-pairs", pairs});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("line 2"), std::string::npos) << result.err;
  EXPECT_EQ(special({"--ignore-pairs", "missing.csv"}).status, 3);
}

TEST(ClashVerb, ComparesWithAnOlderList) {
  const TemporaryFolder folder;
  const std::string old = (folder.path() / "old.json").string();
  ASSERT_EQ(special({"-o", old, "--ignore-class", "crossing"}).status, 0);
  // What is removed now is not resolved.
  const std::vector<std::string> same = {"--baseline",     old,        "--ignore-class", "touching",
                                         "--ignore-class", "crossing", "--json"};
  const ClashLines lines = lines_of(special(same).out);
  std::map<std::string, std::string> status;
  for (const Json& row : lines.rows) {
    status[row.at("b").at("part")] = row.at("status");
  }
  EXPECT_EQ(status,
            (std::map<std::string, std::string>{{"In slab", "active"}, {"Twin again", "active"}}));
  EXPECT_EQ(lines.totals.at("by_status"), (Json{{"new", 0}, {"active", 2}, {"resolved", 0}}));
  // Without the older list's filter one would be new that was there before.
  EXPECT_EQ(special({"--baseline", old, "--ignore-class", "touching"}).status, 2);
  // What the older list looked for less far is new.
  EXPECT_EQ(special({"--baseline", old, "--ignore-class", "crossing", "--clearance", "0.01",
                     "--fail-if", "new"})
                .status,
            1);
}

TEST(ClashVerb, TellsWhatIsResolved) {
  const TemporaryFolder folder;
  const std::string old = (folder.path() / "old.json").string();
  ASSERT_EQ(special({"-o", old, "--clearance", "0.01"}).status, 0);
  // Without the part that crosses the slab.
  const std::string model = (folder.path() / "special_b.obj").string();
  const std::string whole = read_text(clash_data("special_b.obj"));
  const std::size_t last = whole.find("o Crosses slab");
  ASSERT_NE(last, std::string::npos);
  write_text(model, whole.substr(0, last));
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"clash", clash_data("special.obj"), "--against", model});
    return soms_run(words);
  };
  const RunResult result =
      run({"--baseline", old, "--clearance", "0.01", "--json", "--fail-if", "new"});
  EXPECT_EQ(result.status, 0);
  const ClashLines lines = lines_of(result.out);
  EXPECT_EQ(lines.totals.at("by_status"), (Json{{"new", 0}, {"active", 4}, {"resolved", 1}}));
  EXPECT_EQ(lines.rows.back().at("status"), "resolved");
  EXPECT_EQ(lines.rows.back().at("b").at("part"), "Crosses slab");
  // A list with resolved rows is an older list, too; its resolved rows are not.
  const std::string second = (folder.path() / "second.json").string();
  ASSERT_EQ(run({"--baseline", old, "--clearance", "0.01", "-o", second}).status, 0);
  EXPECT_EQ(lines_of(run({"--baseline", second, "--clearance", "0.01", "--json"}).out)
                .totals.at("by_status"),
            (Json{{"new", 0}, {"active", 4}, {"resolved", 0}}));
}

TEST(ClashVerb, ListsOnlyTheStatusesThatAreNamed) {
  const TemporaryFolder folder;
  const std::string old = (folder.path() / "old.json").string();
  ASSERT_EQ(special({"-o", old}).status, 0);
  const auto listed = [&](const std::vector<std::string>& names) {
    std::vector<std::string> words = {"--baseline", old, "--clearance", "0.01", "--json"};
    for (const std::string& name : names) {
      words.insert(words.end(), {"--status", name});
    }
    return lines_of(special(words).out);
  };
  const ClashLines fresh = listed({"new"});
  EXPECT_EQ(in_short(fresh), (std::vector<std::string>{"Post - Near post: near"}));
  EXPECT_EQ(fresh.totals.at("removed").at("status"), 4);
  EXPECT_EQ(fresh.totals.at("by_class").at("crossing"), 0);
  EXPECT_EQ(listed({"active"}).rows.size(), 4U);
  EXPECT_EQ(listed({"active", "new"}).rows.size(), 5U);
  EXPECT_TRUE(listed({"resolved"}).rows.empty());
  const RunResult alone = special({"--status", "new"});
  EXPECT_EQ(alone.status, 2);
  EXPECT_NE(alone.err.find("--status has no effect without --baseline"), std::string::npos)
      << alone.err;
  EXPECT_EQ(special({"--baseline", old, "--status", "old"}).status, 2);
}

TEST(ClashVerb, LeavesOutPartsOfOneObject) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "town.city.json").string();
  const auto solid = [](int x) {
    std::string text = R"("geometry":[{"type":"Solid","lod":"1","boundaries":[[)";
    for (const char* const face : {"0321", "4567", "0154", "1265", "2376", "3047"}) {
      text += std::string(text.back() == '[' ? "" : ",") + "[[";
      for (int k = 0; k < 4; ++k) {
        text += (k == 0 ? "" : ",") + std::to_string(8 * x + face[k] - '0');
      }
      text += "]]";
    }
    return text + "]]}]";
  };
  // Parts 0 and 1 of one building cross, and 1 and the house 2.
  std::string vertices;
  for (int x = 0; x < 3; ++x) {
    for (const char* const v :
         {"0,0,0", "3,0,0", "3,3,0", "0,3,0", "0,0,3", "3,0,3", "3,3,3", "0,3,3"}) {
      const std::string corner(v);
      vertices += std::string(vertices.empty() ? "[" : ",[") +
                  std::to_string(corner[0] - '0' + 2 * x) + "," +
                  std::to_string(corner[2] - '0' + x) + "," + std::to_string(corner[4] - '0' + x) +
                  "]";
    }
  }
  write_text(
      file,
      R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[0,0,0]},)"
      R"("CityObjects":{"home":{"type":"Building","children":["p0","p1"]},)"
      R"("p0":{"type":"BuildingPart","parents":["home"],)" +
          solid(0) + R"(},"p1":{"type":"BuildingPart","parents":["home"],)" + solid(1) +
          R"(},"house":{"type":"Building",)" + solid(2) + R"(}},"vertices":[)" + vertices + "]}");
  EXPECT_EQ(lines_of(soms_run({"clash", file, "--json"}).out).rows.size(), 2U);
  const ClashLines others = lines_of(soms_run({"clash", file, "--ignore-siblings", "--json"}).out);
  ASSERT_EQ(others.rows.size(), 1U);
  EXPECT_EQ(others.totals.at("removed").at("ignore-siblings"), 1);
  EXPECT_NE(others.rows[0].at("a").at("part"), "p0");
  EXPECT_NE(others.rows[0].at("b").at("part"), "p0");
  EXPECT_EQ(soms_run({"clash", file, "--lod", "2"}).status, 2);
  EXPECT_EQ(soms_run({"clash", file, "--lod", "1"}).status, 0);
}

TEST(ClashVerb, KeysSurviveRenumbering) {
  // The parts of special_b.obj in another order, their triangles turned around.
  const TemporaryFolder folder;
  const std::string turned = (folder.path() / "turned.obj").string();
  std::vector<std::string> parts;
  std::vector<std::string> vertices;
  std::string text = read_text(clash_data("special_b.obj"));
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.starts_with("o ")) {
      parts.emplace_back();
    }
    if (line.starts_with("v ")) {
      vertices.push_back(line);
      continue;
    }
    if (line.starts_with("f ")) {
      const std::size_t first = line.find(' ', 2);
      parts.back() += "f" + line.substr(first) + " " + line.substr(2, first - 2) + "\n";
    } else {
      parts.back() += line + "\n";
    }
  }
  std::string again;
  for (const std::string& vertex : vertices) {
    again += vertex + "\n";
  }
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    again += *part;
  }
  write_text(turned, again);
  const auto keys = [&](const std::string& b) {
    std::map<std::string, Json> found;
    const std::string out = soms_run({"clash", clash_data("special.obj"), "--against", b,
                                      "--clearance", "0.01", "--json"})
                                .out;
    for (const Json& row : lines_of(out).rows) {
      found[row.at("key")] =
          Json{row.at("class"), row.at("b").at("part"), row.at("gap"), row.at("triangle_pairs")};
    }
    return found;
  };
  EXPECT_EQ(keys(turned), keys(clash_data("special_b.obj")));
}

TEST(ClashVerb, WritesEachRowToEachFile) {
  const TemporaryFolder folder;
  const std::string csv = (folder.path() / "list.csv").string();
  const std::string json = (folder.path() / "list.jsonl").string();
  ASSERT_EQ(special({"--clearance", "0.01", "-o", csv, "-o", json}).status, 0);
  const ClashLines lines = lines_of(read_text(json));
  const auto rows = read_csv(csv);
  ASSERT_EQ(rows.size(), 1 + lines.rows.size());
  for (std::size_t k = 0; k < lines.rows.size(); ++k) {
    ASSERT_EQ(rows[k + 1].size(), rows[0].size());
    EXPECT_EQ(rows[k + 1].front(), lines.rows[k].at("class"));
    EXPECT_EQ(rows[k + 1].back(), lines.rows[k].at("key"));
    EXPECT_EQ(rows[k + 1][5], lines.rows[k].at("a").at("part"));
    EXPECT_EQ(rows[k + 1][11], lines.rows[k].at("b").at("part"));
  }
  EXPECT_EQ(special({"-o", (folder.path() / "list.txt").string()}).status, 2);
}

TEST(ClashVerb, NamesWhereAPartIsOpen) {
  const TemporaryFolder folder;
  const std::string open = (folder.path() / "open.off").string();
  write_text(open, triangle_off("1 0 0", "1 0.5 0", "1 0 0.5"));
  const RunResult result = soms_run({"clash", box(), "--against", open, "--json"});
  const ClashLines lines = lines_of(result.out);
  ASSERT_EQ(lines.rows.size(), 1U);
  const Json& row = lines.rows[0];
  EXPECT_EQ(row.at("class"), "undecided");
  EXPECT_EQ(row.at("why"), "open");
  EXPECT_EQ(row.at("open"), Json::array({"b"}));
  EXPECT_EQ(row.at("b").at("odd_edges"), 3);
  EXPECT_EQ(row.at("b").at("open_at").size(), 3U);
  EXPECT_GT(row.at("triangle_pairs"), 0);
  EXPECT_NE(soms_run({"clash", box(), "--against", open})
                .out.find("surfaces meet, the second is open at 3 edges"),
            std::string::npos);
}

TEST(ClashVerb, DecidesWhatIsKnownOfOpenParts) {
  const TemporaryFolder folder;
  const std::string open = (folder.path() / "open.off").string();
  write_text(open, triangle_off("0.25 0.25 0.25", "0.5 0.25 0.25", "0.25 0.5 0.25"));
  const ClashLines lines =
      lines_of(soms_run({"clash", box(), "--against", open, "--json", "--verify"}).out);
  ASSERT_EQ(lines.rows.size(), 1U);
  EXPECT_EQ(lines.rows[0].at("class"), "inside");
  EXPECT_EQ(lines.rows[0].at("relation"), "b_in_a");
  EXPECT_EQ(lines.rows[0].at("open"), Json::array({"b"}));
  EXPECT_EQ(lines.rows[0].at("gap"), Json::array({0.5, 0.5}));
  EXPECT_EQ(lines.totals.at("verified"), true);
  write_text(open, triangle_off("0.25 0.25 0.25", "5 0.25 0.25", "0.25 0.5 0.25"));
  EXPECT_EQ(
      lines_of(soms_run({"clash", box(), "--against", open, "--json"}).out).rows.at(0).at("class"),
      "crossing");
}

TEST(ClashVerb, RefusesWhatIsNoDistance) {
  for (const char* const within : {"nan", "-1", "inf", "x"}) {
    EXPECT_EQ(special({"--clearance", within}).status, 2) << within;
  }
  EXPECT_EQ(special({"--ignore-class", "soft"}).status, 2);
  EXPECT_EQ(special({"--fail-if", "new"}).status, 2);
}

TEST(ClashVerb, FailsOnRequest) {
  EXPECT_EQ(special({"--fail-if", "clash"}).status, 1);
  EXPECT_EQ(special({"--fail-if", "hard"}).status, 1);
  EXPECT_EQ(special({"--fail-if", "hard", "--ignore-class", "crossing", "--ignore-class", "inside",
                     "--ignore-class", "same"})
                .status,
            0);
}

TEST(ClashVerb, SaysWhatTimeLeftUndecided) {
  const RunResult result = run_with_time(
      [](const std::string& seconds) {
        return special({"--json", "--timeout", seconds});
      },
      [](const RunResult& run) { return run.status == 0; });
  ASSERT_EQ(result.status, 0) << result.err;
  const ClashLines lines = lines_of(result.out);
  EXPECT_TRUE(lines.totals.at("coverage") == "complete" || lines.totals.at("coverage") == "cut");
}

TEST(ClashVerb, WarnsWhereSetsAreFarApart) {
  const TemporaryFolder folder;
  const std::string far = (folder.path() / "far.off").string();
  write_text(far, triangle_off("9000 0 0", "9001 0 0", "9000 1 0"));
  const RunResult result = soms_run({"clash", box(), "--against", far, "--json"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("apart"), std::string::npos) << result.err;
  EXPECT_EQ(lines_of(result.out).totals.at("warnings").back().at("kind"), "boxes_apart");
  EXPECT_EQ(soms_run({"clash", box(), "--against", far, "--strict"}).status, 3);
}

}  // namespace
}  // namespace soms::test
