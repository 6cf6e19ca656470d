#include "apps/report/page.h"

#include "soms/generate/shapes.h"

#include "tests/report/reading.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>

namespace soms::report {

namespace {

constexpr const char* kBad = "</script><script>alert('x')</script>&\"<img src=x>";

Page small_page(const Mesh& mesh, const std::string& words) {
  Page page{
      .title = words, .lead = words, .facts = {{words, words}}, .plots = {}, .notes = {words}};
  page.plots.push_back({.svg = "<?xml?>\n<svg><path d=\"M0 0\"/></svg>\n", .caption = words});
  page.scene.models = {{mesh, words}};
  page.scene.bodies = {{0, words, true}, {0, words, false}};
  page.scene.parts = {{.name = words, .path = words + "/" + words}};
  page.scene.rows = {{.a = 0, .b = 1, .part_a = 0, .part_b = 0, .count = 1, .steps = 2, .end = 1}};
  page.scene.contacts = {{.a = 0,
                          .b = 1,
                          .part_a = 0,
                          .part_b = 0,
                          .begin = 0,
                          .end = 1,
                          .pairs = {{0, 0}},
                          .pairs_in_all = 1}};
  page.scene.contacts_in_all = 1;
  page.scene.steps.count = 2;
  page.scene.pose = [](std::uint32_t, std::uint64_t) { return Pose(); };
  return page;
}

std::string written(const Page& page) {
  std::ostringstream out;
  EXPECT_EQ(write_page(out, page).contacts, page.scene.contacts.size());
  return out.str();
}

TEST(ReportPage, SetsWarningsApart) {
  const Mesh mesh = generate_knot(500);
  Page page = small_page(mesh, "words");
  page.warnings = {"a < b"};
  EXPECT_NE(written(page).find("class=\"warn\" role=\"note\"><strong>Warning:</strong> a &lt; b"),
            std::string::npos);
}

TEST(ReportPage, LinksRowsOfATableToItsGaps) {
  const Mesh mesh = generate_knot(500);
  Page page = small_page(mesh, "words");
  page.scene.gaps = {{.a = 0, .b = 1, .length = "3 m"}};
  page.tables = {{.title = "Near",
                  .columns = {"who", "what"},
                  .rows = {{"<first>", "3 m"}, {"second", "4 m"}},
                  .of_gaps = true}};
  const std::string text = written(page);
  EXPECT_NE(text.find("<tr><td><a href=\"#gap=0\">&lt;first&gt;</a></td><td>3 m</td></tr>\n"
                      "<tr><td>second</td><td>4 m</td></tr>"),
            std::string::npos);
}

TEST(ReportPage, HasAListWhereSomethingIsListed) {
  const Mesh mesh = generate_knot(500);
  Page page = small_page(mesh, "words");
  EXPECT_NE(written(page).find("<section id=\"view\" class=\"touches\">"), std::string::npos);
  page.scene.rows.clear();
  page.scene.contacts.clear();
  page.scene.contacts_in_all = 0;
  EXPECT_NE(written(page).find("class=\"touches no-list\""), std::string::npos);
}

TEST(ReportPage, PutsTheAnswerBeforeTheFigures) {
  const Mesh mesh = generate_knot(500);
  Page page = small_page(mesh, "words");
  std::string text = written(page);
  EXPECT_LT(text.find("id=\"stage\""), text.find("<details id=\"figures\" class=\"fold\">"));
  // A plot that is the answer stands beside the scene, with the figures.
  page.beside = {{.svg = "<svg id=\"answer\"></svg>", .caption = "the answer"}};
  text = written(page);
  const std::size_t plot = text.find("<svg id=\"answer\">");
  EXPECT_LT(text.find("</div>\n<div id=\"answer\">"), plot) << "it is in what only scripts show";
  EXPECT_LT(plot, text.find("<dl class=\"facts\">"));
  EXPECT_LT(text.find("<dl class=\"facts\">"), text.find("id=\"drawn\""));
  EXPECT_EQ(text.find("<details id=\"figures\""), std::string::npos);
}

TEST(ReportPage, FoldsLongTables) {
  const Mesh mesh = generate_knot(500);
  Page page = small_page(mesh, "words");
  page.tables = {{.title = "Short", .columns = {"a"}, .rows = {{"1"}}},
                 {.title = "Long", .columns = {"a"}, .rows = {13, {"1"}}}};
  const std::string text = written(page);
  EXPECT_NE(text.find("<details class=\"fold\" open>\n<summary>Short"), std::string::npos);
  EXPECT_NE(text.find("<details class=\"fold\">\n<summary>Long"), std::string::npos);
}

TEST(ReportPage, IsOneWholeDocumentWithAllItsParts) {
  const Mesh mesh = generate_knot(500);
  const std::string text = written(small_page(mesh, "words"));
  EXPECT_EQ(text.find("<!DOCTYPE html>"), 0U);
  EXPECT_EQ(text.substr(text.size() - 8), "</html>\n");
  for (const char* part : {"<h1>words</h1>", "<dt>words</dt><dd>words</dd>", "id=\"canvas\"",
                           "id=\"list\"", "id=\"time-line\"", "<figcaption>words</figcaption>",
                           "<svg><path", "<noscript>", "name=\"viewport\""}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(text.find("<?xml"), std::string::npos);
  EXPECT_EQ(test::scene_of(text)["models"][0]["drawn"], 500);
}

TEST(ReportPage, FetchesNothing) {
  const Mesh mesh = generate_knot(500);
  const std::string text = written(small_page(mesh, "words"));
  EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
  const std::string before_script = text.substr(0, text.find("<script"));
  const std::regex outside(R"((src|href)=["'](?!data:|#))");
  EXPECT_FALSE(std::regex_search(before_script, outside));
  EXPECT_EQ(text.find("@import"), std::string::npos);
}

TEST(ReportPage, ShowsMarkupAndDoesNotObeyIt) {
  const Mesh mesh = generate_knot(500);
  const std::string text = written(small_page(mesh, kBad));
  EXPECT_EQ(text.find("alert('x')</script>"), std::string::npos);
  EXPECT_EQ(text.find("<img"), std::string::npos);
  EXPECT_NE(text.find("&lt;/script&gt;&lt;script&gt;alert('x')"), std::string::npos);
  EXPECT_EQ(test::scene_of(text)["bodies"]["names"][0], kBad);
  // As many elements as on the same page with plain words.
  const auto elements = [](const std::string& page) {
    std::size_t found = 0;
    for (std::size_t at = page.find("<script"); at != std::string::npos;
         at = page.find("<script", at + 1)) {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(elements(text), elements(written(small_page(mesh, "words"))));
}

}  // namespace

}  // namespace soms::report
