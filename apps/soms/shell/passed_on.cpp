#include "apps/soms/shell/passed_on.h"

#include "soms/base/error.h"

#include "apps/cli/child.h"
#include "apps/cli/parse.h"

#include <regex>
#include <sstream>
#include <utility>

namespace soms::command {

namespace {

std::filesystem::path reproduce_program() {
  return find_program({.name = "soms-reproduce",
                       .variable = "SOMS_REPRODUCE",
                       .remedy =
                           "make build builds it beside the command, or set SOMS_REPRODUCE to its "
                           "path; see docs/reproduce.md"});
}

[[noreturn]] void pass(const std::filesystem::path& program, std::string_view verb,
                       const std::vector<std::string>& words) {
  std::vector<std::string> all(words);
  all.emplace(all.begin(), verb);
  become(program, "soms", all);
}

}  // namespace

int pass_to_viewer(std::string_view verb, const std::vector<std::string>& words) {
  pass(viewer_program(), verb, words);
}

int pass_to_reproduce(std::string_view verb, const std::vector<std::string>& words) {
  pass(reproduce_program(), verb, words);
}

std::filesystem::path program_of(const Verb& verb) {
  return verb.pass_on == pass_to_reproduce ? reproduce_program() : viewer_program();
}

std::string_view program_name_of(const Verb& verb) {
  return verb.pass_on == pass_to_reproduce ? "soms-reproduce" : "soms-view";
}

std::string passed_help(const Verb& verb) {
  try {
    return output_of(program_of(verb), {std::string(verb.name), "--help"}, "soms");
  } catch (const Error&) {
    return {};
  }
}

std::vector<OptionWords> passed_options(const Verb& verb) {
  std::istringstream help(passed_help(verb));
  // An option begins a line, "  -o,--output FILE    picture to write"; its meaning may go on below,
  // far to the right.
  static const std::regex option_line("  (?:(-[a-z]),)?(--[a-z][a-z-]*)(?: (\\S+))?(?:  +(.*))?");
  constexpr std::size_t kIndent = 6;
  std::vector<OptionWords> options;
  std::string label;
  std::string meaning;
  const auto end_option = [&] {
    if (label == kChoiceText && meaning.find('|') != std::string::npos) {
      options.back().values = listed_words(meaning);
    }
    meaning.clear();
    label.clear();
  };
  for (std::string line; std::getline(help, line);) {
    std::smatch parts;
    if (std::regex_match(line, parts, option_line)) {
      end_option();
      OptionWords option{{parts[2]}, {}, parts[3].matched};
      if (parts[1].matched) {
        option.names.push_back(parts[1]);
      }
      options.push_back(std::move(option));
      label = parts[3];
      meaning = parts[4];
    } else if (const std::size_t text = line.find_first_not_of(' ');
               text != line.npos && text >= kIndent) {
      meaning += line.substr(text);
    } else {
      end_option();  // another heading, an empty line, or one of blanks
    }
  }
  if (!options.empty()) {
    for (OptionWords& shared : shared_option_words()) {  // which the help only names
      options.push_back(std::move(shared));
    }
  }
  return options;
}

}  // namespace soms::command
