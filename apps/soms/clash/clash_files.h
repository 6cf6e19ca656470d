/// \file
/// The files that `clash` writes: lists, pages and archives, by their extensions.
#pragma once

#include "apps/soms/clash/clash_bcf.h"
#include "apps/soms/clash/clash_rows.h"

#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

class Console;
class Parser;

/// How the files of `clash` are written.
struct ClashFileOptions {
  std::optional<BcfVersion> bcf_version = std::nullopt;
  bool no_snapshots = false;
  std::string command = {};  ///< the command line, for those who want the list again
};

/// Adds the options of files: --bcf-version and --no-snapshots.
void add_clash_file_options(Parser& parser, ClashFileOptions& options);

/// \errors ErrorKind::usage for an output with an extension that is not known, and for an option of
/// BCF archives where no output is one.
void check_clash_file_options(const ClashFileOptions& options,
                              const std::vector<std::string>& outputs);

/// Writes the list to `out` as the extension of `name` says, as JSON where it says nothing.
/// \errors Those of the outputs.
void write_clash_file(const std::string& name, const ClashReport& report, bool verified,
                      const ClashFileOptions& options, Console& console, std::ostream& out);

/// The command line of a parsed verb but for its outputs, as a shell takes it:
/// "soms clash a.obj --against b.obj".
[[nodiscard]] std::string stated_command(const Parser& parser);

}  // namespace soms::command
