// The same queries as compare.py, in C++: seconds of processor time for each run.
//   twin POSES CALLS
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/query/overlap.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace {

double seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Places of a car that fill the city evenly: as of compare.py, bit by bit.
std::vector<soms::Pose> places(std::size_t count) {
  std::vector<soms::Pose> poses(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto k = static_cast<double>(i % 1000);
    const auto l = static_cast<double>(i / 1000 % 1000);
    poses[i] = {{0.6, -0.8, 0, k * 2 - 1000, 0.8, 0.6, 0, l * 2 - 1000, 0, 0, 1, 0.25}};
  }
  return poses;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    return 2;
  }
  const auto count = static_cast<std::size_t>(std::atoll(argv[1]));
  const auto calls = static_cast<std::size_t>(std::atoll(argv[2]));
  const soms::Body city(soms::Shape(soms::generate_city({.triangles = 1'000'000}).mesh));
  const soms::Shape car(soms::generate_mover(soms::MoverKind::car));
  const std::vector<soms::Pose> poses = places(count);
  const soms::OverlapOptions any{.mode = soms::OverlapMode::any};
  double begin = seconds();
  const soms::OverlapBatch batch = soms::overlap(car, poses, city, any);
  const double together = seconds() - begin;
  std::size_t touching = 0;
  for (const auto flag : batch.any) {
    touching += flag;
  }
  const soms::Body far(car, soms::Pose::translation(0, 0, 5000));
  std::size_t none = 0;
  begin = seconds();
  for (std::size_t i = 0; i < calls; ++i) {
    none += soms::overlap(far, city, any).any ? 1U : 0U;
  }
  std::printf("%.6f %.9f %zu\n", together, (seconds() - begin) / static_cast<double>(calls),
              touching + none);
}
