#include "python/src/query/ray_arguments.h"

#include "python/src/call.h"

#include <string>

namespace soms::python {

namespace {

/// Rows of three numbers, of which there may be one without brackets of its own.
std::vector<Vec3> rows_of(const py::object& given, const char* what, bool& is_one) {
  const Doubles numbers = doubles_of(given, what);
  is_one = is_point(numbers);
  return is_one ? std::vector{point_of(numbers, what)} : points_of(numbers, what).copied();
}

std::vector<double> lengths_of(const py::object& given, std::size_t count) {
  const Doubles numbers = doubles_of(given, "lengths");
  if (numbers.ndim() == 0) {
    return std::vector(count, *numbers.data());
  }
  if (numbers.ndim() != 1 || static_cast<std::size_t>(numbers.shape(0)) != count) {
    refuse_shape(numbers, "lengths", "a number, or one for each ray");
  }
  return {numbers.data(), numbers.data() + numbers.size()};
}

void check_same(std::size_t origins, bool one_origin, std::size_t others, bool one_other,
                const char* what) {
  if (origins != others || one_origin != one_other) {
    throw usage(std::to_string(origins) + " origins, " + std::to_string(others) + " " + what,
                "give arrays of the same shape");
  }
}

}  // namespace

RayArguments rays_of(const py::object& origins, const py::object& directions,
                     const py::object& ends, const py::object& lengths) {
  if (directions.is_none() == ends.is_none()) {
    throw usage("rays: directions and ends", "give one of the two");
  }
  RayArguments arguments;
  const std::vector<Vec3> from = rows_of(origins, "origins", arguments.is_one);
  bool is_one = false;
  if (!ends.is_none()) {
    const std::vector<Vec3> to = rows_of(ends, "ends", is_one);
    check_same(from.size(), arguments.is_one, to.size(), is_one, "ends");
    for (std::size_t i = 0; i < from.size(); ++i) {
      arguments.rays.push_back(Ray::between(from[i], to[i]));
    }
    return arguments;
  }
  const std::vector<Vec3> along = rows_of(directions, "directions", is_one);
  check_same(from.size(), arguments.is_one, along.size(), is_one, "directions");
  const std::vector<double> length = lengths_of(lengths, from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    arguments.rays.push_back({from[i], along[i], length[i]});
  }
  return arguments;
}

RayOptions ray_options(const py::object& skip) {
  RayOptions options;
  if (!skip.is_none()) {
    Extents shape;
    const std::vector<TriangleId> ids = ids_of(skip, "skip", shape);
    if (!shape.empty()) {
      throw usage("skip: more than a number", "give the number of one triangle, or None");
    }
    options.skip = ids.front();
  }
  return options;
}

}  // namespace soms::python
