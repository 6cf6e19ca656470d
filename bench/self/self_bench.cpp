// Times `self_overlap` beside CGAL's `self_intersections`, on knots, a city and models that are
// named.
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/io/read_mesh.h"
#include "soms/query/self_overlap.h"

#include "bench/measure.h"
#include "bench/self/self_peers.h"

#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using soms::bench::median;
using soms::bench::processor_seconds;

constexpr int kPasses = 5;

/// Milliseconds of a call.
template <class Call>
double timed(const Call& call) {
  const double begin = processor_seconds();
  call();
  return 1e3 * (processor_seconds() - begin);
}

void race(const std::string& name, soms::Mesh mesh) {
  const soms::Shape shape(std::move(mesh), {}, {.threads = 1});
  const std::unique_ptr<soms::bench::SelfPeer> peer(
      soms_bench_self_peer(shape.mesh().vertices, shape.mesh().triangles));
  soms::SelfOverlap found;
  std::size_t of_peer = 0;
  std::vector<double> ours;
  std::vector<double> theirs;
  for (int pass = 0; pass < kPasses; ++pass) {
    ours.push_back(timed([&] { found = soms::self_overlap(shape, {}, {.threads = 1}); }));
    if (peer) {
      theirs.push_back(timed([&] { of_peer = peer->find(); }));
    }
  }
  std::printf("%s: %zu triangles, %zu pairs, %zu duplicates, %llu exact of %llu, %.2f ms",
              name.c_str(), shape.mesh().triangles.size(), found.pairs.size(),
              found.duplicates.size(), static_cast<unsigned long long>(found.cost.exact_tests),
              static_cast<unsigned long long>(found.cost.triangle_tests), median(ours));
  if (peer) {
    std::printf("; CGAL %zu pairs (%zu triangles left out), %.2f ms, %.1f times", of_peer,
                peer->left_out(), median(theirs), median(theirs) / median(ours));
  }
  std::printf("\n");
}

}  // namespace

int main(int count, char** words) {
  try {
    race("knot of 10,000", soms::generate_knot(10'000));
    race("knot of 100,000", soms::generate_knot(100'000));
    race("city of 100,000", soms::generate_city({.triangles = 100'000}).mesh);
    for (int i = 1; i < count; ++i) {
      race(words[i], soms::read_mesh(words[i]));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "self_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
