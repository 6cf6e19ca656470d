#include "soms/io/detail/format.h"

#include "soms/io/detail/cityjson/cityjson.h"
#include "soms/io/detail/collada/collada.h"
#include "soms/io/detail/file_extension.h"
#include "soms/io/detail/gltf/gltf.h"
#include "soms/io/detail/import/import.h"
#include "soms/io/detail/ply/ply.h"
#include "soms/io/detail/simple/obj.h"
#include "soms/io/detail/simple/off.h"
#include "soms/io/detail/simple/stl.h"
#include "soms/io/detail/simple/three_ds.h"
#include "soms/io/detail/text.h"
#include "soms/io/detail/tiles/tile_content.h"
#include "soms/io/detail/tiles/tileset.h"
#include "soms/io/encoding.h"

#include <algorithm>
#include <array>
#include <string>

namespace soms::detail {

namespace {

bool is_ply(std::string_view bytes) {
  return bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
}

constexpr auto kFormats = std::to_array<ReadFormat>({
    {"PLY", ".ply", is_ply, read_ply},
    {"3DS", ".3ds", is_three_ds, read_three_ds, true},
    {"STL", ".stl", is_stl, read_stl},
    {"OFF", ".off", is_off, read_off},
    {"OBJ", ".obj", is_obj, read_obj},
    {"GLB", ".glb", is_glb, read_glb, true},
    {"glTF", ".gltf", is_gltf, read_gltf},
#ifndef SOMS_WITHOUT_CITY_FORMATS
    {"CityJSON", ".json", is_cityjson, read_cityjson},
    {"3D Tiles", ".json", is_tileset, read_tileset},
    {"b3dm", ".b3dm", is_b3dm, read_tile, true},
    {"cmpt", ".cmpt", is_composite, read_tile, true},
#endif
#ifdef SOMS_USE_PUGIXML
    {"COLLADA", ".dae", is_collada, read_collada},
#endif
});

constexpr ReadFormat kImported = {"other", "", nullptr, read_import};

/// Content that is no model, or none that can be read here.
struct Foreign {
  std::string_view begin;
  std::string_view what;
  std::string_view remedy;
  /// False where formats of soms-import begin so, too.
  bool anywhere = false;
  /// Extension of a format that begins so too, and whose reader knows better what is wrong.
  std::string_view unless = {};
};

constexpr std::string_view kUnpack = "unpack it first";
constexpr std::string_view kConvert = "convert it to one of the formats that are read";
constexpr std::string_view kPage = "download the model file itself";

constexpr std::array<Foreign, 16> kForeign = {{
    {"{", "a JSON file", kConvert, false, ".gltf"},
    {"<!DOCTYPE html", "a web page", kPage, true},
    {"<!DOCTYPE HTML", "a web page", kPage, true},
    {"<!doctype html", "a web page", kPage, true},
    {"<html", "a web page", kPage, true},
    {"<", "an XML file", kConvert},
    {"version https://git-lfs", "a Git LFS pointer, not the file itself",
     "fetch the file: git lfs pull", true},
    {"\x89SOMS\r\n\x1a", "a recording of soms simulate, not a model",
     "play it with soms view, or draw a frame with soms render", true},
    {"\x89SOMT\r\n\x1a", "a tree file, not a model",
     "give its path, from which verbs of soms open it; programs call open_shape", true},
    {"i3dm", "an instanced model of 3D Tiles (i3dm)",
     "export the tiles as b3dm or glTF, with their instances as meshes", true},
    {"pnts", "a point cloud of 3D Tiles (pnts), which has no triangles",
     "give tiles with meshes (b3dm, glb)", true},
    {"\x1f\x8b", "a gzip file", kUnpack},
    {"PK\x03\x04", "a zip file", kUnpack},
    {"\xfd"
     "7zXZ",
     "an xz file", kUnpack},
    {"BZh", "a bzip2 file", kUnpack},
    {"\x28\xb5\x2f\xfd", "a zstd file", kUnpack},
}};

std::string format_list() {
  std::string list;
  for (const ReadFormat& format : kFormats) {
    list += (list.empty() ? "" : ", ") + std::string(format.name);
  }
  list += ", and by soms-import";
  for (const std::string_view extension : imported_extensions()) {
    list.append(" ").append(extension);
  }
  return list;
}

[[noreturn]] void fail_unsupported(const Source& source, const std::string& what,
                                   const std::string& remedy) {
  source.fail(ErrorKind::unsupported, what, remedy + "; formats that are read: " + format_list());
}

void refuse_foreign(const Source& source, std::string_view extension) {
  const std::size_t begin =
      std::min(source.bytes.find_first_not_of(" \t\r\n"), source.bytes.size());
  const bool imported = is_imported(extension);
  if (!imported) {
    refuse_utf16(source.bytes, source.name);
  }
  for (const Foreign& foreign : kForeign) {
    if (!source.bytes.substr(begin).starts_with(foreign.begin) || (!foreign.anywhere && imported) ||
        (!extension.empty() && extension == foreign.unless)) {
      continue;
    }
    if (foreign.begin == "<" && source.bytes.find("<robot") != std::string_view::npos) {
      source.fail(ErrorKind::unsupported, "a robot description (URDF), not a model",
                  "give the meshes that it names, one for each link");
    }
    if (foreign.remedy == kConvert) {
      fail_unsupported(source, std::string(foreign.what), std::string(foreign.remedy));
    }
    source.fail(ErrorKind::unsupported, std::string(foreign.what), std::string(foreign.remedy));
  }
}

/// STEP is a family of formats. Buildings (IFC) can be read; the exact surfaces of machine parts
/// can't, and what Assimp says of them helps nobody.
void refuse_step(const Source& source, std::string_view extension) {
  constexpr std::size_t kHeader = std::size_t{1} << 16;
  if (!source.bytes.starts_with("ISO-10303-21")) {
    return;
  }
  const std::string_view head = source.bytes.substr(0, kHeader);
  const std::size_t schemas = std::min(head.find("FILE_SCHEMA"), head.size());
  const std::size_t begin = std::min(head.find('\'', schemas), head.size() - 1) + 1;
  const std::string_view schema = head.substr(begin, head.find_first_of("' {", begin) - begin);
  if (schema.empty()) {
    return;
  }
  if (!schema.starts_with("IFC")) {
    source.fail(ErrorKind::unsupported,
                "a STEP file of the schema " + in_quotes(schema) +
                    ": exact surfaces, not triangles; of STEP only IFC is read",
                "convert it: export STL, OBJ or glTF from the CAD program, or by FreeCAD or Gmsh");
  }
  if (!is_imported(extension)) {
    source.fail(ErrorKind::unsupported, "an IFC file without the extension .ifc",
                "rename it with the extension .ifc");
  }
}

/// Words in a file that holds numbers in bytes: no reader could say where it went wrong.
void refuse_text(const Source& source, const ReadFormat& format) {
  constexpr std::size_t kFirstBytes = 256;
  const std::string_view first = source.bytes.substr(0, kFirstBytes);
  const bool begins_well = first.starts_with("MM") || is_glb(first);
  if (format.binary && !begins_well && std::none_of(first.begin(), first.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte == 0x7f || (byte < 0x20 && !is_blank(c) && !is_line_end(c));
      })) {
    source.fail(ErrorKind::bad_file, "the file is text, not " + std::string(format.name),
                "give the model file, or rename it with the extension of its format");
  }
}

}  // namespace

