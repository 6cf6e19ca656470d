#include "apps/cli/program.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/parser.h"
#include "apps/cli/suggest.h"
#include "apps/cli/terminal.h"
#include "apps/cli/verb_data.h"
#include "apps/output/output.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace soms::command {

namespace {

Error usage(std::string place, std::string remedy) {
  return Error(ErrorKind::usage, std::move(place), std::move(remedy));
}

/// "did you mean ...?" or, with nothing near, where the right words are listed.
std::string remedy_for(std::string_view word, const std::vector<std::string>& known,
                       std::string_view list) {
  const std::string near = nearest_words(word, known);
  return near.empty() ? fmt::format("{} lists them", list)
                      : fmt::format("did you mean {}? ({} lists them)", near, list);
}

/// Takes the places of standard streams that are closed, so that no file gets them: what is written
/// there fails, as it must.
void hold_standard_streams() {
  for (const int descriptor : {0, 1, 2}) {
    if (::fcntl(descriptor, F_GETFD) == -1 && errno == EBADF) {
      (void)::open("/dev/null", O_RDONLY | O_CLOEXEC);  // the lowest that is free
    }
  }
}

void print_plain(std::string_view text) {
  FileStream out(1, "standard output");
  out << text;
  out.finish();
}

void print_help(std::string_view help) {
  print_plain(help_on(terminal_of(1), help));
}

const Verb& find_verb(const Program& program, const std::string& word) {
  const auto known = program.verbs;
  const auto found =
      std::find_if(known.begin(), known.end(), [&](const Verb& verb) { return verb.name == word; });
  if (found != known.end()) {
    return *found;
  }
  if (word.starts_with("-")) {
    throw usage(
        fmt::format("{} is given before the verb", word),
        fmt::format("write {0} VERB, then its options; {0} --help lists the verbs", program.name));
  }
  std::vector<std::string> names;
  for (const Verb& verb : known) {
    names.emplace_back(verb.name);
  }
  throw usage(fmt::format("unknown verb {}", word.empty() ? "\"\"" : word),
              remedy_for(word, names, fmt::format("{} --help", program.name)));
}

/// Throws if words are left over: options that the verb does not have, or too many names.
void check_rest(const ParsedVerb& verb, std::vector<std::string> rest) {
  // The first "--" ends the options and is none of them; the parser leaves it among the rest.
  const auto mark = std::find(rest.begin(), rest.end(), "--");
  const auto options_end = mark == rest.end() ? mark : rest.erase(mark);
  if (rest.empty()) {
    return;
  }
  const auto option = std::find_if(rest.begin(), options_end, [](const std::string& word) {
    return word.starts_with("-") && word != "-";
  });
  const std::string help = verb.parser().name() + " --help";
  if (option == options_end) {
    throw usage(fmt::format("unexpected argument {}", rest.front()), "see " + help);
  }
  std::error_code unknown;
  if (std::filesystem::exists(*option, unknown)) {
    throw usage("unknown option " + *option,
                fmt::format("for a file of that name, write ./{}, or put -- before it", *option));
  }
  const std::string word = option->substr(0, option->find('='));
  const std::vector<std::string> known = verb.option_names();
  if (word.starts_with("--unit") &&
      std::find(known.begin(), known.end(), "--scale") != known.end()) {
    throw usage("unknown option " + word,
                "--scale converts units, such as --scale 0.001 from millimeters to meters");
  }
  throw usage("unknown option " + word, remedy_for(word, known, help));
}

/// What the words ask for.
enum class ParsedAs { question, help, keys };

/// Remarks on old forms go to `remarks`. Keys are printed.
ParsedAs parse(ParsedVerb& verb, const std::vector<std::string>& words,
               std::vector<std::string>& remarks) {
  const ParsedWords parsed = verb.parser().parse(words);
  if (parsed.wants_help) {
    return ParsedAs::help;
  }
  if (!parsed.keys.empty()) {
    print_help(parsed.keys);
    return ParsedAs::keys;
  }
  check_rest(verb, parsed.rest);  // an unknown option says more than a missing argument
  if (!parsed.fault.empty()) {
    throw usage(parsed.fault, "see " + verb.parser().name() + " --help");
  }
  remarks = parsed.remarks;
  return ParsedAs::question;
}

/// Runs it with keys of lists in messages as they are written.
int run_parsed(ParsedVerb& verb, const std::vector<std::string>& words) {
  try {
    std::vector<std::string> remarks;
    if (const ParsedAs parsed = parse(verb, words, remarks); parsed != ParsedAs::question) {
      if (parsed == ParsedAs::help) {
        print_help(verb.help());
      }
      return 0;
    }
    Console console(verb.shared());
    for (const std::string& remark : remarks) {
      console.note(remark);
    }
    const int status = verb.action()(console);
    console.flush();
    return status;
  } catch (const Error& error) {
    throw Error(error.kind(), verb.parser().with_keys(error.place()),
                verb.parser().with_keys(error.remedy()));
  }
}

int run_verb(const Program& program, const Verb& entry, const std::vector<std::string>& words) {
  if (entry.pass_on != nullptr) {
    return entry.pass_on(entry.name, words);
  }
  ParsedVerb verb(program.name, entry);
  if (words.size() == 1 && words.front() == kDataWord) {
    print_plain(data_as_json(data_of(verb.parser())));
    return 0;
  }
  try {
    return run_parsed(verb, words);
  } catch (const std::bad_alloc&) {
    throw out_of_memory(verb.shared());
  }
}

/// Throws if there are more words than `most`.
void check_count(const Program& program, const std::vector<std::string>& words, std::size_t most) {
  if (words.size() > most) {
    throw usage(fmt::format("unexpected argument {}", words[most]),
                fmt::format("see {} --help", program.name));
  }
}

int run(const Program& program, const std::vector<std::string>& words) {
  if (words.empty() || words[0] == "--help" || words[0] == "-h") {
    print_help(help_of(program));
    return 0;
  }
  if (words[0] == "--") {  // the end of options before the verb, of which there are none
    return run(program, {words.begin() + 1, words.end()});
  }
  if (words[0] == "help") {
    check_count(program, words, 2);
    const bool itself = words.size() == 1 || words[1] == "help" || words[1].starts_with("-");
    return itself ? run(program, {}) : run_verb(program, find_verb(program, words[1]), {"--help"});
  }
  if (words[0] == "--version" || words[0] == "-V") {
    check_count(program, words, 1);
    print_plain(fmt::format("{} {}\n", program.name, SOMS_VERSION));
    return 0;
  }
  return run_verb(program, find_verb(program, words[0]), {words.begin() + 1, words.end()});
}

int fail(const Program& program, const std::vector<std::string>& words, std::string_view message,
         int status) {
  const bool named =
      !words.empty() && std::any_of(program.verbs.begin(), program.verbs.end(),
                                    [&](auto& verb) { return verb.name == words[0]; });
  print_error(named ? fmt::format("{} {}", program.name, words[0]) : std::string(program.name),
              message);
  return status;
}

}  // namespace

