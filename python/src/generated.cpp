// Models that are made, for examples and tests.
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/generate/statue.h"
#include "soms/generate/teapot.h"

#include "python/src/bind.h"
#include "python/src/call.h"
#include "python/src/enums.h"

#include <cstdint>
#include <memory>
#include <string>

namespace soms::python {

namespace {

std::shared_ptr<Mesh> generate(const std::string& what, std::uint64_t triangles, std::uint64_t seed,
                               double size) {
  return run(Work::many, 1, py::none(), [&](const Parallel& parallel) {
    if (what == "city") {
      CityOptions options{.size = size, .seed = seed};
      if (triangles != 0) {
        options.triangles = triangles;
      }
      return std::make_shared<Mesh>(generate_city(options, parallel).mesh);
    }
    for (const MoverKind kind : {MoverKind::car, MoverKind::person, MoverKind::drone}) {
      if (what == name(kind)) {
        return std::make_shared<Mesh>(generate_mover(kind, triangles));
      }
    }
    constexpr std::uint64_t kUsual = 2000;
    const std::uint64_t count = triangles == 0 ? kUsual : triangles;
    if (what == "knot") {
      return std::make_shared<Mesh>(generate_knot(count));
    }
    if (what == "sphere") {
      return std::make_shared<Mesh>(generate_sphere(count));
    }
    if (what == "statue") {
      return std::make_shared<Mesh>(generate_statue(count));
    }
    if (what == "teapot" && triangles == 0) {
      return std::make_shared<Mesh>(generate_teapot());
    }
    throw usage("what: \"" + what + "\"" + (what == "teapot" ? " has 6320 triangles" : ""),
                "give city, car, person, drone, knot, sphere, statue or teapot");
  });
}

}  // namespace

void bind_generated(py::module_& module) {
  module.def("generate", &generate, py::arg("what"), py::arg("triangles") = 0, py::kw_only(),
             py::arg("seed") = 1, py::arg("size") = CityOptions{}.size,
             R"(generate(what, triangles=0, *, seed=1, size=4000.0) -> Mesh

A model that is made, the same bits on every machine, in meters, z up: 'city', 'car', 'person',
'drone', 'knot', 'sphere' (radius 1), 'statue' or 'teapot'.

triangles: exactly so many; 0 for the usual number (city 1,000,000). seed, size: of a city, the side
of its square in meters. Raises Error of kind usage, which names the least and nearest count.)");
}

}  // namespace soms::python
