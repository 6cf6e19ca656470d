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

namespace soms::command {

namespace {

std::string page_of_command() {
  const std::string help = help_of(program());
  ManPage page{.name = "soms", .version = SOMS_VERSION, .help = help, .see_also = {}};
  for (const Verb& verb : verbs()) {
    page.see_also.push_back(fmt::format("soms-{}", verb.name));
  }
  return roff(page);
}

/// The help, and the keys of its list, if it has one.
std::string help_with_keys(const Verb& verb) {
  const ParsedVerb parsed("soms", verb);
  const std::string keys = parsed.parser().keys();
  return keys.empty() ? parsed.help() : parsed.help() + "\n" + keys;
}

/// Empty for a verb of another program that is missing.
std::string page_of(const Verb& verb) {
  const std::string help = verb.pass_on != nullptr ? passed_help(verb) : help_with_keys(verb);
  return help.empty() ? help
                      : roff({.name = fmt::format("soms-{}", verb.name),
                              .version = SOMS_VERSION,
                              .help = help,
                              .see_also = {"soms"}});
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
