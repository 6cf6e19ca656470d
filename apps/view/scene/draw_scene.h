/// \file
/// From a scene and what is to be shown of it to a draw list.
#pragma once

#include "apps/view/drawing/draw_list.h"
#include "apps/view/scene/view_options.h"
#include "apps/view/scene/view_scene.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace soms::view {

/// How much of what is to be shown a draw list holds.
struct ShownCounts {
  std::uint64_t contacts = 0;  ///< 0 where none of their marks is to be shown
  std::uint64_t contacts_drawn = 0;
  std::uint64_t gaps = 0;  ///< 0 where they are not to be shown
  std::uint64_t gaps_drawn = 0;
  std::uint64_t part_triangles = 0;  ///< of the parts that contacts drawn belong to
  std::uint64_t part_triangles_drawn = 0;
  std::uint64_t boxes = 0;
  std::uint64_t boxes_drawn = 0;
};

/// A picture, and how much of what there is it holds.
struct DrawnScene {
  DrawList list;
  ShownCounts counts;
};

/// The picture of a scene. Meshes are shared and keep their keys and versions from call to call;
/// only instances, marks and the boxes of a traversal are rebuilt. Builds the trees that
/// `options` need when they are shown for the first time.
/// \errors ErrorKind::usage for a body that is not there, a level below 1, and tree options out of
///         range.
/// \cost   O(bodies + contacts drawn + gaps drawn + boxes drawn).
[[nodiscard]] DrawnScene draw_scene(ViewScene& scene, const ViewOptions& options);

/// Its list alone.
[[nodiscard]] DrawList make_draw_list(ViewScene& scene, const ViewOptions& options);

/// At most `most` of the scene's contacts, spread evenly over their sorted list.
[[nodiscard]] std::vector<Touch> drawn_contacts(const ViewScene& scene, std::size_t most);

/// What found no room in a picture, a line each, as "2,000 of 12,345 contacts"; empty: nothing.
[[nodiscard]] std::vector<std::string> left_out(const ShownCounts& counts);

}  // namespace soms::view
