#include "apps/report/time_line.h"

#include <gtest/gtest.h>

#include <string>

namespace soms::report {

namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++found;
  }
  return found;
}

Scene traffic() {
  Scene scene;
  scene.bodies = {{.name = "city"},
                  {.name = "car 1", .moves = true},
                  {.name = "car 2", .moves = true},
                  {.name = "car 3", .moves = true}};
  scene.steps.count = 100;
  return scene;
}

TEST(TimeLine, IsEmptyWithoutContactsOrTime) {
  Scene scene = traffic();
  EXPECT_EQ(time_line(scene), "");
  scene.contacts.push_back({.a = 1, .b = 0});
  scene.steps.count = 1;
  EXPECT_EQ(time_line(scene), "");
}

TEST(TimeLine, HasARowForEachThatMovesAndTouches) {
  Scene scene = traffic();
  scene.contacts = {{.a = 1, .b = 0, .begin = 5, .end = 9},
                    {.a = 2, .b = 3, .begin = 20, .end = 30}};
  const std::string svg = time_line(scene);
  for (const char* name : {"car 1", "car 2", "car 3"}) {
    EXPECT_EQ(count(svg, std::string(">") + name + "<"), 1U) << name;
  }
  EXPECT_EQ(svg.find(">city<"), std::string::npos);
  EXPECT_EQ(count(svg, "data-contact=\"0\""), 1U);
  EXPECT_EQ(count(svg, "data-contact=\"1\""), 2U);  // of both
}

TEST(TimeLine, JoinsWhatFollowsEachOther) {
  Scene scene = traffic();
  scene.contacts = {{.a = 1, .b = 0, .begin = 5, .end = 9},
                    {.a = 1, .b = 0, .begin = 7, .end = 12},
                    {.a = 1, .b = 0, .begin = 13, .end = 14},
                    {.a = 1, .b = 0, .begin = 16, .end = 16}};
  EXPECT_EQ(count(time_line(scene), "data-contact"), 2U);
}

TEST(TimeLine, KeepsThoseThatTouchForLongest) {
  Scene scene = traffic();
  scene.contacts = {{.a = 1, .b = 0, .begin = 5, .end = 5},
                    {.a = 2, .b = 0, .begin = 6, .end = 60},
                    {.a = 3, .b = 0, .begin = 7, .end = 50}};
  const std::string svg = time_line(scene, 2);
  EXPECT_EQ(svg.find(">car 1<"), std::string::npos);
  EXPECT_LT(svg.find(">car 2<"), svg.find(">car 3<"));
}

TEST(TimeLine, CountsAStepOnceHoweverManyAreTouchedInIt) {
  Scene scene = traffic();
  scene.bodies.push_back({.name = "car 4", .moves = true});
  // Car 1 touches for 10 steps, in each of them a standing and a moving body; car 4 for 15.
  scene.contacts = {{.a = 1, .b = 0, .begin = 10, .end = 19},
                    {.a = 1, .b = 2, .begin = 10, .end = 19},
                    {.a = 4, .b = 0, .begin = 30, .end = 44}};
  const std::string svg = time_line(scene, 1);
  EXPECT_NE(svg.find(">car 4<"), std::string::npos);
  EXPECT_EQ(svg.find(">car 1<"), std::string::npos);
}

TEST(TimeLine, EscapesNames) {
  Scene scene = traffic();
  scene.bodies[1].name = "<b>&\"";
  scene.contacts = {{.a = 1, .b = 0, .begin = 5, .end = 9}};
  const std::string svg = time_line(scene);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  EXPECT_NE(svg.find("&lt;b&gt;&amp;&quot;"), std::string::npos);
}

}  // namespace

}  // namespace soms::report
