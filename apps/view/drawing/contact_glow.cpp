#include "apps/view/drawing/contact_glow.h"

#include "soms/base/box.h"

#include "apps/view/drawing/length.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace soms::view {

namespace {

constexpr double kOfWidth = 0.3;
constexpr double kOfLength = 0.005;  ///< of straight curves
/// Ends nearer than this part of the whole meet: they differ by rounding.
constexpr double kSameEnd = 1e-7;
/// Pieces of the curve shorter than this part of the reach are thinned out.
constexpr double kGlowStep = 0.25;

using CurveCell = std::array<std::int64_t, 3>;

std::size_t first_of(std::vector<std::size_t>& parent, std::size_t k) {
  while (parent[k] != k) {
    parent[k] = parent[parent[k]];
    k = parent[k];
  }
  return k;
}

/// How long and how wide points lie about the line through two that are far apart.
std::pair<double, double> extent_along(const std::vector<Vec3>& points) {
  const auto farthest = [&](const Vec3& from) {
    return *std::max_element(points.begin(), points.end(), [&](const Vec3& p, const Vec3& q) {
      return length(p - from) < length(q - from);
    });
  };
  const Vec3 begin = farthest(points.front());
  const Vec3 along = farthest(begin) - begin;
  const double whole = length(along);
  double wide = 0;
  for (const Vec3& p : points) {
    wide = std::max(wide, whole > 0 ? 2 * length(cross(along, p - begin)) / whole : 0);
  }
  return {whole, wide};
}

}  // namespace

std::vector<std::size_t> ContactGlow::curve_of_pieces() const {
  Box all;
  for (const Piece& piece : pieces_) {
    all.grow(piece.a);
    all.grow(piece.b);
  }
  const double side = std::max(kSameEnd * diagonal(all), 1e-300);
  // Cells begin off the numbers that people choose, on which ends lie.
  const auto cell_of = [&](const Vec3& p) {
    const auto cell = [&](double x, double low) {
      return static_cast<std::int64_t>(std::floor((x - low) / side + 0.3719));
    };
    return CurveCell{cell(p.x, all.lower.x), cell(p.y, all.lower.y), cell(p.z, all.lower.z)};
  };
  std::vector<std::size_t> parent(pieces_.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  std::map<CurveCell, std::size_t> at_end;
  std::map<std::size_t, std::size_t> of_group;
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const Piece& piece = pieces_[k];
    const auto join = [&](auto& firsts, const auto& key) {
      const auto entry = firsts.try_emplace(key, k).first;
      parent[first_of(parent, k)] = first_of(parent, entry->second);
    };
    if (piece.group != kNoGroup) {
      join(of_group, piece.group);
    } else {
      join(at_end, cell_of(piece.a));
      join(at_end, cell_of(piece.b));
    }
  }
  for (std::size_t k = 0; k < parent.size(); ++k) {
    parent[k] = first_of(parent, k);
  }
  return parent;
}

std::vector<Glow> ContactGlow::glows() const {
  const std::vector<std::size_t> curve_of = curve_of_pieces();
  std::map<std::size_t, std::vector<Vec3>> curves;
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    curves[curve_of[k]].push_back(pieces_[k].a);
    curves[curve_of[k]].push_back(pieces_[k].b);
  }
  std::map<std::size_t, double> reaches;
  for (const auto& [curve, points] : curves) {
    const auto [along, across] = extent_along(points);
    reaches[curve] = std::max(kOfWidth * across, kOfLength * along);
  }
  std::set<std::array<double, 4>> taken;
  const auto is_first_here = [&](const Vec3& at, double step) {
    const double side = std::exp2(std::floor(std::log2(step)));
    const auto cell = [side](double x) { return std::floor(x / side); };
    return taken.insert({side, cell(at.x), cell(at.y), cell(at.z)}).second;
  };
  std::vector<Glow> glows;
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const Piece& piece = pieces_[k];
    const double wide = reaches[curve_of[k]];
    // A point has no width: of it a least part of the most.
    const double reach = std::min(piece.most, wide > 0 ? wide : kOfLength * piece.most);
    const double step = kGlowStep * reach;
    const Vec3 along = piece.b - piece.a;
    if (step > 0 &&
        (dot(along, along) > step * step || is_first_here((piece.a + piece.b) * 0.5, step))) {
      glows.push_back({piece.a, piece.b, reach});
    }
  }
  return glows;
}

}  // namespace soms::view
