#include "soms/io/detail/tiles/tile_volume.h"

#include "soms/io/detail/cityjson/geodesy.h"
#include "soms/io/detail/json_numbers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace soms::detail {

namespace {

constexpr double kSlack = 1e-4;  ///< of the size
constexpr double kTurn = 2 * std::numbers::pi;

Vec3 moved_direction(const Affine& frame, const Vec3& v) {
  Affine linear = frame;
  linear.m[3] = linear.m[7] = linear.m[11] = 0;
  return linear.apply(v);
}

double length_of(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

}  // namespace

TileVolume TileVolume::region(const JsonValue& list) {
  TileVolume volume;
  volume.kind_ = Kind::region;
  volume.region_ = json_numbers<6>(list);
  const auto& [west, south, east, north, lowest, highest] = volume.region_;
  if (south > north || lowest > highest) {
    list.fail("the region ends before it begins");
  }
  const double wide = (east < west ? east - west + kTurn : east - west) *
                      std::cos(std::min(std::abs(south), std::abs(north)));
  volume.slack_ = kSlack * std::max({wide * kEquatorialRadius, (north - south) * kEquatorialRadius,
                                     highest - lowest});
  return volume;
}

TileVolume TileVolume::box(const JsonValue& list, const Affine& frame) {
  const std::array<double, 12> n = json_numbers<12>(list);
  TileVolume volume;
  volume.kind_ = Kind::box;
  volume.center_ = frame.apply({n[0], n[1], n[2]});
  for (std::size_t i = 0; i < 3; ++i) {
    volume.axes_[i] = moved_direction(frame, {n[3 * i + 3], n[3 * i + 4], n[3 * i + 5]});
    volume.slack_ = std::max(volume.slack_, kSlack * length_of(volume.axes_[i]));
  }
  const auto& [u, v, w] = volume.axes_;
  const double size = dot(u, cross(v, w));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& axis = volume.axes_[i];
    // A flat box has no duals: its axes are taken for perpendicular.
    const double square = dot(axis, axis);
    const Vec3 across = cross(volume.axes_[(i + 1) % 3], volume.axes_[(i + 2) % 3]);
    volume.duals_[i] = size != 0 ? across * (1 / size) : square != 0 ? axis * (1 / square) : Vec3{};
  }
  return volume;
}

TileVolume TileVolume::sphere(const JsonValue& list, const Affine& frame) {
  const std::array<double, 4> n = json_numbers<4>(list);
  if (n[3] < 0) {
    list.at(std::size_t{3}).fail("a negative radius");
  }
  double scale = 0;
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    scale = std::max(scale, length_of(moved_direction(frame, axis)));
  }
  TileVolume volume;
  volume.kind_ = Kind::sphere;
  volume.center_ = frame.apply({n[0], n[1], n[2]});
  volume.radius_ = n[3] * scale;
  volume.slack_ = kSlack * volume.radius_;
  return volume;
}

std::optional<TileVolume> TileVolume::read(const JsonValue& stated, const Affine& frame) {
  std::optional<TileVolume> volume;
  if (const auto list = stated.find("sphere")) {
    volume = sphere(*list, frame);
  }
  if (const auto list = stated.find("box")) {
    volume = box(*list, frame);
  }
  if (const auto list = stated.find("region")) {
    volume = region(*list);
  }
  if (!volume && !stated.find("extensions")) {
    stated.fail("none of \"region\", \"box\" and \"sphere\"");
  }
  return volume;
}

bool TileVolume::region_contains(const Vec3& point) const {
  const auto& [west, south, east, north, lowest, highest] = region_;
  const GeodeticPlace place = geodetic_place(point);
  const double by = slack_ / kEquatorialRadius;
  constexpr double kPole = 1e-9;
  const double along = by / std::max(std::cos(place.latitude), kPole);
  double from_west = std::fmod(place.longitude - (west - along), kTurn);
  from_west += from_west < 0 ? kTurn : 0;
  const double wide = (east < west ? east - west + kTurn : east - west) + 2 * along;
  return from_west <= wide && place.latitude >= south - by && place.latitude <= north + by &&
         place.height >= lowest - slack_ && place.height <= highest + slack_;
}

bool TileVolume::box_contains(const Vec3& point) const {
  const Vec3 d = point - center_;
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = std::abs(dot(d, duals_[i]));
    if ((share - 1) * length_of(axes_[i]) > slack_) {
      return false;
    }
  }
  return true;
}

bool TileVolume::contains(const Vec3& point) const {
  switch (kind_) {
    case Kind::region:
      return region_contains(point);
    case Kind::box:
      return box_contains(point);
    case Kind::sphere:
      return length_of(point - center_) <= radius_ + slack_;
  }
  return false;
}

std::uint64_t count_outside(const MeshView& mesh, const TileVolume& volume) {
  std::vector<bool> seen(mesh.vertices.size(), false);
  std::uint64_t count = 0;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      if (!seen[v]) {
        seen[v] = true;
        count += volume.contains(mesh.vertices[v]) ? 0U : 1U;
      }
    }
  }
  return count;
}

}  // namespace soms::detail
