#include "soms/io/formats.h"

#include "soms/io/detail/file.h"
#include "soms/io/detail/file_extension.h"
#include "soms/io/detail/format.h"
#include "soms/io/detail/import/import.h"

#include <algorithm>
#include <array>

namespace soms {

namespace {

constexpr std::string_view kJson = ".json";
constexpr std::string_view kJsonLines = ".jsonl";  // of sequences of features

constexpr std::array<WritableFormat, 8> kWritable{{
    {MeshFormat::ply, "ply", "PLY", ".ply"},
    {MeshFormat::ply_ascii, "ply-ascii", "text PLY", ""},
    {MeshFormat::three_ds, "3ds", "3DS", ".3ds", false, true},
    {MeshFormat::stl, "stl", "binary STL", ".stl", false},
    {MeshFormat::stl_ascii, "stl-ascii", "text STL", "", true, true},
    {MeshFormat::off, "off", "OFF", ".off"},
    {MeshFormat::obj, "obj", "OBJ", ".obj", true, true},
    {MeshFormat::glb, "glb", "GLB", ".glb", false, true, true},
}};

/// The extensions that are written, with commas and an "or"; `describe` makes what is reported
/// about each.
template <class Describe>
std::string list(const Describe& describe) {
  std::vector<std::string> items;
  for (const WritableFormat& row : kWritable) {
    if (!row.extension.empty()) {
      items.push_back(describe(row.extension));
    }
  }
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == items.size() ? " or " : ", ") + items[i];
  }
  return text;
}

}  // namespace

std::vector<ReadableFormat> readable_formats() {
  std::vector<ReadableFormat> formats;
  for (const detail::ReadFormat& format : detail::read_formats()) {
    formats.push_back({format.name, format.extension});
  }
  return formats;
}

std::span<const std::string_view> imported_extensions() {
  return detail::imported_extensions();
}

bool is_named_as_model(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const std::string extension = detail::extension_of(name);
  const auto formats = detail::read_formats();
  const auto imported = detail::imported_extensions();
  return !name.starts_with('.') &&
         (extension == kJsonLines ||
          std::any_of(
              formats.begin(), formats.end(),
              [&](const detail::ReadFormat& format) { return format.extension == extension; }) ||
          std::find(imported.begin(), imported.end(), extension) != imported.end());
}

bool is_model_of_folder(const std::filesystem::path& file) {
  if (!is_named_as_model(file)) {
    return false;
  }
  const std::string extension = detail::extension_of(file.filename().string());
  if (extension != kJson && extension != kJsonLines) {
    return true;
  }
  const detail::FileBytes bytes = detail::read_file(file, 0);
  const auto formats = detail::read_formats();
  return std::any_of(formats.begin(), formats.end(), [&](const detail::ReadFormat& format) {
    return format.extension == kJson && format.recognizes(bytes.view());
  });
}

std::span<const WritableFormat> writable_formats() {
  return kWritable;
}

const WritableFormat& entry(MeshFormat format) {
  return *std::find_if(kWritable.begin(), kWritable.end(),
                       [&](const WritableFormat& row) { return row.format == format; });
}

std::string writable_names() {
  return list([](std::string_view extension) {
    std::string name(extension.substr(1));
    std::transform(name.begin(), name.end(), name.begin(), [](char c) {
      return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return name;
  });
}

std::string writable_extensions() {
  return list([](std::string_view extension) { return std::string(extension); });
}

}  // namespace soms
