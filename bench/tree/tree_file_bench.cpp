// What a tree file saves and costs: opening it by each check beside reading and building, queries
// of a mapped and a loaded file and of tiles beside those of a built shape, and the memory that two
// processes share. `tree_file_bench [TRIANGLES]` prints ratios of one run, of medians of its time.
#include "soms/base/random.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/ray.h"
#include "soms/query/within.h"
#include "soms/store/tree_file.h"
#include "soms/tiles/cut_tiles.h"
#include "soms/tiles/tiled_queries.h"

#include "bench/measure.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace soms::bench {
namespace {

constexpr int kRuns = 9;

/// Median processor time of each job, in seconds; they take turns.
std::vector<double> in_turn(const std::vector<std::function<void()>>& jobs) {
  std::vector<std::vector<double>> times(jobs.size());
  for (int run = 0; run < kRuns; ++run) {
    for (std::size_t k = 0; k < jobs.size(); ++k) {
      const double begin = processor_seconds();
      jobs[k]();
      times[k].push_back(processor_seconds() - begin);
    }
  }
  std::vector<double> medians;
  for (const std::vector<double>& of_job : times) {
    medians.push_back(median(of_job));
  }
  return medians;
}

std::vector<Pose> places(const Shape& city, std::size_t count) {
  Rng rng(7);
  const Box box = city.bounds();
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    poses.push_back(Pose::about_z(rng.uniform(0, 6.28), {rng.uniform(box.lower.x, box.upper.x),
                                                         rng.uniform(box.lower.y, box.upper.y),
                                                         box.lower.z + rng.uniform(0, 20)}));
  }
  return poses;
}

void print_opening(const std::filesystem::path& model, const std::filesystem::path& file) {
  std::vector<std::function<void()>> jobs{[&] { Shape(read_mesh(model)); }};
  const std::vector<TreeCheck> checks{TreeCheck::trusted, TreeCheck::safe, TreeCheck::sound,
                                      TreeCheck::full};
  for (const TreeCheck check : checks) {
    jobs.emplace_back([&file, check] { static_cast<void>(open_shape(file, {.check = check})); });
  }
  const std::vector<double> times = in_turn(jobs);
  std::printf("%-22s %10s %14s\n", "", "ms", "times sooner");
  std::printf("%-22s %10.2f\n", "read and build", 1e3 * times[0]);
  for (std::size_t k = 0; k < checks.size(); ++k) {
    std::printf("open, %-16s %10.2f %14.1f\n", std::string(name(checks[k])).c_str(),
                1e3 * times[k + 1], times[0] / times[k + 1]);
  }
}

TileSet tiles_of(const Shape& city, const std::filesystem::path& folder, std::size_t count) {
  TileCutter cutter(folder, {.most = city.mesh().triangles.size() / count + 1});
  cutter.add(city.mesh());
  cutter.finish();
  return TileSet::open(folder);
}

