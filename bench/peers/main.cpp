// Asks every library the same, lets the judge compare the answers, and writes one table.
#include "soms/base/error.h"
#include "soms/base/text.h"

#include "bench/peers/core/machine.h"
#include "bench/peers/core/tables.h"
#include "bench/peers/libraries/modules.h"
#include "bench/peers/options.h"
#include "bench/peers/scenarios/catalog.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>

namespace soms::bench {

namespace {

constexpr int kWrongAnswer = 6;

/// What messages begin with: this program, or the verb that started it.
std::string caller(int argc, char** argv) {
  constexpr std::string_view kVerb = "soms bench";
  return std::string(argc > 0 && argv[0] == kVerb ? kVerb : "soms-bench");
}

Roster libraries(const Options& options) {
  Roster roster;
  const std::vector<std::string> faults = add_modules(roster, module_folder());
  if (!options.quiet) {
    for (const std::string& fault : faults) {
      std::cerr << options.caller << ": cannot load a peer library: " << printable(fault) << '\n';
    }
    if (roster.empty()) {
      std::cerr << options.caller << ": no peer library found in "
                << printable(module_folder().string())
                << "; see docs/bench.md for how to build them\n";
    }
  }
  add_soms(roster);
  return roster;
}

void tell(const Cell& cell) {
  const Entry* peer = best_peer(cell);
  std::cerr << name(cell.job) << ' ' << cell.scene << ' ' << cell.set << ' ' << cell.triangles;
  if (peer != nullptr) {
    std::cerr << ": " << peer->library << ' ' << 1e6 * peer->timing.median << " us";
  }
  for (const Entry& e : cell.entries) {
    if (is_ours(e.library)) {
      const auto reached = ratio(cell, e.library);
      std::cerr << "; " << e.library << ' ' << 1e6 * e.timing.median << " us";
      if (reached) {
        std::cerr << ", " << *reached << " times";
      }
    }
    if (e.verdict.wrong != 0) {
      std::cerr << "; " << e.library << " is wrong in " << e.verdict.wrong << " of "
                << e.verdict.checked;
    }
  }
  std::cerr << '\n';
}

std::string selection(const Options& options) {
  std::string text = options.quick ? "quick" : "whole";
  for (const std::string& scene : options.scenes) {
    text += ", scenes " + scene;
  }
  for (const std::string& library : options.run.libraries) {
    text += ", libraries " + library;
  }
  text += ", seed " + std::to_string(options.seed);
  return text + ", from " + std::to_string(options.least) + " to " + std::to_string(options.most) +
         " triangles";
}

std::vector<Offer> chosen(const Options& options) {
  std::vector<Offer> offers = catalog(options.data, options.seed);
  std::erase_if(offers, [&](const Offer& offer) {
    const bool named = options.scenes.empty() ||
                       std::any_of(options.scenes.begin(), options.scenes.end(),
                                   [&](const auto& name) { return offer.scene.starts_with(name); });
    const bool sized = offer.triangles == 0 ||
                       (offer.triangles >= options.least && offer.triangles <= options.most);
    return !named || !sized || (options.quick && options.scenes.empty() && !offer.quick);
  });
  return offers;
}

/// Before the race: a place that cannot be written to is reported before the work, not after it.
/// \errors ErrorKind::cannot_write.
void make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw Error(ErrorKind::cannot_write,
                folder.string() + ": cannot create the folder: " + failed.message(),
                "choose another location for the output");
  }
}

int run_catalog(const Options& options, const RunFacts& facts) {
  const Roster roster = libraries(options);
  make_folder(options.out);
  std::vector<Cell> cells;
  for (const Offer& offer : chosen(options)) {
    run_scene(offer.make(), roster, options.run, [&](Cell cell) {
      if (!options.quiet) {
        tell(cell);
      }
      cells.push_back(std::move(cell));
      write_csv(options.out / "peers.csv", cells);
      write_markdown(options.out / "peers.md", cells, facts);
    });
  }
  return sound(cells) ? 0 : kWrongAnswer;
}

int run_files(const Options& options, const RunFacts& facts) {
  if (!options.out.empty()) {
    make_folder(options.out);
  }
  const Roster roster = libraries(options);
  const Scene scene = own_files_scene(options.files[0], options.files[1], options.poses,
                                      options.random, options.seed, options.strict);
  if (!options.quiet) {
    for (const std::string& warning : scene.warnings) {
      std::cerr << options.caller << ": warning: " << warning << '\n';
    }
  }
  std::vector<Cell> cells;
  run_scene(scene, roster, options.run, [&](Cell cell) { cells.push_back(std::move(cell)); });
  if (options.json) {
    print_json(std::cout, cells, scene.doubts);
  } else {
    print_times(std::cout, cells);
  }
  if (!options.out.empty()) {
    write_csv(options.out / "peers.csv", cells);
    write_markdown(options.out / "peers.md", cells, facts);
  }
  return sound(cells) ? 0 : kWrongAnswer;
}

int run(const Options& options) {
  if (options.list) {
    for (const Offer& offer : chosen(options)) {
      std::cout << offer.scene << (offer.triangles == 0 ? "" : " ")
                << (offer.triangles == 0 ? "" : std::to_string(offer.triangles)) << '\n';
    }
    return 0;
  }
  const RunFacts facts{isa(), pin(options.cpu), options.run.race.rounds, selection(options)};
  return options.files.empty() ? run_catalog(options, facts) : run_files(options, facts);
}

/// Tells that standard output took no more; a reader that went away is no error.
int cannot_write(const std::string& caller, int fault) {
  if (fault == EPIPE) {
    return 0;
  }
  std::cerr << caller
            << ": standard output: cannot write: " << std::generic_category().message(fault)
            << "; choose another location for the output\n";
  return exit_code(ErrorKind::cannot_write);
}

}  // namespace

}  // namespace soms::bench

int main(int argc, char** argv) {
  const std::string caller = soms::bench::caller(argc, argv);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    auto options = soms::bench::parse(argc, argv);
    if (!options) {
      return 0;
    }
    options->caller = caller;
    const int status = soms::bench::run(*options);
    std::cout.flush();
    return std::cout ? status : soms::bench::cannot_write(caller, errno);
  } catch (const soms::Error& error) {
    std::cerr << caller << ": " << soms::printable(error.what()) << '\n';
    return soms::exit_code(error.kind());
  } catch (const std::exception& error) {
    std::cerr << caller << ": " << soms::printable(error.what()) << '\n';
    return 4;
  }
}
