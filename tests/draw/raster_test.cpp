#include "apps/draw/raster.h"

#include <gtest/gtest.h>

#include <vector>

namespace soms::command {
namespace {

TEST(Raster, TrianglesThatShareAnEdgeShareNoSample) {
  const Raster raster{-1, 2, 0.25, 16, 12};
  std::vector<int> hits(raster.columns * raster.rows);
  const auto hit = [&](std::size_t column, std::size_t row, double) {
    ++hits[row * raster.columns + column];
  };
  // A square of 8 x 8 cells whose corners and diagonal lie on samples, wound both ways.
  const Vec3 a{-0.875, 2.125, 0};
  const Vec3 b{1.125, 2.125, 0};
  const Vec3 c{1.125, 4.125, 0};
  const Vec3 d{-0.875, 4.125, 0};
  for_each_sample(raster, a, b, c, hit);
  for_each_sample(raster, d, c, a, hit);
  for (std::size_t k = 0; k < hits.size(); ++k) {
    EXPECT_EQ(hits[k], k % 16 < 8 && k / 16 < 8 ? 1 : 0) << k;
  }
}

TEST(Raster, GivesTheThirdCoordinateAtTheMiddleOfACell) {
  const Raster raster{.cell = 0.5, .columns = 8, .rows = 8};
  const auto height = [](double x, double y) { return 3 + 2 * x - y; };
  const auto at = [&](double x, double y) { return Vec3{x, y, height(x, y)}; };
  std::size_t samples = 0;
  for_each_sample(raster, at(-1, -1), at(9, 0), at(0, 9),
                  [&](std::size_t column, std::size_t row, double z) {
                    const double x = 0.25 + 0.5 * static_cast<double>(column);
                    const double y = 0.25 + 0.5 * static_cast<double>(row);
                    EXPECT_NEAR(z, height(x, y), 1e-12);
                    ++samples;
                  });
  EXPECT_EQ(samples, 64U);
}

TEST(Raster, AFlatTriangleHasNoSample) {
  std::size_t samples = 0;
  const auto use = [&](std::size_t, std::size_t, double) { ++samples; };
  const Raster raster{.columns = 9, .rows = 9};
  for_each_sample(raster, {1, 1, 0}, {4, 4, 0}, {8, 8, 0}, use);
  for_each_sample(raster, {1, 2.5, 0}, {4, 2.5, 0}, {8, 2.5, 0}, use);
  EXPECT_EQ(samples, 0U);
}

}  // namespace
}  // namespace soms::command
