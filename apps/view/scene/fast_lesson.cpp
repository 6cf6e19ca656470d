#include "apps/view/scene/fast_lesson.h"

#include "soms/tree/layout/detail/wide_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace soms::view {

namespace {

using thesis::FastStep;
using thesis::FastTest;

std::string boxes_in_words(std::uint8_t boxes, std::uint32_t node, const std::string& body) {
  const int count = std::popcount(boxes);
  return count == 0 ? fmt::format("node {} of {} as a whole", node, body)
                    : fmt::format("{} {} of node {} of {}", count, count == 1 ? "box" : "boxes",
                                  node, body);
}

/// What is decided of the pairs of a step.
std::string meeting_in_words(const FastStep& step) {
  const auto meet = static_cast<std::uint64_t>(std::popcount(step.meet));
  const auto pairs = [](std::uint64_t count) {
    return fmt::format("{} {}", count, count == 1 ? "pair" : "pairs");
  };
  if (meet == 0) {
    return fmt::format("Of {} none meets: nothing below can touch.", pairs(step.node_tests));
  }
  return fmt::format("Of {}, {} may meet and {} looked into later{}.", pairs(step.node_tests), meet,
                     meet == 1 ? "is" : "are",
                     meet < step.node_tests ? "; below the others nothing can touch" : "");
}

/// The frame of a node's boxes in the world.
Pose frame_of(const Body& body, const Vec3& origin, const layout::Axes& axes) {
  const auto& m = body.pose.m;
  Pose pose;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      double sum = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        sum += m[4 * i + j] * static_cast<double>(axes[3 * k + j]);
      }
      pose.m[4 * i + k] = sum;
    }
  }
  const Vec3 at = body.pose.apply(origin);
  pose.m[3] = at.x;
  pose.m[7] = at.y;
  pose.m[11] = at.z;
  return pose;
}

Vec3 place_of(const WideTree& layout, const std::array<double, 3>& origin) {
  return layout.origin() + Vec3{origin[0], origin[1], origin[2]};
}

}  // namespace

std::vector<LayoutBar> bars_of(const WideTree& layout) {
  const auto nodes = layout.nodes();
  std::vector<LayoutBar> bars(nodes.size());
  std::uint64_t placed = 0;
  const auto leaf = [&](std::uint32_t token) {
    std::uint64_t count = 0;
    std::uint32_t block = token & (WideNode::kMost - 1);
    for (std::uint32_t left = layout.blocks()[block].following + 1; left > 0; --left, ++block) {
      count += layout.blocks()[block].count;
    }
    return count;
  };
  const auto visit = [&](const auto& self, std::uint32_t i, std::uint32_t level) -> void {
    bars[i] = {level, placed, 0};
    for (std::uint32_t lane = 0; lane < nodes[i].count; ++lane) {
      if ((nodes[i].leaves >> lane & 1U) != 0) {
        placed += leaf(nodes[i].child[lane]);
      } else {
        self(self, nodes[i].child[lane], level + 1);
      }
    }
    bars[i].count = placed - bars[i].first;
  };
  if (!nodes.empty()) {
    visit(visit, 0, 0);
  }
  return bars;
}

void FastLesson::update(const ViewScene& scene) {
  const auto pair = scene.pair();
  if (!pair) {
    key_.reset();
    steps_ = {};
    return;
  }
  const Body& a = scene.body(pair->first);
  const Body& b = scene.body(pair->second);
  const Key key{*pair, a.pose, b.pose, &a.shape.mesh(), &b.shape.mesh()};
  if (key_ != key) {
    steps_ = thesis::fast_steps(a, b);
    key_ = key;
  }
}

