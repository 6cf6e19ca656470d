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

TEST(Block, HasTheSameBytesByEveryProcessorsInstructions) {
  for (const test::Input input : test::kInputs) {
    SCOPED_TRACE(test::name(input));
    const Mesh mesh = test::make_input(input, 64);
    const Box box = bounds(mesh);
    const Vec3 extent = box.extent();
    const double size = std::max({extent.x, extent.y, extent.z});
    const double scale = size > 0 ? std::exp2(-std::floor(std::log2(size))) : 1;
    const layout::Frame frame{box.center(), scale, size * scale};
    std::array<TriangleId, 8> ids = {};
    for (std::uint32_t k = 0; k < 8; ++k) {
      ids[k] = 7 * k;
    }
    for (std::size_t count = 1; count <= 8; ++count) {
      TriangleBlock plain;
      TriangleBlock fast;
      const auto run = std::span<const TriangleId>(ids).first(count);
      const layout::Moments a = layout::make_block_plainly(mesh, run, frame, plain);
      const layout::Moments b = layout::make_block(mesh, run, frame, fast);
      EXPECT_EQ(plain, fast) << count;
      expect_same(a, b);
    }
  }
}

}  // namespace
}  // namespace soms
