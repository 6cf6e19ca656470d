#include "soms/io/detail/cityjson/cityjson_geometry.h"

#include "soms/base/decimal.h"
#include "soms/geometry/detail/counts.h"
#include "soms/io/detail/affine.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace soms::detail {

namespace {

/// Three numbers.
std::array<double, 3> three_numbers(const JsonValue& list) {
  if (list.size() != 3) {
    list.fail("expected three numbers");
  }
  return {list.at(std::size_t{0}).number(), list.at(std::size_t{1}).number(),
          list.at(std::size_t{2}).number()};
}

Vec3 vertex_at(const JsonValue& list, const CityTransform& transform) {
  const std::array<double, 3> numbers = three_numbers(list);
  Vec3 v;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    v[axis] = numbers[axis] * transform.scale[axis] + transform.translate[axis];
  }
  return v;
}

/// A level of detail as the file states it: "2.2", or a number in old files.
std::string stated_level(const JsonValue& geometry) {
  const std::optional<JsonValue> lod = geometry.find("lod");
  return lod ? lod->as_text() : std::string();
}

/// As a number. What is none is the coarsest.
double level_of(const JsonValue& geometry) {
  const std::string text = stated_level(geometry);
  double level = 0;
  const auto end = text.data() + text.size();
  const auto [at, error] = read_decimal(text.data(), end, level);
  return error == std::errc{} && at == end && level >= 0 ? level : 0;
}

/// A surface, and its number in the list of semantic surfaces, if it has one.
struct SemanticSurface {
  JsonValue rings;
  std::optional<std::size_t> number = {};
};

/// Surfaces of `list` with their numbers, which are nested as the surfaces are; null leaves out all
/// below it.
void gather_surfaces(const JsonValue& list, std::size_t depth,
                     const std::optional<JsonValue>& values, std::size_t count,
                     std::vector<SemanticSurface>& found) {
  const bool has_values = values && !values->is_null();
  if (has_values && values->size() != list.size()) {
    values->fail("there are " + std::to_string(list.size()) + " surfaces or lists of them, but " +
                 std::to_string(values->size()) + " values");
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::optional<JsonValue> value = has_values ? std::optional(values->at(i)) : std::nullopt;
    if (depth > 1) {
      gather_surfaces(list.at(i), depth - 1, value, count, found);
      continue;
    }
    SemanticSurface& surface = found.emplace_back(SemanticSurface{list.at(i)});
    if (value && !value->is_null()) {
      const std::uint64_t number = value->whole();
      if (number >= count) {
        value->fail(index_fault("number " + std::to_string(number), "surfaces", count));
      }
      surface.number = static_cast<std::size_t>(number);
    }
  }
}

/// What the file states about a semantic surface, but its type.
std::vector<Attribute> attributes_of(const JsonValue& surface) {
  std::vector<Attribute> attributes;
  for (const auto& [name, value] : surface.members()) {
    if (name != "type") {
      attributes.push_back({std::string(name), value.as_text()});
    }
  }
  return attributes;
}

Affine affine_of(const JsonValue& matrix) {
  constexpr std::size_t kNumbers = 16;
  if (matrix.size() != kNumbers) {
    matrix.fail("expected 16 numbers");
  }
  Affine affine;
  for (std::size_t i = 0; i < kNumbers; ++i) {
    const double number = matrix.at(i).number();
    if (i < affine.m.size()) {
      affine.m[i] = number;
    } else if (number != (i + 1 == kNumbers ? 1 : 0)) {
      matrix.fail(ErrorKind::unsupported, "the last row is not 0, 0, 0, 1",
                  "place the template without a projection");
    }
  }
  return affine;
}

}  // namespace

/// A template at a place, and its vertices that were added.
struct CityGeometries::Instance {
  JsonValue vertices;
  Affine affine;
  Vec3 origin;
  bool mirrors = false;
  std::unordered_map<std::uint64_t, std::uint32_t> added = {};
};

CityTransform city_transform(const JsonValue& root) {
  CityTransform transform;
  if (const std::optional<JsonValue> stated = root.find("transform")) {
    transform.scale = three_numbers(stated->at("scale"));
    transform.translate = three_numbers(stated->at("translate"));
  }
  return transform;
}

