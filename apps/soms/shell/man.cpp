#include "apps/soms/shell/man.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/soms/shell/man_page.h"
#include "apps/soms/shell/passed_on.h"
#include "apps/soms/shell/verbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace soms::command {

namespace {

/// The option as its line of --help has it.
ManRow row_of(const OptionData& option) {
  return {.names = option.line, .value = option.value, .text = option.meaning};
}

void add_to(std::vector<ManList>& lists, const std::string& heading, ManRow row) {
  const auto same = std::find_if(lists.begin(), lists.end(),
                                 [&](const ManList& list) { return list.heading == heading; });
  if (same == lists.end()) {
    lists.push_back({heading, {std::move(row)}});
  } else {
    same->rows.push_back(std::move(row));
  }
}

std::string page_of_command() {
  Parser shared("", "soms");
  Shared values;
  add_help_option(shared);
  add_shared_options(shared, values);
  const Program soms = program();
  ManPage page{.name = "soms",
               .version = SOMS_VERSION,
               .summary = std::string(soms.summary),
               .command = "soms VERB",
               .words = "[OPTIONS] ...",
               .text = about_verbs(soms) + "\n" + kAboutAnswers};
  for (const OptionData& option : data_of(shared).options) {
    add_to(page.options, option.group, row_of(option));
  }
  for (const Verb& verb : verbs()) {
    add_to(page.lists, "Verbs",
           {.names = {std::string(verb.name)}, .text = std::string(verb.question)});
    page.see_also.push_back(fmt::format("soms-{}", verb.name));
  }
  return roff(page);
}

/// "FILE..." of an argument; in brackets, if it may be left out.
std::string usage_of(const OptionData& argument) {
  const std::string name = argument.names.front() + (argument.takes_several ? "..." : "");
  return argument.is_required ? " " + name : " [" + name + "]";
}

/// Sorts an option to its place on the page.
void add_option(ManPage& page, const OptionData& option) {
  if (option.is_argument) {
    page.words += usage_of(option);
    page.arguments.push_back(row_of(option));
  } else if (option.group == kSharedGroup) {
    page.shared += (page.shared.empty() ? "Shared options (soms --help): " : ", ") +
                   option.names.front() + (option.value.empty() ? "" : " ") + option.value;
  } else if (!option.list.empty()) {
    add_to(page.lists, "Keys of " + option.list,
           {.names = {option.names.front().substr(2) + "="},
            .value = option.value,
            .text = option.meaning});
  } else if (!option.line.empty()) {
    add_to(page.options, option.group, row_of(option));
  }
}

/// Empty for a verb of another program that is missing.
std::string page_of(const Verb& verb) {
  const std::optional<VerbData> data = data_of(verb);
  if (!data) {
    return {};
  }
  ManPage page{.name = fmt::format("soms-{}", verb.name),
               .version = SOMS_VERSION,
               .summary = data->question,
               .command = data->name,
               .words = "[OPTIONS]",
               .text = data->footer,
               .see_also = {"soms"}};
  for (const OptionData& option : data->options) {
    add_option(page, option);
  }
  return roff(page);
}

void write_page(const std::string& folder, const std::string& name, const std::string& text) {
  OutputFile file(std::filesystem::path(folder) / (name + ".1"));
  file.stream() << text;
  file.commit();
}

void write_all(const std::string& folder, const Console& console) {
  write_page(folder, "soms", page_of_command());
  for (const Verb& verb : verbs()) {
    const std::string text = page_of(verb);
    if (text.empty()) {
      console.note(fmt::format("soms-{}.1 is not written: {} is not installed", verb.name,
                               program_name_of(verb)));
    } else {
      write_page(folder, fmt::format("soms-{}", verb.name), text);
    }
  }
}

const Verb& verb_named(const std::string& word) {
  Choices<const Verb*> choices;
  for (const Verb& verb : verbs()) {
    choices.emplace_back(verb.name, &verb);
  }
  return *parse_choice("VERB", word, choices);
}

}  // namespace

Action add_man(Parser& parser, Shared&) {
  const auto options = std::make_shared<ManOptions>();
  parser.add_option("VERB", options->verb, "verb whose page to print (default: the page of soms)");
  add_output(parser, "--output", options->folder, "write all pages to this existing folder instead",
             "FOLDER");
  parser.footer(
      "Pages are in roff format and have the same content as --help. After installation, man\n"
      "finds them: man soms-overlap.\n\n"
      "Example:\n"
      "  soms man overlap > soms-overlap.1");
  return [options](Console& console) { return run_man(*options, console); };
}

int run_man(const ManOptions& options, Console& console) {
  refuse_json(console, "man prints man pages");
  if (!options.folder.empty() && !options.verb.empty()) {
    throw Error(ErrorKind::usage, "--output writes all pages", "leave out the verb, or --output");
  }
  if (!options.folder.empty()) {
    write_all(options.folder, console);
    return 0;
  }
  if (options.verb.empty()) {
    console.print(page_of_command());
    return 0;
  }
  const Verb& verb = verb_named(options.verb);
  const std::string text = page_of(verb);
  if (text.empty()) {
    (void)program_of(verb);  // says what is missing
  }
  console.print(text);
  return 0;
}

}  // namespace soms::command
