#include "apps/view/drawing/gl_labels.h"

#include "apps/view/drawing/gl_shaders.h"
#include "apps/view/drawing/labels.h"
#include "apps/view/drawing/stroke_font.h"

#include <epoxy/gl.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

constexpr double kPen = 0.15;     // of the height of digits
constexpr double kLetterRim = 2;  // pixels

struct StrokeRow {
  std::array<float, 2> from;
  std::array<float, 2> to;
  Color color;
  float width;
};

/// The strokes of a label, in pixels from the middle of the picture.
void add_rows(const Label& label, const PlacedLabel& place, Size size,
              std::vector<StrokeRow>& rows) {
  // Whole pixels keep letters alike wherever they stand.
  const double left = std::round(place.upper_left.x) - 0.5 * size.width;
  const double base = 0.5 * size.height - std::round(place.lower_right.y);
  const auto pixel = [&](TextPoint p) {
    return std::array<float, 2>{static_cast<float>(left + p.x), static_cast<float>(base + p.y)};
  };
  const std::vector<TextStroke> strokes = strokes_of(label.text, label.height);
  const double pen = kPen * label.height;
  for (const auto& [color, width] :
       {std::pair(label.rim, pen + 2 * kLetterRim), std::pair(label.color, pen)}) {
    for (const TextStroke& stroke : strokes) {
      rows.push_back({pixel(stroke.from), pixel(stroke.to), color, static_cast<float>(width)});
    }
  }
}

}  // namespace

GlLabels::GlLabels() : program_("label", shader::kLetterVertex, shader::kLetterFragment) {
  reading_.floats(0, 2, strokes_, sizeof(StrokeRow), offsetof(StrokeRow, from), 1);
  reading_.floats(1, 2, strokes_, sizeof(StrokeRow), offsetof(StrokeRow, to), 1);
  reading_.color(2, strokes_, sizeof(StrokeRow), offsetof(StrokeRow, color), 1);
  reading_.floats(3, 1, strokes_, sizeof(StrokeRow), offsetof(StrokeRow, width), 1);
}

void GlLabels::draw(const DrawList& list, const Camera& camera, Size size,
                    DrawStatistics& statistics) {
  std::vector<StrokeRow> rows;
  const std::vector<PlacedLabel> placed = place_labels(list.labels, camera, size);
  for (const PlacedLabel& place : placed) {
    add_rows(list.labels[place.label], place, size, rows);
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
  statistics.labels += placed.size();
  ++statistics.draw_calls;
}

}  // namespace soms::view
