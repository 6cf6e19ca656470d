#include "apps/report/scene.h"

#include <algorithm>
#include <numeric>

namespace soms::report {

namespace {

/// However many bodies share a model: this many triangles of it are drawn.
constexpr std::uint64_t kFewTriangles = 64;

}  // namespace

std::vector<std::size_t> longest(std::span<const Span> spans, std::size_t most) {
  std::vector<std::size_t> order(spans.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (order.size() > most) {
    const auto length = [&](std::size_t k) { return spans[k].end - spans[k].begin; };
    std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most), order.end(),
                     [&](std::size_t a, std::size_t b) {
                       return length(a) != length(b) ? length(a) > length(b) : a < b;
                     });
    order.resize(most);
    std::sort(order.begin(), order.end());
  }
  return order;
}

std::array<Pose, 2> poses_of(const Scene& scene, const SceneContact& contact) {
  return contact.poses.value_or(
      std::array{scene.pose(contact.a, contact.begin), scene.pose(contact.b, contact.begin)});
}

std::vector<std::uint64_t> fair_shares(std::span<const std::uint64_t> wanted, std::uint64_t most) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
  std::vector<std::uint64_t> shares(wanted.size(), 0);
  std::uint64_t left = most;
  for (std::size_t k = 0; k < order.size(); ++k) {
    shares[order[k]] = std::min(wanted[order[k]], left / (order.size() - k));
    left -= shares[order[k]];
  }
  return shares;
}

std::vector<std::uint64_t> spread_steps(std::uint64_t count, std::uint64_t most) {
  std::vector<std::uint64_t> steps;
  if (count == 0) {
    return steps;
  }
  const std::uint64_t pause = std::max<std::uint64_t>(1, (count + most - 3) / (most - 1));
  for (std::uint64_t step = 0; step + 1 < count; step += pause) {
    steps.push_back(step);
  }
  steps.push_back(count - 1);
  return steps;
}

std::vector<std::uint32_t> chosen_bodies(const Scene& scene, std::size_t most) {
  std::vector<std::uint8_t> chosen(scene.bodies.size(), 0);
  std::size_t count = 0;
  const auto choose = [&](std::size_t body) {
    count += chosen[body] == 0 ? 1U : 0U;
    chosen[body] = 1;
  };
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (!scene.bodies[k].moves) {
      choose(k);
    }
  }
  for (const SceneRow& row : scene.rows) {
    choose(row.a);
    choose(row.b);
  }
  for (const SceneGap& gap : scene.gaps) {
    choose(gap.a);
    choose(gap.b);
  }
  const std::size_t left = scene.bodies.size() - count;
  const std::size_t room = most > count ? std::min(left, most - count) : 0;
  std::size_t number = 0;  // of a body not chosen so far
  for (std::size_t k = 0; k < scene.bodies.size() && room > 0; ++k) {
    if (chosen[k] == 0) {
      // Number n is one of the evenly spread if n * room / left steps on to the next whole number.
      if ((number + 1) * room / left > number * room / left) {
        choose(k);
      }
      ++number;
    }
  }
  std::vector<std::uint32_t> bodies;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (chosen[k] != 0) {
      bodies.push_back(static_cast<std::uint32_t>(k));
    }
  }
  return bodies;
}

std::vector<std::uint64_t> shared_out(const Scene& scene, std::span<const std::uint32_t> bodies,
                                      const SceneLimits& limits) {
  std::vector<std::uint64_t> times(scene.models.size(), 0);
  for (const std::uint32_t body : bodies) {
    ++times[scene.bodies[body].model];
  }
  std::vector<std::uint64_t> wanted;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const std::uint64_t all = scene.models[k].mesh.triangles.size();
    const std::uint64_t most =
        std::max(kFewTriangles, limits.drawn_at_once / std::max<std::uint64_t>(1, times[k]));
    wanted.push_back(times[k] == 0 ? 0 : std::min(all, most));
  }
  return fair_shares(wanted, limits.triangles);
}

}  // namespace soms::report
