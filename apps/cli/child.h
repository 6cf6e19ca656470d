/// \file
/// Other programs, run in the place of the command or for it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soms::command {

class Console;

/// A program and how it is come by.
struct ChildProgram {
  std::string name;                           ///< of its file
  std::string variable;                       ///< of the environment, which names another file
  std::string remedy;                         ///< what to do where it is missing
  std::vector<std::string> other_names = {};  ///< of its file, elsewhere
};

/// Its file: the one that the variable names, else the one beside the command, else
/// libexec/soms/NAME under the command's prefix, else the first on PATH; other names, in their
/// order, where none has the first. \errors ErrorKind::unsupported where there is none.
[[nodiscard]] std::filesystem::path find_program(const ChildProgram& program);

/// The program soms-view, sought as `find_program` does.
/// \errors ErrorKind::unsupported where there is none; the remedy says how to get it.
[[nodiscard]] std::filesystem::path viewer_program();

/// A path that a child does not take for an option.
[[nodiscard]] std::string as_argument(const std::string& path);

/// How a child is run.
struct ChildOptions {
  std::string called = {};  ///< its first argument; empty: its path
  bool timed = true;        ///< --timeout ends it
  /// Folder of a child that is a stranger to soms: its home, so that it writes nothing elsewhere.
  /// It reads nothing, what it says goes to the file `said` there, and it is killed with all that
  /// it started. Empty: a program of soms.
  std::filesystem::path home = {};
};

/// Runs `program` with `words` and waits: on the command's own standard input, output and error,
/// unless it has a home. Returns its exit status, 128 + n where signal n ended it. Ctrl-C and
/// --timeout end it.
/// \errors ErrorKind::unsupported where it cannot be started; ErrorKind::timed_out; cancelled.
[[nodiscard]] int run_child(const std::filesystem::path& program,
                            const std::vector<std::string>& words, const Console& console,
                            const ChildOptions& options = {});

/// Becomes `program`, called by a name. Returns only by an exception.
/// \errors ErrorKind::unsupported where it cannot be started.
[[noreturn]] void become(const std::filesystem::path& program, const std::string& called,
                         const std::vector<std::string>& words);

/// What `program`, called by a name (empty: its path), says on standard output; empty where it
/// cannot be started.
[[nodiscard]] std::string output_of(const std::filesystem::path& program,
                                    const std::vector<std::string>& words,
                                    const std::string& called = {});

/// What a child said on standard output and standard error, in the order in which it came.
struct ChildAnswer {
  int status = 0;  ///< its exit status, 128 + n where signal n ended it
  std::string text = {};
};

/// Runs `program` with `words` and waits.
/// \errors ErrorKind::unsupported where it cannot be started; ErrorKind::out_of_memory.
[[nodiscard]] ChildAnswer answer_of(const std::filesystem::path& program,
                                    const std::vector<std::string>& words);

}  // namespace soms::command
