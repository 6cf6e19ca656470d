#include "soms/io/detail/format.h"

#include "soms/io/detail/collada.h"
#include "soms/io/detail/ending.h"
#include "soms/io/detail/gltf.h"
#include "soms/io/detail/import.h"
#include "soms/io/detail/obj.h"
#include "soms/io/detail/off.h"
#include "soms/io/detail/ply.h"
#include "soms/io/detail/stl.h"
#include "soms/io/detail/three_ds.h"

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
    {"3DS", ".3ds", is_three_ds, read_three_ds},
    {"STL", ".stl", is_stl, read_stl},
    {"OFF", ".off", is_off, read_off},
    {"OBJ", ".obj", is_obj, read_obj},
    {"GLB", ".glb", is_glb, read_glb},
    {"glTF", ".gltf", is_gltf, read_gltf},
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
  /// Ending of a format that begins so too, and whose reader knows better what is wrong.
  std::string_view unless = {};
};

constexpr std::string_view kUnpack = "unpack it first";
constexpr std::string_view kConvert = "convert it to one of the formats that are read";

constexpr std::array<Foreign, 13> kForeign = {{
    {"{", "a JSON file", kConvert, ".gltf"},
    {"<!DOCTYPE", "a web page", "get the file that the page offers"},
    {"<!doctype", "a web page", "get the file that the page offers"},
    {"<html", "a web page", "get the file that the page offers"},
    {"<", "an XML file", kConvert},
    {"version https://git-lfs", "the pointer that Git LFS keeps in place of a file",
     "fetch the file: git lfs pull"},
    {"\x1f\x8b", "a gzip file", kUnpack},
    {"PK\x03\x04", "a zip file", kUnpack},
    {"\xfd"
     "7zXZ",
     "an xz file", kUnpack},
    {"BZh", "a bzip2 file", kUnpack},
    {"\x28\xb5\x2f\xfd", "a zstd file", kUnpack},
    {"\xff\xfe", "text in UTF-16", "save it as ASCII or UTF-8"},
    {"\xfe\xff", "text in UTF-16", "save it as ASCII or UTF-8"},
}};

std::string format_list() {
  std::string list;
  for (const ReadFormat& format : kFormats) {
    list += (list.empty() ? "" : ", ") + std::string(format.name);
  }
  return list;
}

[[noreturn]] void fail_unsupported(const Source& source, const std::string& what,
                                   const std::string& remedy) {
  source.fail(ErrorKind::unsupported, what, remedy + "; formats that are read: " + format_list());
}

}  // namespace

const ReadFormat& identify(const Source& source) {
  if (source.bytes.empty()) {
    source.fail(ErrorKind::bad_file, "the file is empty", "get the file whole");
  }
  const auto by_content = std::find_if(kFormats.begin(), kFormats.end(), [&](const ReadFormat& f) {
    return f.recognizes(source.bytes);
  });
  const std::string ending = ending_of(source.name);
  const auto by_name = std::find_if(kFormats.begin(), kFormats.end(),
                                    [&](const ReadFormat& f) { return f.ending == ending; });
  if (by_content != kFormats.end()) {
    if (by_name != kFormats.end() && by_name != by_content) {
      source.fail(ErrorKind::bad_file,
                  "the content is " + std::string(by_content->name) + ", the name says " +
                      std::string(by_name->name),
                  "rename the file to end with " + std::string(by_content->ending));
    }
    return *by_content;
  }
  if (is_imported(ending)) {
    return kImported;
  }
  const std::size_t begin =
      std::min(source.bytes.find_first_not_of(" \t\r\n"), source.bytes.size());
  for (const Foreign& foreign : kForeign) {
    if (source.bytes.substr(begin).starts_with(foreign.begin) &&
        (ending.empty() || ending != foreign.unless)) {
      fail_unsupported(source, std::string(foreign.what), std::string(foreign.remedy));
    }
  }
  if (by_name == kFormats.end()) {
    fail_unsupported(source,
                     ending.empty() ? "a file of unknown format and without an ending"
                                    : "format " + in_quotes(ending) + " is not read",
                     std::string(kConvert));
  }
  return *by_name;
}

}  // namespace soms::detail
