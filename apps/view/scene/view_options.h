/// \file
/// What of a scene is shown, and how. Plain values, right for most as they are.
#pragma once

#include "soms/thesis/traversal_options.h"
#include "soms/tree/build_options.h"

#include "apps/view/drawing/draw_list.h"
#include "apps/view/drawing/palette.h"
#include "apps/view/scene/touch.h"

#include <cstddef>
#include <optional>

namespace soms::view {

/// How the city's surfaces are colored.
enum class CityColors : std::uint8_t {
  by_building,  ///< by part; without parts by connected pieces; without these by place
  plain,        ///< all alike, so that marks stand out
};

/// The trees that are shown and traversed: how they are built, and how two of them are traversed.
/// The answers of the scene do not depend on them.
struct TreeChoice {
  BuildOptions build{.rule = Rule::soms};
  TraversalOptions traversal{.traversal = Traversal::e_node, .descent = Descent::larger};

  [[nodiscard]] bool operator==(const TreeChoice&) const = default;
};

/// Boxes of one level of a body's tree (thesis, figs. 4.28 to 4.30).
struct LevelBoxes {
  BodyRef body;
  int level = 1;             ///< 1 is the root alone
  bool leaves_above = true;  ///< also the leaves of levels above, which hold the other triangles
  BoxStyle style = BoxStyle::wire;

  [[nodiscard]] bool operator==(const LevelBoxes&) const = default;
};

/// Boxes that the last traversal of the chosen pair looked at (thesis, fig. 4.35).
struct TraceBoxes {
  bool visited = true;  ///< nodes that were descended
  bool pruned = true;   ///< nodes that were apart from all they were tested against
  bool found = true;    ///< leaves of the pairs found
  bool city = true;     ///< boxes of the pair's first tree
  bool mover = true;    ///< boxes of the pair's second tree

  [[nodiscard]] bool operator==(const TraceBoxes&) const = default;
};

/// What is shown of contacts.
struct ContactMarks {
  bool glow = true;          ///< surfaces are red about where they touch, the less the farther off
  bool triangles = false;    ///< touching triangles in red, whole
  bool parts = false;        ///< the parts they belong to, in a paler red
  bool segments = true;      ///< where they cross: segments, points, common areas
  bool lines = false;        ///< from the middle of each touching mover to its contacts
  bool markers = true;       ///< a number where movers touch and it is too small to be seen
  bool all_markers = false;  ///< also where it is large enough
  bool on_top = false;       ///< seen through everything
  std::size_t most = 2000;   ///< most contacts drawn; `DrawnScene` says how many there are
  std::size_t most_of_parts = 20000;  ///< most triangles of parts drawn

  [[nodiscard]] bool operator==(const ContactMarks&) const = default;
};

/// What is shown of the gaps of a recording's frame.
struct FrameGapMarks {
  bool shown = true;        ///< lines between the nearest points, with their lengths
  std::size_t most = 1000;  ///< most gaps drawn, the nearest; `DrawnScene` says how many there are

  [[nodiscard]] bool operator==(const FrameGapMarks&) const = default;
};

/// The contact that a picture is of: its two in colors of their own, with their names.
struct TouchingPair {
  PartPair touching;
  Box around = {};     ///< what is looked at
  bool alone = false;  ///< other parts of the two bodies are pale, and other contacts left out

  [[nodiscard]] bool operator==(const TouchingPair&) const = default;
};

/// Colors of marks. The default ones are distinguished by people who see fewer colors.
struct ViewColors {
  Color contact = palette::kContact;
  Color part = {240, 150, 130, 255};
  Color segment = palette::kContact;
  Color gap = palette::kGap;
  Color line = palette::kPurple;
  Color level = palette::kBlue;
  Color leaf_above = palette::kSkyBlue;
  Color visited = {40, 44, 66, 255};
  Color pruned = {150, 150, 150, 255};
  /// Boxes that collide are red as in the thesis, fig. 4.35. Where they are shown, surfaces that
  /// touch have the next two colors in place of `contact` and `part`.
  Color found = palette::kContact;
  Color contact_beside_boxes = palette::kViolet;
  Color part_beside_boxes = {196, 160, 245, 255};
  Color tested_a = palette::kPurple;  ///< boxes of the pair's first tree, test by test
  Color tested_b = palette::kGreen;   ///< of its second tree; movers are blue
  Color plain_city = {222, 211, 186, 255};

  [[nodiscard]] bool operator==(const ViewColors&) const = default;
};

/// What is shown.
struct ViewOptions {
  bool city = true;
  bool movers = true;
  SurfaceStyle city_style = SurfaceStyle::solid;
  SurfaceStyle mover_style = SurfaceStyle::solid;
  CityColors city_colors = CityColors::by_building;
  TreeChoice trees;
  std::optional<LevelBoxes> level;  ///< nothing: no boxes of a level
  std::optional<TraceBoxes> trace;  ///< nothing: no boxes of a traversal
  ContactMarks contacts;
  FrameGapMarks frame_gaps;
  bool gap =
      true;  ///< nearest points of the pair, if its bodies share none: a line with its length
  bool in_meters = false;                ///< units are meters: the length of the gap says so
  bool ground = true;                    ///< a plain ground below everything
  bool key = true;                       ///< what the colors mean, and names at a contact
  std::optional<BodyRef> highlighted;    ///< drawn brighter
  std::optional<Touch> chosen;           ///< a contact drawn through everything
  std::optional<Box> focus;              ///< what is looked at: what is farther off is pale
  std::optional<TouchingPair> touching;  ///< what the picture is of; nothing: no single contact
  std::size_t most_boxes = 50'000;       ///< of a level or a traversal; the largest are drawn
  ViewColors colors;
};

/// The colors of a picture: where it shows boxes that collide, surfaces that touch are not red.
[[nodiscard]] inline ViewColors colors_in(const ViewOptions& options) {
  ViewColors colors = options.colors;
  if (options.trace && options.trace->found) {
    colors.contact = colors.segment = colors.contact_beside_boxes;
    colors.part = colors.part_beside_boxes;
  }
  return colors;
}

}  // namespace soms::view
