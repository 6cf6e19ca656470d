#include "soms/io/detail/collada/collada.h"

#include "soms/io/detail/collada/collada_left_out.h"
#include "soms/io/detail/collada/collada_scene.h"
#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace soms::detail {

namespace {

/// Meters a unit, 0 where the file does not say.
double read_unit(const ColladaDocument& document) {
  const pugi::xml_node unit = document.root().child("asset").child("unit");
  if (!unit) {
    return 0;
  }
  const std::string_view meter = unit.attribute("meter").as_string("1");
  const ParsedNumber parsed =
      parse_number(meter.data(), meter.data() + meter.size(), Precision::as_double);
  if (parsed.status != NumberStatus::good || parsed.end != meter.data() + meter.size() ||
      !(parsed.value > 0) || !std::isfinite(parsed.value)) {
    document.fail(unit, "the unit is " + in_quotes(meter) + " meters");
  }
  return parsed.value;
}

/// An axis that is none of COLLADA's three changes no vertex: it is noted.
UpAxis read_up(const ColladaDocument& document, MeshBuilder& builder) {
  constexpr std::array<std::pair<std::string_view, UpAxis>, 3> kAxes = {
      {{"X_UP", UpAxis::x}, {"Y_UP", UpAxis::y}, {"Z_UP", UpAxis::z}}};
  const pugi::xml_node up = document.root().child("asset").child("up_axis");
  if (!up) {
    return UpAxis::unknown;
  }
  std::string_view text = up.text().get();
  text = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
  const auto* axis = std::find_if(kAxes.begin(), kAxes.end(),
                                  [&](const auto& known) { return known.first == text; });
  if (axis == kAxes.end()) {
    LeftOut unknown;
    unknown.add([&] { return document.place_of(up) + ": " + in_quotes(text); });
    builder.note(unknown, "up axes that are not known");
    return UpAxis::unknown;
  }
  return axis->second;
}

/// The visual scene to show, or nothing where the file has none.
pugi::xml_node find_scene(const ColladaDocument& document, MeshBuilder& builder) {
  const pugi::xml_node instance = document.root().child("scene").child("instance_visual_scene");
  if (instance) {
    const pugi::xml_node shown = document.referred(instance, "url", "visual_scene");
    ColladaLeftOut others;
    document.for_each("visual_scene", [&](pugi::xml_node scene) {
      if (scene != shown) {
        others.add(scene);
      }
    });
    builder.note(others.in_line(document), "scenes that were not read");
    return shown;
  }
  const pugi::xml_node library = document.root().child("library_visual_scenes");
  const pugi::xml_node only = library.child("visual_scene");
  if (only.next_sibling("visual_scene") || library.next_sibling("library_visual_scenes")) {
    document.fail(only, "the file has several scenes and does not say which one to show",
                  "choose one with <instance_visual_scene>");
  }
  return only;
}

/// Passes a document type behind its first two bytes, <!.
void skip_doctype(std::string_view& bytes) {
  std::size_t brackets = 0;
  char quote = '\0';
  std::size_t i = 0;
  for (; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (quote != '\0') {
      quote = c == quote ? '\0' : quote;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[') {
      ++brackets;
    } else if (c == ']') {
      brackets -= brackets > 0 ? 1 : 0;
    } else if (c == '>' && brackets == 0) {
      break;
    }
  }
  bytes.remove_prefix(std::min(i + 1, bytes.size()));
}

}  // namespace

bool is_collada(std::string_view bytes) {
  const auto skip_behind = [&](std::string_view mark) {
    const std::size_t at = bytes.find(mark);
    bytes.remove_prefix(at == std::string_view::npos ? bytes.size() : at + mark.size());
  };
  while (true) {
    bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
    if (bytes.starts_with("<?")) {
      skip_behind("?>");
    } else if (bytes.starts_with("<!--")) {
      skip_behind("-->");
    } else if (bytes.starts_with("<!DOCTYPE")) {
      skip_doctype(bytes);
    } else {
      constexpr std::string_view kRoot = "<COLLADA";
      const std::string_view behind = bytes.substr(std::min(kRoot.size(), bytes.size()), 1);
      return bytes.starts_with(kRoot) &&
             (behind.empty() || is_blank(behind[0]) || is_line_end(behind[0]) || behind == ">");
    }
  }
}

Mesh read_collada(Source& source) {
  const bool allow_empty = std::exchange(source.allow_empty, true);
  ColladaDocument document(source);
  MeshBuilder builder(source);
  const double unit = read_unit(document);
  const UpAxis up = read_up(document, builder);
  show_scene(document, find_scene(document, builder), builder);
  source.allow_empty = allow_empty;
  Mesh mesh = builder.finish();
  mesh.unit = unit;
  mesh.up = up;
  return mesh;
}

}  // namespace soms::detail
