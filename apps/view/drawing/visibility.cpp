#include "apps/view/drawing/visibility.h"

#include "apps/view/drawing/length.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace soms::view {

namespace {

// Without more of the triangles than this part, holes would be seen.
constexpr double kLittle = 0.4;

// How large a box looks: pixels squared, at most the picture.
double seen_area(const Camera& camera, Size size, const Box& box, double depth) {
  const double side = diagonal(box);
  const double pixel = length_of_pixel(camera, size, std::max(depth, side * 0.5));
  const double across = pixel > 0 ? side / pixel : 0;
  const double whole = static_cast<double>(size.width) * static_cast<double>(size.height);
  return std::clamp(across * across, 1e-6, whole);
}

// Shares the triangles that may be drawn among groups: each gets in proportion to how large it
// looks, and none more than it has.
void share(Visible& visible, const std::vector<double>& areas, std::uint64_t most) {
  std::vector<std::size_t> order(visible.groups.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto need = [&](std::size_t i) { return visible.groups[i].triangles / areas[i]; };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(need(a), a) < std::pair(need(b), b);
  });
  const auto copies = [&](std::size_t i) {
    return static_cast<double>(visible.groups[i].instances.size());
  };
  double weight = 0;
  for (const std::size_t i : order) {
    weight += areas[i] * copies(i);
  }
  double left = static_cast<double>(most);
  for (const std::size_t i : order) {
    TileGroup& group = visible.groups[i];
    const double part = weight > 0 ? left * areas[i] / weight : 0;
    weight -= areas[i] * copies(i);
    group.triangles = static_cast<std::uint32_t>(
        std::clamp(std::floor(part), 0.0, static_cast<double>(group.triangles)));
    left -= group.triangles * copies(i);
  }
}

void make_coarse(Visible& visible, std::span<const std::span<const Tile>> tiles) {
  for (TileGroup& group : visible.groups) {
    const Tile& tile = tiles[group.mesh][group.tile];
    if (tile.stand_in_count > 0) {
      group.coarse = true;
      group.triangles = tile.stand_in_count;
    }
  }
}

// Draws coarse groups whole as long as there is room, those first that need the fewest triangles
// for what they cover.
void make_whole(Visible& visible, const std::vector<double>& areas,
                std::span<const std::span<const Tile>> tiles, std::uint64_t most) {
  std::uint64_t used = 0;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t g = 0; g < visible.groups.size(); ++g) {
    const TileGroup& group = visible.groups[g];
    used += std::uint64_t{group.triangles} * group.instances.size();
    if (group.coarse) {
      order.emplace_back(tiles[group.mesh][group.tile].count / areas[g], g);
    }
  }
  std::sort(order.begin(), order.end());
  for (const auto& [need, g] : order) {
    TileGroup& group = visible.groups[g];
    const std::uint64_t whole = tiles[group.mesh][group.tile].count;
    const std::uint64_t more = (whole - std::min<std::uint64_t>(whole, group.triangles)) *
                               std::uint64_t{group.instances.size()};
    if (used + more <= most) {
      used += more;
      group.coarse = false;
      group.triangles = static_cast<std::uint32_t>(whole);
    }
  }
}

}  // namespace

Frustum frustum(const Camera& camera, Size size) {
  const CameraFrame f = frame(camera);
  const double tall = std::tan(camera.field_of_view / 2);
  const double wide = tall * size.width / size.height;
  return {camera.eye,
          f.forward,
          {f.forward * wide + f.right, f.forward * wide - f.right, f.forward * tall + f.up,
           f.forward * tall - f.up}};
}

bool sees(const Frustum& f, const Box& box) {
  if (box.empty()) {
    return false;
  }
  const Vec3 center = box.center() - f.eye;
  const Vec3 half = box.extent() * 0.5;
  const auto reaches = [&](const Vec3& n) {
    const double reach = std::abs(n.x) * half.x + std::abs(n.y) * half.y + std::abs(n.z) * half.z;
    const double slack = 1e-9 * (reach + std::abs(dot(n, center)));
    return dot(n, center) + reach + slack >= 0;
  };
  return reaches(f.forward) && std::all_of(f.inward.begin(), f.inward.end(), reaches);
}

Pass pass_of(const Instance& instance) {
  if (instance.style == SurfaceStyle::wire) {
    return Pass::wire;
  }
  return instance.color.a < 255 ? Pass::translucent : Pass::solid;
}

