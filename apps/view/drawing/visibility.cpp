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

// What looks as large as this part of the picture, at least, is near.
constexpr double kNear = 0.25;

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

void set_form(TileGroup& group, const Tile& tile, TileForm form) {
  group.form = form;
  group.triangles = run_of(tile, form).count;
}

std::uint64_t triangles_of(const TileGroup& group) {
  return std::uint64_t{group.triangles} * group.instances.size();
}

// Draws groups in a finer form as long as there is room, those first that need the fewest triangles
// for what they cover.
void make_finer(Visible& visible, const std::vector<std::size_t>& order,
                std::span<const std::span<const Tile>> tiles, TileForm form, std::uint64_t& left) {
  for (const std::size_t g : order) {
    TileGroup& group = visible.groups[g];
    const Tile& tile = tiles[group.mesh][group.tile];
    const std::uint64_t wanted =
        std::uint64_t{run_of(tile, form).count} * std::uint64_t{group.instances.size()};
    const std::uint64_t more = wanted - std::min(wanted, triangles_of(group));
    if (more <= left && group.form < form) {
      left -= more;
      set_form(group, tile, form);
    }
  }
}

// Draws what is near whole, the nearest first, within so many more triangles; returns how many it
// took. Boxes about the eye would hide all.
std::uint64_t make_near_whole(Visible& visible, const std::vector<double>& areas,
                              std::span<const std::span<const Tile>> tiles, Size size,
                              std::uint64_t most) {
  const double picture = static_cast<double>(size.width) * static_cast<double>(size.height);
  std::vector<std::size_t> near;
  for (std::size_t g = 0; g < areas.size(); ++g) {
    if (areas[g] >= kNear * picture) {
      near.push_back(g);
    }
  }
  std::sort(near.begin(), near.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(std::abs(visible.groups[a].depth), a) <
           std::pair(std::abs(visible.groups[b].depth), b);
  });
  std::uint64_t left = most;
  make_finer(visible, near, tiles, TileForm::whole, left);
  return most - left;
}

// Draws all that has copies by the coarsest ones that must be, and the rest in shares of what is
// left.
void make_coarse(Visible& visible, const std::vector<double>& areas,
                 std::span<const std::span<const Tile>> tiles, Size size, std::uint64_t most) {
  std::vector<std::pair<double, std::size_t>> needs;
  Visible bare;
  std::vector<double> bare_areas;
  std::vector<std::size_t> bare_groups;
  std::uint64_t used = 0;
  for (std::size_t g = 0; g < visible.groups.size(); ++g) {
    TileGroup& group = visible.groups[g];
    const Tile& tile = tiles[group.mesh][group.tile];
    if (tile.stand_in_count > 0) {
      set_form(group, tile, TileForm::least);
      used += triangles_of(group);
      needs.emplace_back(tile.count / areas[g], g);
    } else {
      bare.groups.push_back(group);
      bare_areas.push_back(areas[g]);
      bare_groups.push_back(g);
    }
  }
  share(bare, bare_areas, most - std::min(most, used));
  for (std::size_t k = 0; k < bare_groups.size(); ++k) {
    visible.groups[bare_groups[k]].triangles = bare.groups[k].triangles;
    used += triangles_of(bare.groups[k]);
  }
  std::sort(needs.begin(), needs.end());
  std::vector<std::size_t> order;
  for (const auto& [need, g] : needs) {
    order.push_back(g);
  }
  used +=
      make_near_whole(visible, areas, tiles, size, std::max(most - std::min(most, used), most / 2));
  std::uint64_t left = most - std::min(most, used);
  make_finer(visible, order, tiles, TileForm::stand_in, left);
  make_finer(visible, order, tiles, TileForm::whole, left);
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

TileRun run_of(const Tile& tile, TileForm form) {
  if (form == TileForm::least && tile.least_count > 0) {
    return {tile.least_first, tile.least_count};
  }
  if (form != TileForm::whole && tile.stand_in_count > 0) {
    return {tile.stand_in_first, tile.stand_in_count};
  }
  return {tile.first, tile.count};
}

namespace {

/// How large an instance looks, as far as it matters to what is drawn of it.
enum class SeenAs : std::uint8_t { speck, small, large };

SeenAs seen_as(double area, const Tile& tile) {
  return area >= kSmallInstance * kSmallInstance             ? SeenAs::large
         : area < kSpeck * kSpeck && tile.stand_in_count > 0 ? SeenAs::speck
                                                             : SeenAs::small;
}

}  // namespace

Visible choose_tiles(const DrawList& list, std::span<const std::span<const Tile>> tiles,
                     const Camera& camera, Size size, std::uint64_t most_triangles) {
  Visible visible;
  const Frustum view = frustum(camera, size);
  std::map<std::tuple<Pass, bool, std::uint32_t, std::uint32_t, SeenAs>, std::size_t> group_of;
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
      const SeenAs seen = seen_as(area, mine[t]);
      const auto [at, fresh] =
          group_of.try_emplace({pass, edges, instance.mesh, t, seen}, visible.groups.size());
      if (fresh) {
        TileGroup& group = visible.groups.emplace_back();
        group.mesh = instance.mesh;
        group.tile = t;
        group.pass = pass;
        group.edges = edges;
        group.depth = std::numeric_limits<double>::infinity();
        set_form(group, mine[t], seen == SeenAs::speck ? TileForm::least : TileForm::whole);
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
    seen += triangles_of(group);
    visible.tiles_drawn += group.instances.size();
  }
  if (seen > most_triangles) {
    const bool is_little =
        static_cast<double>(most_triangles) < kLittle * static_cast<double>(seen);
    if (is_little) {
      make_coarse(visible, areas, tiles, size, most_triangles);
    } else {
      share(visible, areas, most_triangles);
    }
  }
  for (const TileGroup& group : visible.groups) {
    visible.triangles += triangles_of(group);
    visible.tiles_drawn -= group.triangles == 0 ? group.instances.size() : 0;
  }
  visible.triangles_left = seen - std::min(seen, visible.triangles);
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
        set_form(group, mine[t],
                 diagonal(mine[t].bounds) < speck ? TileForm::stand_in : TileForm::whole);
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
