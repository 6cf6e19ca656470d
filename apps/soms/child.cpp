#include "apps/soms/child.h"

#include "soms/base/error.h"

#include "apps/support/console.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

namespace soms::command {

namespace {

/// Starts a child to which signals mean what they usually do.
pid_t start(const std::filesystem::path& program, const std::vector<std::string>& words) {
  std::vector<std::string> copies(words);
  copies.insert(copies.begin(), program.string());
  std::vector<char*> argv;
  argv.reserve(copies.size() + 1);
  for (std::string& word : copies) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
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
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  pid_t child = -1;
  const int fault =
      posix_spawn(&child, program.c_str(), nullptr, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  if (fault != 0) {
    throw Error(ErrorKind::unsupported,
                program.string() + " cannot be started: " + std::strerror(fault),
                "build or install it anew");
  }
  return child;
}

}  // namespace

int run_child(const std::filesystem::path& program, const std::vector<std::string>& words,
              const Console& console) {
  const pid_t child = start(program, words);
  int status = 0;
  bool ending = false;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (!ending && (console.interrupted() || console.out_of_time())) {
      ::kill(child, SIGTERM);
      ending = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  if (console.interrupted()) {
    throw Error(ErrorKind::cancelled, "interrupted", "");
  }
  if (ending) {
    throw Error(ErrorKind::timed_out, "out of time while " + program.filename().string() + " ran",
                "allow more by --timeout");
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace soms::command
