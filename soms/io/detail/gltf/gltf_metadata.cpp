#include "soms/io/detail/gltf/gltf_metadata.h"

#include "soms/base/text.h"
#include "soms/geometry/detail/counts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soms::detail {

namespace {

std::string_view text_or(const JsonValue& holder, std::string_view key,
                         std::string_view otherwise) {
  const std::optional<JsonValue> value = holder.find(key);
  return value ? value->text() : otherwise;
}

StoredType type_of(const JsonValue& holder, std::string_view key, std::string_view otherwise) {
  const std::string_view name = text_or(holder, key, otherwise);
  const std::optional<StoredType> type = stored_type(name);
  if (!type) {
    holder.fail(in_quotes(name) + " is not a component type");
  }
  return *type;
}

/// The largest number of a type of whole numbers, by which normalized ones are divided.
double largest_of(StoredType type) {
  const int bits = static_cast<int>(8 * type.size) - (type.kind == StoredKind::with_sign ? 1 : 0);
  return std::ldexp(1.0, bits) - 1;
}

}  // namespace

GltfPropertyTable::GltfPropertyTable(GltfBuffers& buffers, const JsonValue& schema,
                                     const JsonValue& table, LeftOut& unread)
    : count_(table.at("count").whole()) {
  const JsonValue name = table.at("class");
  const std::optional<JsonValue> classes = schema.find("classes");
  const std::optional<JsonValue> row_class = classes ? classes->find(name.text()) : std::nullopt;
  if (!row_class) {
    name.fail("the schema has no class " + in_quotes(name.text()));
  }
  const std::optional<JsonValue> properties = table.find("properties");
  if (!properties) {
    return;
  }
  const std::optional<JsonValue> stated = row_class->find("properties");
  for (const auto& [key, json] : properties->members()) {
    const std::optional<JsonValue> property = stated ? stated->find(key) : std::nullopt;
    if (!property) {
      json.fail("the class " + in_quotes(name.text()) + " has no such property");
    }
    add_column(buffers, schema, key, json, *property, unread);
  }
}

/// False for a type that is not read.
bool GltfPropertyTable::find_type(Column& column, const JsonValue& schema) const {
  const JsonValue& property = column.property;
  const std::string_view type = property.at("type").text();
  const std::optional<JsonValue> array = property.find("array");
  if (array && array->boolean()) {
    return false;
  }
  if (type == "SCALAR") {
    column.kind = Kind::number;
    column.type = type_of(property, "componentType", "");
    return true;
  }
  if (type == "STRING") {
    column.kind = Kind::text;
    return true;
  }
  if (type == "BOOLEAN") {
    column.kind = Kind::truth;
    return true;
  }
  if (type != "ENUM") {
    return false;
  }
  const JsonValue name = property.at("enumType");
  const std::optional<JsonValue> enums = schema.find("enums");
  const std::optional<JsonValue> named = enums ? enums->find(name.text()) : std::nullopt;
  if (!named) {
    name.fail("the schema has no enumeration " + in_quotes(name.text()));
  }
  column.kind = Kind::name;
  column.type = type_of(*named, "valueType", "UINT16");
  column.names = named->at("values");
  return true;
}

void GltfPropertyTable::find_values(GltfBuffers& buffers, Column& column) const {
  const auto check_size = [&](std::string_view key, std::string_view bytes, std::uint64_t needed) {
    if (needed > bytes.size()) {
      column.json.at(key).fail(std::to_string(count_) + " features need " + std::to_string(needed) +
                               " bytes, but the view has " + std::to_string(bytes.size()));
    }
  };
  // Of any element at least one bit: the count is bounded before it is multiplied.
  constexpr std::uint64_t kBits = 8;
  column.values = buffers.view(column.json.at("values")).bytes;
  switch (column.kind) {
    case Kind::number:
    case Kind::name:
      check_size("values", column.values, count_);
      check_size("values", column.values, count_ * column.type.size);
      break;
    case Kind::truth:
      check_size("values", column.values, count_ / kBits + (count_ % kBits > 0 ? 1 : 0));
      break;
    case Kind::text:
      column.offset_type = type_of(column.json, "stringOffsetType", "UINT32");
      if (column.offset_type.kind != StoredKind::whole) {
        column.json.fail("the type of string offsets must be without sign");
      }
      column.offsets = buffers.view(column.json.at("stringOffsets")).bytes;
      check_size("stringOffsets", column.offsets, count_);
      check_size("stringOffsets", column.offsets, (count_ + 1) * column.offset_type.size);
      break;
  }
}

void GltfPropertyTable::add_column(GltfBuffers& buffers, const JsonValue& schema,
                                   std::string_view name, const JsonValue& json,
                                   const JsonValue& property, LeftOut& unread) {
  Column column{.name = std::string(name), .json = json, .property = property};
  if (!find_type(column, schema)) {
    unread.add([&] { return "at " + json.path(); });
    return;
  }
  find_values(buffers, column);
  columns_.push_back(std::move(column));
}

