#include "soms/io/detail/gltf/gltf_frame.h"

#include "soms/base/decimal.h"
#include "soms/io/crs.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace soms::detail {

namespace {

struct NumberField {
  std::string_view name;
  double MapConversion::*value;
};

/// Names in files: those of the struct.
constexpr std::array kNumbers = {
    NumberField{"eastings", &MapConversion::eastings},
    NumberField{"northings", &MapConversion::northings},
    NumberField{"height", &MapConversion::height},
    NumberField{"abscissa", &MapConversion::abscissa},
    NumberField{"ordinate", &MapConversion::ordinate},
    NumberField{"scale", &MapConversion::scale},
    NumberField{"unit", &MapConversion::unit},
};

UpAxis read_up_axis(const JsonValue& up) {
  const std::string_view axis = up.text();
  if (axis != "x" && axis != "y" && axis != "z" && axis != "unknown") {
    up.fail("the up axis must be x, y, z or unknown");
  }
  constexpr std::array kAxes{UpAxis::x, UpAxis::y, UpAxis::z};
  return axis.size() == 1 ? kAxes[static_cast<std::size_t>(axis[0] - 'x')] : UpAxis::unknown;
}

/// A member; nothing where it is not there or null.
std::optional<JsonValue> stated(const JsonValue& json, std::string_view name) {
  std::optional<JsonValue> value = json.find(name);
  return value && !value->is_null() ? value : std::nullopt;
}

MapConversion read_map_conversion(const JsonValue& json) {
  MapConversion map;
  for (const NumberField& field : kNumbers) {
    if (const auto value = stated(json, field.name)) {
      map.*field.value = value->number();
    }
  }
  if (const auto factors = stated(json, "factors")) {
    if (factors->size() != 3) {
      factors->fail("the factors must be three numbers");
    }
    map.factors = {factors->at(0).number(), factors->at(1).number(), factors->at(2).number()};
  }
  return map;
}

Georeference read_georeference(const JsonValue& json) {
  Georeference georeference;
  for (const auto& [name, text] : {std::pair{"crs", &georeference.crs},
                                   std::pair{"vertical_datum", &georeference.vertical_datum}}) {
    if (const auto value = stated(json, name)) {
      *text = value->text();
    }
  }
  georeference.crs = crs_name(georeference.crs);
  if (const auto map = stated(json, "map_conversion")) {
    georeference.map_conversion = read_map_conversion(*map);
  }
  return georeference;
}

std::string shortest(double value) {
  std::array<char, 32> digits{};
  return {digits.data(), write_shortest(digits.data(), digits.data() + digits.size(), value)};
}

/// Members of a JSON object.
class Members {
 public:
  void add(std::string_view name, const std::string& value) {
    text_.append(text_.empty() ? "" : ",").append(json_text(name)).append(":").append(value);
  }

  [[nodiscard]] bool empty() const { return text_.empty(); }

  [[nodiscard]] std::string object() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

std::string map_conversion_json(const MapConversion& map) {
  Members members;
  for (const NumberField& field : kNumbers) {
    members.add(field.name, shortest(map.*field.value));
  }
  std::string factors;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    factors.append(axis == 0 ? "[" : ",").append(shortest(map.factors[axis]));
  }
  members.add("factors", factors.append("]"));
  return members.object();
}

std::string georeference_json(const Georeference& georeference) {
  Members members;
  if (!georeference.crs.empty()) {
    members.add("crs", json_text(georeference.crs));
  }
  if (!georeference.vertical_datum.empty()) {
    members.add("vertical_datum", json_text(georeference.vertical_datum));
  }
  if (georeference.map_conversion) {
    members.add("map_conversion", map_conversion_json(*georeference.map_conversion));
  }
  return members.object();
}

}  // namespace

void read_gltf_frame(const JsonValue& root, Mesh& mesh) {
  mesh.unit = 1;
  mesh.up = UpAxis::y;
  const std::optional<JsonValue> extras = root.at("asset").find("extras");
  const std::optional<JsonValue> own =
      extras && extras->is_object() ? extras->find("soms") : std::nullopt;
  if (!own || !own->is_object()) {
    return;
  }
  if (const std::optional<JsonValue> unit = own->find("unit")) {
    mesh.unit = unit->number();
    if (!(mesh.unit >= 0)) {
      unit->fail("the unit must be 0 or more");
    }
  }
  if (const std::optional<JsonValue> up = own->find("up")) {
    mesh.up = read_up_axis(*up);
  }
  if (const auto georeference = stated(*own, "georeference")) {
    mesh.georeference = read_georeference(*georeference);
  }
}

std::string gltf_frame_extras(const MeshView& mesh) {
  Members members;
  if (mesh.unit != 1) {
    members.add("unit", shortest(mesh.unit > 0 ? mesh.unit : 0));
  }
  if (mesh.up != UpAxis::y) {
    members.add("up", mesh.up == UpAxis::x   ? "\"x\""
                      : mesh.up == UpAxis::z ? "\"z\""
                                             : "\"unknown\"");
  }
  if (!mesh.georeference.empty()) {
    members.add("georeference", georeference_json(mesh.georeference));
  }
  return members.empty() ? std::string() : ",\"extras\":{\"soms\":" + members.object() + "}";
}

}  // namespace soms::detail
