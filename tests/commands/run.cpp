#include "tests/commands/run.h"

#include "tests/support/wait.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace soms::test {

namespace {

void redirect(const std::filesystem::path& path, int target) {
  const int fd = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (fd < 0 || dup2(fd, target) < 0) {
    _exit(126);
  }
}

[[noreturn]] void exec_words(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) {
    argv.push_back(const_cast<char*>(word.c_str()));
  }
  argv.push_back(nullptr);
  execvp(argv[0], argv.data());
  _exit(127);
}

}  // namespace

RunResult soms_run(std::vector<std::string> words, const std::string& input) {
  words.insert(words.begin(), command().string());
  return run_program(words, input);
}

RunResult soms_on_terminal(std::vector<std::string> words) {
  words.insert(words.begin(), command().string());
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child < 0) {
    throw std::runtime_error("cannot fork");
  }
  if (child == 0) {
    setenv("TERM", "xterm", 1);
    exec_words(words);
  }
  RunResult result;
  std::array<char, 4096> bytes{};
  // Reading fails when the child has closed the terminal.
  for (ssize_t got = 1; got > 0;) {
    got = read(terminal, bytes.data(), bytes.size());
    result.out.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  }
  close(terminal);
  int status = 0;
  waitpid(child, &status, 0);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

RunResult shell(const std::string& line) {
  return run_program({"sh", "-c", "soms='" + command().string() + "'; " + line});
}

RunResult run_with_time(const std::function<RunResult(const std::string&)>& run,
                        const std::function<bool(const RunResult&)>& enough) {
  for (double seconds = 0.25;; seconds *= 2) {
    RunResult result = run(std::to_string(seconds));
    if (enough(result)) {
      return result;
    }
  }
}

std::vector<Json> json_lines(const std::string& text) {
  std::vector<Json> values;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    values.push_back(Json::parse(line));
  }
  return values;
}

Child::Child(const std::vector<std::string>& words, const std::filesystem::path& folder)
    : folder_(folder) {
  std::filesystem::remove(folder / "out");
  std::filesystem::remove(folder / "err");
  pid_ = fork();
  if (pid_ < 0) {
    throw std::runtime_error("cannot fork");
  }
  if (pid_ == 0) {
    std::signal(SIGINT, SIG_DFL);
    redirect(folder / "out", STDOUT_FILENO);
    redirect(folder / "err", STDERR_FILENO);
    exec_words(words);
  }
}

void Child::send(int signal) const {
  kill(pid_, signal);
}

void Child::send_together(const std::vector<int>& signals) const {
  send(SIGSTOP);
  for (const int signal : signals) {
    send(signal);
  }
  send(SIGCONT);
}

bool Child::reap(int flags) {
  if (!ended_) {
    rusage usage{};
    ended_ = wait4(pid_, &status_, flags, &usage) == pid_;
    max_resident_ = usage.ru_maxrss;
  }
  return ended_;
}

bool Child::wait_until(const std::function<bool()>& happened) {
  bool has_happened = false;
  // What happened before the end is seen after it.
  test::wait_until([&] {
    const bool ended = reap(WNOHANG);
    has_happened = happened();
    return has_happened || ended;
  });
  return has_happened;
}

bool Child::wait_for_output(std::uintmax_t size) {
  return wait_until([&] {
    std::error_code missing;
    const std::uintmax_t now = std::filesystem::file_size(folder_ / "out", missing);
    return !missing && now >= size;
  });
}

bool Child::wait_for_lines(std::ptrdiff_t count) {
  return wait_until([&] {
    const std::string out = read_text(folder_ / "out");
    return std::count(out.begin(), out.end(), '\n') >= count;
  });
}

std::uintmax_t Child::count_of(const std::string& name) const {
  std::ifstream in("/proc/" + std::to_string(pid_) + "/io");
  std::uintmax_t value = 0;
  for (std::string word; in >> word >> value;) {
    if (word == name) {
      return value;
    }
  }
  return 0;
}

bool Child::wait_for_reading(std::uintmax_t size) {
  return wait_until([&] { return count_of("rchar:") >= size; });
}

bool Child::wait_for_writing(std::uintmax_t size) {
  return wait_until([&] { return count_of("wchar:") >= size; });
}

bool Child::wait_for_interrupts() {
  // It blocks them, and a thread of its own waits for them.
  return wait_until([&] {
    std::ifstream in("/proc/" + std::to_string(pid_) + "/status");
    std::string word;
    while (in >> word && word != "SigBlk:") {
    }
    std::uint64_t blocked = 0;
    in >> std::hex >> blocked;
    return (blocked >> (SIGTERM - 1) & 1) != 0;
  });
}

void Child::send_until_it_ends(int signal) {
  test::wait_until([&] {
    if (!reap(WNOHANG)) {
      send(signal);
    }
    return ended_;
  });
}

RunResult Child::wait() {
  reap(0);
  RunResult result;
  result.status = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  result.out = read_text(folder_ / "out");
  result.err = read_text(folder_ / "err");
  return result;
}

std::string box() {
  return test::data("truth/meshes/box2.ply").string();
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string triangle_off(const std::string& a, const std::string& b, const std::string& c) {
  std::string text = "OFF\n3 1 0\n";
  for (const std::string& corner : {a, b, c}) {
    text += corner + "\n";
  }
  return text + "3 0 1 2\n";
}

}  // namespace soms::test
