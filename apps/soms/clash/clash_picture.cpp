#include "apps/soms/clash/clash_picture.h"

#include "apps/draw/look.h"
#include "apps/soms/clash/clash_canvas.h"

#include <cmath>

namespace soms::command {

namespace {

/// What is farther from the focus than so many reaches is not in the picture, or far behind.
constexpr double kAroundPicture = 4;
constexpr double kMarkRadius = 4.5;  // pixels

constexpr std::uint16_t kObjectA = 1;
constexpr std::uint16_t kObjectB = 2;
constexpr std::uint16_t kObjectsAround = 3;  // and up: neighbors have lines between them
constexpr std::uint16_t kMostObjects = 12;

Vec3 unit(const Vec3& v) {
  return v * (1 / std::sqrt(dot(v, v)));
}

CanvasCamera camera_of(const ClashSight& sight) {
  CanvasCamera camera{
      .eye = sight.eye(), .forward = -sight.toward, .tangent = ClashSight::kTangent};
  camera.right = unit(cross(camera.forward, {0, 0, 1}));  // no sight is vertical
  camera.up = cross(camera.right, camera.forward);
  return camera;
}

std::vector<Box> boxes_of(const ClashSet& set) {
  std::vector<Box> boxes;
  boxes.reserve(set.parts.size());
  for (const PartBody& part : set.parts) {
    boxes.push_back(part.body.shape.bounds());
  }
  return boxes;
}

}  // namespace

ClashPainter::ClashPainter(const ClashModels& models)
    : models_(models), of_a_(boxes_of(models.a)), of_b_(boxes_of(models.b)) {
}

RgbPicture ClashPainter::draw(const ListedClash& clash, const ClashSight& sight) const {
  const CanvasCamera camera = camera_of(sight);
  Canvas canvas(kWidth, kHeight, camera, look::kSkyLow.light);
  const double nearest = 0.02 * sight.reach;
  const double cut = dot(sight.cut() - camera.eye, camera.forward);
  const double around = kAroundPicture * sight.reach;
  Box region;
  region.grow(sight.focus - Vec3{around, around, around});
  region.grow(sight.focus + Vec3{around, around, around});
  const auto draw_part = [&](const PartBody& part, double from, const CanvasPaint& paint) {
    const MeshView& mesh = part.body.shape.mesh();
    for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
      if (const Triangle triangle = mesh.triangle(i); overlaps(bounds(triangle), region)) {
        canvas.draw(triangle, from, paint);
      }
    }
  };
  const auto draw_set = [&](const ClashSet& set, const std::vector<Box>& boxes, bool is_a,
                            bool is_b) {
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
      if (!overlaps(boxes[k], region)) {
        continue;
      }
      if (is_a && clash.a == k) {
        draw_part(set.parts[k], nearest,
                  {look::kBodyA.light, kObjectA,
                   sight.a_is_larger ? CanvasLayer::glass : CanvasLayer::solid});
      } else if (is_b && clash.b == k) {
        draw_part(set.parts[k], nearest,
                  {look::kBodyB.light, kObjectB,
                   sight.a_is_larger ? CanvasLayer::solid : CanvasLayer::glass});
      } else {
        draw_part(
            set.parts[k], cut,
            {look::kGround.light, static_cast<std::uint16_t>(kObjectsAround + k % kMostObjects)});
      }
    }
  };
  draw_set(models_.a, of_a_, true, !models_.two_sets);
  draw_set(models_.b, of_b_, false, true);
  canvas.mark(sight.place, kMarkRadius, look::kContact.light, look::kPaper.light);
  return canvas.picture();
}

}  // namespace soms::command
