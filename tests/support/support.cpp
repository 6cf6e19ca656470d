#include "tests/support/support.h"

#include "soms/base/hash.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace soms::test {

namespace {

std::uint64_t seed_of(std::string_view tag, int i) {
  Fnv1a hash;
  for (const char c : tag) {
    hash.add_byte(static_cast<std::uint8_t>(c));
  }
  hash.add(static_cast<std::uint32_t>(i));
  return hash.value();
}

int factor() {
  const char* text = std::getenv("SOMS_TEST_FACTOR");
  return text == nullptr ? 1 : static_cast<int>(std::max(1L, std::strtol(text, nullptr, 10)));
}

std::string read_all(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

[[noreturn]] void run_child(const std::vector<std::string>& arguments,
                            const std::filesystem::path& in, const std::filesystem::path& out,
                            const std::filesystem::path& err) {
  const auto redirect = [](const std::filesystem::path& path, int flags, int target) {
    const int fd = open(path.c_str(), flags, 0600);
    if (fd < 0 || dup2(fd, target) < 0) {
      _exit(126);
    }
    close(fd);
  };
  redirect(in, O_RDONLY, STDIN_FILENO);
  redirect(out, O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
  redirect(err, O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
  std::vector<char*> argv;
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  execvp(argv[0], argv.data());
  _exit(127);
}

/// Unpacks `packed` into a temporary folder of this process, once.
std::filesystem::path unpack(const std::filesystem::path& packed, std::string_view name) {
  static const TemporaryFolder folder;
  const std::filesystem::path target = folder.path() / name;
  if (!std::filesystem::exists(target)) {
    std::filesystem::create_directories(target.parent_path());
    const RunResult result = run_program({"xz", "-dc", packed.string()});
    if (result.status != 0) {
      throw std::runtime_error("xz -dc " + packed.string() + ": " + result.err);
    }
    std::ofstream(target, std::ios::binary) << result.out;
  }
  return target;
}

}  // namespace

void for_each_case(std::string_view tag, int n, const std::function<void(Rng&)>& body) {
  for (int i = 0; i < n * factor(); ++i) {
    SCOPED_TRACE(std::string(tag) + ", case " + std::to_string(i));
    Rng rng(seed_of(tag, i));
    body(rng);
    if (::testing::Test::HasFailure()) {
      return;
    }
  }
}

std::filesystem::path data(std::string_view name) {
  const std::filesystem::path plain = std::filesystem::path(SOMS_TEST_DATA) / name;
  std::filesystem::path packed = plain;
  packed += ".xz";
  if (!std::filesystem::exists(plain) && std::filesystem::exists(packed)) {
    return unpack(packed, name);
  }
  return plain;
}

std::optional<std::filesystem::path> outside_data(std::string_view name) {
  const char* folder = std::getenv("SOMS_DATA");
  if (folder == nullptr || *folder == '\0') {
    return std::nullopt;
  }
  return std::filesystem::path(folder) / name;
}

std::filesystem::path command() {
  return SOMS_COMMAND;
}

std::vector<std::vector<std::string>> read_csv(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) {
    throw std::runtime_error("cannot open " + file.string());
  }
  std::vector<std::vector<std::string>> rows;
  std::string line;
  while (std::getline(in, line)) {
    std::vector<std::string>& row = rows.emplace_back();
    row.emplace_back();
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"') {
        const bool doubled = quoted && line.compare(i, 2, "\"\"") == 0;
        quoted = doubled || !quoted;
        if (doubled) {
          row.back() += line[++i];
        }
      } else if (line[i] == ',' && !quoted) {
        row.emplace_back();
      } else {
        row.back() += line[i];
      }
    }
  }
  return rows;
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "soms-test-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error("cannot make a temporary folder");
  }
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

RunResult run_program(const std::vector<std::string>& arguments, const std::string& input) {
  const TemporaryFolder folder;
  const auto in = folder.path() / "in";
  const auto out = folder.path() / "out";
  const auto err = folder.path() / "err";
  std::ofstream(in, std::ios::binary) << input;
  const pid_t child = fork();
  if (child < 0) {
    throw std::runtime_error("cannot fork");
  }
  if (child == 0) {
    run_child(arguments, in, out, err);
  }
  int status = 0;
  waitpid(child, &status, 0);
  RunResult result;
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = read_all(out);
  result.err = read_all(err);
  return result;
}

}  // namespace soms::test
