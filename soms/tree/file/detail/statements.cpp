#include "soms/tree/file/detail/statements.h"

#include "soms/base/byte_fields.h"
#include "soms/tree/file/detail/head.h"

#include <array>
#include <cstdint>

namespace soms::detail {

namespace {

// Least bytes of a text, an attribute and a part.
constexpr std::size_t kText = 4;
constexpr std::size_t kAttribute = 2 * kText;
constexpr std::size_t kPart = 3 * kText + 5 * sizeof(std::uint32_t);

/// The numbers of a map conversion, in their order in the file.
template <class Conversion>
auto numbers_of(Conversion& map) {
  return std::array{&map.eastings, &map.northings, &map.height,    &map.abscissa,  &map.ordinate,
                    &map.scale,    &map.factors.x, &map.factors.y, &map.factors.z, &map.unit};
}

void put_part(std::string& bytes, const Part& part) {
  put_text(bytes, part.name);
  put_text(bytes, part.id);
  put_text(bytes, part.type);
  put(bytes, part.parent);
  put(bytes, part.first);
  put(bytes, part.count);
  put(bytes, part.continues);
  put(bytes, static_cast<std::uint32_t>(part.attributes.size()));
  for (const Attribute& attribute : part.attributes) {
    put_text(bytes, attribute.name);
    put_text(bytes, attribute.value);
  }
}

Part take_part(ByteReader& reader) {
  Part part;
  part.name = reader.text();
  part.id = reader.text();
  part.type = reader.text();
  part.parent = reader.number<std::uint32_t>();
  part.first = reader.number<std::uint32_t>();
  part.count = reader.number<std::uint32_t>();
  part.continues = reader.number<std::uint32_t>();
  part.attributes.resize(reader.count(kAttribute));
  for (Attribute& attribute : part.attributes) {
    attribute.name = reader.text();
    attribute.value = reader.text();
  }
  return part;
}

}  // namespace

std::string bytes_of_statements(const MeshView& mesh) {
  std::string bytes;
  put(bytes, mesh.unit);
  put(bytes, static_cast<std::uint32_t>(mesh.up));
  put_text(bytes, mesh.georeference.crs);
  put_text(bytes, mesh.georeference.vertical_datum);
  put(bytes, std::uint32_t{mesh.georeference.map_conversion.has_value()});
  if (mesh.georeference.map_conversion) {
    for (const double* number : numbers_of(*mesh.georeference.map_conversion)) {
      put(bytes, *number);
    }
  }
  put_text(bytes, mesh.source);
  put(bytes, static_cast<std::uint32_t>(mesh.notes.size()));
  for (const std::string& note : mesh.notes) {
    put_text(bytes, note);
  }
  put(bytes, static_cast<std::uint32_t>(mesh.parts.size()));
  for (const Part& part : mesh.parts) {
    put_part(bytes, part);
  }
  return bytes;
}

Mesh read_statements(std::string_view bytes, const std::string& name) {
  ByteReader reader(bytes);
  Mesh mesh;
  mesh.unit = reader.real();
  const auto up = reader.number<std::uint32_t>();
  mesh.georeference.crs = reader.text();
  mesh.georeference.vertical_datum = reader.text();
  if (reader.number<std::uint32_t>() != 0) {
    for (double* number : numbers_of(mesh.georeference.map_conversion.emplace())) {
      *number = reader.real();
    }
  }
  mesh.source = reader.text();
  mesh.notes.resize(reader.count(kText));
  for (std::string& note : mesh.notes) {
    note = reader.text();
  }
  const std::uint32_t parts = reader.count(kPart);
  mesh.parts.reserve(parts);
  for (std::uint32_t i = 0; i < parts && !reader.failed(); ++i) {
    mesh.parts.push_back(take_part(reader));
  }
  if (!reader.is_done() || up > static_cast<std::uint32_t>(UpAxis::z) || !(mesh.unit >= 0)) {
    fail_tree_file(name, "section statements: what it holds is not whole");
  }
  mesh.up = static_cast<UpAxis>(up);
  return mesh;
}

}  // namespace soms::detail
