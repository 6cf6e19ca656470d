#include "soms/generate/print.h"

#include "soms/base/print_fields.h"
#include "soms/generate/city.h"
#include "soms/generate/routes.h"
#include "soms/generate/shapes.h"
#include "soms/generate/spread.h"
#include "soms/generate/urban.h"
#include "soms/geometry/print.h"

namespace soms {

std::ostream& operator<<(std::ostream& out, const City& value) {
  return out << PrintedFields("City")
                    .item(printed(value.mesh))
                    .add("options", value.options)
                    .add("street_spacing", value.street_spacing)
                    .add("street_width", value.street_width);
}

std::ostream& operator<<(std::ostream& out, const CityOptions& value) {
  return out << PrintedFields("CityOptions")
                    .add("triangles", value.triangles)
                    .add("size", value.size)
                    .add("seed", value.seed)
                    .add("streets", value.streets);
}

std::ostream& operator<<(std::ostream& out, const Route& value) {
  return out << PrintedFields("Route")
                    .item(printed_count(value.points.size(), "point", "points"))
                    .add("closed", value.closed)
                    .add("start", value.start)
                    .add("speed", value.speed)
                    .add("base", value.base);
}

std::ostream& operator<<(std::ostream& out, const SpreadOptions& value) {
  return out << PrintedFields("SpreadOptions")
                    .add("triangles", value.triangles)
                    .add("ratio", value.ratio)
                    .add("size", value.size)
                    .add("height", value.height)
                    .add("cover", value.cover)
                    .add("seed", value.seed);
}

}  // namespace soms
