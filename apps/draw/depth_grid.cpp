#include "apps/draw/depth_grid.h"

#include <cmath>
#include <limits>

namespace soms::look {

DepthGrid::DepthGrid(const command::Raster& raster)
    : raster_(raster),
      shown_(raster.columns * raster.rows, kNothing),
      depths_(shown_.size(), std::numeric_limits<double>::infinity()) {
}

void DepthGrid::draw(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t number) {
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (!(std::fabs(area) > 0) || !std::isfinite(area)) {
    return;
  }
  command::for_each_sample(raster_, a, b, c,
                           [&](std::size_t column, std::size_t row, double depth) {
                             const std::size_t at = row * raster_.columns + column;
                             if (depth <= depths_[at]) {
                               depths_[at] = depth;
                               shown_[at] = number;
                             }
                           });
}

}  // namespace soms::look
