#include "soms/geometry/georeference.h"
#include "soms/geometry/print.h"

#include "python/src/answer.h"
#include "python/src/text.h"

#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <utility>

namespace soms::python {

namespace {

using Factors = std::array<double, 3>;

MapConversion make_conversion(double eastings, double northings, double height, double abscissa,
                              double ordinate, double scale, const Factors& factors, double unit) {
  return {.eastings = eastings,
          .northings = northings,
          .height = height,
          .abscissa = abscissa,
          .ordinate = ordinate,
          .scale = scale,
          .factors = {factors[0], factors[1], factors[2]},
          .unit = unit};
}

void bind_map_conversion(py::module_& module) {
  py::class_<MapConversion> map(
      module, "MapConversion",
      R"(MapConversion(*, eastings=0.0, northings=0.0, height=0.0, abscissa=1.0, ordinate=0.0, scale=1.0,
              factors=(1.0, 1.0, 1.0), unit=0.0)

How a file places its numbers in a map (IfcMapConversion). The origin lies at eastings, northings
and height, in units of the map; the x axis points to (abscissa, ordinate), its east and its north
part; a unit of the file, times its factor of the axis, is scale units of the map. unit: meters a
unit of the map, 0 if unknown. It is recorded, never applied.)");
  map.def(py::init(&make_conversion), py::kw_only(), py::arg("eastings") = 0.0,
          py::arg("northings") = 0.0, py::arg("height") = 0.0, py::arg("abscissa") = 1.0,
          py::arg("ordinate") = 0.0, py::arg("scale") = 1.0, py::arg("factors") = Factors{1, 1, 1},
          py::arg("unit") = 0.0);
  map.def_readonly("eastings", &MapConversion::eastings, "East coordinate of the origin.");
  map.def_readonly("northings", &MapConversion::northings, "North coordinate of the origin.");
  map.def_readonly("height", &MapConversion::height, "Height of the origin.");
  map.def_readonly("abscissa", &MapConversion::abscissa, "East part of the x axis.");
  map.def_readonly("ordinate", &MapConversion::ordinate, "North part of the x axis.");
  map.def_readonly("scale", &MapConversion::scale, "Units of the map for a unit of the file.");
  map.def_property_readonly(
      "factors",
      [](const MapConversion& m) { return py::make_tuple(m.factors.x, m.factors.y, m.factors.z); },
      "More of the scale, for each axis of the file.");
  map.def_readonly("unit", &MapConversion::unit, "Meters a unit of the map, 0 if unknown.");
  map.def(
      "__eq__", [](const MapConversion& a, const MapConversion& b) { return a == b; },
      py::is_operator());
  map.attr("__hash__") = py::none();
  map.def("__repr__", &printed<MapConversion>);
  map.def(py::pickle(
      [](const MapConversion& m) {
        return py::make_tuple(m.eastings, m.northings, m.height, m.abscissa, m.ordinate, m.scale,
                              Factors{m.factors.x, m.factors.y, m.factors.z}, m.unit);
      },
      [](const py::tuple& s) {
        return make_conversion(s[0].cast<double>(), s[1].cast<double>(), s[2].cast<double>(),
                               s[3].cast<double>(), s[4].cast<double>(), s[5].cast<double>(),
                               s[6].cast<Factors>(), s[7].cast<double>());
      }));
}

Georeference make_georeference(Text crs, Text vertical_datum, std::optional<MapConversion> map) {
  return {.crs = std::move(crs.bytes),
          .vertical_datum = std::move(vertical_datum.bytes),
          .map_conversion = map};
}

}  // namespace

void bind_georeferences(py::module_& module) {
  bind_map_conversion(module);
  py::class_<Georeference> place(module, "Georeference",
                                 R"(Georeference(crs='', vertical_datum='', map_conversion=None)

What a file states about where its numbers lie on the Earth: recorded, never applied. crs: the
coordinate reference system, 'EPSG:25833'. map_conversion: a MapConversion from the numbers to
coordinates of crs; without it they are such coordinates. False if nothing is stated.)");
  place.def(py::init(&make_georeference), py::arg("crs") = "", py::arg("vertical_datum") = "",
            py::arg("map_conversion") = py::none());
  place.def_property_readonly(
      "crs", [](const Georeference& g) { return Text{g.crs}; },
      "Name of the coordinate reference system, or an empty text.");
  place.def_property_readonly(
      "vertical_datum", [](const Georeference& g) { return Text{g.vertical_datum}; },
      "What heights begin at, if it is named apart, or an empty text.");
  place.def_readonly("map_conversion", &Georeference::map_conversion, "A MapConversion, or None.");
  place.def("__bool__", [](const Georeference& g) { return !g.empty(); });
  place.def(
      "__eq__", [](const Georeference& a, const Georeference& b) { return a == b; },
      py::is_operator());
  place.attr("__hash__") = py::none();
  place.def(
      "__str__", [](const Georeference& g) { return Text{describe(g)}; },
      "In words, as the command has them.");
  place.def("__repr__", &printed<Georeference>);
  place.def(py::pickle(
      [](const Georeference& g) {
        return py::make_tuple(Text{g.crs}, Text{g.vertical_datum}, g.map_conversion);
      },
      [](const py::tuple& s) {
        return make_georeference(s[0].cast<Text>(), s[1].cast<Text>(),
                                 s[2].cast<std::optional<MapConversion>>());
      }));
}

}  // namespace soms::python
