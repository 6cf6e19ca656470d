// Models that are made, for examples and tests.
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/generate/statue.h"
#include "soms/generate/teapot.h"

#include "python/src/call.h"
#include "python/src/enums.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace soms::python {

namespace {

/// What `generate` takes beside a name; 0 triangles are the usual number.
struct Wanted {
  std::uint64_t triangles = 0;
  CityOptions city;
};

/// A model by its name.
struct Generator {
  std::string_view name;
  Mesh (*make)(const Wanted& wanted, const Limits& limits);
};

std::uint64_t or_usual(std::uint64_t triangles) {
  constexpr std::uint64_t kUsual = 2000;
  return triangles == 0 ? kUsual : triangles;
}

Mesh make_city(const Wanted& wanted, const Limits& limits) {
  CityOptions options = wanted.city;
  if (wanted.triangles != 0) {
    options.triangles = wanted.triangles;
  }
  if (options.size == 0) {
    options.size = city_size(options.triangles);
  }
  return generate_city(options, limits).mesh;
}

Mesh make_teapot(const Wanted& wanted, const Limits&) {
  Mesh teapot = generate_teapot();
  if (wanted.triangles != 0 && wanted.triangles != teapot.triangles.size()) {
    throw usage("triangles: " + std::to_string(wanted.triangles) + " for a teapot",
                "give " + std::to_string(teapot.triangles.size()) + ", or 0");
  }
  return teapot;
}

constexpr Generator kGenerators[] = {
    {"city", &make_city},
    {"car",
     [](const Wanted& w, const Limits&) { return generate_mover(MoverKind::car, w.triangles); }},
    {"person",
     [](const Wanted& w, const Limits&) { return generate_mover(MoverKind::person, w.triangles); }},
    {"drone",
     [](const Wanted& w, const Limits&) { return generate_mover(MoverKind::drone, w.triangles); }},
    {"sedan",
     [](const Wanted& w, const Limits&) { return generate_mover(MoverKind::sedan, w.triangles); }},
    {"van",
     [](const Wanted& w, const Limits&) { return generate_mover(MoverKind::van, w.triangles); }},
    {"knot", [](const Wanted& w, const Limits&) { return generate_knot(or_usual(w.triangles)); }},
    {"sphere",
     [](const Wanted& w, const Limits&) { return generate_sphere(or_usual(w.triangles)); }},
    {"statue",
     [](const Wanted& w, const Limits&) { return generate_statue(or_usual(w.triangles)); }},
    {"teapot", &make_teapot},
};

CityStreets streets_named(const std::string& word) {
  for (const CityStreets streets : {CityStreets::paved, CityStreets::bare}) {
    if (name(streets) == word) {
      return streets;
    }
  }
  throw usage("streets: \"" + word + "\"", "give paved or bare");
}

std::shared_ptr<Mesh> generate(const std::string& what, std::uint64_t triangles, std::uint64_t seed,
                               double size, const std::string& streets) {
  const Wanted wanted{.triangles = triangles,
                      .city = {.size = size, .seed = seed, .streets = streets_named(streets)}};
  std::string names;
  for (const Generator& generator : kGenerators) {
    if (generator.name == what) {
      return run(Work::many, 1, py::none(), [&](const Limits& limits) {
        return std::make_shared<Mesh>(generator.make(wanted, limits));
      });
    }
    names += (names.empty() ? "" : ", ") + std::string(generator.name);
  }
  throw usage("what: \"" + what + "\"", "give one of " + names);
}

}  // namespace

void bind_generated(py::module_& module) {
  module.def("generate", &generate, py::arg("what"), py::arg("triangles") = 0, py::kw_only(),
             py::arg("seed") = 1, py::arg("size") = 0.0, py::arg("streets") = "paved",
             R"(generate(what, triangles=0, *, seed=1, size=0, streets='paved') -> Mesh

A model that is made, the same bits on every machine, in meters, z up: 'city', 'car', 'sedan',
'van', 'person', 'drone', 'knot', 'sphere' (radius 1), 'statue' or 'teapot'.

triangles: exactly so many; 0 for the usual number (city 1,000,000). seed, size, streets: of a city.
Its square has sides of size meters; 0 takes 3 square meters a triangle, and at least 200 m. Streets
are 'paved', with sidewalks and lane marks, or 'bare'. Raises Error of kind usage, which names the
least and nearest count.)");
}

}  // namespace soms::python