/// A number as the schema means it: normalized, scaled and moved in double.
std::optional<std::string> GltfPropertyTable::number_value(const Column& column,
                                                           std::uint32_t number) const {
  const std::size_t at = std::size_t{number} * column.type.size;
  double value = stored_number(column.values, at, column.type);
  const auto stated = [&](std::string_view key) {
    const std::optional<JsonValue> own = column.json.find(key);
    return own ? own : column.property.find(key);
  };
  const std::optional<JsonValue> none = column.property.find("noData");
  if (none && none->number() == value) {
    const std::optional<JsonValue> otherwise = column.property.find("default");
    return otherwise ? std::optional(otherwise->as_text()) : std::nullopt;
  }
  const std::optional<JsonValue> normalized = column.property.find("normalized");
  const std::optional<JsonValue> scale = stated("scale");
  const std::optional<JsonValue> offset = stated("offset");
  const bool divided = normalized && normalized->boolean() && column.type.kind != StoredKind::real;
  if (!divided && !scale && !offset) {
    return stored_text(column.values, at, column.type);
  }
  value = divided ? std::max(value / largest_of(column.type), -1.0) : value;
  value = scale ? value * scale->number() : value;
  return shortest(offset ? value + offset->number() : value);
}

std::string GltfPropertyTable::text_value(const Column& column, std::uint32_t number) const {
  const std::size_t at = std::size_t{number} * column.offset_type.size;
  const std::uint64_t begin = stored_whole(column.offsets, at, column.offset_type);
  const std::uint64_t end =
      stored_whole(column.offsets, at + column.offset_type.size, column.offset_type);
  if (begin > end || end > column.values.size()) {
    column.json.at("stringOffsets")
        .fail("text " + std::to_string(number) + " reaches from byte " + std::to_string(begin) +
              " to " + std::to_string(end) + ", but there are " +
              std::to_string(column.values.size()) + " bytes");
  }
  return std::string(
      column.values.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin)));
}

/// The name of an enumeration's value; the number where the schema names none.
std::string GltfPropertyTable::name_value(const Column& column, std::uint32_t number) const {
  const std::size_t at = std::size_t{number} * column.type.size;
  const double value = stored_number(column.values, at, column.type);
  for (std::size_t i = 0; i < column.names->size(); ++i) {
    const JsonValue named = column.names->at(i);
    if (named.at("value").number() == value) {
      return std::string(named.at("name").text());
    }
  }
  return stored_text(column.values, at, column.type);
}

std::optional<std::string> GltfPropertyTable::value(const Column& column,
                                                    std::uint32_t number) const {
  const auto or_default = [&](std::string text) -> std::optional<std::string> {
    const std::optional<JsonValue> none = column.property.find("noData");
    if (!none || none->as_text() != text) {
      return text;
    }
    const std::optional<JsonValue> otherwise = column.property.find("default");
    return otherwise ? std::optional(otherwise->as_text()) : std::nullopt;
  };
  switch (column.kind) {
    case Kind::number:
      return number_value(column, number);
    case Kind::text:
      return or_default(text_value(column, number));
    case Kind::name:
      return or_default(name_value(column, number));
    case Kind::truth:
      return (std::uint32_t{static_cast<unsigned char>(column.values[number / 8])} >> (number % 8) &
              1U) != 0
                 ? "true"
                 : "false";
  }
  return std::nullopt;
}

Feature GltfPropertyTable::feature(std::uint32_t number) const {
  std::vector<Attribute> attributes;
  for (const Column& column : columns_) {
    if (std::optional<std::string> text = value(column, number)) {
      attributes.push_back({column.name, std::move(*text)});
    }
  }
  return feature_of(std::move(attributes), number);
}

GltfMetadata::GltfMetadata(const JsonValue& root, GltfBuffers& buffers) : buffers_(buffers) {
  const std::optional<JsonValue> extensions = root.find("extensions");
  const std::optional<JsonValue> metadata =
      extensions ? extensions->find("EXT_structural_metadata") : std::nullopt;
  if (!metadata) {
    return;
  }
  schema_ = metadata->find("schema");
  tables_ = metadata->find("propertyTables");
  if (const auto elsewhere = metadata->find("schemaUri")) {
    foreign_schemas_.add([&] { return "at " + elsewhere->path(); });
  }
}

const GltfPropertyTable& GltfMetadata::table(const JsonValue& number) {
  const std::uint64_t index = number.whole();
  if (index >= tables_->size()) {
    number.fail(index_fault("number " + std::to_string(index), "property tables", tables_->size()));
  }
  std::unique_ptr<GltfPropertyTable>& known = loaded_[index];
  if (!known) {
    known = std::make_unique<GltfPropertyTable>(
        buffers_, *schema_, tables_->at(static_cast<std::size_t>(index)), unread_);
  }
  return *known;
}

void GltfMetadata::add_notes(std::vector<std::string>& notes) const {
  add_note(notes, unread_, "properties of features that are lists, vectors or matrices, not read");
  add_note(notes, foreign_schemas_,
           "schemas of features in another file, not read: parts are nodes");
}

}  // namespace soms::detail
