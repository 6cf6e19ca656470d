#include "soms/io/detail/tiles/batch_table.h"

#include <optional>
#include <utility>

namespace soms::detail {

namespace {

/// Numbers in a value of such a type; 0 if it is none.
std::size_t numbers_in(std::string_view type) {
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
}

}  // namespace

BatchTable::BatchTable(Source& source, std::uint64_t length, FileSection json,
                       std::string_view binary)
    : length_(length), binary_(binary) {
  // Zeros and blanks fill the table up to a multiple of eight bytes.
  const std::size_t end = json.bytes.find_last_not_of(std::string_view("\0 ", 2)) + 1;
  if (end == 0) {
    return;
  }
  document_ = std::make_unique<JsonDocument>(source, json.bytes.substr(0, end), json.at, true,
                                             "batch table");
  for (const auto& [name, value] : document_->root().members()) {
    if (name == "HIERARCHY" ||
        (name == "extensions" && value.find("3DTILES_batch_table_hierarchy"))) {
      hierarchies_.add([&, place = value.path()] { return "at " + place + " of the batch table"; });
    } else if (name != "extensions" && name != "extras") {
      if (!source.budget.take(sizeof(Column) + name.size())) {
        source.fail_memory(sizeof(Column) + name.size());
      }
      add_column(name, value);
    }
  }
}

void BatchTable::add_column(std::string_view name, const JsonValue& json) {
  if (json.is_object()) {
    columns_.push_back(binary_column(name, json));
    return;
  }
  if (json.size() != length_) {
    json.fail(std::to_string(json.size()) + " values, but BATCH_LENGTH is " +
              std::to_string(length_));
  }
  columns_.push_back({std::string(name), json});
}

BatchTable::Column BatchTable::binary_column(std::string_view name, const JsonValue& json) const {
  const JsonValue component = json.at("componentType");
  const std::optional<StoredType> type = stored_type(component.text());
  if (!type) {
    component.fail(in_quotes(component.text()) + " is not a component type");
  }
  const std::size_t count = numbers_in(json.at("type").text());
  if (count == 0) {
    json.at("type").fail(in_quotes(json.at("type").text()) + " is not a type of batch properties");
  }
  const std::uint64_t at = json.at("byteOffset").whole();
  const std::uint64_t row = count * type->size;
  if (at > binary_.size() || length_ > (binary_.size() - at) / row) {
    json.fail(std::to_string(length_) + " values of " + std::to_string(row) + " bytes from byte " +
              std::to_string(at) + ", but the table's numbers have " +
              std::to_string(binary_.size()) + " bytes");
  }
  return {std::string(name), json, static_cast<std::size_t>(at), count, *type};
}

std::string BatchTable::value(const Column& column, std::uint32_t batch) const {
  if (column.count == 0) {
    return column.json.at(std::size_t{batch}).as_text();
  }
  const std::size_t row = column.at + std::size_t{batch} * column.count * column.type.size;
  if (column.count == 1) {
    return stored_text(binary_, row, column.type);
  }
  std::string text = "[";
  for (std::size_t i = 0; i < column.count; ++i) {
    text.append(i == 0 ? "" : ",");
    text.append(stored_text(binary_, row + i * column.type.size, column.type));
  }
  text.append("]");
  return text;
}

Feature BatchTable::feature(std::uint32_t batch) const {
  std::vector<Attribute> attributes;
  attributes.reserve(columns_.size());
  for (const Column& column : columns_) {
    attributes.push_back({column.name, value(column, batch)});
  }
  return feature_of(std::move(attributes), batch);
}

void BatchTable::add_notes(std::vector<std::string>& notes) const {
  add_note(notes, hierarchies_, "batch table hierarchies, not read");
}

}  // namespace soms::detail
