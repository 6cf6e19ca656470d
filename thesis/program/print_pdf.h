/// \file
/// The page of a run as a PDF, printed by Chromium.
#pragma once

#include "apps/cli/console.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace soms::command {

/// Chromium, or Chrome: the one that SOMS_CHROMIUM names, else the first on PATH.
/// \errors ErrorKind::unsupported where there is none.
[[nodiscard]] std::filesystem::path find_chromium();

/// The bytes of a PDF of the page `html`. Chromium gets a temporary folder as its home, which is
/// removed, and no network. Ctrl-C and --timeout end it.
/// \errors ErrorKind::unsupported where it does not start or fails, with the end of what it said;
/// cannot_write without a temporary folder; timed_out; cancelled.
[[nodiscard]] std::string printed_pdf(const std::filesystem::path& chromium, std::string_view html,
                                      const Console& console);

}  // namespace soms::command
