#include "soms/geometry/georeference.h"

#include "soms/base/arithmetic.h"

#include <locale>
#include <sstream>
#include <utility>

namespace soms {

namespace {

std::string place_words(const MapConversion& map) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  constexpr int kDigits = 15;  // what text can state of a double
  out.precision(kDigits);
  out << "at east " << map.eastings << ", north " << map.northings << ", height " << map.height;
  if (map.abscissa != 1 || map.ordinate != 0) {
    out << "; x toward (" << map.abscissa << ", " << map.ordinate << ")";
  }
  if (map.scale != 1) {
    out << "; scale " << map.scale;
  }
  if (map.factors != Vec3{1, 1, 1}) {
    out << "; factors (" << map.factors.x << ", " << map.factors.y << ", " << map.factors.z << ")";
  }
  if (map.unit > 0 && map.unit != 1) {
    out << "; map units of " << map.unit << " m";
  }
  return out.str();
}

}  // namespace

Georeference scaled(Georeference georeference, double scale) {
  const PlainArithmetic plain;
  if (!georeference.empty() && scale != 1) {
    if (!georeference.map_conversion) {
      georeference.map_conversion.emplace();
    }
    MapConversion& map = *georeference.map_conversion;
    map.scale /= scale;
    // Numbers that are those of the system again are in it.
    if (!georeference.crs.empty() && map == MapConversion{.unit = map.unit}) {
      georeference.map_conversion.reset();
    }
  }
  return georeference;
}

std::string describe(const Georeference& georeference) {
  std::string text = georeference.crs;
  const auto add = [&text](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  if (!georeference.vertical_datum.empty()) {
    add("vertical datum " + georeference.vertical_datum);
  }
  if (georeference.map_conversion) {
    add("origin " + place_words(*georeference.map_conversion));
  }
  return text.empty() ? "none" : text;
}

}  // namespace soms
