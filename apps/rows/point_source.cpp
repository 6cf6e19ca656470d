#include "apps/rows/point_source.h"

namespace soms::command {

PointSource::PointSource(const std::string& path, const Console& console)
    : RowSource(path, {std::string(kNoun), {{{"x"}, {"y"}, {"z"}}}}, console) {
}

std::optional<Vec3> PointSource::next() {
  const auto row = next_row();
  return row ? std::optional(point_of(*row, 0)) : std::nullopt;
}

}  // namespace soms::command
