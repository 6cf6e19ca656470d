#include "apps/support/shared.h"

#include "apps/support/parse.h"

namespace soms::command {

void add_shared_options(CLI::App& app, Shared& shared) {
  const char* const group = kSharedGroup;
  app.add_flag("--json", shared.json, "answers as JSON, for programs")->group(group);
  app.add_flag("-q,--quiet", shared.quiet, "nothing on standard error but errors")->group(group);
  add_count(app, "--threads", shared.threads, 0, 1024, "threads to use; 0: all processors")
      ->group(group);
  add_count(app, "--seed", shared.seed, 0, ~std::uint64_t{0}, "seed of whatever is random (1)")
      ->group(group);
  add_seconds(app, "--timeout", shared.timeout, "stop after so many seconds")->group(group);
  add_bytes(app, "--max-memory", shared.max_memory, "most memory to take, as 500M or 2G")
      ->group(group);
}

}  // namespace soms::command
