#include "apps/cli/spawn.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

namespace soms::command {

namespace {

/// The environment, for a child with a home of its own with that in the place of the user's.
std::vector<std::string> environment_of(const std::filesystem::path& home) {
  std::vector<std::string> variables;
  for (char* const* variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (home.empty() || !(text.starts_with("HOME=") || text.starts_with("XDG_"))) {
      variables.emplace_back(text);
    }
  }
  if (!home.empty()) {
    variables.push_back("HOME=" + home.string());
  }
  return variables;
}

}  // namespace

Error not_started(const std::filesystem::path& program, int fault) {
  if (fault == ENOMEM) {
    return Error(ErrorKind::out_of_memory,
                 program.string() + " cannot be started: " + std::strerror(fault),
                 "allow more with --max-memory, or free some");
  }
  return Error(ErrorKind::unsupported,
               program.string() + " cannot be started: " + std::strerror(fault),
               "rebuild or reinstall it");
}

pid_t start_program(const std::filesystem::path& program, const std::vector<std::string>& words,
                    const std::string& called, const Surroundings& around) {
  Arguments arguments(called.empty() ? program.string() : called, words);
  Arguments variables(environment_of(around.home));
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  sigset_t usual;
  sigemptyset(&usual);
  sigaddset(&usual, SIGPIPE);
  sigaddset(&usual, SIGXFSZ);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int group = around.home.empty() && !around.apart ? 0 : POSIX_SPAWN_SETPGROUP;
  posix_spawnattr_setflags(
      &attributes, static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | group));
  pid_t child = -1;
  const int fault = posix_spawn(&child, program.c_str(), around.files, &attributes, arguments.get(),
                                variables.get());
  posix_spawnattr_destroy(&attributes);
  if (fault != 0) {
    throw not_started(program, fault);
  }
  return child;
}

int exit_status_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace soms::command
