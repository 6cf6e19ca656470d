#include "tests/view/window/display.h"

#include "tests/support/support.h"
#include "tests/support/wait.h"
#include "tests/view/window/drop.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace soms::view::test_window {

namespace {

bool installed(const std::string& program) {
  std::istringstream folders(std::getenv("PATH") == nullptr ? "" : std::getenv("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (::access((folder + "/" + program).c_str(), X_OK) == 0) {
      return true;
    }
  }
  return false;
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> all;
  for (const std::string& word : words) {
    all.push_back(const_cast<char*>(word.c_str()));
  }
  all.push_back(nullptr);
  return all;
}

/// The variables of this process without those of a display, and these.
std::vector<std::string> environment(const std::vector<std::string>& more) {
  std::vector<std::string> all;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string text = *variable;
    if (text.rfind("DISPLAY=", 0) != 0 && text.rfind("WAYLAND_DISPLAY=", 0) != 0) {
      all.push_back(text);
    }
  }
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

int status_of(int raw) {
  return WIFSIGNALED(raw) ? 128 + WTERMSIG(raw) : WEXITSTATUS(raw);
}

}  // namespace

bool Display::possible() {
  return installed("Xvfb") && installed("xdotool");
}

Display::Display(int density) {
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) {
    throw std::runtime_error("no pipe");
  }
  const std::string descriptor = std::to_string(pipe[1]);
  // Without -noreset the server start over, and refuses clients meanwhile, when its last one goes.
  const std::vector<std::string> words{"Xvfb", "-noreset",    "-displayfd", descriptor, "-screen",
                                       "0",    "1280x720x24", "-nolisten",  "tcp"};
  const std::vector<char*> arguments = pointers(words);
  server_ = ::fork();
  if (server_ == 0) {
    ::close(pipe[0]);
    const int nothing = ::open("/dev/null", O_RDWR);
    ::dup2(nothing, STDOUT_FILENO);
    ::dup2(nothing, STDERR_FILENO);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  ::close(pipe[1]);
  // The server writes its number once it listens, and closes the pipe if it cannot.
  std::string number;
  for (char c = 0; ::read(pipe[0], &c, 1) == 1 && c != '\n';) {
    number.push_back(c);
  }
  ::close(pipe[0]);
  if (number.empty()) {
    end();
    throw std::runtime_error("Xvfb did not start");
  }
  name_.push_back(':');
  name_.append(number);
  if (density != 1) {
    set_density(name_, density);
  }
}

Display::~Display() {
  end();
}

void Display::end() {
  if (server_ > 0) {
    ::kill(server_, SIGTERM);  // it removes its socket then
    ::waitpid(server_, nullptr, 0);
    server_ = -1;
  }
}

void Display::type(const std::vector<std::string>& words) const {
  std::vector<std::string> all{"env", "DISPLAY=" + name_, "xdotool"};
  all.insert(all.end(), words.begin(), words.end());
  const soms::test::RunResult result = soms::test::run_program(all);
  if (result.status != 0) {
    throw std::runtime_error("xdotool: " + result.err);
  }
}

bool Display::wait_for_window(const std::string& title, RunningProgram& program) const {
  bool is_there = false;
  soms::test::wait_until([&] {
    const bool ended = program.ended();
    const auto found = soms::test::run_program(
        {"env", "DISPLAY=" + name_, "xdotool", "search", "--onlyvisible", "--name", title});
    is_there = found.status == 0;
    return is_there || ended;
  });
  return is_there;
}

unsigned long Display::window(const std::string& title) const {
  const auto found = soms::test::run_program(
      {"env", "DISPLAY=" + name_, "xdotool", "search", "--onlyvisible", "--name", title});
  return std::stoul(found.out);
}

void Display::drag(PixelPoint from, PixelPoint to, const std::function<void()>& taken) const {
  const auto move = [&](double t) {
    const long x = std::lround(from.x + t * (to.x - from.x));
    const long y = std::lround(from.y + t * (to.y - from.y));
    type({"mousemove", std::to_string(x), std::to_string(y)});
    taken();
  };
  move(0);
  type({"mousedown", "1"});
  taken();
  for (const double t : {0.1, 0.4, 0.7, 1.0}) {
    move(t);
  }
  type({"mouseup", "1"});
  taken();
}

RunningProgram::RunningProgram(const std::vector<std::string>& words,
                               const std::filesystem::path& folder, const std::string& display,
                               const std::vector<std::string>& variables)
    : errors_(folder / "errors.txt") {
  std::vector<std::string> more = variables;
  more.emplace_back("LIBGL_ALWAYS_SOFTWARE=1");
  if (!display.empty()) {
    more.push_back("DISPLAY=" + display);
  }
  const std::vector<std::string> environs = environment(more);
  const std::vector<char*> variables_of_child = pointers(environs);
  const std::vector<char*> arguments = pointers(words);
  child_ = ::fork();
  if (child_ == 0) {
    const int file = ::open(errors_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(file, STDERR_FILENO);
    if (::chdir(folder.c_str()) == 0) {
      ::execve(arguments[0], arguments.data(), variables_of_child.data());
    }
    ::_exit(127);
  }
}

RunningProgram::~RunningProgram() {
  if (child_ > 0) {
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
}

int RunningProgram::wait() {
  soms::test::wait_until([&] { return ended(); });
  return status_;
}

bool RunningProgram::ended() {
  int raw = 0;
  if (child_ > 0 && ::waitpid(child_, &raw, WNOHANG) == child_) {
    child_ = -1;
    status_ = status_of(raw);
  }
  return child_ <= 0;
}

void RunningProgram::signal(int number) const {
  ::kill(child_, number);
}

double RunningProgram::processor_seconds() const {
  std::ifstream file("/proc/" + std::to_string(child_) + "/stat");
  std::stringstream text;
  text << file.rdbuf();
  // The name, in brackets, may hold blanks; 11 numbers on come user and system time in ticks.
  std::istringstream fields(text.str().substr(text.str().rfind(')') + 1));
  std::string skipped;
  for (int i = 0; i < 11; ++i) {
    fields >> skipped;
  }
  double user = 0;
  double system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

std::string RunningProgram::errors() const {
  std::ifstream file(errors_);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace soms::view::test_window
