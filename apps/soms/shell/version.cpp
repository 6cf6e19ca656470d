#include "apps/soms/shell/version.h"

#include "soms/base/error.h"
#include "soms/io/formats.h"
#include "soms/query/instruction_set.h"

#include "apps/cli/console.h"
#include "apps/output/json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

namespace {

/// The instruction set that queries run on, or why they do not run.
struct Chosen {
  std::string_view name;  ///< empty where SOMS_ISA cannot be obeyed
  std::string fault;
};

Chosen chosen_instruction_set() {
  try {
    return {instruction_set(), {}};
  } catch (const Error& error) {
    return {{}, error.what()};
  }
}

std::vector<std::string_view> written_extensions() {
  std::vector<std::string_view> extensions;
  for (const WritableFormat& row : writable_formats()) {
    if (!row.extension.empty()) {
      extensions.push_back(row.extension);
    }
  }
  return extensions;
}

std::vector<std::string_view> read_extensions() {
  std::vector<std::string_view> extensions;
  for (const ReadableFormat& format : readable_formats()) {
    // Two formats share .json.
    if (std::find(extensions.begin(), extensions.end(), format.extension) == extensions.end()) {
      extensions.push_back(format.extension);
    }
  }
  return extensions;
}

/// On lines of a screen, each under the first.
std::string folded(const std::vector<std::string_view>& words) {
  constexpr std::size_t kWidth = 80;
  std::string text;
  std::size_t column = 0;
  for (const std::string_view word : words) {
    if (column + word.size() > kWidth) {
      text += fmt::format("\n{:18}", "");
      column = 0;
    } else if (!text.empty()) {
      text += " ";
    }
    text += word;
    column += word.size() + 1;
  }
  return text;
}

}  // namespace

Action add_version(Parser& parser, Shared&) {
  parser.footer(
      "Example:\n"
      "  soms version");
  return [](Console& console) { return run_version(console); };
}

int run_version(Console& console) {
  const Chosen chosen = chosen_instruction_set();
  const auto imported = imported_extensions();
  const std::vector<std::string_view> others(imported.begin(), imported.end());
  if (console.shared().json) {
    console.print(
        json_line({{"schema", "soms.version/1"},
                   {"version", SOMS_VERSION},
                   {"instruction_set", chosen.name.empty() ? Json() : Json(chosen.name)},
                   {"instruction_set_fault", chosen.fault.empty() ? Json() : Json(chosen.fault)},
                   {"instruction_sets", instruction_sets()},
                   {"reads", read_extensions()},
                   {"reads_by_soms_import", others},
                   {"writes", written_extensions()}}));
    return 0;
  }
  console.print(fmt::format("soms {}\n", SOMS_VERSION));
  console.print(fmt::format(
      "  instruction set {}\n",
      chosen.name.empty()
          ? fmt::format("none, queries fail: {}", chosen.fault)
          : fmt::format("{}, of {} here", chosen.name, fmt::join(instruction_sets(), ", "))));
  console.print(fmt::format("  reads           {}\n", folded(read_extensions())));
  console.print(fmt::format("  by soms-import  {}\n", folded(others)));
  console.print(fmt::format("  writes          {}\n", folded(written_extensions())));
  return 0;
}

}  // namespace soms::command
