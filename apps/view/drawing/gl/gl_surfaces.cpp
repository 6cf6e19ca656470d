#include "apps/view/drawing/gl/gl_surfaces.h"

#include "apps/view/drawing/gl/gl_shaders.h"
#include "apps/view/drawing/gl/gl_shadows.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace soms::view {

namespace {

struct MarkVertex {
  std::array<float, 3> at;
  Color color;
};

// Edges of triangles upon their faces are this much darker.
constexpr float kEdgeShade = 0.55F;

const void* index_offset(std::uint32_t triangle) {
  const std::size_t bytes = std::size_t{12} * triangle;
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): its interface
}

}  // namespace

GlSurfaces::GlSurfaces() : program_("surface", shader::kSurfaceVertex, shader::kSurfaceFragment) {
  marks_reading_.floats(0, 3, marks_, sizeof(MarkVertex), offsetof(MarkVertex, at), 0);
  marks_reading_.color(1, marks_, sizeof(MarkVertex), offsetof(MarkVertex, color), 0);
  marks_reading_.color(5, marks_, sizeof(MarkVertex), offsetof(MarkVertex, color),
                       0);  // for its opacity
}

void GlSurfaces::upload(const DrawMesh& mesh, OnDevice& place, const GlSlicer& slicer) {
  // Who watches a drawing expects reports of its own thread alone.
  const Limits quiet{.threads = slicer.limits().threads, .stop = slicer.limits().stop};
  std::optional<TiledMesh> known = cut_.take(mesh);
  TiledMesh cut = known ? std::move(*known) : tiles_of(mesh, quiet);
  place.version = mesh.version;
  place.vertices.fill(std::as_bytes(std::span(cut.vertices)));
  place.indices.fill(std::as_bytes(std::span(cut.indices)));
  check_device("uploading a mesh of " + std::to_string(mesh.mesh->triangles.size()) +
               " triangles to the device");
  place.reading.floats(0, 3, place.vertices, sizeof(TileVertex), offsetof(TileVertex, x), 0);
  place.reading.color(1, place.vertices, sizeof(TileVertex), offsetof(TileVertex, color), 0);
  place.reading.indices(place.indices);
  place.tiles = std::move(cut.tiles);
  place.filled = true;
}

void GlSurfaces::bring(const DrawList& list, const GlSlicer& slicer, DrawStatistics& statistics) {
  std::map<std::uint64_t, OnDevice> kept;
  of_list_.clear();
  calls_.clear();
  for (const DrawMesh& mesh : list.meshes) {
    const auto old = meshes_.find(mesh.key);
    const auto at = old == meshes_.end() ? kept.try_emplace(mesh.key).first
                                         : kept.insert(meshes_.extract(old)).position;
    OnDevice& place = at->second;
    if (!place.filled || place.version != mesh.version) {
      upload(mesh, place, slicer);
      ++statistics.uploads;
    }
    of_list_.push_back(&place);
  }
  meshes_ = std::move(kept);
}

Box GlSurfaces::bounds(const DrawList& list) const {
  Box all;
  for (const Instance& instance : list.instances) {
    for (const Tile& tile : of_list_[instance.mesh]->tiles) {
      all.grow(moved(instance.pose, tile.bounds));
    }
  }
  return all;
}

std::vector<std::span<const Tile>> GlSurfaces::tiles() const {
  std::vector<std::span<const Tile>> all;
  for (const OnDevice* place : of_list_) {
    all.emplace_back(place->tiles);
  }
  return all;
}

void GlSurfaces::place(const DrawList& list, const GlView& view,
                       std::span<const TileGroup> groups) {
  std::vector<Row> rows;
  calls_.clear();
  for (const TileGroup& group : groups) {
    const Tile& tile = of_list_[group.mesh]->tiles[group.tile];
    calls_.push_back({of_list_[group.mesh], group.pass, group.edges, run_of(tile, group.form).first,
                      group.triangles, rows.size(), group.instances.size()});
    const bool plain = list.meshes[group.mesh].colors == nullptr;
    for (const std::uint32_t i : group.instances) {
      const Instance& instance = list.instances[i];
      rows.push_back({relative_rows(view, instance.pose, tile.origin, tile.scale), instance.color,
                      plain ? 1.0F : 0.0F, instance.highlighted ? 0.45F : 0.0F});
    }
  }
  rows_.stream(std::as_bytes(std::span(rows)));
}

