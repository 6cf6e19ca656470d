// Asks every contestant the same, lets the judge compare the answers, and writes one table.
#include "soms/base/error.h"

#include "bench/peers/contestants/contestant.h"
#include "bench/peers/core/judge.h"
#include "bench/peers/core/report.h"
#include "bench/peers/core/timing.h"
#include "bench/peers/options.h"
#include "bench/peers/scenarios/scene.h"

#include <algorithm>
#include <functional>
#include <iostream>

namespace soms::bench {

namespace {

/// A scene that can be made, and its size.
struct Offer {
  const char* name;
  std::uint64_t triangles;
  Scene (*make)(std::uint64_t);
};

constexpr Offer kOffers[] = {
    {"city-car", 5'672, city_car_scene},
    {"city-car", 100'000, city_car_scene},
    {"city-car", 1'000'000, city_car_scene},
    {"city-drone", 5'672, city_drone_scene},
    {"city-drone", 100'000, city_drone_scene},
    {"city-drone", 1'000'000, city_drone_scene},
    {"streets", 5'672, street_scene},
    {"streets", 1'000'000, street_scene},
    {"knot", 1'000, knot_scene},
    {"knot", 10'000, knot_scene},
    {"knot", 100'000, knot_scene},
};

Roster roster() {
  Roster all;
#if SOMS_BENCH_FCL
  soms_bench_fcl(all);
#endif
  add_soms(all);
  return all;
}

void run(const Scene& scene, const Roster& all, const Options& options, std::vector<Cell>& cells) {
  std::vector<std::unique_ptr<Match>> matches;
  std::vector<double> builds;
  for (const auto& contestant : all) {
    const double start = processor_seconds();
    matches.push_back(contestant->prepare(scene.mover, scene.fixed));
    builds.push_back(processor_seconds() - start);
  }
  for (const PoseSet& set : scene.sets) {
    std::vector<std::vector<std::uint8_t>> answers;
    const auto timings = race(matches, set.poses, options.passes, answers);
    const auto verdicts = judge(scene.mover, scene.fixed, set.poses, answers, options.judge);
    Cell cell{scene.name,
              set.name,
              scene.fixed.triangles.size(),
              scene.mover.triangles.size(),
              set.poses.size(),
              0,
              {}};
    cell.touching =
        static_cast<std::size_t>(std::count(answers.back().begin(), answers.back().end(), 1));
    for (std::size_t k = 0; k < all.size(); ++k) {
      cell.entries.push_back({all[k]->name(), builds[k], timings[k], verdicts[k]});
      for (const std::size_t pose : verdicts[k].wrong_poses) {
        std::cerr << scene.name << ' ' << set.name << ", pose " << pose << ": " << all[k]->name()
                  << " is wrong\n";
      }
      std::cerr << scene.name << ' ' << cell.triangles << ' ' << set.name << ", " << all[k]->name()
                << ": " << 1e6 * timings[k].median << " us, " << ratio(cell, all[k]->name())
                << " times the fastest FCL\n";
    }
    cells.push_back(std::move(cell));
  }
}

int run_all(const Options& options) {
  const Roster all = roster();
  std::vector<Cell> cells;
  if (!options.city.empty()) {
    run(file_scene(options.city, options.mover), all, options, cells);
  } else {
    for (const Offer& offer : kOffers) {
      const bool wanted = std::count(options.scenes.begin(), options.scenes.end(), offer.name) > 0;
      if (wanted && offer.triangles <= options.most) {
        run(offer.make(offer.triangles), all, options, cells);
      }
    }
  }
  write_csv(options.out + ".csv", cells);
  write_markdown(options.out + ".md", cells, options.passes);
  const bool sound = std::all_of(cells.begin(), cells.end(), [](const Cell& cell) {
    return std::all_of(cell.entries.begin(), cell.entries.end(), [](const Entry& e) {
      return !e.contestant.starts_with("soms") || e.verdict.wrong == 0;
    });
  });
  return sound ? 0 : 6;
}

}  // namespace

}  // namespace soms::bench

int main(int argc, char** argv) {
  try {
    const auto options = soms::bench::parse(argc, argv);
    return options ? soms::bench::run_all(*options) : 0;
  } catch (const soms::Error& error) {
    std::cerr << "peers: " << error.what() << '\n';
    return soms::exit_code(error.kind());
  }
}
