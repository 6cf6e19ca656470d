#include "apps/cli/shared.h"

#include "soms/base/threads.h"

#include "apps/cli/parse.h"

#include <fmt/format.h>

#include <string_view>

namespace soms::command {

void add_help_option(Parser& parser) {
  parser.add_help("-h,--help", "print this help")->group(kSharedGroup);
}

void add_shared_options(Parser& parser, Shared& shared) {
  const char* const group = kSharedGroup;
  parser.add_flag("--json", shared.json, "print answers as JSON")->group(group);
  parser.add_flag("-q,--quiet", shared.quiet, "print only errors on standard error")->group(group);
  add_count(parser, "--threads", shared.threads, 0, kMostThreads,
            "number of threads; 0: one per processor")
      ->group(group);
  add_count(parser, "--seed", shared.seed, 0, ~std::uint64_t{0}, "seed of all random choices (1)")
      ->group(group);
  add_seconds(parser, "--timeout", shared.timeout, "stop after this many seconds")->group(group);
  add_bytes(parser, "--max-memory", shared.max_memory, "memory limit, such as 500M or 2G")
      ->group(group);
}

std::string size_words(std::uint64_t bytes) {
  constexpr std::string_view kUnits = "KMGT";
  std::size_t power = 0;
  while (bytes != 0 && bytes % 1024 == 0 && power < kUnits.size()) {
    bytes /= 1024;
    ++power;
  }
  return power == 0 ? fmt::format("{}", bytes) : fmt::format("{}{}", bytes, kUnits[power - 1]);
}

Error out_of_memory(const Shared& shared, const std::string& place) {
  const std::string where = place.empty() ? "" : place + ": ";
  if (shared.max_memory == 0) {
    return {ErrorKind::out_of_memory, where + "not enough memory",
            "free some memory, or use a smaller model"};
  }
  return {ErrorKind::out_of_memory,
          fmt::format("{}--max-memory {} is not enough", where, size_words(shared.max_memory)),
          "raise the limit, or use a smaller model"};
}

}  // namespace soms::command
