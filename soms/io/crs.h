/// \file
/// Names of coordinate reference systems, and the units of those in the EPSG registry.
#pragma once

#include <string>
#include <string_view>

namespace soms {

/// The short form of a name of the EPSG registry: "EPSG:7415" for "urn:ogc:def:crs:EPSG::7415",
/// "http://www.opengis.net/def/crs/EPSG/0/7415" and "epsg: 7415"; "EPSG:28992+5709" for a compound
/// one. Any other name stays as it is, but for spaces around it.
///
/// \code{.cpp}
/// #include <soms/io/crs.h>
///
/// #include <iostream>
///
/// int main() {
///   std::cout << soms::crs_name("urn:ogc:def:crs:EPSG::7415") << '\n';  // EPSG:7415
/// }
/// \endcode
[[nodiscard]] std::string crs_name(std::string_view text);

/// What the axes of a system count.
struct CrsAxes {
  double unit = 0;      ///< meters a unit of all axes; 0: not known, or not one unit
  bool angles = false;  ///< some are angles: longitude and latitude

  [[nodiscard]] bool operator==(const CrsAxes&) const = default;
};

/// Of a name that `crs_name` gave. A system that is not in the registry, version 10.076, gives
/// unit 0 and no angles.
[[nodiscard]] CrsAxes crs_axes(std::string_view crs);

/// The note of a model whose coordinates are in such a system with angles.
[[nodiscard]] std::string angles_note(std::string_view crs);

}  // namespace soms