CityGeometries::CityGeometries(Source& source, const JsonValue& root,
                               const CityTransform& transform, MeshBuilder& builder,
                               CityLeftOut& left_out)
    : source_(source),
      root_(root),
      builder_(builder),
      left_out_(left_out),
      first_(static_cast<std::uint32_t>(builder.vertices().size())) {
  const JsonValue vertices = root.at("vertices");
  count_ = vertices.size();
  builder_.reserve_vertices(count_);
  for (std::size_t i = 0; i < count_; ++i) {
    if (i % kRowsPerTick == 0) {
      check(source_.limits);
    }
    add_vertex(vertex_at(vertices.at(i), transform), vertices.at(i));
  }
}

void CityGeometries::add_vertex(const Vec3& v, const JsonValue& place) {
  if (!fit_for_mesh(v)) [[unlikely]] {
    const CoordinateFault fault = describe_fault(v);
    place.fail(fault.kind, fault.what, fault.remedy);
  }
  builder_.add_vertex(v);
}

const CityGeometries::Kind* CityGeometries::kind_of(const JsonValue& geometry) {
  static constexpr std::array<Kind, 6> kKinds{{{"MultiSurface", 1, 1},
                                               {"CompositeSurface", 1, 1},
                                               {"Solid", 2, 2},
                                               {"MultiSolid", 3, 2},
                                               {"CompositeSolid", 3, 2},
                                               {"GeometryInstance", 0, 3}}};
  const std::string_view name = geometry.at("type").text();
  const auto* const kind =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return k.name == name; });
  if (kind == kKinds.end()) {
    if (name != "MultiPoint" && name != "MultiLineString") {
      geometry.at("type").fail(in_quotes(name) + " is no type of geometry");
    }
    return nullptr;
  }
  return kind;
}

JsonValue CityGeometries::template_of(const JsonValue& instance) const {
  const JsonValue number = instance.at("template");
  const JsonValue templates = root_.at("geometry-templates").at("templates");
  const std::uint64_t index = number.whole();
  if (index >= templates.size()) {
    number.fail(index_fault("number " + std::to_string(index), "templates", templates.size()));
  }
  return templates.at(static_cast<std::size_t>(index));
}

/// How detailed a geometry is; nothing if it has no areas.
std::optional<double> CityGeometries::detail_of(const JsonValue& geometry) const {
  const Kind* const kind = kind_of(geometry);
  if (kind == nullptr) {
    return std::nullopt;
  }
  if (kind->depth > 0) {
    left_out_.levels.insert(stated_level(geometry));
    return level_of(geometry);
  }
  const JsonValue shape = template_of(geometry);
  const Kind* const inner = kind_of(shape);
  if (inner != nullptr && inner->depth == 0) {
    shape.at("type").fail("a template is placed by another");
  }
  if (inner == nullptr) {
    return std::nullopt;
  }
  left_out_.levels.insert(stated_level(shape));
  return level_of(shape);
}

void CityGeometries::add(const JsonValue& object) {
  const std::optional<JsonValue> geometries = object.find("geometry");
  std::optional<std::size_t> best;
  std::pair<double, int> best_detail;
  std::size_t areas = 0;
  for (std::size_t i = 0; geometries && i < geometries->size(); ++i) {
    const JsonValue geometry = geometries->at(i);
    const std::optional<double> level = detail_of(geometry);
    if (!level) {
      left_out_.not_areas.add([&] { return "at " + geometry.path(); });
      continue;
    }
    ++areas;
    if (source_.lod && *level != *source_.lod) {
      continue;
    }
    const std::pair detail(*level, kind_of(geometry)->rank);
    if (!best || detail > best_detail) {
      best = i;
      best_detail = detail;
    }
  }
  if (areas > 0 && !best) {
    left_out_.without.add([&] { return "at " + geometries->path(); });
  }
  if (best) {
    left_out_.others.add([&] { return "at " + geometries->path(); }, areas - 1);
    add_geometry(geometries->at(*best));
  }
}

void CityGeometries::add_geometry(const JsonValue& geometry) {
  const Kind* const kind = kind_of(geometry);
  if (kind->depth == 0) {
    add_instance(geometry);
  } else {
    add_boundaries(geometry);
  }
}

