// What of `SceneSubject` concerns a traversal test by test.
#include "soms/tree/layout/detail/wide_tree.h"

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

/// A run of triangles of a tree in a row of its picture.
struct Part {
  double first = 0;  ///< 0 to 1, as `last`
  double last = 1;
  std::uint16_t level = 0;
};

/// The picture of a tree: each part as a bar, small ones together.
TreeBars picture_of(std::span<const Part> parts, const std::vector<Look>& looks,
                    const std::string& name, Color now) {
  TreeBars bars;
  bars.name = name;
  bars.now = now;
  std::map<std::pair<std::uint16_t, int>, Look> small;  // by level and part of the width
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = parts[i];
    if (part.last - part.first >= 1 / kParts) {
      bars.bars.push_back(
          {static_cast<float>(part.first), static_cast<float>(part.last), part.level, looks[i]});
    } else if (looks[i] != Look::untouched) {
      Look& look = small[{part.level, static_cast<int>(kParts * part.first)}];
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

std::vector<Part> parts_of(const Tree& tree) {
  std::vector<Part> parts;
  const double all = tree.nodes.empty() ? 1 : std::max(tree.nodes[0].count, 1U);
  for (const Node& node : tree.nodes) {
    parts.push_back({node.first / all, (node.first + node.count) / all,
                     static_cast<std::uint16_t>(std::min(node.depth, 0xfffeU))});
  }
  return parts;
}

std::vector<Part> parts_of(const WideTree& layout) {
  std::vector<Part> parts;
  const std::vector<LayoutBar> bars = bars_of(layout);
  const double all =
      bars.empty() ? 1 : static_cast<double>(std::max<std::uint64_t>(bars[0].count, 1));
  for (const LayoutBar& bar : bars) {
    const auto first = static_cast<double>(bar.first);
    parts.push_back({first / all, (first + static_cast<double>(bar.count)) / all,
                     static_cast<std::uint16_t>(std::min(bar.level, 0xfffeU))});
  }
  return parts;
}

/// What became of each node of a layout up to a step. Leaves are parts of their nodes.
std::vector<Look> looks_of(std::size_t nodes, std::span<const thesis::FastStep> steps, bool first) {
  using thesis::FastTest;
  std::vector<Look> looks(nodes, Look::untouched);
  for (const thesis::FastStep& step : steps) {
    if (step.test == FastTest::nodes || step.test == FastTest::larger) {
      Look& look = looks[first ? step.a : step.b];
      look = std::max(look, step.meet == 0 ? Look::pruned : Look::visited);
    }
  }
  if (!steps.empty() && steps.back().test != FastTest::leaves &&
      steps.back().test != FastTest::large_leaves) {
    looks[first ? steps.back().a : steps.back().b] = Look::now;
  }
  return looks;
}

/// Faces and edges of boxes that are tested.
void add_tested(DrawList& list, const Pose& pose, const std::vector<Box>& boxes, Color color) {
  BoxGroup faces{.pose = pose, .style = BoxStyle::solid};
  BoxGroup edges{.pose = pose, .width = kTestedEdges, .on_top = true};
  for (const Box& box : boxes) {
    faces.boxes.push_back({box, with_alpha(color, kTestedFaces)});
    edges.boxes.push_back({box, color});
  }
  list.box_groups.push_back(std::move(faces));
  list.box_groups.push_back(std::move(edges));
}

}  // namespace

void SceneSubject::prepare_lesson(const ViewState& state) {
  lesson_facts_.reset();
  const auto pair = scene_.pair();
  if (!state.learn || !pair) {
    return;
  }
  lesson_facts_.emplace().title = in_a_sentence(scene_.trees().traversal);
  if (scene_.trees().traversal.traversal == Traversal::fast) {
    prepare_fast_lesson(state);
    return;
  }
  lesson_.update(scene_);
  LearnFacts& facts = *lesson_facts_;
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
    return picture_of(parts_of(tree), looks_of(tree, done, first), scene_.body(body).name,
                      first ? ViewColors{}.tested_a : ViewColors{}.tested_b);
  };
  facts.a = bars(pair->first, true);
  facts.b = bars(pair->second, false);
}

void SceneSubject::prepare_fast_lesson(const ViewState& state) {
  fast_lesson_.update(scene_);
  const std::span<const thesis::FastStep> steps = fast_lesson_.steps();
  if (steps.empty()) {
    return;
  }
  LearnFacts& facts = *lesson_facts_;
  facts.tests = steps.size();
  facts.test = std::min<std::uint64_t>(state.learn_step, steps.size() - 1);
  facts.sentences = fast_lesson_.sentences(scene_, facts.test);
  const std::span<const thesis::FastStep> done = steps.first(facts.test + 1);
  const auto bars = [&](BodyRef body, bool first) {
    const WideTree& layout = scene_.body(body).shape.layout();
    return picture_of(parts_of(layout), looks_of(layout.nodes().size(), done, first),
                      scene_.body(body).name,
                      first ? ViewColors{}.tested_a : ViewColors{}.tested_b);
  };
  const auto pair = *scene_.pair();
  facts.a = bars(pair.first, true);
  facts.b = bars(pair.second, false);
}

void SceneSubject::add_lesson(DrawList& list) {
  if (!lesson_facts_ || lesson_facts_->tests == 0) {
    return;
  }
  if (scene_.trees().traversal.traversal == Traversal::fast) {
    add_fast_lesson(list);
    return;
  }
  const auto pair = *scene_.pair();
  const LessonTest test = lesson_.tests()[lesson_facts_->test];
  const ViewColors colors;
  add_tested(list, {}, {scene_.world_boxes(pair.first)[test.nodes.a]}, colors.tested_a);
  add_tested(list, {}, {scene_.world_boxes(pair.second)[test.nodes.b]}, colors.tested_b);
}

void SceneSubject::add_fast_lesson(DrawList& list) const {
  const ViewColors colors;
  for (const bool first : {true, false}) {
    const StepBoxes boxes = fast_lesson_.boxes(scene_, lesson_facts_->test, first);
    add_tested(list, boxes.pose, boxes.meet, first ? colors.tested_a : colors.tested_b);
    if (!boxes.apart.empty()) {
      BoxGroup apart{.pose = boxes.pose, .on_top = true};
      for (const Box& box : boxes.apart) {
        apart.boxes.push_back({box, colors.pruned});
      }
      list.box_groups.push_back(std::move(apart));
    }
  }
}

}  // namespace soms::view
