// What of `SceneSubject` concerns a traversal test by test.
#include "apps/view/drawing/palette.h"
#include "apps/view/window/scene_subject.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

/// Width of the edges of the two boxes that are tested, in pixels.
constexpr float kTestedEdges = 3;
/// Opacity of their faces.
constexpr std::uint8_t kTestedFaces = 50;
/// Parts of a tree's width beside the scene: smaller nodes share one.
constexpr double kParts = 400;

using Look = TreeBars::Look;

/// What became of each node of a tree up to a test: of several tests the greatest counts.
std::vector<Look> looks_of(const Tree& tree, std::span<const LessonTest> tests, bool first) {
  std::vector<Look> looks(tree.nodes.size(), Look::untouched);
  for (const LessonTest& test : tests) {
    Look& look = looks[first ? test.nodes.a : test.nodes.b];
    const Look now = test.step == LessonStep::ends     ? Look::pruned
                     : test.step == LessonStep::leaves ? Look::found
                                                       : Look::visited;
    look = std::max(look, now);
  }
  if (!tests.empty()) {
    looks[first ? tests.back().nodes.a : tests.back().nodes.b] = Look::now;
  }
  return looks;
}

TreeBars bars_of(const Tree& tree, const std::vector<Look>& looks, const std::string& name) {
  TreeBars bars;
  bars.name = name;
  std::map<std::pair<std::uint16_t, int>, Look> small;  // by level and part of the width
  const double all = tree.nodes.empty() ? 1 : std::max(tree.nodes[0].count, 1U);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    const auto level = static_cast<std::uint16_t>(std::min(node.depth, 0xfffeU));
    if (node.count / all >= 1 / kParts) {
      bars.bars.push_back({static_cast<float>(node.first / all),
                           static_cast<float>((node.first + node.count) / all), level, looks[i]});
    } else if (looks[i] != Look::untouched) {
      Look& look = small[{level, static_cast<int>(kParts * (node.first / all))}];
      look = std::max(look, looks[i]);
    }
  }
  for (const auto& [place, look] : small) {
    const auto left = static_cast<float>(place.second / kParts);
    bars.bars.push_back({left, left + static_cast<float>(1 / kParts), place.first, look});
  }
  for (const TreeBars::Bar& bar : bars.bars) {
    bars.levels = std::max(bars.levels, static_cast<std::uint16_t>(bar.level + 1));
  }
  return bars;
}

}  // namespace

void SceneSubject::prepare_lesson(const ViewState& state) {
  lesson_facts_.reset();
  const auto pair = scene_.pair();
  if (!state.learn || !pair) {
    return;
  }
  lesson_.update(scene_);
  LearnFacts& facts = lesson_facts_.emplace();
  facts.title = in_a_sentence(scene_.trees().traversal);
  const std::span<const LessonTest> tests = lesson_.tests();
  if (tests.empty()) {
    return;
  }
  facts.tests = tests.size();
  facts.test = std::min<std::uint64_t>(state.learn_step, tests.size() - 1);
  facts.sentences = lesson_.sentences(scene_, facts.test);
  const std::span<const LessonTest> done = tests.first(facts.test + 1);
  const auto bars = [&](BodyRef body, bool first) {
    const Tree& tree = scene_.tree(body);
    return bars_of(tree, looks_of(tree, done, first), scene_.body(body).name);
  };
  facts.a = bars(pair->first, true);
  facts.b = bars(pair->second, false);
}

void SceneSubject::add_lesson(DrawList& list) {
  if (!lesson_facts_ || lesson_.tests().empty()) {
    return;
  }
  const auto pair = *scene_.pair();
  const LessonTest test = lesson_.tests()[lesson_facts_->test];
  const auto add = [&](BodyRef body, std::uint32_t node, Color color) {
    const Box box = scene_.world_boxes(body)[node];
    Color face = color;
    face.a = kTestedFaces;
    list.box_groups.push_back({.style = BoxStyle::solid, .boxes = {{box, face}}});
    list.box_groups.push_back({.width = kTestedEdges, .on_top = true, .boxes = {{box, color}}});
  };
  add(pair.first, test.nodes.a, palette::kOrange);
  add(pair.second, test.nodes.b, palette::kBlue);
}

}  // namespace soms::view
