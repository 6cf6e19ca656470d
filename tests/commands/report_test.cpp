#include "tests/commands/run.h"
#include "tests/support/slow_build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace soms {

namespace {

/// A house of 12 triangles, named as no house should be, on a ground of two.
std::string town_obj() {
  std::string text = "v 0 0 0\nv 60 0 0\nv 60 60 0\nv 0 60 0\no ground\nf 1 2 3\nf 1 3 4\n";
  for (unsigned corner = 0; corner < 8; ++corner) {
    text += "v " + std::to_string((corner & 1U) != 0 ? 45 : 15) + " " +
            std::to_string((corner & 2U) != 0 ? 45 : 15) + " " +
            std::to_string((corner & 4U) != 0 ? 9 : 0) + "\n";
  }
  text += "o house</script><script>alert(1)</script>\"&\n";
  const int faces[6][4] = {{5, 7, 8, 6},   {9, 10, 12, 11}, {5, 6, 10, 9},
                           {7, 11, 12, 8}, {5, 9, 11, 7},   {6, 8, 12, 10}};
  for (const auto& f : faces) {
    for (const int last : {2, 3}) {
      text += "f " + std::to_string(f[0]) + " " + std::to_string(f[last - 1]) + " " +
              std::to_string(f[last]) + "\n";
    }
  }
  return text;
}

class Report : public ::testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  std::string write(const std::string& name, const std::string& text) {
    test::write_text(at(name), text);
    return at(name);
  }

  test::TemporaryFolder folder_;
};

std::string scene_text(const std::string& page) {
  const std::string mark = "id=\"soms-scene\">";
  const std::size_t begin = page.find(mark) + mark.size();
  return page.substr(begin, page.find("</script>", begin) - begin);
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t k = text.find(what); k != std::string::npos; k = text.find(what, k + 1)) {
    ++found;
  }
  return found;
}

