/// \file
/// Files that a model names: only such as lie in its folder or below it are opened.
#pragma once

#include "soms/io/detail/file.h"
#include "soms/io/detail/json_document.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace soms::detail {

/// True for a URI that holds its data ("data:...").
[[nodiscard]] bool is_data_uri(std::string_view uri);

/// The text with each %41 made the byte that it stands for; a % without two digits stays.
[[nodiscard]] std::string without_escapes(std::string_view uri);

/// A file that a model names, open.
struct NamedFile {
  std::filesystem::path path;  ///< without links
  RegularFile file;
};

/// Finds and opens the file that a URI of a model's JSON names.
/// \errors ErrorKind::bad_file (outside of the folder of the model), cannot_open (also a model from
///         memory, which has no folder), unsupported (a scheme, such as `https:`), cancelled.
[[nodiscard]] NamedFile open_named(const Source& source, const JsonValue& uri);

/// Reads it. The file counts toward the memory that reading may take, as the model's own file does;
/// where it was `read_before`, it allows no more than it did then.
/// \errors ErrorKind::cannot_open, out_of_memory, cancelled.
[[nodiscard]] FileBytes read_named(Source& source, const NamedFile& named, const JsonValue& uri,
                                   bool read_before = false);

}  // namespace soms::detail
