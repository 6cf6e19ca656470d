#include "bench/peers/core/machine.h"

#include "soms/query/instruction_set.h"

#include <malloc.h>
#include <sched.h>

#include <array>
#include <cctype>
#include <ctime>
#include <fstream>
#include <regex>
#include <thread>

namespace soms::bench {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line)) {
    if (line.starts_with("model name")) {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown processor";
}

std::string isa() {
  return std::string(instruction_set());
}

std::string machine_folder() {
  const std::string plain =
      std::regex_replace(processor(), std::regex(R"(\((R|TM)\)|CPU|Processor)"), "");
  std::string name;
  for (const char c : plain) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.') {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  if (!name.empty() && name.back() == '-') {
    name.pop_back();
  }
  return name + "-" + std::to_string(std::thread::hardware_concurrency()) + "-cores_" + isa();
}

int pin(int cpu) {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) {
    return -1;
  }
  int chosen = cpu;
  for (int i = 0; cpu < 0 && i < CPU_SETSIZE; ++i) {
    chosen = CPU_ISSET(static_cast<std::size_t>(i), &allowed) ? i : chosen;
  }
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(chosen), &one);
  return sched_setaffinity(0, sizeof one, &one) == 0 ? chosen : -1;
}

std::size_t heap_bytes() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 16> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts);
  return {text.data(), size};
}

}  // namespace soms::bench