void GlSurfaces::choose(const DrawList& list, const Camera& camera, Size size, const GlView& view,
                        const DrawOptions& options, DrawStatistics& statistics) {
  const Visible visible = choose_tiles(list, tiles(), camera, size, options.most_triangles);
  statistics.tiles = visible.tiles;
  statistics.tiles_drawn = visible.tiles_drawn;
  statistics.triangles = visible.triangles;
  statistics.triangles_left = visible.triangles_left;
  statistics.instances = list.instances.size();
  place(list, view, visible.groups);
  focus_ = {};
  if (list.focus) {
    const std::array<float, 3> at = view.relative(list.focus->center);
    focus_ = {at[0], at[1], at[2], static_cast<float>(list.focus->radius * view.unit)};
  }
}

void GlSurfaces::cast(const DrawList& list, const GlView& view,
                      const std::function<bool(const Box&)>& reaches, double speck,
                      GlSlicer& slicer, DrawStatistics& statistics) {
  place(list, view, choose_casters(list, tiles(), reaches, speck));
  for (const Call& call : calls_) {
    issue(call, slicer, statistics);
  }
}

void GlSurfaces::begin(const GlView& view, const GlShadows& shadows, float flatness, float shade,
                       float lift) const {
  const GlProgram& program = program_.use(shadows, view);
  program.set("clip", std::span(view.clip));
  program.set("flatness", flatness);
  program.set("shade", shade);
  program.set("lift", lift);
  program.set("focus", std::span(focus_));
}

void GlSurfaces::issue(const Call& call, GlSlicer& slicer, DrawStatistics& statistics) const {
  const GlVertexArray& reading = call.mesh->reading;
  const std::size_t most = slicer.copies(call.copies, call.triangles);
  for (std::size_t first = 0; first < call.copies; first += most) {
    const std::size_t copies = std::min(most, call.copies - first);
    const std::size_t start = (call.row + first) * sizeof(Row);
    for (unsigned r = 0; r < 3; ++r) {
      reading.floats(2 + r, 4, rows_, sizeof(Row),
                     start + offsetof(Row, rows) + std::size_t{16} * r, 1);
    }
    reading.color(5, rows_, sizeof(Row), start + offsetof(Row, tint), 1);
    reading.floats(6, 2, rows_, sizeof(Row), start + offsetof(Row, plain), 1);
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(3 * call.triangles), GL_UNSIGNED_INT,
                            index_offset(call.first), static_cast<GLsizei>(copies));
    ++statistics.draw_calls;
    slicer.drawn(copies * call.triangles);
  }
}

void GlSurfaces::draw_solid(const GlView& view, const GlShadows& shadows, GlSlicer& slicer,
                            DrawStatistics& statistics) const {
  begin(view, shadows, 0, 1, 1);
  for (const Call& call : calls_) {
    if (call.pass == Pass::solid) {
      issue(call, slicer, statistics);
    }
  }
  begin(view, shadows, 0.6F, kEdgeShade, view.lift);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  for (const Call& call : calls_) {
    if (call.pass == Pass::wire || call.edges) {
      issue(call, slicer, statistics);
    }
  }
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void GlSurfaces::draw_translucent(const GlView& view, const GlShadows& shadows, GlSlicer& slicer,
                                  DrawStatistics& statistics) const {
  begin(view, shadows, 0, 1, 1);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  for (const Call& call : calls_) {
    if (call.pass == Pass::translucent) {
      issue(call, slicer, statistics);
    }
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_FALSE);
  for (const Call& call : calls_) {
    if (call.pass == Pass::translucent) {
      issue(call, slicer, statistics);
    }
  }
  glDepthMask(GL_TRUE);
}

void GlSurfaces::draw_marks(const DrawList& list, const GlView& view, const GlShadows& shadows,
                            bool on_top, GlSlicer& slicer, DrawStatistics& statistics) const {
  std::vector<MarkVertex> corners;
  for (const TriangleMark& mark : list.marks) {
    if (mark.on_top == on_top) {
      for (const Vec3& p : {mark.corners.a, mark.corners.b, mark.corners.c}) {
        corners.push_back({view.relative(p), mark.color});
      }
    }
  }
  if (corners.empty()) {
    return;
  }
  marks_.stream(std::as_bytes(std::span(corners)));
  begin(view, shadows, 0.55F, 1, view.lift);
  marks_reading_.bind();
  glVertexAttrib4f(2, 1, 0, 0, 0);
  glVertexAttrib4f(3, 0, 1, 0, 0);
  glVertexAttrib4f(4, 0, 0, 1, 0);
  glVertexAttrib2f(6, 0, 0);
  const std::size_t triangles = corners.size() / 3;
  const std::size_t most = slicer.copies(triangles, 1);
  for (std::size_t first = 0; first < triangles; first += most) {
    const std::size_t count = std::min(most, triangles - first);
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(3 * first), static_cast<GLsizei>(3 * count));
    ++statistics.draw_calls;
    slicer.drawn(count);
  }
}

}  // namespace soms::view