TEST_F(Report, OfASimulationCountsAsTheAnswerDoes) {
  const std::string town = write("to<wn & \"co\".obj", town_obj());
  const std::string page_path = at("page.html");
  const test::RunResult run =
      test::soms_run({"simulate", town, "--count", "12", "--frames", "300", "-o", page_path,
                      "--contacts", at("events.csv"), "--json", "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  const test::Json answer = test::Json::parse(run.out);
  const std::string page = test::read_text(page_path);
  const test::Json scene = test::Json::parse(scene_text(page));
  ASSERT_GT(answer["contacts"], 0);
  EXPECT_EQ(scene["contacts"]["all"], answer["contacts"]);
  EXPECT_EQ(scene["contacts"]["listed"], answer["contacts"]);
  EXPECT_EQ(scene["contacts"]["all"], count(test::read_text(at("events.csv")), "\n") - 1);
  EXPECT_EQ(scene["steps"]["count"], 300);
  EXPECT_EQ(scene["models"][0]["triangles"], 14);
  EXPECT_EQ(scene["models"][0]["drawn"], 14);
  EXPECT_EQ(scene["bodies"]["names"].size(), 1 + answer["movers"].get<std::size_t>());
  EXPECT_EQ(scene["bodies"]["names"][0], "to<wn & \"co\"");
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_NE(page.find("to&lt;wn &amp; &quot;co&quot; and 12 movers"), std::string::npos);
  EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
}

TEST_F(Report, CountsAContactOfTwoMoversForBothModels) {
  const std::string town = write("town.off", test::triangle_off("50 0 0", "51 0 0", "50 1 0"));
  const std::string hammer = write("hammer.off", test::triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const std::string anvil =
      write("anvil.off", test::triangle_off("0.2 0.2 -1", "0.2 0.2 1", "3 3 1"));
  const std::string route = write("route.csv", "x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n");
  const test::RunResult run = test::soms_run({"simulate", town, "--mover", hammer, "--mover", anvil,
                                              "--route", route, "--route", route, "--frames", "1",
                                              "-o", at("page.html"), "--json", "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  ASSERT_EQ(test::Json::parse(run.out)["contacts_between_movers"], 1) << run.out;
  const std::string page = test::read_text(at("page.html"));
  const std::size_t begin = page.find("<title>Models by contacts</title>");
  ASSERT_NE(begin, std::string::npos);
  const std::string chart = page.substr(begin, page.find("</svg>", begin) - begin);
  EXPECT_EQ(count(chart, ">hammer</text>"), 1U);
  EXPECT_EQ(count(chart, ">anvil</text>"), 1U);
  EXPECT_GT(count(chart, "class=\"f0 "), 0U) << "what moves is blue";
}

TEST_F(Report, HasNoBarsOfOneBarAndSandForWhatStands) {
  const std::string town = write("town.obj", town_obj());
  ASSERT_EQ(test::soms_run({"simulate", town, "--count", "40", "--frames", "60", "-o",
                            at("page.html"), "--quiet"})
                .status,
            0);
  const std::string page = test::read_text(at("page.html"));
  EXPECT_EQ(page.find("<title>Parts of the city by contacts</title>"), std::string::npos)
      << "the town is one part";
  const std::size_t begin = page.find("<title>Contacts in each frame</title>");
  ASSERT_NE(begin, std::string::npos);
  const std::string chart = page.substr(begin, page.find("</svg>", begin) - begin);
  EXPECT_GT(count(chart, "class=\"s7\""), 0U) << "with the city";
  EXPECT_GT(count(chart, "class=\"s0\""), 0U) << "between movers";
  EXPECT_EQ(count(chart, "class=\"s1\""), 0U) << "orange means neither";
}

TEST_F(Report, OfTheSameRunIsTheSameButForTimes) {
  const std::string town = write("town.obj", town_obj());
  std::vector<std::string> scenes;
  for (const char* threads : {"1", "2"}) {
    ASSERT_EQ(test::soms_run({"simulate", town, "--count", "9", "--frames", "40", "--threads",
                              threads, "-o", at("page.html"), "--quiet"})
                  .status,
              0);
    const std::string page = test::read_text(at("page.html"));
    const std::size_t begin = page.find("id=\"soms-model-0\"");
    scenes.push_back(page.substr(begin));
  }
  EXPECT_EQ(scenes[0], scenes[1]);
}

TEST_F(Report, OfOnePoseListsItsPairs) {
  const std::string a = write("a<i>.off", test::triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const std::string b = write("b.off", test::triangle_off("0.2 0.2 -1", "0.2 0.2 1", "3 3 1"));
  const test::RunResult run = test::soms_run({"overlap", a, b, "-o", at("page.html")});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string page = test::read_text(at("page.html"));
  const test::Json scene = test::Json::parse(scene_text(page));
  EXPECT_EQ(scene["contacts"]["all"], 1);
  EXPECT_EQ(scene["contacts"]["pairs"], 1);
  EXPECT_EQ(scene["steps"]["count"], 1);
  EXPECT_NE(page.find("a&lt;i&gt; and b"), std::string::npos);
  EXPECT_NE(page.find("<dt>pairs found</dt><dd>1</dd>"), std::string::npos);
}

TEST_F(Report, OfManyPosesHoldsWhatFindsRoom) {
  const std::string a = write("a.off", test::triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const std::string b = write("b.off", test::triangle_off("0.2 0.2 -1", "0.2 0.2 1", "3 3 1"));
  std::string poses = "x,y,z\n";
  for (int k = 0; k < 30'000; ++k) {
    poses += k % 2 == 0 ? "0,0,0\n" : "50,0,0\n";
  }
  const test::RunResult run = test::soms_run({"overlap", a, b, "--pose", write("poses.csv", poses),
                                              "-o", at("page.html"), "--json", "--no-pairs"});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string page = test::read_text(at("page.html"));
  const test::Json scene = test::Json::parse(scene_text(page));
  EXPECT_EQ(scene["contacts"]["all"], 15'000);
  EXPECT_LE(scene["contacts"]["listed"], 10'000);
  EXPECT_GE(scene["contacts"]["listed"], 2'000);
  EXPECT_EQ(scene["steps"]["count"], 30'000);
  EXPECT_NE(page.find("30,000: 15,000 with overlap, 15,000 without"), std::string::npos);
  EXPECT_LT(page.size(), 4'500'000U);
}

TEST_F(Report, OfNothingThatTouchesSaysSo) {
  const std::string a = write("a.off", test::triangle_off("0 0 0", "1 0 0", "0 1 0"));
  ASSERT_EQ(test::soms_run({"overlap", a, a, "--pose", "0 0 9", "-o", at("page.html")}).status, 0);
  const std::string page = test::read_text(at("page.html"));
  EXPECT_EQ(test::Json::parse(scene_text(page))["contacts"]["all"], 0);
  EXPECT_NE(page.find("<dt>pairs found</dt><dd>0</dd>"), std::string::npos);
}

TEST_F(Report, OfTheThesisNeedsNoOtherFile) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const test::RunResult run = test::soms_run({"reproduce", "--quick", "--quiet", "--item", "5.3",
                                              "-o", at("out"), "--report", at("thesis.html")});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string page = test::read_text(at("thesis.html"));
  EXPECT_EQ(page.find("href=\"tables/"), std::string::npos);
  EXPECT_EQ(page.find("href=\"figures/"), std::string::npos);
  EXPECT_EQ(page.find("run.json"), std::string::npos);
  EXPECT_NE(page.find("href=\"data:text/csv;charset=utf-8,"), std::string::npos);
  EXPECT_EQ(count(page, "<figure"), count(test::read_text(at("out/index.html")), "<figure"));
}

TEST_F(Report, TellsAPlaceThatCannotBeWrittenBeforeTheWork) {
  const std::string a = write("a.off", test::triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const std::string nowhere = at("no/folder/page.html");
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"simulate", "--frames", "1", "-o", nowhere},
           {"overlap", a, a, "-o", nowhere},
           {"reproduce", "--item", "5.3", "-o", at("out"), "--report", nowhere}}) {
    const test::RunResult run = test::soms_run(words);
    EXPECT_EQ(run.status, 5) << words[0];
    EXPECT_NE(run.err.find("page.html"), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

TEST_F(Report, OverwritesNothingThatIsRead) {
  const std::string a = write("a.off", test::triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const std::string before = test::read_text(a);
  EXPECT_EQ(test::soms_run({"overlap", a, a, "-o", a}).status, 2);
  EXPECT_EQ(test::soms_run({"overlap", a, a, "-o", "-"}).status, 2);
  EXPECT_EQ(test::soms_run({"simulate", a, "--report", a}).status, 2);
  EXPECT_EQ(test::soms_run({"simulate", a, "--report", at("x"), "--map", at("x")}).status, 2);
  EXPECT_EQ(test::soms_run({"reproduce", "--item", "5.3", "--report", "-"}).status, 2);
  EXPECT_EQ(test::read_text(a), before);
}

TEST_F(Report, IsNotThereWhereTheRunFailed) {
  const std::string a = write("a.off", test::triangle_off("0 0 0", "1 0 0", "0 1 0"));
  const std::string poses = write("poses.csv", "x,y,z\n0,0,0\n0,0,oops\n");
  EXPECT_NE(test::soms_run({"overlap", a, a, "--pose", poses, "-o", at("page.html")}).status, 0);
  EXPECT_NE(test::soms_run({"simulate", at("none.ply"), "-o", at("page.html")}).status, 0);
  EXPECT_EQ(test::files_in(folder_.path()), (std::vector<std::string>{"a.off", "poses.csv"}));
}

}  // namespace

}  // namespace soms
