// Which kinds of triangle pairs the float kernels leave open: for scenes of the referee, all pairs
// of blocks whose spheres meet are judged as queries judge them, and what is open is counted by
// kind. Counts, the same on every machine.
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/detail/leaf_pairs.h"
#include "soms/query/overlap.h"

#include "bench/peers/scenarios/catalog.h"
#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace soms::bench {
namespace {

using detail::BlockTask;
using detail::kJudged;
using detail::PairFrame;

/// Triangles that differ so much in size are unlike. The smaller one is far where its first corner
/// is so many times its length away from the other's corners.
constexpr double kUnlike = 16;

/// A triangle whose height is less than this share of its longest side is thin.
constexpr double kThin = 0.01;

/// Corners closer than this share of the larger triangle to its plane lie in it.
constexpr double kInPlane = 1e-9;

struct Counts {
  std::uint64_t tested = 0;  ///< pairs that queries for all pairs say they tested
  std::uint64_t judged = 0;
  std::uint64_t sure = 0;
  std::uint64_t open = 0;
  std::uint64_t overlap = 0;  ///< of the open ones, as all that follow
  std::uint64_t exact = 0;    ///< open in double, too
  std::uint64_t coplanar = 0;
  std::uint64_t thin = 0;
  std::uint64_t unlike = 0;
  std::uint64_t far = 0;
  std::uint64_t none = 0;
};

double length(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

/// A triangle by its measures.
struct Measures {
  explicit Measures(const Triangle& t)
      : corners{t.a, t.b, t.c},
        normal(cross(t.b - t.a, t.c - t.a)),
        longest(std::max({length(t.b - t.a), length(t.c - t.b), length(t.a - t.c)})) {}

  [[nodiscard]] bool thin() const { return length(normal) < kThin * longest * longest; }

  /// Farthest of the other's corners from the plane.
  [[nodiscard]] double off_plane(const Measures& other) const {
    double most = 0;
    for (const Vec3& corner : other.corners) {
      most = std::max(most, std::abs(dot(normal, corner - corners[0])));
    }
    const double norm = length(normal);
    return norm > 0 ? most / norm : 0;
  }

  std::array<Vec3, 3> corners;
  Vec3 normal;
  double longest;
};

/// A node or, where `leaf`, the first block of a leaf.
struct Place {
  std::uint32_t index = 0;
  bool leaf = false;
};

/// Judges what two bodies have in common.
class Judge {
 public:
  Judge(const Body& a, const Body& b, detail::LeafQueue& queue, Counts& counts)
      : frame_(a, b),
        x_(frame_.x().layout()),
        y_(frame_.y().layout()),
        kernels_(detail::kernels()),
        queue_(queue),
        counts_(counts) {
    frame_.relative().prepare();
  }

  void run() {
    std::vector<std::array<Place, 2>> pending{{Place{}, Place{}}};
    while (!pending.empty()) {
      const auto [x, y] = pending.back();
      pending.pop_back();
      if (x.leaf && y.leaf) {
        meet(x.index, y.index);
      } else if (spheres_meet(x, y)) {
        const bool descend_x = !x.leaf && (y.leaf || radius(x_, x) * ratio() >= radius(y_, y));
        const WideNode& node = descend_x ? x_.nodes()[x.index] : y_.nodes()[y.index];
        for (std::size_t k = 0; k < node.count; ++k) {
          const Place child{node.child[k] & (WideNode::kMost - 1),
                            (std::uint32_t{node.leaves} >> k & 1U) != 0};
          pending.push_back(descend_x ? std::array{child, y} : std::array{x, child});
        }
      }
    }
    drain();
  }

 private:
  [[nodiscard]] float ratio() const { return frame_.relative().numbers().ratio; }

  static float radius(const WideTree& tree, const Place& place) {
    return place.leaf ? tree.blocks()[place.index].l1_radius : tree.nodes()[place.index].l1_radius;
  }

  static const std::array<double, 3>& origin(const WideTree& tree, const Place& place) {
    return place.leaf ? tree.blocks()[place.index].origin : tree.nodes()[place.index].origin;
  }

  /// Leaves of several blocks meet everything.
  [[nodiscard]] bool spheres_meet(const Place& x, const Place& y) const {
    if ((x.leaf && x_.blocks()[x.index].following != 0) ||
        (y.leaf && y_.blocks()[y.index].following != 0)) {
      return true;
    }
    const auto d = frame_.relative().numbers().offset_in_double(origin(x_, x), origin(y_, y));
    const double reach = static_cast<double>(radius(x_, x) * ratio() + radius(y_, y));
    return length({d[0], d[1], d[2]}) <= 1.001 * reach;
  }

  /// All blocks of two leaves.
  void meet(std::uint32_t x, std::uint32_t y) {
    for (std::uint32_t i = x;; ++i) {
      for (std::uint32_t j = y;; ++j) {
        BlockTask task = {
            &frame_.relative().numbers(), &x_.blocks()[i], &y_.blocks()[j], {}, 0, 0, 0};
        kernels_.test_slabs(&task, 1);
        if (task.lanes_x != 0 && task.lanes_y != 0) {
          if (queue_.full()) {
            drain();
          }
          queue_.add(kernels_, task);
        }
        if (y_.blocks()[j].following == 0) {
          break;
        }
      }
      if (x_.blocks()[i].following == 0) {
        break;
      }
    }
  }

  void drain() {
    counts_.judged += queue_.size();
    queue_.judge(kernels_, 0, queue_.size());
    queue_.judge_open(kernels_, frame_.relative().numbers(), 0, queue_.size());
    for (std::size_t set = 0; set < queue_.size(); set += kJudged) {
      counts_.sure += static_cast<std::uint64_t>(std::popcount(queue_.in_float(set).hit));
      counts_.exact += static_cast<std::uint64_t>(std::popcount(queue_.in_double(set).open));
      for (std::uint32_t open = queue_.in_float(set).open; open != 0; open &= open - 1) {
        count(queue_.ids(set + static_cast<std::size_t>(std::countr_zero(open))));
      }
    }
    queue_.clear();
  }

  void count(const TrianglePair& ids) {
    const Triangle a = detail::moved(frame_.x(), ids.a);
    const Triangle b = detail::moved(frame_.y(), ids.b);
    const Measures p(a);
    const Measures q(b);
    const Measures& large = p.longest > q.longest ? p : q;
    const Measures& small = p.longest > q.longest ? q : p;
    const bool coplanar = large.off_plane(small) <= kInPlane * large.longest &&
                          small.off_plane(large) <= kInPlane * large.longest;
    const bool thin = p.thin() || q.thin();
    const bool unlike = large.longest >= kUnlike * small.longest;
    const double apart = std::min({length(small.corners[0] - large.corners[0]),
                                   length(small.corners[0] - large.corners[1]),
                                   length(small.corners[0] - large.corners[2])});
    const bool far = apart >= kUnlike * small.longest;
    ++counts_.open;
    counts_.overlap += triangles_overlap(a, b) ? 1U : 0U;
    counts_.coplanar += coplanar ? 1U : 0U;
    counts_.thin += thin ? 1U : 0U;
    counts_.unlike += unlike ? 1U : 0U;
    counts_.far += far ? 1U : 0U;
    counts_.none += coplanar || thin || unlike || far ? 0U : 1U;
  }

  PairFrame frame_;
  const WideTree& x_;
  const WideTree& y_;
  const detail::Kernels& kernels_;
  detail::LeafQueue& queue_;
  Counts& counts_;
};

void count_scene(const Scene& scene, std::size_t most_poses) {
  const auto queue = std::make_unique<detail::LeafQueue>();
  Body mover{Shape(widened(scene.mover))};
  const Body fixed{Shape(widened(scene.fixed))};
  for (const PoseSet& set : scene.sets) {
    Counts counts;
    const std::size_t poses = std::min(most_poses, set.poses.size());
    for (std::size_t i = 0; i < poses; ++i) {
      mover.pose = set.poses[i];
      Judge(mover, fixed, *queue, counts).run();
      counts.tested += overlap(mover, fixed).cost.triangle_tests;
    }
    const auto share = [&](std::uint64_t part) {
      return counts.open == 0 ? 0.0
                              : 100 * static_cast<double>(part) / static_cast<double>(counts.open);
    };
    std::printf("%s,%zu,%s,%zu,%llu,%llu,%llu,%llu,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%llu\n",
                scene.name.c_str(), scene.fixed.triangles.size(), set.name.c_str(), poses,
                static_cast<unsigned long long>(counts.tested),
                static_cast<unsigned long long>(counts.judged),
                static_cast<unsigned long long>(counts.sure),
                static_cast<unsigned long long>(counts.open), share(counts.overlap),
                share(counts.coplanar), share(counts.thin), share(counts.unlike), share(counts.far),
                share(counts.none), static_cast<unsigned long long>(counts.exact));
    std::fflush(stdout);
  }
}

int run(int argc, char** argv) {
  if (argc < 2 || std::strcmp(argv[1], "--help") == 0) {
    std::printf(
        "Usage: open_pairs WORD [POSES]\n"
        "counts open pairs of the scenes whose names have WORD, in up to POSES (100) poses\n"
        "of each set; models and cities in the folder SOMS_DATA\n");
    return argc < 2 ? 1 : 0;
  }
  const char* const data = std::getenv("SOMS_DATA");
  const std::size_t poses = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 100;
  std::printf(
      "scene,triangles,poses of,poses,tested,judged,sure,open,overlap [%%],coplanar [%%],thin [%%],"
      "unlike [%%],far [%%],none of these [%%],exact\n");
  for (const Offer& offer : catalog(data != nullptr ? data : "", 1)) {
    if (offer.scene.find(argv[1]) != std::string::npos) {
      const Scene scene = offer.make();
      if (!scene.sets.empty() && scene.links.empty()) {
        count_scene(scene, poses);
      }
    }
  }
  return 0;
}

}  // namespace
}  // namespace soms::bench

int main(int argc, char** argv) {
  return soms::bench::run(argc, argv);
}
