#include "soms/io/detail/gltf/feature.h"

#include <array>
#include <span>
#include <string_view>
#include <utility>

namespace soms::detail {

namespace {

constexpr std::array<std::string_view, 12> kIds = {
    "id",        "gml:id", "gml_id",   "gmlid",     "guid",      "globalid",
    "global_id", "uuid",   "objectid", "object_id", "elementid", "element_id"};
constexpr std::array<std::string_view, 1> kNames = {"name"};
constexpr std::array<std::string_view, 2> kTypes = {"type", "class"};

bool equal_but_for_case(std::string_view a, std::string_view lower) {
  if (a.size() != lower.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const char c = a[i] >= 'A' && a[i] <= 'Z' ? static_cast<char>(a[i] - 'A' + 'a') : a[i];
    if (c != lower[i]) {
      return false;
    }
  }
  return true;
}

/// The value of the first of these columns that says something; empty if none does.
std::string_view value_of(std::span<const Attribute> columns,
                          std::span<const std::string_view> names) {
  for (const std::string_view name : names) {
    for (const Attribute& column : columns) {
      if (equal_but_for_case(column.name, name) && !column.value.empty() &&
          column.value != "null") {
        return column.value;
      }
    }
  }
  return {};
}

}  // namespace

Feature feature_of(std::vector<Attribute> columns, std::uint64_t number) {
  Feature feature;
  feature.id = value_of(columns, kIds);
  feature.name = value_of(columns, kNames);
  feature.type = value_of(columns, kTypes);
  if (feature.id.empty()) {
    feature.id = std::to_string(number);
  }
  if (feature.name.empty()) {
    feature.name = feature.id;
  }
  feature.attributes = std::move(columns);
  return feature;
}

}  // namespace soms::detail
