#include "apps/soms/simulate/simulate_verify.h"

#include "soms/base/parallel.h"
#include "soms/query/reference/overlap.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <utility>

namespace soms::command {

namespace {

/// Movers that touch nothing and are checked in a frame.
constexpr std::size_t kFreeAFrame = 2;
/// Movers that share one pass over the city's triangles.
constexpr std::size_t kSubjectsAPass = 16;
/// Triangles tested for all of them before the next: their boxes stay in the cache.
constexpr std::size_t kBlock = 1024;

/// Triangles of a body that a mover's box may meet, and the mesh they make.
struct Near {
  std::vector<TriangleId> triangles;

  [[nodiscard]] Mesh mesh_of(const MeshView& whole) const {
    Mesh mesh;
    for (const TriangleId i : triangles) {
      const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
      const Triangle triangle = whole.triangle(i);
      mesh.vertices.insert(mesh.vertices.end(), {triangle.a, triangle.b, triangle.c});
      mesh.triangles.push_back({next, next + 1, next + 2});
    }
    return mesh;
  }
};

}  // namespace

Verifier::Verifier(const World& world, std::uint64_t seed) : world_(world), rng_(seed) {
  for (const Body& body : world.city) {
    const MeshView& mesh = body.shape.mesh();
    Boxes& boxes = boxes_.emplace_back();
    for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
      const Box box = bounds(mesh.triangle(i));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        boxes.lower[axis].push_back(box.lower[axis]);
        boxes.upper[axis].push_back(box.upper[axis]);
      }
    }
  }
}

const MeshView& Verifier::mesh(MoverId mover) const {
  return world_.models[world_.routes[mover].model].shape.mesh();
}

Box Verifier::moved_box(MoverId mover, const std::vector<Pose>& poses) const {
  Box box;
  const MeshView& whole = mesh(mover);
  for (TriangleId i = 0; i < whole.triangles.size(); ++i) {
    const Triangle t = whole.triangle(i);
    for (const Vec3& corner : {t.a, t.b, t.c}) {
      box.grow(poses[mover].apply(corner));
    }
  }
  return box;
}

std::vector<Verifier::Subject> Verifier::choose(const StepReport& report,
                                                const std::vector<Pose>& poses) {
  std::vector<bool> chosen(poses.size(), false);
  std::vector<Subject> subjects;
  const auto add = [&](MoverId mover, bool touches_movers) {
    if (!chosen[mover]) {
      chosen[mover] = true;
      subjects.push_back(
          {.mover = mover, .box = moved_box(mover, poses), .touches_movers = touches_movers});
    }
  };
  for (const EnvironmentContact& contact : report.environment) {
    add(contact.mover, false);
    subjects.back().said.push_back(contact);
  }
  for (const MoverContact& contact : report.movers) {
    add(contact.a, true);
    add(contact.b, true);
  }
  for (std::size_t k = 0; k < kFreeAFrame && !poses.empty(); ++k) {
    add(static_cast<MoverId>(rng_.below(poses.size())), false);
  }
  return subjects;
}

/// Compares what was said of each subject with what all triangles of the city say.
void Verifier::scan_city(std::span<Subject> subjects, const std::vector<Pose>& poses,
                         const Limits& alone) const {
  std::vector<std::vector<EnvironmentContact>> seen(subjects.size());
  std::vector<Near> near(subjects.size());
  std::array<std::uint8_t, kBlock> meets{};
  for (std::uint32_t part = 0; part < boxes_.size(); ++part) {
    const Boxes& boxes = boxes_[part];
    const std::size_t count = boxes.lower[0].size();
    for (std::size_t first = 0; first < count; first += kBlock) {
      const std::size_t size = std::min(kBlock, count - first);
      for (std::size_t s = 0; s < subjects.size(); ++s) {
        meets.fill(1);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double* const lower = &boxes.lower[axis][first];
          const double* const upper = &boxes.upper[axis][first];
          const double least = subjects[s].box.lower[axis];
          const double most = subjects[s].box.upper[axis];
          for (std::size_t k = 0; k < size; ++k) {
            meets[k] = static_cast<std::uint8_t>(meets[k] & (lower[k] <= most ? 1 : 0) &
                                                 (upper[k] >= least ? 1 : 0));
          }
        }
        for (std::size_t k = 0; k < size; ++k) {
          if (meets[k] != 0) {
            near[s].triangles.push_back(static_cast<TriangleId>(first + k));
          }
        }
      }
    }
    for (std::size_t s = 0; s < subjects.size(); ++s) {
      const MoverId mover = subjects[s].mover;
      const Mesh city = near[s].mesh_of(world_.city[part].shape.mesh());
      const Overlap answer = reference::overlap(mesh(mover), poses[mover], city, Pose{}, alone);
      for (const auto& [i, j] : answer.pairs) {
        seen[s].push_back({mover, part, i, near[s].triangles[j]});
      }
      near[s].triangles.clear();
    }
  }
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    subjects[s].right = seen[s] == subjects[s].said;
  }
}

