#include "soms/query/instruction_set.h"

#include "thesis/page/report.h"
#include "thesis/run/build.h"

#include <fmt/format.h>
#include <sched.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace soms::reproduce {

namespace {

/// The value of the first line "key<spaces><mark>value" of a file; empty if there is none.
std::string first_value(const std::filesystem::path& file, std::string_view key, char mark) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t at = line.find(mark);
    if (line.starts_with(key) && at != std::string::npos) {
      const std::size_t begin = line.find_first_not_of(" \t\"", at + 1);
      const std::size_t end = line.find_last_not_of(" \t\"");
      return begin == std::string::npos ? "" : line.substr(begin, end - begin + 1);
    }
  }
  return {};
}

std::string processor() {
  const std::string model = first_value("/proc/cpuinfo", "model name", ':');
  utsname kernel{};
  uname(&kernel);
  return model.empty() ? kernel.machine : model;
}

std::string system() {
  const std::string pretty = first_value("/etc/os-release", "PRETTY_NAME", '=');
  utsname kernel{};
  uname(&kernel);
  return fmt::format("{}, {} {}", pretty.empty() ? "unknown distribution" : pretty, kernel.sysname,
                     kernel.release);
}

std::string compiler() {
#ifdef __clang__
  const std::string name =
      fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  const std::string name =
      fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
#ifdef __OPTIMIZE__
  return name + ", optimized";
#else
  return name + ", not optimized";
#endif
}

/// The processors that this process may run on, by number.
std::vector<int> usable_processors() {
  constexpr std::size_t kSets = 16;  // of 1,024 processors each
  std::array<cpu_set_t, kSets> sets{};
  std::vector<int> numbers;
  if (sched_getaffinity(0, sizeof(sets), sets.data()) == 0) {
    for (int number = 0; number < static_cast<int>(kSets) * CPU_SETSIZE; ++number) {
      if (CPU_ISSET_S(static_cast<std::size_t>(number), sizeof(sets), sets.data())) {
        numbers.push_back(number);
      }
    }
  }
  return numbers;
}

std::uint64_t memory() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long bytes = sysconf(_SC_PAGESIZE);
  return pages > 0 && bytes > 0
             ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(bytes)
             : 0;
}

/// A word as a POSIX shell takes it back.
std::string shell_word(std::string_view word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./=:,+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) {
    return std::string(word);
  }
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'') {
      quoted += R"('\'')";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

}  // namespace

std::string joined_ranges(std::span<const int> numbers) {
  std::string text;
  for (std::size_t first = 0; first < numbers.size();) {
    std::size_t last = first;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) {
      ++last;
    }
    text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[first]);
    if (last > first) {
      text += fmt::format("-{}", numbers[last]);
    }
    first = last + 1;
  }
  return text;
}

std::string shell_line(std::span<const std::string> words) {
  std::string line;
  for (const std::string& word : words) {
    line += line.empty() ? "" : " ";
    line += shell_word(word);
  }
  return line;
}

std::string command_line() {
  std::ifstream in("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(in, word, '\0');) {
    words.push_back(word);
  }
  return shell_line(words);
}

Machine this_machine() {
  const Build build = this_build();
  return {.processor = processor(),
          .system = system(),
          .compiler = compiler(),
          .version = std::string(build.version),
          .processors = static_cast<int>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN))),
          .usable_processors = joined_ranges(usable_processors()),
          .memory = memory(),
          .instruction_set = std::string(instruction_set()),
          .commit = std::string(build.commit),
          .build_type = std::string(build.type),
          .flags = std::string(build.flags)};
}

}  // namespace soms::reproduce
