// How far from what one core can do at all: each of our jobs beside a floor that no program of its
// kind goes below, measured in the same run. `limits_bench [FOLDER]` writes limits.csv and
// limits.svg there.
#include "soms/base/random.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/query/overlap.h"
#include "soms/scene/broad_phase.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include "apps/draw/chart.h"
#include "bench/measure.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace soms::bench {
namespace {

double now() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Median seconds of nine runs, after one that warms caches.
template <class Job>
double seconds(const Job& job) {
  job();
  std::vector<double> times(9);
  for (double& time : times) {
    const double begin = now();
    job();
    time = now() - begin;
  }
  return median(times);
}

/// Keeps the compiler from leaving out what made `value`.
template <class Value>
void use(const Value& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// Seconds of one test of two nodes, 16 pairs of boxes, all in the first cache.
double hot_node_test(const Shape& shape) {
  constexpr std::size_t kTasks = 16;
  const auto nodes = shape.layout().nodes();
  detail::RelativePose relative(shape.layout(), Pose::about_z(0.3, {0.1, 0, 0}),
                                detail::ReferenceFrame(shape.layout(), {}));
  relative.prepare();
  std::array<detail::NodeTask, kTasks> tasks = {};
  for (std::size_t i = 0; i < kTasks; ++i) {
    tasks[i].pose = &relative.numbers();
    tasks[i].x = &nodes[i];
    tasks[i].y = &nodes[2 * i + 1];
  }
  constexpr int kRepeats = 20000;
  const double all = seconds([&] {
    for (int k = 0; k < kRepeats; ++k) {
      for (detail::NodeTask& task : tasks) {
        task.pairs = 0xffff;
      }
      detail::kernels().test_nodes(tasks.data(), kTasks);
      use(tasks);
    }
  });
  return all / (kRepeats * kTasks);
}

/// Seconds of reading and writing one byte of memory that no cache holds.
double streamed_byte() {
  constexpr std::size_t kBytes = std::size_t{1} << 28;
  const std::vector<char> from(kBytes, 1);
  std::vector<char> to(kBytes);
  return seconds([&] {
           std::memcpy(to.data(), from.data(), kBytes);
           use(to);
         }) /
         (2.0 * kBytes);
}

struct Key {
  std::uint32_t key;
  std::uint32_t id;
};

/// Seconds of sorting `count` keys of 32 bits with their numbers, eleven bits a pass.
double sorted_keys(std::size_t count) {
  Rng rng(1);
  std::vector<Key> first(count);
  for (std::size_t i = 0; i < count; ++i) {
    first[i] = {static_cast<std::uint32_t>(rng.next()), static_cast<std::uint32_t>(i)};
  }
  std::vector<Key> from(count);
  std::vector<Key> to(count);
  return seconds([&] {
    from = first;
    for (const unsigned shift : {0U, 11U, 22U}) {
      std::array<std::uint32_t, 2049> begin = {};
      for (const Key& key : from) {
        ++begin[(key.key >> shift & 2047) + 1];
      }
      for (std::size_t k = 0; k < 2048; ++k) {
        begin[k + 1] += begin[k];
      }
      for (const Key& key : from) {
        to[begin[key.key >> shift & 2047]++] = key;
      }
      from.swap(to);
    }
    use(from);
  });
}

/// A job, the floor below it and what the floor counts.
struct Row {
  std::string name;
  double floor;  ///< seconds
  double taken;
  std::string counts;
};

/// Random turns of a shape about itself, apart by `gap` on x, or half touching.
std::vector<Pose> oriented(double spread, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Pose> poses;
  for (int i = 0; i < 500; ++i) {
    std::array<double, 4> q;
    double norm = 0;
    for (double& part : q) {
      part = rng.uniform(-1, 1);
      norm += part * part;
    }
    norm = std::sqrt(norm);
    poses.push_back(Pose::from_quaternion(q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm,
                                          {spread * rng.unit(), spread * rng.uniform(-1, 1), 0}));
  }
  return poses;
}

Row query_row(const std::string& name, const Shape& mover, const std::vector<Pose>& poses,
              const Body& fixed, double node_test) {
  std::uint64_t boxes = 0;
  for (const Pose& pose : poses) {
    boxes += overlap(Body(mover, pose), fixed, {.mode = OverlapMode::any}).cost.node_tests;
  }
  const double taken = seconds([&] {
    for (const Pose& pose : poses) {
      use(overlap(Body(mover, pose), fixed, {.mode = OverlapMode::any}).any);
    }
  });
  const auto n = static_cast<double>(poses.size());
  const double tests = static_cast<double>(boxes) / 16 / n;
  char counts[96];
  std::snprintf(counts, sizeof counts, "%.1f tests of 16 pairs of boxes at %.1f ns", tests,
                1e9 * node_test);
  return {name, tests * node_test, taken / n, counts};
}

Row build_row(const std::string& name, const MeshView& mesh, double byte) {
  const auto shared = std::make_shared<const Mesh>(mesh);
  const double taken = seconds([&] { use(Shape(shared).layout()); });
  const Shape shape(shared);
  const double bytes =
      static_cast<double>(shape.memory()) + static_cast<double>(8 * mesh.triangles.size());
  const double sort = sorted_keys(mesh.triangles.size());
  char counts[96];
  std::snprintf(counts, sizeof counts, "sorting keys %.1f ms, streaming %.0f MB %.1f ms",
                1e3 * sort, 1e-6 * bytes, 1e3 * bytes * byte);
  return {name, sort + bytes * byte, taken, counts};
}

Row broad_row(const std::string& name, std::size_t count, double byte) {
  Rng rng(3);
  const double side = std::cbrt(static_cast<double>(count));
  std::vector<Box> boxes(count);
  for (Box& box : boxes) {
    const Vec3 at{side * rng.unit(), side * rng.unit(), side * rng.unit()};
    box = Box{at, at + Vec3{0.5, 0.5, 0.5}};
  }
  BroadPhase phase;
  const double taken = seconds([&] {
    phase.forget();
    use(phase.find(boxes).size());
  });
  const double bytes = static_cast<double>(count * sizeof(Box) + 2 * count * sizeof(Key));
  const double sort = sorted_keys(count);
  char counts[96];
  std::snprintf(counts, sizeof counts, "sorting keys %.2f ms, streaming %.1f MB %.2f ms",
                1e3 * sort, 1e-6 * bytes, 1e3 * bytes * byte);
  return {name, sort + bytes * byte, taken, counts};
}

std::vector<Row> measure() {
  const Shape knot(generate_knot(10'000));
  const Shape large(generate_knot(1'000'000));
  const double test = hot_node_test(knot);
  const double byte = streamed_byte();
  std::printf("one test of two nodes %.1f ns: %.2f G pairs of boxes a second; memory %.1f GB/s\n\n",
              1e9 * test, 16e-9 / test, 1e-9 / byte);
  City city = generate_city({.triangles = 1'000'000});
  std::vector<Row> rows;
  rows.push_back(query_row("any, knots 10k", knot, oriented(1.2, 1), Body(knot), test));
  rows.push_back(query_row("any, knots 1M", large, oriented(1.2, 1), Body(large), test));
  rows.push_back(build_row("build, knot 1M", large.mesh(), byte));
  rows.push_back(build_row("build, city 1M", city.mesh, byte));
  rows.push_back(broad_row("boxes 10k", 10'000, byte));
  rows.push_back(broad_row("boxes 100k", 100'000, byte));
  return rows;
}

void write(const std::vector<Row>& rows, const std::string& folder) {
  std::ofstream csv(folder + "/limits.csv");
  csv << "job,floor_s,taken_s,ratio,floor_counts\n";
  reproduce::BarChart chart{.title = "What one core gives, and what soms takes",
                            .y_label = "microseconds",
                            .y_scale = reproduce::Scale::log};
  chart.bars = {{"floor"}, {"soms"}};
  for (const Row& row : rows) {
    csv << row.name << ',' << row.floor << ',' << row.taken << ',' << row.taken / row.floor << ",\""
        << row.counts << "\"\n";
    chart.groups.push_back(row.name);
    chart.bars[0].values.push_back(1e6 * row.floor);
    chart.bars[1].values.push_back(1e6 * row.taken);
  }
  std::ofstream(folder + "/limits.svg") << reproduce::draw(chart);
}

int run(int argc, char** argv) {
  const std::vector<Row> rows = measure();
  std::printf("%-16s %12s %12s %7s  %s\n", "job", "floor us", "soms us", "ratio", "the floor");
  for (const Row& row : rows) {
    std::printf("%-16s %12.2f %12.2f %7.2f  %s\n", row.name.c_str(), 1e6 * row.floor,
                1e6 * row.taken, row.taken / row.floor, row.counts.c_str());
  }
  if (argc > 1) {
    write(rows, argv[1]);
  }
  return 0;
}

}  // namespace
}  // namespace soms::bench

int main(int argc, char** argv) {
  return soms::bench::run(argc, argv);
}
