#include "soms/tree/layout/detail/node_boxes.h"

#include "soms/tree/layout/detail/block.h"

#include "tests/support/support.h"
#include "tests/tree/inputs.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace soms {
namespace {

using layout::Axes;
using layout::LaneContent;

/// Leaves of up to eight triangles of a mesh, as lanes of one node.
class FewLanes {
 public:
  FewLanes(const Mesh& mesh, std::size_t lanes, std::size_t each) {
    const Box box = bounds(mesh);
    const Vec3 extent = box.extent();
    const double size = std::max({extent.x, extent.y, extent.z});
    frame_ = {box.center(), size > 0 ? std::exp2(-std::floor(std::log2(size))) : 1, 0};
    frame_.size = size * frame_.scale;
    blocks_.resize(lanes);
    TriangleId next = 0;
    Box whole;
    for (std::size_t k = 0; k < lanes; ++k) {
      std::vector<TriangleId> ids;
      for (std::size_t i = 0; i < each; ++i) {
        ids.push_back(next++);
        corners_.push_back({k, mesh.triangle(ids.back())});
      }
      const layout::BlockContent content = layout::make_block(mesh, ids, frame_, blocks_[k]);
      lanes_.push_back({content.bounds, std::span(blocks_).subspan(k, 1)});
      whole.grow(content.bounds);
    }
    node_.count = static_cast<std::uint8_t>(lanes);
    node_.origin = frame_.middle(whole);
  }

  [[nodiscard]] WideNode node(const Axes& axes, bool plainly = false) const {
    WideNode node = node_;
    (plainly ? &layout::set_boxes_plainly : &layout::set_boxes)(lanes_, axes, frame_, node);
    return node;
  }

  void expect_held_by(const WideNode& node) const {
    for (const Corner& corner : corners_) {
      for (const Vec3& v : {corner.triangle.a, corner.triangle.b, corner.triangle.c}) {
        const Vec3 seen = layout::along(node.axes(), frame_.local(v, node.origin));
        double norm = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto center = static_cast<double>(node.center[axis][corner.lane]);
          EXPECT_LE(std::abs(seen[axis] - center),
                    static_cast<double>(node.half[axis][corner.lane]));
          EXPECT_LE(std::abs(seen[axis]), static_cast<double>(node.row[axis][3]));
          norm += std::abs(seen[axis]);
        }
        EXPECT_LE(norm, static_cast<double>(node.l1_radius));
      }
    }
  }

 private:
  struct Corner {
    std::size_t lane;
    Triangle triangle;
  };

  layout::Frame frame_;
  std::vector<TriangleBlock> blocks_;
  std::vector<LaneContent> lanes_;
  std::vector<Corner> corners_;
  WideNode node_;
};

/// A turn by about 0.6 about a slanted axis.
constexpr Axes kTurned = {0.8862F,  -0.3268F, 0.3284F, 0.3936F, 0.9020F,
                          -0.1772F, -0.2383F, 0.2863F, 0.9280F};

TEST(NodeBoxes, AreTheSameByEveryProcessorsInstructions) {
  for (const test::Input input : test::kInputs) {
    const Mesh mesh = test::make_input(input, 32);
    for (std::size_t lanes = 1; lanes <= 4; ++lanes) {
      for (const std::size_t each : {1U, 5U, 8U}) {
        SCOPED_TRACE(test::name(input) + " " + std::to_string(lanes));
        const FewLanes few(mesh, lanes, each);
        for (const Axes& axes : {layout::kMeshAxes, kTurned}) {
          EXPECT_EQ(few.node(axes), few.node(axes, true));
        }
      }
    }
  }
}

TEST(NodeBoxes, HoldAllCornersOfTheirLanes) {
  for (const test::Input input : test::kInputs) {
    SCOPED_TRACE(test::name(input));
    const Mesh mesh = test::make_input(input, 32);
    for (std::size_t lanes = 1; lanes <= 4; ++lanes) {
      const FewLanes few(mesh, lanes, 8);
      const WideNode node = few.node(layout::kMeshAxes);
      EXPECT_EQ(node.oriented, 0);
      few.expect_held_by(node);
    }
  }
}

/// Triangles along a slanted line, which fill small boxes along its axis.
Mesh slanted(const Vec3& along) {
  Mesh mesh;
  Rng rng(7);
  for (std::uint32_t i = 0; i < 32; ++i) {
    for (int c = 0; c < 3; ++c) {
      const Vec3 beside{rng.uniform(-0.01, 0.01), rng.uniform(-0.01, 0.01),
                        rng.uniform(-0.01, 0.01)};
      mesh.vertices.push_back(rng.uniform(-1, 1) * along + beside);
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TEST(NodeBoxes, TurnWhereTheyGetATenthSmallerByIt) {
  const Mesh mesh = slanted({kTurned[0], kTurned[3], kTurned[6]});
  for (std::size_t lanes = 1; lanes <= 4; ++lanes) {
    const FewLanes few(mesh, lanes, 8);
    const WideNode turned = few.node(kTurned);
    EXPECT_EQ(turned.oriented, 1);
    EXPECT_EQ(turned.axes(), kTurned);
    few.expect_held_by(turned);
    for (std::size_t k = 0; k < lanes; ++k) {
      EXPECT_LT(turned.half[1][k], 0.02F);
      EXPECT_LT(turned.half[2][k], 0.02F);
    }
  }
  const FewLanes straight(slanted({1, 0, 0}), 4, 8);
  EXPECT_EQ(straight.node(kTurned), straight.node(layout::kMeshAxes));
}

TEST(NodeBoxes, LeaveLanesThatAreNotInUseEmpty) {
  const FewLanes few(slanted({kTurned[0], kTurned[3], kTurned[6]}), 2, 8);
  for (const Axes& axes : {layout::kMeshAxes, kTurned}) {
    const WideNode node = few.node(axes);
    EXPECT_EQ(node.oriented, axes == kTurned ? 1 : 0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const std::size_t k : {2U, 3U}) {
        EXPECT_EQ(node.center[axis][k], 0);
        EXPECT_EQ(node.half[axis][k], 0);
      }
    }
  }
}

}  // namespace
}  // namespace soms