void CityGeometries::add_boundaries(const JsonValue& geometry) {
  const std::size_t depth = kind_of(geometry)->depth;
  const std::optional<JsonValue> semantics =
      source_.surfaces ? geometry.find("semantics") : std::nullopt;
  if (semantics) {
    add_by_semantics(geometry.at("boundaries"), depth, *semantics);
  } else {
    add_surfaces(geometry.at("boundaries"), depth);
  }
}

/// First the surfaces without semantics, then those of one semantic surface after the other, each
/// in a part of its own.
void CityGeometries::add_by_semantics(const JsonValue& boundaries, std::size_t depth,
                                      const JsonValue& semantics) {
  const JsonValue stated = semantics.at("surfaces");
  const std::size_t count = stated.size();
  std::vector<SemanticSurface> surfaces;
  gather_surfaces(boundaries, depth, semantics.find("values"), count, surfaces);
  std::stable_sort(
      surfaces.begin(), surfaces.end(),
      [](const SemanticSurface& a, const SemanticSurface& b) { return a.number < b.number; });
  std::optional<std::size_t> open;
  for (const SemanticSurface& surface : surfaces) {
    if (surface.number != open) {
      if (open) {
        builder_.close_part();
      }
      open = surface.number;
      const JsonValue of_part = stated.at(*open);
      const std::string type(of_part.at("type").text());
      builder_.open_part(type + " " + std::to_string(*open));
      builder_.describe_part("", type, attributes_of(of_part));
    }
    add_surface(surface.rings);
  }
  if (open) {
    builder_.close_part();
  }
}

void CityGeometries::add_instance(const JsonValue& instance) {
  const JsonValue places = instance.at("boundaries");
  if (places.size() != 1) {
    places.fail("expected one vertex");
  }
  const Vec3 origin = builder_.vertices()[vertex_of(places.at(std::size_t{0}))];
  const JsonValue shape = template_of(instance);
  Instance placed{.vertices = root_.at("geometry-templates").at("vertices-templates"),
                  .affine = affine_of(instance.at("transformationMatrix")),
                  .origin = origin};
  placed.mirrors = placed.affine.mirrors();
  instance_ = &placed;
  add_boundaries(shape);
  instance_ = nullptr;
}

void CityGeometries::add_surfaces(const JsonValue& list, std::size_t depth) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (depth > 1) {
      add_surfaces(list.at(i), depth - 1);
    } else {
      add_surface(list.at(i));
    }
  }
}

void CityGeometries::add_surface(const JsonValue& rings) {
  constexpr std::uint64_t kSurfacesPerCheck = 1024;
  if (surfaces_++ % kSurfacesPerCheck == 0) {
    check(source_.limits);
  }
  corners_.clear();
  ends_.clear();
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const JsonValue ring = rings.at(i);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      corners_.push_back(vertex_of(ring.at(k)));
    }
    if (instance_ != nullptr && instance_->mirrors) {
      std::reverse(corners_.begin() + static_cast<std::ptrdiff_t>(ends_.empty() ? 0 : ends_.back()),
                   corners_.end());
    }
    ends_.push_back(corners_.size());
  }
  builder_.add_face(corners_, ends_);
}

/// A vertex of the mesh from its number in the document, or, while a template is placed, in the
/// list of templates.
std::uint32_t CityGeometries::vertex_of(const JsonValue& index) {
  const std::uint64_t number = index.whole();
  const std::uint64_t count = instance_ == nullptr ? count_ : instance_->vertices.size();
  if (number >= count) {
    index.fail(index_fault("vertex " + std::to_string(number), "vertices", count));
  }
  if (instance_ == nullptr) {
    return first_ + static_cast<std::uint32_t>(number);
  }
  const auto [place, is_new] =
      instance_->added.try_emplace(number, static_cast<std::uint32_t>(builder_.vertices().size()));
  if (is_new) {
    const JsonValue stored = instance_->vertices.at(static_cast<std::size_t>(number));
    add_vertex(instance_->affine.apply(vertex_at(stored, {})) + instance_->origin, index);
  }
  return place->second;
}

}  // namespace soms::detail