/// True if the spheres about two movers' boxes are apart by a good margin for rounding.
bool Verifier::far_apart(MoverId a, MoverId b, const std::vector<Pose>& poses) const {
  const auto sphere = [&](MoverId mover) {
    const Box box = world_.models[world_.routes[mover].model].shape.bounds();
    const Vec3 extent = box.extent();
    return std::pair(poses[mover].apply(box.center()), 0.51 * std::sqrt(dot(extent, extent)));
  };
  const auto [from, radius_from] = sphere(a);
  const auto [to, radius_to] = sphere(b);
  const Vec3 offset = to - from;
  const double rounding = 1e-12 * (std::sqrt(dot(from, from)) + std::sqrt(dot(to, to)));
  return std::sqrt(dot(offset, offset)) > 1.01 * (radius_from + radius_to) + rounding;
}

/// Touching triangles of two movers: a scan of each for what lies in the other's box, then all
/// pairs of these.
std::vector<TrianglePair> Verifier::pairs_of(MoverId a, MoverId b, const std::vector<Pose>& poses,
                                             const Limits& alone) const {
  const auto near_to = [&](MoverId mover, const Box& box) {
    Near near;
    const MeshView& whole = mesh(mover);
    for (TriangleId i = 0; i < whole.triangles.size(); ++i) {
      const Triangle t = whole.triangle(i);
      const Pose& pose = poses[mover];
      if (overlaps(bounds(Triangle{pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)}), box)) {
        near.triangles.push_back(i);
      }
    }
    return near;
  };
  const Near near_a = near_to(a, moved_box(b, poses));
  const Near near_b = near_to(b, moved_box(a, poses));
  std::vector<TrianglePair> pairs;
  const Overlap answer = reference::overlap(near_a.mesh_of(mesh(a)), poses[a],
                                            near_b.mesh_of(mesh(b)), poses[b], alone);
  for (const auto& [i, j] : answer.pairs) {
    pairs.push_back({near_a.triangles[i], near_b.triangles[j]});
  }
  return pairs;
}

/// True if brute force finds a mover that `subject` touches and that the report does not name.
bool Verifier::touches_unsaid(const Subject& subject, const MoverPairs& said,
                              const std::vector<Pose>& poses, const Limits& alone) const {
  const MoverId mover = subject.mover;
  for (MoverId other = 0; other < poses.size(); ++other) {
    check_stop(alone);
    if (other != mover && world_.filter.tests(mover, other) && !far_apart(mover, other, poses) &&
        !std::binary_search(said.begin(), said.end(),
                            std::pair<MoverId, MoverId>(std::minmax(mover, other))) &&
        overlaps(subject.box, moved_box(other, poses)) &&
        !pairs_of(mover, other, poses, alone).empty()) {
      return true;
    }
  }
  return false;
}

/// All touching pairs of movers; the list is sorted, so a pair's contacts stand together.
void Verifier::verify_movers(const StepReport& report, const std::vector<Pose>& poses,
                             const Limits& limits) {
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  const std::vector<MoverContact>& all = report.movers;
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin;
    while (end < all.size() && all[end].a == all[begin].a && all[end].b == all[begin].b) {
      ++end;
    }
    runs.emplace_back(begin, end);
    begin = end;
  }
  std::atomic<std::uint64_t> wrong = 0;
  for_each_chunk(runs.size(), 1, limits, [&](std::size_t k, std::size_t) {
    const auto [begin, end] = runs[k];
    const MoverContact& first = all[begin];
    const auto pairs = pairs_of(first.a, first.b, poses, {.stop = limits.stop});
    bool right = world_.filter.tests(first.a, first.b) && pairs.size() == end - begin;
    for (std::size_t p = 0; right && p < pairs.size(); ++p) {
      right = all[begin + p] == MoverContact{first.a, first.b, pairs[p].a, pairs[p].b};
    }
    wrong += right ? 0 : 1;
  });
  result_.contacts += runs.size();
  result_.wrong += wrong;
}

void Verifier::verify(const StepReport& report, const std::vector<Pose>& poses,
                      const Limits& limits) {
  const Verified before = result_;
  try {
    compare(report, poses, limits);
  } catch (...) {
    result_ = before;
    throw;
  }
}

void Verifier::compare(const StepReport& report, const std::vector<Pose>& poses,
                       const Limits& limits) {
  const Limits alone = limits.alone();
  std::vector<Subject> subjects = choose(report, poses);
  MoverPairs touching;
  for (const MoverContact& contact : report.movers) {
    touching.emplace_back(contact.a, contact.b);
  }
  for_each_chunk(subjects.size(), kSubjectsAPass, limits, [&](std::size_t begin, std::size_t end) {
    scan_city(std::span(subjects).subspan(begin, end - begin), poses, alone);
  });
  for_each_chunk(subjects.size(), 1, limits, [&](std::size_t k, std::size_t) {
    Subject& subject = subjects[k];
    subject.right = subject.right && !touches_unsaid(subject, touching, poses, alone);
  });
  for (const Subject& subject : subjects) {
    if (!subject.said.empty()) {
      ++result_.contacts;
    } else if (!subject.touches_movers) {
      ++result_.free;
    }
    result_.wrong += subject.right ? 0 : 1;
  }
  verify_movers(report, poses, limits);
}

}  // namespace soms::command
