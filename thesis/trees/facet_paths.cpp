#include "thesis/trees/facet_paths.h"

#include "apps/draw/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr int kShades = 14;
/// How many paths back a facet may go to find its color.
constexpr std::size_t kReach = 48;

look::Color rgb_of(int color) {
  if (color == kClay) {
    return {216, 206, 190};
  }
  if (color == kHighlight) {
    return {226, 30, 45};
  }
  return look::color_of(
      look::kSeries[static_cast<std::size_t>(color) % look::kSeries.size()].light);
}

/// What a facet may cover, its outline included.
struct FacetExtent {
  double left;
  double top;
  double right;
  double bottom;
};

FacetExtent extent_of(const Facet& facet) {
  const auto& [a, b, c] = facet.corners;
  constexpr double kOutline = 0.5;
  return {std::min({a.x, b.x, c.x}) - kOutline, std::min({a.y, b.y, c.y}) - kOutline,
          std::max({a.x, b.x, c.x}) + kOutline, std::max({a.y, b.y, c.y}) + kOutline};
}

bool overlap(const FacetExtent& a, const FacetExtent& b) {
  return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

/// "12 -3" needs no space before a sign.
void append_number(std::string& data, long number) {
  if (number >= 0) {
    data += ' ';
  }
  data += fmt::format("{}", number);
}

void append_facet(std::string& data, const Facet& facet) {
  const auto tenth = [](double value) { return std::lround(10 * value); };
  const auto& [a, b, c] = facet.corners;
  data += fmt::format("M{}", tenth(a.x));
  append_number(data, tenth(a.y));
  data += fmt::format("l{}", tenth(b.x) - tenth(a.x));
  append_number(data, tenth(b.y) - tenth(a.y));
  append_number(data, tenth(c.x) - tenth(b.x));
  append_number(data, tenth(c.y) - tenth(b.y));
  data += 'z';
}

/// Bytes of paths as they are written, attributes included.
std::size_t bytes_of(std::span<const FacetPath> paths) {
  std::size_t bytes = 0;
  for (const FacetPath& path : paths) {
    bytes += path.data.size() + (path.outlined ? 32 : 66);
  }
  return bytes;
}

/// Keeps the `count` facets that show most, in their order.
void keep_most(std::vector<Facet>& facets, std::size_t count) {
  std::vector<std::size_t> order(facets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return facets[a].samples > facets[b].samples;
  });
  order.resize(count);
  std::sort(order.begin(), order.end());
  std::vector<Facet> kept;
  kept.reserve(count);
  for (const std::size_t k : order) {
    kept.push_back(facets[k]);
  }
  facets = std::move(kept);
}

}  // namespace

std::string shade_of(int color, double brightness) {
  const double light = 1.08 * std::round(brightness * kShades) / kShades;
  const look::Color shade = look::lit(rgb_of(color), light);
  return look::hex({shade.r, shade.g, shade.b});
}

std::vector<FacetPath> facet_paths(std::span<const Facet> facets) {
  std::vector<FacetPath> paths;
  std::vector<std::vector<FacetExtent>> covered;
  for (const Facet& facet : facets) {
    std::string fill = shade_of(facet.color, facet.brightness);
    const FacetExtent extent = extent_of(facet);
    std::size_t at = paths.size();
    for (std::size_t k = paths.size(); k-- > 0 && paths.size() - k <= kReach;) {
      if (paths[k].fill == fill && paths[k].outlined == facet.whole) {
        at = k;
        break;
      }
      if (std::any_of(covered[k].begin(), covered[k].end(),
                      [&](const FacetExtent& other) { return overlap(extent, other); })) {
        break;
      }
    }
    if (at == paths.size()) {
      paths.push_back({std::move(fill), {}, facet.whole});
      covered.emplace_back();
    }
    append_facet(paths[at].data, facet);
    covered[at].push_back(extent);
  }
  return paths;
}

FittedPaths paths_within(std::vector<Facet> facets, std::size_t bytes) {
  for (;;) {
    std::vector<FacetPath> paths = facet_paths(facets);
    const std::size_t size = bytes_of(paths);
    if (size <= bytes || facets.empty()) {
      return {std::move(paths), facets.size()};
    }
    const double share = 0.98 * static_cast<double>(bytes) / static_cast<double>(size);
    keep_most(facets, static_cast<std::size_t>(share * static_cast<double>(facets.size())));
  }
}

}  // namespace soms::reproduce
