/// \file
/// Verbs of other programs, which the command starts: soms-view and soms-reproduce.
#pragma once

#include "apps/cli/verb.h"
#include "apps/cli/verb_data.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// Becomes soms-view with this verb and these words. \errors As `program_of`, `become`.
[[nodiscard]] int pass_to_viewer(std::string_view verb, const std::vector<std::string>& words);

/// The same for soms-reproduce.
[[nodiscard]] int pass_to_reproduce(std::string_view verb, const std::vector<std::string>& words);

/// The program of a verb that is passed on, sought as `find_program` does.
/// \errors ErrorKind::unsupported where there is none; the remedy says how to get it.
[[nodiscard]] std::filesystem::path program_of(const Verb& verb);

/// The name of that program.
[[nodiscard]] std::string_view program_name_of(const Verb& verb);

/// The verb as its program describes it; nothing where that is missing, or of another version.
[[nodiscard]] std::optional<VerbData> passed_data(const Verb& verb);

/// A verb of the command or of another program.
[[nodiscard]] std::optional<VerbData> data_of(const Verb& verb);

}  // namespace soms::command
