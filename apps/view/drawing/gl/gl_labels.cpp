#include "apps/view/drawing/gl/gl_labels.h"

#include "apps/view/drawing/gl/gl_shaders.h"
#include "apps/view/drawing/overlay.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace soms::view {

namespace {

struct StrokeRow {
  std::array<float, 2> from;
  std::array<float, 2> to;
  Color color;
  float width;
};

}  // namespace

GlLabels::GlLabels() : program_("label", shader::kLetterVertex, shader::kLetterFragment) {
  reading_.floats(0, 2, strokes_, sizeof(StrokeRow), offsetof(StrokeRow, from), 1);
  reading_.floats(1, 2, strokes_, sizeof(StrokeRow), offsetof(StrokeRow, to), 1);
  reading_.color(2, strokes_, sizeof(StrokeRow), offsetof(StrokeRow, color), 1);
  reading_.floats(3, 1, strokes_, sizeof(StrokeRow), offsetof(StrokeRow, width), 1);
}

void GlLabels::draw(const DrawList& list, const Camera& camera, Size size, double density,
                    DrawStatistics& statistics) {
  const auto points = [density](int pixels) {
    return std::max(1, static_cast<int>(std::lround(pixels / density)));
  };
  const Overlay overlay = overlay_of(list, camera, {points(size.width), points(size.height)});
  const auto pixel = [size, density](PixelPoint p) {  // from the middle, y up
    return std::array<float, 2>{static_cast<float>(density * p.x - 0.5 * size.width),
                                static_cast<float>(0.5 * size.height - density * p.y)};
  };
  std::vector<StrokeRow> rows;
  rows.reserve(overlay.strokes.size());
  for (const OverlayStroke& s : overlay.strokes) {
    rows.push_back({pixel(s.from), pixel(s.to), s.color, static_cast<float>(density * s.width)});
  }
  if (rows.empty()) {
    return;
  }
  strokes_.stream(std::as_bytes(std::span(rows)));
  program_.use();
  program_.set("half_size", 0.5F * static_cast<float>(size.width),
               0.5F * static_cast<float>(size.height));
  reading_.bind();
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(rows.size()));
  statistics.labels += overlay.labels;
  statistics.markers += overlay.markers;
  statistics.marked += overlay.marked;
  ++statistics.draw_calls;
}

}  // namespace soms::view
