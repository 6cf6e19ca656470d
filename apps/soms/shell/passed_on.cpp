#include "apps/soms/shell/passed_on.h"

#include "soms/base/error.h"

#include "apps/cli/child.h"

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
  if (verb.pass_on != pass_to_reproduce && verb.pass_on != pass_to_viewer) {
    (void)verb.pass_on(verb.name, {});  // says what was not built
  }
  return verb.pass_on == pass_to_reproduce ? reproduce_program() : viewer_program();
}

std::string_view program_name_of(const Verb& verb) {
  return verb.pass_on == pass_to_reproduce ? "soms-reproduce"
         : verb.pass_on == pass_to_viewer  ? "soms-view"
                                           : verb.name;
}

std::optional<VerbData> passed_data(const Verb& verb) {
  try {
    return data_from_json(
        output_of(program_of(verb), {std::string(verb.name), std::string(kDataWord)}, "soms"));
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::optional<VerbData> data_of(const Verb& verb) {
  return verb.pass_on != nullptr ? passed_data(verb) : data_of(ParsedVerb("soms", verb).parser());
}

}  // namespace soms::command
