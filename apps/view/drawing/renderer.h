/// \file
/// What turns a draw list into a picture.
#pragma once

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"
#include "apps/view/drawing/picture_file.h"

#include <cstdint>
#include <limits>

namespace soms::view {

/// How much care a frame gets.
struct DrawOptions {
  static constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();

  /// Most triangles of meshes: where there are more, small ones are left out, the more of a tile
  /// the smaller it looks. While the camera moves a program sets some 200,000, and `kAll` when it
  /// stands still.
  std::uint64_t most_triangles = kAll;
  int samples = 4;      ///< for each pixel: 1 is fast, 4 and 8 make smooth edges
  double scale = 1;     ///< sides of the picture drawn, in those wanted: below 1 is coarse
  double density = 1;   ///< pixels of a point: lengths of strokes, letters and signs are in points
  bool relief = true;   ///< darken where near surfaces hide the sky; takes passes over the picture
  bool shadows = true;  ///< of the sun; takes two more views of all triangles
};

/// What the last frame took.
struct DrawStatistics {
  std::uint64_t draw_calls = 0;
  std::uint64_t triangles = 0;       ///< of meshes, sent to be drawn
  std::uint64_t triangles_left = 0;  ///< of meshes within the view, left out by `most_triangles`
  std::uint64_t tiles = 0;           ///< of all instances
  std::uint64_t tiles_drawn = 0;
  std::uint64_t instances = 0;
  std::uint64_t marks = 0;
  std::uint64_t boxes = 0;
  std::uint64_t lines = 0;
  std::uint64_t points = 0;
  std::uint64_t markers = 0;  ///< drawn, after merging
  std::uint64_t marked = 0;   ///< the sum of their counts
  std::uint64_t labels = 0;   ///< written: those that had room
  std::uint64_t uploads = 0;  ///< meshes and box groups brought to the device in this frame
};

/// Draws lists. One object belongs to one thread and, where it uses OpenGL, to one context.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// Draws one frame of `size` pixels.
  /// \errors As `check(DrawList)`; ErrorKind::usage for a size below 1 or beyond what the device
  ///         has; ErrorKind::out_of_memory.
  virtual void draw(const DrawList& list, const Camera& camera, Size size,
                    const DrawOptions& options = {}) = 0;

  /// Copies the last frame to the window's frame buffer, lower left corners together; does nothing
  /// where there is no window.
  virtual void present() = 0;

  /// The last frame. \errors ErrorKind::usage before the first.
  [[nodiscard]] virtual Picture read_pixels() = 0;

  /// Of the last frame; zeros before the first.
  [[nodiscard]] virtual DrawStatistics statistics() const = 0;
};

}  // namespace soms::view