std::string about_verbs(const Program& program) {
  return fmt::format(
      "{0} VERB --help lists the options of a verb and shows an example.\n"
      "{0} --version prints the version.\n",
      program.name);
}

std::string help_of(const Program& program) {
  std::string text = fmt::format("{0}: {1}\nUsage: {0} VERB [OPTIONS] ...\n\nVerbs:\n",
                                 program.name, program.summary);
  for (const Verb& verb : program.verbs) {
    text += fmt::format("  {:<12}{}\n", verb.name, verb.question);
  }
  text += "\n" + about_verbs(program);
  Parser shared("", std::string(program.name));
  Shared values;
  add_help_option(shared);
  add_shared_options(shared, values);
  text += fmt::format("\n{}:\n{}\n{}", kSharedGroup, shared.lines_of(kSharedGroup), kAboutAnswers);
  return text;
}

int run_program(const Program& program, const std::vector<std::string>& words) {
  hold_standard_streams();
  // A reader that went away, or a limit on file sizes, shall be an error of write(), not a death.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // Where who started us ignores the ends of children, theirs would be lost to us.
  std::signal(SIGCHLD, SIG_DFL);
  try {
    return run(program, words);
  } catch (const ClosedPipe&) {
    return 0;
  } catch (const Error& error) {
    const bool bare = error.kind() == ErrorKind::cancelled && error.remedy().empty();
    return fail(program, words, bare ? "interrupted" : error.what(), exit_code(error.kind()));
  } catch (const std::bad_alloc&) {
    return fail(program, words, "not enough memory; free some memory", 4);
  } catch (const std::logic_error& error) {
    // A fault of ours, such as two ways to one answer that differ: reported as --verify reports it.
    return fail(program, words, fmt::format("internal error: {}", error.what()), 6);
  } catch (const std::system_error& error) {
    return fail(program, words,
                fmt::format("the system refused: {}; try --threads 1", error.what()), 4);
  } catch (const std::exception& error) {
    // Nothing else is thrown on purpose; a program that aborts would not even say so much.
    return fail(program, words, fmt::format("internal error: {}", error.what()), 6);
  }
}

}  // namespace soms::command
