#include "apps/view/drawing/gl/gl_strokes.h"

#include "apps/view/drawing/gl/gl_shaders.h"

#include <epoxy/gl.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace soms::view {

namespace {

struct LineRow {
  std::array<float, 3> a;
  std::array<float, 3> b;
  Color color;
  float width;
  Color rim;
  float rim_width;
};

struct PointRow {
  std::array<float, 3> at;
  Color color;
  float diameter;
  Color rim;
};

void begin(const GlProgram& program, const GlView& view) {
  program.use();
  program.set("clip", std::span(view.clip));
  program.set("lift", view.lift);
  program.set("nearest", view.nearest);
  program.set("slope", view.slope);
  program.set("half_size", view.half_width, view.half_height);
}

}  // namespace

GlStrokes::GlStrokes()
    : line_program_("line", std::string(shader::kStrokeHead) + shader::kLineVertex,
                    shader::kLineFragment),
      point_program_("point", shader::kPointVertex, shader::kPointFragment) {
  lines_reading_.floats(0, 3, lines_, sizeof(LineRow), offsetof(LineRow, a), 1);
  lines_reading_.floats(1, 3, lines_, sizeof(LineRow), offsetof(LineRow, b), 1);
  lines_reading_.color(2, lines_, sizeof(LineRow), offsetof(LineRow, color), 1);
  lines_reading_.floats(3, 1, lines_, sizeof(LineRow), offsetof(LineRow, width), 1);
  lines_reading_.color(4, lines_, sizeof(LineRow), offsetof(LineRow, rim), 1);
  lines_reading_.floats(5, 1, lines_, sizeof(LineRow), offsetof(LineRow, rim_width), 1);
  points_reading_.floats(0, 3, points_, sizeof(PointRow), offsetof(PointRow, at), 1);
  points_reading_.color(1, points_, sizeof(PointRow), offsetof(PointRow, color), 1);
  points_reading_.floats(2, 1, points_, sizeof(PointRow), offsetof(PointRow, diameter), 1);
  points_reading_.color(3, points_, sizeof(PointRow), offsetof(PointRow, rim), 1);
}

void GlStrokes::draw(const DrawList& list, const GlView& view, bool on_top,
                     DrawStatistics& statistics) {
  draw_lines(list, view, on_top, statistics);
  draw_points(list, view, on_top, statistics);
}

void GlStrokes::draw_lines(const DrawList& list, const GlView& view, bool on_top,
                           DrawStatistics& statistics) {
  std::vector<LineRow> rows;
  for (const Line& line : list.lines) {
    if (line.on_top == on_top) {
      rows.push_back({view.relative(line.a), view.relative(line.b), line.color,
                      view.point * line.width, line.rim, view.point * line.rim_width});
    }
  }
  if (rows.empty()) {
    return;
  }
  lines_.stream(std::as_bytes(std::span(rows)));
  begin(line_program_, view);
  lines_reading_.bind();
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(rows.size()));
  statistics.lines += rows.size();
  ++statistics.draw_calls;
}

void GlStrokes::draw_points(const DrawList& list, const GlView& view, bool on_top,
                            DrawStatistics& statistics) {
  std::vector<PointRow> rows;
  for (const Point& point : list.points) {
    if (point.on_top == on_top) {
      rows.push_back(
          {view.relative(point.at), point.color, view.point * point.diameter, point.rim});
    }
  }
  if (rows.empty()) {
    return;
  }
  points_.stream(std::as_bytes(std::span(rows)));
  begin(point_program_, view);
  points_reading_.bind();
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(rows.size()));
  statistics.points += rows.size();
  ++statistics.draw_calls;
}

}  // namespace soms::view
