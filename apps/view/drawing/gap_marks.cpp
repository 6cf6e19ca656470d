#include "apps/view/drawing/gap_marks.h"

namespace soms::view {

namespace {

constexpr float kGapWidth = 3;
constexpr float kGapRim = 1.5F;
constexpr float kGapEnd = 11;               // diameter, with its rim
constexpr std::uint8_t kHiddenAlpha = 100;  // of what surfaces hide

}  // namespace

void add_gap(DrawList& list, const GapMark& gap) {
  list.lines.push_back({.a = gap.point_a,
                        .b = gap.point_b,
                        .color = gap.color,
                        .width = kGapWidth,
                        .rim = palette::kPaper,
                        .rim_width = kGapRim});
  for (const Vec3& end : {gap.point_a, gap.point_b}) {
    list.points.push_back(
        {.at = end, .color = gap.color, .diameter = kGapEnd, .rim = palette::kPaper});
  }
  // Once more over everything: of equal color, it changes nothing where the first ones are seen.
  const Color pale = with_alpha(gap.color, kHiddenAlpha);
  list.lines.push_back(
      {.a = gap.point_a, .b = gap.point_b, .color = pale, .width = kGapWidth, .on_top = true});
  for (const Vec3& end : {gap.point_a, gap.point_b}) {
    list.points.push_back(
        {.at = end, .color = pale, .diameter = kGapEnd, .on_top = true, .rim = palette::kPaper});
  }
  if (!gap.length.empty()) {
    list.labels.push_back(
        {.a = gap.point_a, .b = gap.point_b, .text = gap.length, .color = gap.color});
  }
}

}  // namespace soms::view
