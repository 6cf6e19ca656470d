#include "thesis/pictures/side_view.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::reproduce {

namespace {

/// Tenths of a pixel are enough for triangles by the thousand, and short.
std::string tenths(Spot spot) {
  return fmt::format("{:.1f},{:.1f}", spot.x, spot.y);
}

std::string triangle_path(Spot a, Spot b, Spot c) {
  return fmt::format("M{}L{}L{}Z", tenths(a), tenths(b), tenths(c));
}

/// Twice the area that the corners go around on the page: negative where they turn to the left,
/// since y goes downwards.
double turn(Spot a, Spot b, Spot c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

}  // namespace

SideView::SideView(Side side, const Box& shown, const PagePlace& place)
    : side_(side),
      middle_{place.corner.x + place.width / 2, place.corner.y + place.height / 2},
      center_(shown.center()) {
  const Vec3 extent = shown.extent();
  const double across = side == Side::front ? extent.x : extent.z;
  const double wide = across > 0 ? place.width / across : place.width;
  const double high = extent.y > 0 ? place.height / extent.y : place.height;
  scale_ = std::min(wide, high);
}

Spot SideView::operator()(const Vec3& point) const {
  const Vec3 from = point - center_;
  const double across = side_ == Side::front ? from.x : -from.z;
  return {middle_.x + scale_ * across, middle_.y - scale_ * from.y};
}

std::string SideView::facing(const MeshView& mesh, const Vec3& offset) const {
  std::string path;
  for (const auto& t : mesh.triangles) {
    const Spot a = (*this)(mesh.vertices[t[0]] + offset);
    const Spot b = (*this)(mesh.vertices[t[1]] + offset);
    const Spot c = (*this)(mesh.vertices[t[2]] + offset);
    if (turn(a, b, c) < 0) {
      path += triangle_path(a, b, c);
    }
  }
  return path;
}

std::string SideView::triangles(const MeshView& mesh, std::span<const TriangleId> which,
                                const Vec3& offset) const {
  std::string path;
  for (const TriangleId i : which) {
    const Triangle t = mesh.triangle(i);
    path += triangle_path((*this)(t.a + offset), (*this)(t.b + offset), (*this)(t.c + offset));
  }
  return path;
}

std::string SideView::box(const Box& box) const {
  if (box.empty()) {
    return {};
  }
  const Spot one = (*this)(box.lower);
  const Spot other = (*this)(box.upper);
  return fmt::format("M{}L{}L{}L{}Z", tenths(one), tenths({other.x, one.y}), tenths(other),
                     tenths({one.x, other.y}));
}

}  // namespace soms::reproduce
