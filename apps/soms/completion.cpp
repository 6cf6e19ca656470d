#include "apps/soms/completion.h"

#include "apps/soms/verbs.h"
#include "apps/soms/viewer.h"
#include "apps/support/console.h"
#include "apps/support/parse.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

namespace soms::command {

namespace {

std::vector<std::string> verb_names() {
  std::vector<std::string> names;
  for (const Verb& verb : verbs()) {
    names.emplace_back(verb.name);
  }
  return names;
}

std::vector<std::string> option_names(const Verb& verb) {
  return verb.pass_on != nullptr ? viewer_option_names(verb.name)
                                 : ParsedVerb("soms", verb).option_names();
}

/// Works in zsh too, by its emulation of bash's completion.
std::string bash_script() {
  std::string cases;
  for (const Verb& verb : verbs()) {
    cases +=
        fmt::format("    {}) words=\"{}\" ;;\n", verb.name, fmt::join(option_names(verb), " "));
  }
  return fmt::format(
      "_soms() {{\n"
      "  local word=\"${{COMP_WORDS[COMP_CWORD]}}\" words=\"\"\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W \"{} --help --version\" -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case \"${{COMP_WORDS[1]}}\" in\n{}  esac\n"
      "  case \"$word\" in\n"
      "    -*) COMPREPLY=($(compgen -W \"$words\" -- \"$word\")) ;;\n"
      "    *) COMPREPLY=($(compgen -f -- \"$word\")) ;;\n"
      "  esac\n"
      "}}\n"
      "complete -o filenames -F _soms soms\n",
      fmt::join(verb_names(), " "), cases);
}

std::string fish_script() {
  std::string text;
  for (const Verb& verb : verbs()) {
    text += fmt::format("complete -c soms -n __fish_use_subcommand -a {} -d '{}'\n", verb.name,
                        verb.question);
    for (const std::string& option : option_names(verb)) {
      const bool is_long = option.starts_with("--");
      text += fmt::format("complete -c soms -n '__fish_seen_subcommand_from {}' -{} {}\n",
                          verb.name, is_long ? "l" : "s", option.substr(is_long ? 2 : 1));
    }
  }
  return text;
}

}  // namespace

Action add_completion(CLI::App& app, Shared&) {
  const auto options = std::make_shared<CompletionOptions>();
  add_choice<Shell>(app, "SHELL", options->shell,
                    {{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}},
                    "whose words")
      ->required();
  app.footer("Example:\n  soms completion bash > soms.bash");
  return [options](Console& console) { return run_completion(*options, console); };
}

int run_completion(const CompletionOptions& options, Console& console) {
  switch (options.shell) {
    case Shell::bash:
      console.print(bash_script());
      break;
    case Shell::zsh:
      console.print("autoload -U +X bashcompinit && bashcompinit\n" + bash_script());
      break;
    case Shell::fish:
      console.print(fish_script());
      break;
  }
  return 0;
}

}  // namespace soms::command
