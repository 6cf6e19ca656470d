#include "reproduce/report.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <fstream>
#include <thread>

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
  std::string name = fmt::format("clang {}.{}", __clang_major__, __clang_minor__);
#else
  std::string name = fmt::format("g++ {}.{}", __GNUC__, __GNUC_MINOR__);
#endif
#ifdef __OPTIMIZE__
  return name + ", optimized";
#else
  return name + ", not optimized";
#endif
}

}  // namespace

Machine this_machine() {
  return {.processor = processor(),
          .system = system(),
          .compiler = compiler(),
          .version = SOMS_VERSION,
          .processors = static_cast<int>(std::thread::hardware_concurrency())};
}

}  // namespace soms::reproduce