void print_queries(const Shape& built, const std::filesystem::path& file) {
  const Shape mapped = open_shape(file, {.check = TreeCheck::trusted});
  const Shape loaded = open_shape(file, {.check = TreeCheck::trusted, .load = true});
  const Shape car(generate_mover(MoverKind::car));
  const std::vector<Pose> poses = places(built, 20'000);
  const std::span<const Pose> few = std::span(poses).first(2000);
  const TiledBody many{tiles_of(built, file.string() + ".many", 25)};
  std::vector<Ray> rays;
  for (const Pose& pose : poses) {  // the way that a car looks
    rays.push_back({pose.apply({0, 0, 1}), pose.apply({1, 0, 1}) - pose.apply({0, 0, 1}), 300});
  }
  const auto row = [&](const char* what, std::size_t rows, const auto& ask) {
    const std::vector<double> times =
        in_turn({[&] { ask(Body(built)); }, [&] { ask(Body(mapped)); }, [&] { ask(Body(loaded)); },
                 [&] { ask(many); }});
    std::printf("%-22s %8.2f us", what, 1e6 * times[0] / static_cast<double>(rows));
    for (std::size_t k = 1; k < times.size(); ++k) {
      std::printf(" %14.3f", times[k] / times[0]);
    }
    std::printf("\n");
  };
  std::printf("%-22s %11s %14s %14s %14s\n", "", "built, a row", "mapped/built", "loaded/built",
              "25 tiles/built");
  row("overlap, any", poses.size(), [&](const auto& city) {
    static_cast<void>(overlap(car, poses, city, {.mode = OverlapMode::any}));
  });
  row("overlap, all pairs", poses.size(),
      [&](const auto& city) { static_cast<void>(overlap(car, poses, city)); });
  row("within 1 m", poses.size(),
      [&](const auto& city) { static_cast<void>(within(car, poses, city, 1)); });
  row("distance", few.size(),
      [&](const auto& city) { static_cast<void>(distance(car, few, city)); });
  row("closest_hit", rays.size(),
      [&](const auto& city) { static_cast<void>(closest_hit(city, std::span<const Ray>(rays))); });
  std::filesystem::remove_all(many.tiles.folder());
}

/// Kilobytes of this process that are its own alone.
std::uint64_t own_kilobytes() {
  std::ifstream file("/proc/self/smaps_rollup");
  std::uint64_t sum = 0;
  for (std::string word; file >> word;) {
    if (word == "Private_Clean:" || word == "Private_Dirty:") {
      std::uint64_t kilobytes = 0;
      file >> kilobytes;
      sum += kilobytes;
    }
  }
  return sum;
}

/// Processes that wait for each other at each step.
class Barrier {
 public:
  explicit Barrier(std::size_t processes) : processes_(processes) {
    if (pipe(up_) != 0 || pipe(down_) != 0) {
      std::abort();
    }
  }

  void wait() const {
    char byte = 0;
    if (write(up_[1], &byte, 1) != 1 || read(down_[0], &byte, 1) != 1) {
      std::abort();
    }
  }

  /// Lets all go on once all wait.
  void open() const {
    char byte = 0;
    for (std::size_t k = 0; k < processes_; ++k) {
      if (read(up_[0], &byte, 1) != 1) {
        std::abort();
      }
    }
    for (std::size_t k = 0; k < processes_; ++k) {
      if (write(down_[1], &byte, 1) != 1) {
        std::abort();
      }
    }
  }

 private:
  std::size_t processes_;
  int up_[2] = {};    // NOLINT(modernize-avoid-c-arrays): as pipe() has it
  int down_[2] = {};  // NOLINT(modernize-avoid-c-arrays)
};

/// Two processes that open the file and query it, each measured beside the other.
void print_memory(const std::filesystem::path& file) {
  std::printf("%-22s %10s %14s\n", "", "file, MB", "own, MB");
  std::fflush(stdout);
  const Barrier barrier(2);
  for (int k = 1; k <= 2; ++k) {
    if (fork() == 0) {
      const std::uint64_t before = own_kilobytes();
      const Shape city = open_shape(file);
      const Shape car(generate_mover(MoverKind::car));
      static_cast<void>(overlap(car, places(city, 20'000), Body(city)));
      barrier.wait();
      const std::uint64_t after = own_kilobytes();
      std::printf("process %-14d %10.1f %14.1f\n", k,
                  static_cast<double>(std::filesystem::file_size(file)) / 1e6,
                  1e-3 * static_cast<double>(after - std::min(before, after)));
      std::fflush(stdout);
      barrier.wait();
      _exit(0);
    }
  }
  barrier.open();
  barrier.open();
  while (wait(nullptr) > 0) {
  }
}

int run(int argc, char** argv) {
  const std::uint64_t triangles = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::filesystem::path model =
      folder / ("tree_file_bench-" + std::to_string(getpid()) + ".ply");
  const std::filesystem::path file = std::filesystem::path(model).replace_extension(".somst");
  write_mesh(model, generate_city({.triangles = triangles}).mesh, MeshFormat::ply);
  {
    const Shape built(read_mesh(model));
    save(file, built);
    print_opening(model, file);
    print_queries(built, file);
  }
  print_memory(file);
  std::filesystem::remove(model);
  std::filesystem::remove(file);
  return 0;
}

}  // namespace
}  // namespace soms::bench

int main(int argc, char** argv) {
  return soms::bench::run(argc, argv);
}
