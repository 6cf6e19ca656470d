// The broad phase beside Bullet's, FCL's and CGAL's: sets of boxes that all move from frame to
// frame. One process, libraries in turn; a frame is handed over and its pairs are listed. Processor
// time.
#include "soms/base/random.h"
#include "soms/scene/broad_phase.h"

#include "bench/measure.h"
#include "bench/scene/broad_phase_peers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace soms::bench {
namespace {

constexpr std::size_t kFrames = 20;

/// Boxes frame by frame, their ends floats, so that no library has to round.
using Frames = std::vector<std::vector<Box>>;

Vec3 random_direction(Rng& rng) {
  for (;;) {
    const Vec3 v{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const double length = std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
    if (length > 0.1 && length <= 1) {
      return v * (1 / length);
    }
  }
}

double as_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

/// `spread`: over a city of 4 km; `dense`: about ten partners each; `mixed`: sides of 1 to 200 m.
/// Up to 20 m/s at 60 frames a second, straight on.
Frames make_frames(std::string_view name, std::size_t count) {
  Rng rng(41 + count);
  const auto n = static_cast<double>(count);
  const double side = name == "dense"   ? std::cbrt(n * 5.5 * 5.5 * 5.5 / 10)
                      : name == "mixed" ? 10 * std::sqrt(n)
                                        : 4000;
  const double height = name == "dense" ? side : 100;

  struct Mover {
    Vec3 center;
    Vec3 half;
    Vec3 step;
  };

  std::vector<Mover> movers(count);
  for (Mover& mover : movers) {
    mover.center = {rng.uniform(0, side), rng.uniform(0, side), rng.uniform(0, height)};
    // Pareto: half of the boxes below 1.4 times the least.
    const bool mixed = name == "mixed";
    const double least = mixed ? 0.5 / std::sqrt(rng.uniform(1e-4, 1)) : 0.5;
    const double most = mixed ? 2 * least : 2.25;
    mover.half = {rng.uniform(least, most), rng.uniform(least, most), rng.uniform(least, most)};
    mover.step = random_direction(rng) * (rng.uniform(0, 20) / 60);
  }
  Frames frames(kFrames);
  for (std::vector<Box>& boxes : frames) {
    for (Mover& mover : movers) {
      Box box;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.lower[axis] = as_float(mover.center[axis] - mover.half[axis]);
        box.upper[axis] = as_float(mover.center[axis] + mover.half[axis]);
      }
      boxes.push_back(box);
      mover.center += mover.step;
    }
  }
  return frames;
}

/// soms, from call to call or from nothing in each.
template <bool keeps>
class SomsMovingBoxes final : public BroadPhasePeer {
 public:
  void step(std::span<const Box> boxes, PairList& pairs) override {
    if constexpr (!keeps) {
      phase_.forget();
    }
    for (const auto& [a, b] : phase_.find(boxes)) {
      pairs.push_back(packed(a, b));
    }
  }

 private:
  BroadPhase phase_;
};

struct Row {
  std::string name;
  bool keeps = false;
  std::unique_ptr<BroadPhasePeer> peer;
  std::vector<double> seconds;  ///< of the frames of all passes
  bool right = true;
  bool slow = false;
  double median = 0;
  double mean = 0;
};

/// A library whose pass lasts longer than this, in seconds, is timed once.
constexpr double kSlow = 2;

void run_pass(Row& row, const Frames& frames) {
  PairList pairs;
  for (const std::vector<Box>& boxes : frames) {
    pairs.clear();
    const double begin = processor_seconds();
    row.peer->step(boxes, pairs);
    row.seconds.push_back(processor_seconds() - begin);
  }
}

/// The first pass, whose answers are compared. Its times count for slow libraries only.
void check_pass(Row& row, const Frames& frames, std::span<const PairList> expected) {
  PairList pairs;
  double sum = 0;
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    pairs.clear();
    const double begin = processor_seconds();
    row.peer->step(frames[frame], pairs);
    row.seconds.push_back(processor_seconds() - begin);
    sum += row.seconds.back();
    std::sort(pairs.begin(), pairs.end());
    row.right = row.right && pairs == expected[frame];
  }
  row.slow = sum > kSlow;
  if (!row.slow) {
    row.seconds.clear();
  }
}

/// The pairs of each frame by a way of no library: a sweep along one axis.
std::vector<PairList> sweep(const Frames& frames) {
  std::vector<PairList> answers;
  for (const std::vector<Box>& boxes : frames) {
    std::vector<std::size_t> order(boxes.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      order[k] = k;
    }
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return boxes[a].lower.x < boxes[b].lower.x; });
    PairList& pairs = answers.emplace_back();
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Box& box = boxes[order[i]];
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        if (boxes[order[j]].lower.x > box.upper.x) {
          break;
        }
        if (overlaps(box, boxes[order[j]])) {
          pairs.push_back(packed(order[i], order[j]));
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
  }
  return answers;
}

void summarize(Row& row) {
  for (const double seconds : row.seconds) {
    row.mean += seconds / static_cast<double>(row.seconds.size());
  }
  std::sort(row.seconds.begin(), row.seconds.end());
  row.median = row.seconds[row.seconds.size() / 2];
}

void compare(std::string_view name, std::size_t count, int passes) {
  const Frames frames = make_frames(name, count);
  const std::vector<PairList> expected = sweep(frames);
  std::vector<Row> rows;
  rows.push_back({"soms", true, std::make_unique<SomsMovingBoxes<true>>(), {}});
  rows.push_back({"soms-scratch", false, std::make_unique<SomsMovingBoxes<false>>(), {}});
  std::vector<BroadPhasePeerMaker> makers;
  soms_bench_broad_phase_peers(makers);
  for (const BroadPhasePeerMaker& maker : makers) {
    rows.push_back({maker.name, maker.keeps, maker.make(frames.front()), {}});
  }
  for (Row& row : rows) {
    check_pass(row, frames, expected);
  }
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      Row& row = rows[(k + static_cast<std::size_t>(pass)) % rows.size()];
      if (!row.slow) {
        run_pass(row, frames);
      }
    }
  }
  double kept = 0;
  double rebuilt = 0;
  for (Row& row : rows) {
    summarize(row);
    double& best = row.keeps ? kept : rebuilt;
    if (row.name.find("soms") == std::string::npos && row.right) {
      best = best > 0 ? std::min(best, row.mean) : row.mean;
    }
  }
  for (const Row& row : rows) {
    std::printf("%s,%zu,%zu,%s,%s,%s,%.4f,%.4f,%.2f,%.2f\n", std::string(name).c_str(), count,
                expected.front().size(), row.name.c_str(), row.keeps ? "yes" : "no",
                row.right ? "yes" : "no", 1e3 * row.mean, 1e3 * row.median, kept / row.mean,
                rebuilt / row.mean);
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace soms::bench

int main(int argc, char** argv) {
  int passes = 5;
  if (argc > 1) {
    const std::string_view text = argv[1];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), passes);
    if (error != std::errc() || end != text.data() + text.size() || passes < 1) {
      std::fputs("usage: broad_phase_bench [PASSES]\n", stderr);
      return 2;
    }
  }
  std::puts(
      "set,boxes,pairs,library,keeps,answers right,mean ms a frame,median ms,"
      "best keeping peer / mean,best peer from nothing / mean");
  for (const std::size_t count : {std::size_t{10000}, std::size_t{100000}}) {
    for (const std::string_view name : {"spread", "dense", "mixed"}) {
      soms::bench::compare(name, count, passes);
    }
  }
  return 0;
}
