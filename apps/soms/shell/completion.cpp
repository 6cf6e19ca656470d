#include "apps/soms/shell/completion.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/soms/models/generate.h"
#include "apps/soms/shell/man.h"
#include "apps/soms/shell/passed_on.h"
#include "apps/soms/shell/verbs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>

namespace soms::command {

namespace {

Choices<Shell> shells() {
  return {{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}};
}

std::vector<std::string> verb_names() {
  std::vector<std::string> names;
  for (const Verb& verb : verbs()) {
    names.emplace_back(verb.name);
  }
  return names;
}

/// What a verb's first argument may be where it is no file.
std::vector<std::string> argument_words(const Verb& verb) {
  std::vector<std::string> words;
  if (verb.add == add_generate) {
    for (const GenerateKind& kind : generate_kinds()) {
      words.emplace_back(kind.name);
    }
  } else if (verb.add == add_completion) {
    for (const auto& [name, shell] : shells()) {
      words.push_back(name);
    }
  } else if (verb.add == add_man) {
    words = verb_names();
  }
  return words;
}

std::vector<OptionData> options_of(const Verb& verb) {
  const std::optional<VerbData> data = data_of(verb);
  std::vector<OptionData> options = data ? data->options : std::vector<OptionData>();
  std::erase_if(options, [](const OptionData& option) { return option.is_argument; });
  return options;
}

/// "rule=fast", "rule=quality", "leaf=": what may stand in a list, without `before=`.
std::vector<std::string> items_of(const std::string& list, const std::vector<OptionData>& options) {
  std::vector<std::string> items;
  for (const OptionData& key : options) {
    if (key.list == list) {
      const std::string begin = key.names.front().substr(2) + "=";
      for (const std::string& word : key.choices) {
        items.push_back(begin + word);
      }
      if (key.choices.empty()) {
        items.push_back(begin);
      }
    }
  }
  return items;
}

/// Works in zsh too, by its emulation of bash's completion. Files are left to the shell, which
/// knows how names with blanks are quoted.
std::string bash_script() {
  std::string options;
  std::string values;
  std::string lists;
  std::string arguments;
  for (const Verb& verb : verbs()) {
    std::vector<std::string> names;
    const std::vector<OptionData> own = options_of(verb);
    for (const OptionData& option : own) {
      if (!option.list.empty()) {
        continue;
      }
      names.insert(names.end(), option.names.begin(), option.names.end());
      if (!option.choices.empty()) {
        values += fmt::format("    \"{} {}\") words=\"{}\" ;;\n", verb.name, option.names[0],
                              fmt::join(option.choices, " "));
      }
      if (const auto items = items_of(option.names[0], own); !items.empty()) {
        lists += fmt::format("    \"{} {}\") words=\"{} help\" ;;\n", verb.name, option.names[0],
                             fmt::join(items, " "));
      }
    }
    options += fmt::format("    \"{} -\"*) words=\"{}\" ;;\n", verb.name, fmt::join(names, " "));
    if (const auto words = argument_words(verb); !words.empty()) {
      arguments += fmt::format("      {}) words=\"{}\" ;;\n", verb.name, fmt::join(words, " "));
    }
  }
  return fmt::format(
      "_soms() {{\n"
      "  local word=\"${{COMP_WORDS[COMP_CWORD]}}\" verb=\"${{COMP_WORDS[1]}}\" words=\"\"\n"
      "  local before=\"${{COMP_WORDS[COMP_CWORD-1]}}\" stem=\"\" given at whole list left\n"
      "  COMPREPLY=()\n"
      // An item of --tree KEY=VALUE,...: `whole` is the argument, of which bash makes many words,
      // and `left` what stands in it left of the word.
      "  at=\"$COMP_CWORD\" whole=\"$word\"\n"
      "  while [ \"$at\" -gt 2 ] && [ \"${{COMP_WORDS[at]}}\" = \"=\" -o \"${{COMP_WORDS[at-1]}}\" "
      "= \"=\" ]; do\n"
      "    at=$((at-1)) whole=\"${{COMP_WORDS[at]}}$whole\"\n"
      "  done\n"
      "  left=\"${{whole%\"${{word#=}}\"}}\" list=\"${{COMP_WORDS[at-1]}}\"\n"
      "  case \"$whole\" in --*=*) list=\"${{whole%%=*}}\" ;; esac\n"
      "  case \"$verb $list\" in\n{4}  esac\n"
      "  if [ -n \"$words\" ]; then\n"
      "    stem=\"${{whole#\"$list=\"}}\"\n"
      "    stem=\"${{whole%\"${{stem##*,}}\"}}\"\n"
      "    for given in $words; do\n"
      "      case \"$stem$given\" in\n"
      "        \"$whole\"*) COMPREPLY+=(\"$stem$given\") ;;\n"
      "      esac\n"
      "    done\n"
      "    COMPREPLY=(\"${{COMPREPLY[@]#\"$left\"}}\")\n"
      "    compopt -o nospace 2>/dev/null\n"
      "    return\n"
      "  fi\n"
      // Of --option=word bash makes three words, zsh one.
      "  if [ \"$before\" = \"=\" ]; then\n"
      "    before=\"${{COMP_WORDS[COMP_CWORD-2]}}\"\n"
      "  elif [ \"$word\" = \"=\" ]; then\n"
      "    word=\"\"\n"
      "  elif [ \"${{word#--*=}}\" != \"$word\" ]; then\n"
      "    before=\"${{word%%=*}}\" stem=\"${{word%%=*}}=\" word=\"${{word#*=}}\"\n"
      "  fi\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    words=\"{0} help --help --version\"\n"
      "  fi\n"
      "  [ \"$COMP_CWORD\" -gt 1 ] && case \"$verb $before\" in\n"
      "    \"help help\") words=\"{0}\" ;;\n{1}  esac\n"
      "  [ -z \"$words\" ] && case \"$verb $word\" in\n{2}  esac\n"
      "  if [ -z \"$words\" ] && [ \"${{before#-}}\" = \"$before\" ]; then\n"
      "    case \"$verb\" in\n{3}    esac\n"
      // One of them is enough; files may follow.
      "    for given in \"${{COMP_WORDS[@]:2:$((COMP_CWORD-2))}}\"; do\n"
      "      case \" $words \" in *\" $given \"*) words=\"\" ;; esac\n"
      "    done\n"
      "  fi\n"
      "  [ -n \"$words\" ] && COMPREPLY=($(compgen -P \"$stem\" -W \"$words\" -- \"$word\"))\n"
      "}}\n"
      "complete -o bashdefault -o default -F _soms soms\n",
      fmt::join(verb_names(), " "), values, options, arguments, lists);
}

/// True of the word behind the verb. Words behind `man` are verbs, so that asking for one of them
/// would ask for `man` itself.
constexpr const char* kFishFirst = "test (count (commandline -opc)) -eq 2";

std::string fish_script() {
  const std::string first = "complete -c soms -n __fish_use_subcommand";
  // Items of a list behind those that stand there already.
  std::string text =
      "function __soms_item\n"
      "  set -l word (string replace -r '^--[a-z-]+=' '' -- (commandline -ct))\n"
      "  printf '%s\\n' (string match -r '^.*,' -- $word)$argv\n"
      "  string match -q '*,*' -- $word; or printf '%s\\n' $argv\n"
      "end\n";
  text += fmt::format(
      "{0} -f -l help -s h\n{0} -l version\n{0} -a help -d 'what a verb does'\n"
      "complete -c soms -n '__fish_seen_subcommand_from help; and {1}' -f -a '{2}'\n",
      first, kFishFirst, fmt::join(verb_names(), " "));
  for (const Verb& verb : verbs()) {
    text += fmt::format("{} -a {} -d '{}'\n", first, verb.name, verb.question);
    const std::string seen =
        fmt::format("complete -c soms -n '__fish_seen_subcommand_from {}'", verb.name);
    if (const auto words = argument_words(verb); !words.empty()) {
      const std::string list = fmt::format("{}", fmt::join(words, " "));
      const std::string none =
          verb.add == add_man ? std::string(kFishFirst) : "not __fish_seen_subcommand_from " + list;
      text +=
          fmt::format("complete -c soms -n '__fish_seen_subcommand_from {}; and {}' -f -a '{}'\n",
                      verb.name, none, list);
    }
    const std::vector<OptionData> own = options_of(verb);
    for (const OptionData& option : own) {
      if (!option.list.empty()) {
        continue;
      }
      text += seen;
      for (const std::string& name : option.names) {
        const bool is_long = name.starts_with("--");
        text += fmt::format(" -{} {}", is_long ? "l" : "s", name.substr(is_long ? 2 : 1));
      }
      if (const auto items = items_of(option.names[0], own); !items.empty()) {
        text += fmt::format(" -x -a '(__soms_item {} help)'", fmt::join(items, " "));
      } else if (!option.choices.empty()) {
        text += fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
      } else if (!option.value.empty()) {
        text += " -r";
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace

Action add_completion(Parser& parser, Shared&) {
  const auto options = std::make_shared<CompletionOptions>();
  add_choice<Shell>(parser, "SHELL", options->shell, shells(), "shell that will run the script")
      ->required();
  parser.footer("Example:\n  soms completion bash > soms.bash");
  return [options](Console& console) { return run_completion(*options, console); };
}

int run_completion(const CompletionOptions& options, Console& console) {
  refuse_json(console, "completion prints a shell script");
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
