/// \file
/// Boxes on the device. Private to the renderer.
#pragma once

#include "apps/view/drawing/gl/gl_objects.h"
#include "apps/view/drawing/gl/gl_view.h"
#include "apps/view/drawing/renderer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace soms::view {

class GlShadows;

/// Groups of boxes: every edge of a group in one draw call, and every face in one.
class GlBoxes {
 public:
  GlBoxes();

  /// Brings new and changed groups to the device. \errors ErrorKind::out_of_memory.
  void bring(const DrawList& list, DrawStatistics& statistics);

  /// Opaque faces, then edges, of the groups on top or of the others.
  void draw_solid(const DrawList& list, const GlView& view, const GlShadows& shadows, bool on_top,
                  DrawStatistics& statistics) const;

  /// Translucent faces, from far to near within each group.
  void draw_translucent(const DrawList& list, const GlView& view, const GlShadows& shadows,
                        bool on_top, DrawStatistics& statistics) const;

 private:
  /// A box as the device gets it, in units of its group.
  struct Row {
    std::array<float, 3> middle;
    std::array<float, 3> reach;
    Color color;
  };

  struct Group {
    std::uint64_t version = 0;
    bool filled = false;
    bool translucent = false;  ///< a box of it is
    Vec3 origin;
    double scale = 1;
    std::vector<Row> rows;  ///< kept where faces are translucent and need an order
    std::size_t count = 0;
    GlBuffer buffer;
    GlVertexArray reading;
  };

  static void fill(const BoxGroup& boxes, Group& group);
  void begin(const GlProgram& program, const GlView& view, const BoxGroup& boxes,
             const Group& group, const GlShadows& shadows, float lift) const;

  GlProgram face_program_;
  GlProgram edge_program_;
  std::map<std::uint64_t, Group> kept_;
  std::vector<Group> brief_;           ///< groups without a key: for this frame
  std::vector<const Group*> of_list_;  ///< the group of each box group of the list
  mutable GlBuffer ordered_;
  GlVertexArray ordered_reading_;
};

}  // namespace soms::view
