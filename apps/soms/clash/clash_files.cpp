#include "apps/soms/clash/clash_files.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/output/output.h"
#include "apps/rows/json_list.h"
#include "apps/soms/clash/clash_output.h"
#include "apps/soms/clash/clash_page.h"
#include "apps/soms/pairs/pair_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace soms::command {

namespace {

/// A word of a command line, in quotes where a shell would not take it as it is.
std::string shell_word(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("_./,:=+@%-").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) {
    return word;
  }
  std::string quoted = "'";
  for (const char c : word) {
    quoted += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return quoted + "'";
}

bool is_bcf(const std::string& name) {
  const std::string extension = extension_of(name);
  return extension == ".bcf" || extension == ".bcfzip";
}

}  // namespace

void add_clash_file_options(Parser& parser, ClashFileOptions& options) {
  parser
      .add_option_function(
          "--bcf-version",
          [&options](const std::string& text) {
            if (text != "2.1" && text != "3.0") {
              throw unknown_choice("--bcf-version", text, {"2.1", "3.0"});
            }
            options.bcf_version = text == "3.0" ? BcfVersion::v3_0 : BcfVersion::v2_1;
          },
          "version of BCF archives: 2.1 (the default) or 3.0")
      ->option_text(kChoiceText)
      ->choices({"2.1", "3.0"});
  parser.add_flag("--no-snapshots", options.no_snapshots, "leave the pictures out of BCF archives");
}

void check_clash_file_options(const ClashFileOptions& options,
                              const std::vector<std::string>& outputs) {
  for (const std::string& output : outputs) {
    check_extension("-o", output, {".csv", ".json", ".jsonl", ".html", ".bcfzip", ".bcf"});
  }
  const bool stated = options.bcf_version.has_value() || options.no_snapshots;
  if (stated && std::none_of(outputs.begin(), outputs.end(), is_bcf)) {
    throw Error(ErrorKind::usage,
                fmt::format("{} has no effect without a BCF archive",
                            options.no_snapshots ? "--no-snapshots" : "--bcf-version"),
                "also give -o FILE.bcfzip");
  }
}

void write_clash_file(const std::string& name, const ClashReport& report, bool verified,
                      const ClashFileOptions& options, Console& console, std::ostream& out) {
  const std::string extension = extension_of(name);
  if (extension == ".csv") {
    write_clashes_as_csv(report, out);
  } else if (extension == ".html") {
    write_clashes_as_page(report, options.command, verified, out);
  } else if (is_bcf(name)) {
    write_clashes_as_bcf(report,
                         {.version = options.bcf_version.value_or(BcfVersion::v2_1),
                          .snapshots = !options.no_snapshots},
                         console, out);
  } else {
    JsonListWriter list(out, name);
    write_clashes_as_json(report, verified, list);
  }
}

std::string stated_command(const Parser& parser) {
  std::string command = parser.name();
  std::string named;
  for (const Option* const option : parser.options()) {
    const bool is_of_output =
        option->is_named("output") || option->is_named("json") || option->is_named("quiet");
    if (option->count() == 0 || is_of_output) {
      continue;
    }
    const std::string name = option->name();
    if (option->is_argument()) {
      for (const std::string& word : option->results()) {
        command += " " + shell_word(word);
      }
    } else if (!option->has_value()) {
      named += " " + name;
    } else {
      for (const std::string& word : option->results()) {
        named += fmt::format(" {} {}", name, shell_word(word));
      }
    }
  }
  return command + named;
}

}  // namespace soms::command
