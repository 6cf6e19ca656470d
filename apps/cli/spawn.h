/// \file
/// How programs are started, for all that starts one.
#pragma once

#include "soms/base/error.h"

#include <spawn.h>
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace soms::command {

/// Words as a program takes them; pointers last as long as the object.
class Arguments {
 public:
  Arguments(const std::string& first, std::vector<std::string> words)
      : Arguments(with_first(first, std::move(words))) {}

  explicit Arguments(std::vector<std::string> words) : words_(std::move(words)) {
    for (std::string& word : words_) {
      pointers_.push_back(word.data());
    }
    pointers_.push_back(nullptr);
  }

  [[nodiscard]] char* const* get() { return pointers_.data(); }

 private:
  static std::vector<std::string> with_first(const std::string& first,
                                             std::vector<std::string> words) {
    words.insert(words.begin(), first);
    return words;
  }

  std::vector<std::string> words_;
  std::vector<char*> pointers_;
};

/// What a program that does not start is reported as. `fault` is an errno.
[[nodiscard]] Error not_started(const std::filesystem::path& program, int fault);

/// What a child has for standard streams, and who it is.
struct Surroundings {
  const posix_spawn_file_actions_t* files = nullptr;
  std::filesystem::path home = {};  ///< as ChildOptions has it; then it leads a process group
  bool apart = false;               ///< it leads a process group, so that Ctrl-C does not reach it
};

/// Starts a child to which signals mean what they usually do; `called` is its first argument,
/// empty: its path. \errors Those of `not_started`.
[[nodiscard]] pid_t start_program(const std::filesystem::path& program,
                                  const std::vector<std::string>& words, const std::string& called,
                                  const Surroundings& around);

/// The exit status of what `waitpid` says, 128 + n where signal n ended it.
[[nodiscard]] int exit_status_of(int status);

}  // namespace soms::command
