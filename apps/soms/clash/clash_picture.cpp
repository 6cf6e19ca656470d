#include "apps/soms/clash/clash_picture.h"

#include "apps/draw/canvas.h"
#include "apps/draw/look.h"

namespace soms::command {

namespace {

/// What is farther from the focus than so many reaches is not in the picture, or far behind.
constexpr double kAroundPicture = 4;
constexpr double kMarkRadius = 4.5;  // pixels

constexpr std::uint16_t kObjectA = 1;
constexpr std::uint16_t kObjectB = 2;
constexpr std::uint16_t kObjectsAround = 3;  // and up: neighbors have lines between them
constexpr std::uint16_t kMostObjects = 12;

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

look::Picture ClashPainter::draw(const ListedClash& clash, const ClashSight& sight) const {
  const look::Eye eye{sight.eye(), look::frame_along(-sight.toward, {0, 0, 1}),
                      ClashSight::kTangent};
  look::Canvas canvas(kSize, eye, look::kSkyLow.light);
  const double nearest = 0.02 * sight.reach;
  const double cut = eye.see(sight.cut()).z;
  const double around = kAroundPicture * sight.reach;
  Box region;
  region.grow(sight.focus - Vec3{around, around, around});
  region.grow(sight.focus + Vec3{around, around, around});
  const auto draw_part = [&](const PartBody& part, double from, const look::CanvasPaint& paint) {
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
                   sight.a_is_larger ? look::CanvasLayer::glass : look::CanvasLayer::solid});
      } else if (is_b && clash.b == k) {
        draw_part(set.parts[k], nearest,
                  {look::kBodyB.light, kObjectB,
                   sight.a_is_larger ? look::CanvasLayer::solid : look::CanvasLayer::glass});
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
