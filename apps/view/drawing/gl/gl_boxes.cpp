#include "apps/view/drawing/gl/gl_boxes.h"

#include "apps/view/drawing/gl/gl_shaders.h"
#include "apps/view/drawing/gl/gl_shadows.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

template <typename Row>
void read_rows(const GlVertexArray& reading, const GlBuffer& buffer) {
  reading.floats(0, 3, buffer, sizeof(Row), offsetof(Row, middle), 1);
  reading.floats(1, 3, buffer, sizeof(Row), offsetof(Row, reach), 1);
  reading.color(2, buffer, sizeof(Row), offsetof(Row, color), 1);
}

}  // namespace

GlBoxes::GlBoxes()
    : face_program_("box", shader::kBoxVertex,
                    std::string(shader::kLightHead) + shader::kSurfaceFragment),
      edge_program_("edge", std::string(shader::kStrokeHead) + shader::kEdgeVertex,
                    shader::kStrokeFragment) {
  read_rows<Row>(ordered_reading_, ordered_);
}

void GlBoxes::fill(const BoxGroup& boxes, Group& group) {
  Box all;
  for (const BoxItem& item : boxes.boxes) {
    all.grow(item.box);
  }
  group.origin = all.empty() ? Vec3{} : all.center();
  const Vec3 e = all.extent();
  const double half = 0.5 * std::max({e.x, e.y, e.z});
  group.scale = half > 0 ? half : 1;
  group.rows.clear();
  group.translucent = false;
  for (const BoxItem& item : boxes.boxes) {
    if (!item.box.empty()) {
      group.rows.push_back({narrow((item.box.center() - group.origin) * (1 / group.scale)),
                            narrow(item.box.extent() * (0.5 / group.scale)), item.color});
      group.translucent = group.translucent || item.color.a < 255;
    }
  }
  group.count = group.rows.size();
  group.buffer.fill(std::as_bytes(std::span(group.rows)));
  check_device("uploading " + std::to_string(group.count) + " boxes to the device");
  read_rows<Row>(group.reading, group.buffer);
  if (!group.translucent) {
    group.rows = {};
  }
  group.version = boxes.version;
  group.filled = true;
}

void GlBoxes::bring(const DrawList& list, DrawStatistics& statistics) {
  std::map<std::uint64_t, Group> kept;
  brief_.clear();
  brief_.reserve(list.box_groups.size());
  of_list_.clear();
  for (const BoxGroup& boxes : list.box_groups) {
    Group* group = nullptr;
    if (boxes.key == 0) {
      group = &brief_.emplace_back();
    } else {
      const auto old = kept_.find(boxes.key);
      group = &(old == kept_.end() ? kept.try_emplace(boxes.key).first
                                   : kept.insert(kept_.extract(old)).position)
                   ->second;
    }
    if (!group->filled || group->version != boxes.version) {
      fill(boxes, *group);
      ++statistics.uploads;
    }
    statistics.boxes += group->count;
    of_list_.push_back(group);
  }
  kept_ = std::move(kept);
}

void GlBoxes::begin(const GlProgram& program, const GlView& view, const BoxGroup& boxes,
                    const Group& group, const GlShadows& shadows, float lift) const {
  const std::array<float, 12> rows = relative_rows(view, boxes.pose, group.origin, group.scale);
  program.use();
  program.set("clip", std::span(view.clip));
  program.set("lift", lift);
  program.set("row0", std::span(rows).subspan<0, 4>());
  program.set("row1", std::span(rows).subspan<4, 4>());
  program.set("row2", std::span(rows).subspan<8, 4>());
  program.set("nearest", view.nearest);
  program.set("slope", view.slope);
  program.set("half_size", view.half_width, view.half_height);
  program.set("width", view.point * boxes.width);
  program.set("least_alpha", boxes.style == BoxStyle::both ? 1.0F : 0.0F);
  shadows.light(program, view);
  program.set("flatness", 0.3F);
  program.set("shade", 1.0F);
}

void GlBoxes::draw_solid(const DrawList& list, const GlView& view, const GlShadows& shadows,
                         bool on_top, DrawStatistics& statistics) const {
  for (std::size_t i = 0; i < list.box_groups.size(); ++i) {
    const BoxGroup& boxes = list.box_groups[i];
    const Group& group = *of_list_[i];
    if (boxes.on_top != on_top || group.count == 0) {
      continue;
    }
    group.reading.bind();
    if (boxes.style != BoxStyle::wire && !group.translucent) {
      begin(face_program_, view, boxes, group, shadows, 1);
      glDrawArraysInstanced(GL_TRIANGLES, 0, 36, static_cast<GLsizei>(group.count));
      ++statistics.draw_calls;
    }
    if (boxes.style != BoxStyle::solid) {
      begin(edge_program_, view, boxes, group, shadows, view.lift);
      glDrawArraysInstanced(GL_TRIANGLES, 0, 72, static_cast<GLsizei>(group.count));
      ++statistics.draw_calls;
    }
  }
}

void GlBoxes::draw_translucent(const DrawList& list, const GlView& view, const GlShadows& shadows,
                               bool on_top, DrawStatistics& statistics) const {
  glDepthMask(GL_FALSE);
  for (std::size_t i = 0; i < list.box_groups.size(); ++i) {
    const BoxGroup& boxes = list.box_groups[i];
    const Group& group = *of_list_[i];
    if (boxes.on_top != on_top || boxes.style == BoxStyle::wire || !group.translucent) {
      continue;
    }
    // Clip w of a middle, from which the constant part is left out: it orders alike.
    const auto& clip = view.clip;
    const std::array<float, 12> m = relative_rows(view, boxes.pose, group.origin, group.scale);
    const auto depth = [&](const Row& row) {
      float sum = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        sum += row.middle[c] * (clip[3] * m[c] + clip[7] * m[4 + c] + clip[11] * m[8 + c]);
      }
      return sum;
    };
    std::vector<std::pair<float, std::size_t>> order;
    order.reserve(group.rows.size());
    for (std::size_t k = 0; k < group.rows.size(); ++k) {
      order.emplace_back(-depth(group.rows[k]), k);
    }
    std::sort(order.begin(), order.end());
    std::vector<Row> rows;
    rows.reserve(order.size());
    std::transform(order.begin(), order.end(), std::back_inserter(rows),
                   [&](const auto& entry) { return group.rows[entry.second]; });
    ordered_.stream(std::as_bytes(std::span(rows)));
    begin(face_program_, view, boxes, group, shadows, 1);
    ordered_reading_.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 36, static_cast<GLsizei>(rows.size()));
    ++statistics.draw_calls;
  }
  glDepthMask(GL_TRUE);
}

}  // namespace soms::view
