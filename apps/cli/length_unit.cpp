#include "apps/cli/length_unit.h"

#include "soms/geometry/frames.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace soms::command {

double common_unit(std::span<const Body> bodies) {
  if (bodies.empty()) {
    return 0;
  }
  const double unit = bodies.front().shape.mesh().unit;
  for (const Body& body : bodies) {
    if (!(unit > 0) || !same_unit(body.shape.mesh().unit, unit)) {
      return 0;
    }
  }
  return unit;
}

std::string unit_name(double meters) {
  constexpr std::array<std::pair<double, const char*>, 6> kNames{
      {{1, "m"}, {0.001, "mm"}, {0.01, "cm"}, {0.0254, "in"}, {0.3048, "ft"}, {1000, "km"}}};
  for (const auto& [unit, name] : kNames) {
    if (meters > 0 && same_unit(meters, unit)) {
      return name;
    }
  }
  return meters > 0 ? fmt::format("units of {:.9g} m", meters) : "units";
}

std::string length_with_unit(double length, double meters_a_unit) {
  const std::string name = unit_name(meters_a_unit);
  return name == "m" && length >= 1000 ? fmt::format("{:g} km", length / 1000)
                                       : fmt::format("{:g} {}", length, name);
}

}  // namespace soms::command
