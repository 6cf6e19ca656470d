#include "apps/rows/ray_source.h"

#include <fmt/format.h>

#include <vector>

namespace soms::command {

namespace {

RowKind rays() {
  const std::vector<Column> endless{{"ox"}, {"oy"}, {"oz"}, {"dx"}, {"dy"}, {"dz"}};
  std::vector<Column> limited = endless;
  limited.push_back({"length", true});
  return {std::string(RaySource::kNoun), {endless, limited}};
}

}  // namespace

RaySource::RaySource(const std::string& path, const Console& console)
    : RowSource(path, rays(), console) {
}

std::optional<Ray> RaySource::next() {
  const auto row = next_row();
  if (!row) {
    return std::nullopt;
  }
  Ray ray{point_of(*row, 0), {(*row)[3], (*row)[4], (*row)[5]}};
  if (ray.direction == Vec3{}) {
    refuse(ErrorKind::bad_file, "the direction is zero",
           "give dx, dy and dz that are not all zero");
  }
  if (row->size() > 6) {
    ray.length = (*row)[6];
  }
  if (ray.length < 0) {
    refuse(ErrorKind::bad_file, fmt::format("length is {}, which is negative", ray.length),
           "give 0 or more, or inf");
  }
  return ray;
}

SegmentSource::SegmentSource(const std::string& path, const Console& console)
    : RowSource(path, {std::string(kNoun), {{{"x0"}, {"y0"}, {"z0"}, {"x1"}, {"y1"}, {"z1"}}}},
                console) {
}

std::optional<Ray> SegmentSource::next() {
  const auto row = next_row();
  if (!row) {
    return std::nullopt;
  }
  return Ray::between(point_of(*row, 0), point_of(*row, 3));
}

}  // namespace soms::command