Visible choose_tiles(const DrawList& list, std::span<const std::span<const Tile>> tiles,
                     const Camera& camera, Size size, std::uint64_t most_triangles) {
  Visible visible;
  const Frustum view = frustum(camera, size);
  std::map<std::tuple<Pass, bool, std::uint32_t, std::uint32_t, bool>, std::size_t> group_of;
  std::vector<double> areas;
  for (std::uint32_t i = 0; i < list.instances.size(); ++i) {
    const Instance& instance = list.instances[i];
    const Pass pass = pass_of(instance);
    const bool edges = instance.style == SurfaceStyle::both;
    const auto mine = tiles[instance.mesh];
    visible.tiles += mine.size();
    for (std::uint32_t t = 0; t < mine.size(); ++t) {
      const Box box = moved(instance.pose, mine[t].bounds);
      if (!sees(view, box)) {
        continue;
      }
      const double depth = dot(box.center() - view.eye, view.forward);
      const double area = seen_area(camera, size, box, depth);
      const bool speck = area < kSpeck * kSpeck && mine[t].stand_in_count > 0;
      const auto [at, fresh] =
          group_of.try_emplace({pass, edges, instance.mesh, t, speck}, visible.groups.size());
      if (fresh) {
        visible.groups.push_back({instance.mesh,
                                  t,
                                  pass,
                                  edges,
                                  {},
                                  speck ? mine[t].stand_in_count : mine[t].count,
                                  speck,
                                  std::numeric_limits<double>::infinity()});
        areas.push_back(0);
      }
      TileGroup& group = visible.groups[at->second];
      group.instances.push_back(i);
      group.depth = std::min(group.depth, depth);
      areas[at->second] += area;
    }
  }
  std::uint64_t seen = 0;
  for (std::size_t g = 0; g < visible.groups.size(); ++g) {
    const TileGroup& group = visible.groups[g];
    areas[g] /= static_cast<double>(group.instances.size());
    seen += std::uint64_t{group.triangles} * group.instances.size();
    visible.tiles_drawn += group.instances.size();
  }
  if (seen > most_triangles) {
    const bool is_little =
        static_cast<double>(most_triangles) < kLittle * static_cast<double>(seen);
    if (is_little) {
      make_coarse(visible, tiles);
    }
    share(visible, areas, most_triangles);
    if (is_little) {
      make_whole(visible, areas, tiles, most_triangles);
    }
  }
  for (const TileGroup& group : visible.groups) {
    visible.triangles += std::uint64_t{group.triangles} * group.instances.size();
    visible.tiles_drawn -= group.triangles == 0 ? group.instances.size() : 0;
  }
  visible.triangles_left = seen - visible.triangles;
  std::erase_if(visible.groups, [](const TileGroup& group) { return group.triangles == 0; });
  std::sort(visible.groups.begin(), visible.groups.end(),
            [](const TileGroup& a, const TileGroup& b) {
              return std::tuple(a.pass, a.depth, a.mesh, a.tile, a.edges) <
                     std::tuple(b.pass, b.depth, b.mesh, b.tile, b.edges);
            });
  return visible;
}

std::vector<TileGroup> choose_casters(const DrawList& list,
                                      std::span<const std::span<const Tile>> tiles,
                                      const std::function<bool(const Box&)>& reaches,
                                      double speck) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, TileGroup> groups;
  for (std::uint32_t i = 0; i < list.instances.size(); ++i) {
    const Instance& instance = list.instances[i];
    if (pass_of(instance) != Pass::solid) {
      continue;
    }
    const auto mine = tiles[instance.mesh];
    for (std::uint32_t t = 0; t < mine.size(); ++t) {
      if (reaches(moved(instance.pose, mine[t].bounds))) {
        TileGroup& group = groups[{instance.mesh, t}];
        group.mesh = instance.mesh;
        group.tile = t;
        group.coarse = mine[t].stand_in_count > 0 && diagonal(mine[t].bounds) < speck;
        group.triangles = group.coarse ? mine[t].stand_in_count : mine[t].count;
        group.instances.push_back(i);
      }
    }
  }
  std::vector<TileGroup> casters;
  casters.reserve(groups.size());
  for (auto& [place, group] : groups) {
    casters.push_back(std::move(group));
  }
  return casters;
}

}  // namespace soms::view
