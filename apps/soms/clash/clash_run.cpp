#include "apps/soms/clash/clash_run.h"

#include "soms/base/error.h"
#include "soms/clash/reference/clash.h"

#include "apps/cli/console.h"
#include "apps/soms/clash/clash_journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

namespace soms::command {

namespace {

/// Pairs of parts that are decided at a time: between two blocks Ctrl-C ends the list.
constexpr std::size_t kPairsOfABlock = 1024;

std::vector<PartNumbers> candidates_of(const ClashModels& models, const ClashOptions& options) {
  return models.two_sets ? clash_candidates(models.a.parts, models.b.parts, options)
                         : clash_candidates(models.a.parts, options);
}

/// Takes over what a journal has.
void go_on(const ClashJournal& journal, ClashRun& run) {
  const DecidedClashes& kept = journal.kept();
  run.clashes = kept.clashes;
  run.done = run.resumed = kept.done;
  run.compared = kept.done;
  run.cost = kept.cost;
}

}  // namespace

ClashRun decide_clashes(const ClashModels& models, const ClashOptions& options,
                        const std::string& journal, const Console& console) {
  ClashRun run;
  run.candidates = candidates_of(models, options);
  const std::span<const PartNumbers> all(run.candidates);
  std::optional<ClashJournal> kept;
  if (!journal.empty()) {
    kept.emplace(journal, models, options, all);
    go_on(*kept, run);
  }
  bool whole = true;
  Progress bar = console.progress("comparing parts");
  while (run.done < all.size() && !run.interrupted) {
    const auto block = all.subspan(run.done, std::min(kPairsOfABlock, all.size() - run.done));
    try {
      const ClashList list =
          clashes_of(models.a.parts, models.second().parts, block, options, console.limits());
      run.clashes.insert(run.clashes.end(), list.clashes.begin(), list.clashes.end());
      run.compared += list.compared;
      run.cost += list.cost;
      run.done += block.size();
      whole = whole && list.left_out == 0;
      if (kept && whole) {
        kept->add(run.done, list);
      }
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::cancelled) {
        throw;
      }
      run.interrupted = true;
    }
    bar.show(static_cast<double>(run.done) / static_cast<double>(all.size()));
  }
  run.left = all.size() - run.compared;
  return run;
}

std::uint64_t count_wrong_clashes(const ClashModels& models, const ClashRun& run,
                                  const ClashOptions& options, Console& console) {
  std::uint64_t wrong = 0;
  console.run("verifying", [&](const Limits& limits) {
    auto next = run.clashes.begin();
    const std::vector<PartBody>& a = models.a.parts;
    const std::vector<PartBody>& b = models.second().parts;
    for (std::uint32_t i = 0; i < a.size(); ++i) {
      limits.progress(static_cast<double>(i) / static_cast<double>(a.size()));
      for (std::uint32_t j = models.two_sets ? 0 : i + 1; j < b.size(); ++j) {
        if (options.wanted && !options.wanted(i, j)) {
          continue;
        }
        std::optional<Clash> found;
        if (next != run.clashes.end() && next->a == i && next->b == j) {
          found = *next++;
          found->a = found->b = 0;
          found->place = {};
          found->box = {};
          found->penetration.reset();
        }
        if (found != reference::clash_by_brute_force(a[i], b[j], options.within, limits)) {
          ++wrong;
          print_error("soms clash",
                      fmt::format("parts {} and {}: brute force finds otherwise", i, j));
        }
      }
    }
  });
  return wrong;
}

}  // namespace soms::command