std::vector<std::string> FastLesson::sentences(const ViewScene& scene, std::size_t step) const {
  const FastStep& now = steps_.steps[step];
  const auto pair = *scene.pair();
  const std::string& a = scene.body(pair.first).name;
  const std::string& b = scene.body(pair.second).name;
  std::vector<std::string> sentences{
      fmt::format("Step {} of {}{}.", step + 1, steps_.steps.size(), steps_.cut ? " or more" : "")};
  switch (now.test) {
    case FastTest::whole:
      sentences.push_back(
          steps_.steps.size() == 1
              ? fmt::format("The boxes of {} and {} are apart: nothing touches.", a, b)
              : fmt::format("The boxes of {} and {} may meet.", a, b));
      break;
    case FastTest::one_box:
      sentences.push_back(fmt::format(
          "One body is small beside the other: as one box it goes down the other's tree, which "
          "takes {} {}.",
          now.node_tests, now.node_tests == 1 ? "test" : "tests"));
      break;
    case FastTest::large_leaves:
      sentences.push_back(fmt::format(
          "Leaves that are large beside the node that they meet: {} of their triangles are held "
          "against it. Where none is near, the pair ends.",
          now.node_tests));
      break;
    case FastTest::nodes:
    case FastTest::larger:
      sentences.push_back(fmt::format("{} against {}, all at once.",
                                      boxes_in_words(now.boxes_a, now.a, a),
                                      boxes_in_words(now.boxes_b, now.b, b)));
      sentences.push_back(meeting_in_words(now));
      break;
    case FastTest::leaves: {
      const auto count = [&](BodyRef body, std::uint32_t block) {
        return static_cast<std::uint32_t>(scene.body(body).shape.layout().blocks()[block].count);
      };
      sentences.push_back(fmt::format(
          "Two leaves: {} triangles of {} against {} of {}, each first against the slab that holds "
          "the others.",
          count(pair.first, now.a), a, count(pair.second, now.b), b));
      sentences.push_back(
          now.triangle_tests == 0
              ? "Pairs that are left wait until there are enough to compare sixteen at a time."
              : fmt::format("With those that waited, {} {} of triangles {} compared.",
                            now.triangle_tests, now.triangle_tests == 1 ? "pair" : "pairs",
                            now.triangle_tests == 1 ? "is" : "are"));
      break;
    }
  }
  sentences.push_back(fmt::format("Touching pairs known so far: {}.", now.found));
  return sentences;
}

StepBoxes FastLesson::boxes(const ViewScene& scene, std::size_t step, bool first) const {
  const FastStep& now = steps_.steps[step];
  const auto pair = *scene.pair();
  const Body& body = scene.body(first ? pair.first : pair.second);
  const WideTree& layout = body.shape.layout();
  if (now.test == FastTest::large_leaves) {
    return {};  // which they are is not known
  }
  if (now.test == FastTest::whole || now.test == FastTest::one_box) {
    return {body.pose, {body.shape.bounds()}, {}};
  }
  const double unit = 1 / layout.scale();
  const auto about = [unit](const std::array<float, 3>& c, const std::array<float, 3>& h) {
    const Vec3 center = Vec3{c[0], c[1], c[2]} * unit;
    const Vec3 half = Vec3{h[0], h[1], h[2]} * unit;
    return Box{center - half, center + half};
  };
  const std::uint32_t at = first ? now.a : now.b;
  if (now.test == FastTest::leaves) {
    const TriangleBlock& block = layout.blocks()[at];
    return {frame_of(body, place_of(layout, block.origin), {1, 0, 0, 0, 1, 0, 0, 0, 1}),
            {about({}, block.own_half)},
            {}};
  }
  const WideNode& node = layout.nodes()[at];
  StepBoxes boxes{frame_of(body, place_of(layout, node.origin), node.axes()), {}, {}};
  const std::uint8_t tested = first ? now.boxes_a : now.boxes_b;
  if (tested == 0) {
    (now.meet == 0 ? boxes.apart : boxes.meet).push_back(about({}, node.own_half()));
  }
  for (std::uint32_t k = 0; k < WideNode::kWidth; ++k) {
    if ((tested >> k & 1U) != 0) {
      const std::uint32_t met = first ? now.meet >> 4 * k & 0xfU : now.meet >> k & 0x1111U;
      (met == 0 ? boxes.apart : boxes.meet)
          .push_back(about({node.center[0][k], node.center[1][k], node.center[2][k]},
                           {node.half[0][k], node.half[1][k], node.half[2][k]}));
    }
  }
  return boxes;
}

}  // namespace soms::view
