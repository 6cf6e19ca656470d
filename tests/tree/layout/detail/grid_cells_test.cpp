#include "soms/tree/layout/detail/grid_cells.h"

#include "soms/tree/layout/detail/block.h"
#include "soms/tree/layout/detail/frame.h"

#include "tests/support/support.h"
#include "tests/tree/inputs.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace soms {
namespace {

using layout::GridCells;
using layout::GridFrame;

/// Number by number.
GridCells plain_cells(const TriangleBlock& block, const GridFrame& frame) {
  GridCells cells;
  const double give = 0x1p-23 * static_cast<double>(block.l1_radius);
  for (std::size_t lane = 0; lane < 8; ++lane) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t axis = frame.axis[i];
      const double at = block.origin[axis] * frame.scale;
      const auto& q = block.corner;
      const auto [least, most] = std::minmax({q[axis][lane], q[3 + axis][lane], q[6 + axis][lane]});
      const double lower = at + (static_cast<double>(least) - give);
      const double upper = at + (static_cast<double>(most) + give);
      if (i == 2) {
        cells.least[lane] = -layout::rounded_up(-lower);
        cells.most[lane] = layout::rounded_up(upper);
        continue;
      }
      const auto cell = [&](double x) {
        const double place = (x - frame.corner[i]) * frame.cells_a_unit;
        return static_cast<std::uint32_t>(std::clamp(place, 0.0, frame.last[i]));
      };
      cells.from[i][lane] = cell(lower);
      cells.to[i][lane] = cell(upper);
    }
  }
  return cells;
}

TEST(GridCells, AreThoseOfPlainNumbersByEveryProcessorsInstructions) {
  test::for_each_case("grid_cells", 300, [](Rng& rng) {
    const test::Input input = test::kInputs[rng.below(test::kInputs.size())];
    const Mesh mesh = test::make_input(input, 40, rng.below(1000));
    const Vec3 extent = bounds(mesh).extent();
    const double size = std::max({extent.x, extent.y, extent.z});
    const double scale = size > 0 ? std::exp2(-std::floor(std::log2(size))) : 1;
    const layout::Frame in_mesh{bounds(mesh).center(), scale, size * scale};
    std::vector<TriangleId> ids(1 + rng.below(8));
    for (TriangleId& id : ids) {
      id = static_cast<TriangleId>(rng.below(40));
    }
    TriangleBlock block;
    static_cast<void>(layout::make_block(mesh, ids, in_mesh, block));
    // Grids that the block lies beside, too.
    const double unit = std::exp2(rng.uniform(-3, 20));
    const GridFrame frame{{rng.below(3), rng.below(3), rng.below(3)},
                          {rng.uniform(-1, 1), rng.uniform(-1, 1)},
                          {std::floor(unit), std::floor(unit * rng.unit())},
                          unit,
                          scale};
    GridCells cells;
    layout::find_cells(block, frame, cells);
    EXPECT_EQ(cells, plain_cells(block, frame));
    GridCells by_all;
    layout::find_cells_plainly(block, frame, by_all);
    EXPECT_EQ(cells, by_all);
  });
}

}  // namespace
}  // namespace soms
