#include "soms/tree/layout/detail/block.h"

#include "tests/support/support.h"
#include "tests/tree/inputs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soms {
namespace {

void expect_same(const layout::Moments& a, const layout::Moments& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.sum, b.sum);
  EXPECT_EQ(a.square, b.square);
  EXPECT_EQ(a.product, b.product);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.area, b.area);
}

/// A frame in which the mesh is 1 to 2 long.
layout::Frame frame_of(const Mesh& mesh) {
  const Box box = bounds(mesh);
  const Vec3 extent = box.extent();
  const double size = std::max({extent.x, extent.y, extent.z});
  const double scale = size > 0 ? std::exp2(-std::floor(std::log2(size))) : 1;
  return {box.center(), scale, size * scale};
}

TEST(Block, HasTheSameBytesByEveryProcessorsInstructions) {
  for (const test::Input input : test::kInputs) {
    SCOPED_TRACE(test::name(input));
    const Mesh mesh = test::make_input(input, 64);
    const layout::Frame frame = frame_of(mesh);
    std::array<TriangleId, 8> ids = {};
    for (std::uint32_t k = 0; k < 8; ++k) {
      ids[k] = 7 * k;
    }
    for (std::size_t count = 1; count <= 8; ++count) {
      TriangleBlock plain;
      TriangleBlock fast;
      const auto run = std::span<const TriangleId>(ids).first(count);
      const layout::BlockContent a = layout::make_block_plainly(mesh, run, frame, plain);
      const layout::BlockContent b = layout::make_block(mesh, run, frame, fast);
      EXPECT_EQ(plain, fast) << count;
      expect_same(a.moments, b.moments);
      EXPECT_EQ(a.bounds, b.bounds);
    }
  }
}

// What a block's bytes are, in plain loops: lanes are added half to half, then the even ones and
// the odd ones, and of equal numbers the first is kept.
class PlainBlock {
 public:
  PlainBlock(const Mesh& mesh, std::span<const TriangleId> ids, const layout::Frame& frame)
      : frame_(frame), count_(ids.size()) {
    for (std::size_t lane = 0; lane < 8; ++lane) {
      block_.id[lane] = ids[std::min(lane, count_ - 1)];
      const Triangle t = mesh.triangle(block_.id[lane]);
      const std::array<Vec3, 3> corners{t.a, t.b, t.c};
      for (std::size_t row = 0; row < 9; ++row) {
        at_[row][lane] = corners[row / 3][row % 3] - frame.origin[row % 3];
      }
    }
    block_.count = static_cast<std::uint32_t>(count_) & 0xf;
    center();
    measure();
    store_slab();
  }

  [[nodiscard]] const TriangleBlock& block() const { return block_; }

  [[nodiscard]] const layout::Moments& moments() const { return moments_; }

 private:
  using Lanes = std::array<double, 8>;

  static double sum(const Lanes& v, std::size_t count) {
    const auto of = [&](std::size_t k) {
      return (k < count ? v[k] : 0) + (k + 4 < count ? v[k + 4] : 0);
    };
    return (of(0) + of(2)) + (of(1) + of(3));
  }

  static std::array<double, 2> range(const Lanes& a, const Lanes& b, const Lanes& c) {
    double lower = a[0];
    double upper = a[0];
    for (const Lanes* lanes : {&a, &b, &c}) {
      for (const double x : *lanes) {
        lower = std::min(lower, x);
        upper = std::max(upper, x);
      }
    }
    return {lower, upper};
  }

