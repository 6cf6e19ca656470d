/// \file
/// The formats that models are read from and written in: what every list of them is made of.
#pragma once

#include "soms/io/write_mesh.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms {

/// A format that soms reads itself.
struct ReadableFormat {
  std::string_view name;       ///< as in messages: "PLY"
  std::string_view extension;  ///< of file names, lower case, with its point

  [[nodiscard]] bool operator==(const ReadableFormat&) const = default;
};

/// Formats that this build reads itself, in the order of the manual.
[[nodiscard]] std::vector<ReadableFormat> readable_formats();

/// Extensions of the formats that are read by the program soms-import, where it is installed;
/// sorted.
[[nodiscard]] std::span<const std::string_view> imported_extensions();

/// True if a name is that of a model: its extension is that of a format that is read, and it does
/// not begin with a point, as those of hidden files do.
[[nodiscard]] bool is_named_as_model(const std::filesystem::path& file);

/// True if a file of a folder is to be read as a model: it is named as one and, as JSON has many
/// uses, begins as a model where it is JSON. A model that is broken is one.
/// \errors ErrorKind::cannot_open for a JSON file that cannot be read.
[[nodiscard]] bool is_model_of_folder(const std::filesystem::path& file);

/// A way to write a model, and what it keeps beyond triangles.
struct WritableFormat {
  MeshFormat format = MeshFormat::ply;
  std::string_view name;       ///< kebab-case: "stl-ascii"
  std::string_view title;      ///< as in messages: "text STL"
  std::string_view extension;  ///< of file names; empty where another way has the extension
  bool doubles = true;         ///< coordinates keep every bit; else they become floats
  bool names = false;          ///< of parts
  bool unit_and_axis = false;

  [[nodiscard]] bool operator==(const WritableFormat&) const = default;
};

/// All ways to write, in the order of the manual.
[[nodiscard]] std::span<const WritableFormat> writable_formats();

/// The row of a format.
[[nodiscard]] const WritableFormat& entry(MeshFormat format);

/// The formats that are written, as a sentence has them: "PLY, 3DS or GLB".
[[nodiscard]] std::string writable_names();

/// The extensions that are written, as a sentence has them: ".ply, .3ds or .glb".
[[nodiscard]] std::string writable_extensions();

}  // namespace soms
