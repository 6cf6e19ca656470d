/// \file
/// Which program reads a format that soms does not read itself, and where it is.
#pragma once

#include "soms/io/detail/source.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// A program that answers as soms-import does (docs/formats.md).
struct ImportProgram {
  std::string name = {};  ///< as messages call it
  std::filesystem::path path = {};
  std::vector<std::string> arguments = {};  ///< the extension comes after them
  std::uint64_t own_memory = 0;             ///< bytes that it needs before it has read anything
  /// It reserves addresses that it never uses, so that its data is limited, not its address space.
  bool reserves_addresses = false;

  [[nodiscard]] bool operator==(const ImportProgram&) const = default;
};

/// The program for files with this extension: for .ifc the npm package web-ifc, run by Node.js,
/// where both are found, and soms-import for all others. Node.js is found by the variable
/// SOMS_NODE, else by PATH; web-ifc by SOMS_WEB_IFC, else in node_modules beside soms-import, by
/// NODE_PATH, in node_modules of the current folder, or among the global packages of npm;
/// soms-import by SOMS_IMPORT, else beside this program or in libexec/soms beside it or the
/// library. \errors ErrorKind::unsupported: not found, or a variable names nothing that runs.
[[nodiscard]] ImportProgram find_import_program(const Source& source, std::string_view extension);

/// Folders where soms-import may lie, the nearest first, for a program and a library at these
/// places. None is far from them: what somebody else put into a folder above them must not be
/// started. A place that is not known, or not from the root on, gives none: nor must what lies in
/// the folder that is current.
[[nodiscard]] std::vector<std::filesystem::path> import_folders(
    const std::filesystem::path& program, const std::filesystem::path& library);

}  // namespace soms::detail