  void center() {
    double far = 0;
    std::array<double, 3> side = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [lower, upper] = range(at_[axis], at_[3 + axis], at_[6 + axis]);
      block_.origin[axis] = 0.5 * (lower + upper);
      side[axis] =
          std::max(upper - block_.origin[axis], block_.origin[axis] - lower) * frame_.scale;
      far += side[axis];
      for (std::size_t row = axis; row < 9; row += 3) {
        for (std::size_t lane = 0; lane < 8; ++lane) {
          at_[row][lane] = (at_[row][lane] - block_.origin[axis]) * frame_.scale;
          const auto rounded = static_cast<float>(at_[row][lane]);
          block_.corner[row][lane] = rounded;
        }
      }
    }
    give_ = frame_.doubt(far, false);
    double l1_radius = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      block_.own_half[axis] = layout::rounded_up(side[axis] + give_);
      l1_radius += static_cast<double>(block_.own_half[axis]);
    }
    block_.l1_radius = layout::rounded_up(l1_radius * (1 + 0x1p-50));
  }

  void measure() {
    moments_.points = 3 * static_cast<double>(count_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t next = (axis + 1) % 3;
      Lanes sums;
      Lanes squares;
      Lanes products;
      Lanes normals;
      Lanes sizes;
      for (std::size_t k = 0; k < 8; ++k) {
        const double a = at_[axis][k];
        const double b = at_[3 + axis][k];
        const double c = at_[6 + axis][k];
        const double p = at_[next][k];
        const double q = at_[3 + next][k];
        const double r = at_[6 + next][k];
        sums[k] = (a + b) + c;
        squares[k] = (a * a + b * b) + c * c;
        products[k] = (a * p + b * q) + c * r;
        normals[k] = (b - a) * (r - p) - (q - p) * (c - a);
        sizes[k] = std::abs(normals[k]);
      }
      moments_.sum[axis] = sum(sums, count_);
      moments_.square[axis] = sum(squares, count_);
      moments_.product[axis] = sum(products, count_);
      moments_.normal[(axis + 2) % 3] = sum(normals, count_);
      moments_.area += sum(sizes, count_);
    }
  }

  void store_slab() {
    const auto& sum = moments_.normal;
    const double most = std::max({std::abs(sum[0]), std::abs(sum[1]), std::abs(sum[2])});
    const Vec3 n = most > 0 ? Vec3{sum[0] / most, sum[1] / most, sum[2] / most} : Vec3{0, 0, 1};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      block_.normal[axis] = static_cast<float>(n[axis] / std::sqrt(dot(n, n)));
    }
    std::array<Lanes, 3> along;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t k = 0; k < 8; ++k) {
        along[corner][k] = (static_cast<double>(block_.normal[0]) * at_[3 * corner][k] +
                            static_cast<double>(block_.normal[1]) * at_[3 * corner + 1][k]) +
                           static_cast<double>(block_.normal[2]) * at_[3 * corner + 2][k];
      }
    }
    const auto [lower, upper] = range(along[0], along[1], along[2]);
    block_.lower = -layout::rounded_up(3 * give_ - lower);
    block_.upper = layout::rounded_up(3 * give_ + upper);
  }

  const layout::Frame& frame_;
  std::size_t count_;
  std::array<Lanes, 9> at_ = {};
  double give_ = 0;
  TriangleBlock block_;
  layout::Moments moments_;
};

TEST(Block, HasTheBytesOfPlainLoops) {
  for (const test::Input input : test::kInputs) {
    SCOPED_TRACE(test::name(input));
    const Mesh mesh = test::make_input(input, 64);
    const layout::Frame frame = frame_of(mesh);
    std::array<TriangleId, 8> ids = {};
    for (std::uint32_t k = 0; k < 8; ++k) {
      ids[k] = 61 - 7 * k;
    }
    for (std::size_t count = 1; count <= 8; ++count) {
      const auto run = std::span<const TriangleId>(ids).first(count);
      const PlainBlock plain(mesh, run, frame);
      TriangleBlock block;
      const layout::BlockContent content = layout::make_block(mesh, run, frame, block);
      EXPECT_EQ(block, plain.block()) << count;
      expect_same(content.moments, plain.moments());
      Box box;
      for (const TriangleId id : run) {
        box.grow(bounds(mesh.triangle(id)));
      }
      EXPECT_EQ(content.bounds, box);
    }
  }
}

}  // namespace
}  // namespace soms