std::span<const ReadFormat> read_formats() {
  return kFormats;
}

const ReadFormat& identify(const Source& source) {
  if (source.bytes.empty()) {
    source.fail(ErrorKind::bad_file, "the file is empty", "get the complete file");
  }
  const auto by_content = std::find_if(kFormats.begin(), kFormats.end(), [&](const ReadFormat& f) {
    return f.recognizes(source.bytes);
  });
  const std::string extension = extension_of(source.name);
  const auto by_name = std::find_if(kFormats.begin(), kFormats.end(),
                                    [&](const ReadFormat& f) { return f.extension == extension; });
  if (by_content != kFormats.end()) {
    if (by_name != kFormats.end() && by_name->extension != by_content->extension) {
      source.fail(ErrorKind::bad_file,
                  "the content is " + std::string(by_content->name) + ", but the extension says " +
                      std::string(by_name->name),
                  "rename it with the extension " + std::string(by_content->extension));
    }
    return *by_content;
  }
  refuse_foreign(source, extension);
  refuse_step(source, extension);
  if (is_imported(extension)) {
    return kImported;
  }
  if (by_name == kFormats.end()) {
    fail_unsupported(source,
                     extension.empty() ? "unknown format, and no file extension"
                                       : "format " + in_quotes(extension) + " is not read",
                     std::string(kConvert));
  }
  refuse_text(source, *by_name);
  return *by_name;
}

}  // namespace soms::detail
