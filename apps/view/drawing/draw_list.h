/// \file
/// What to draw, as plain data in world coordinates: no OpenGL, no questions of collision.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/geometry/mesh.h"

#include "apps/draw/picture.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soms::view {

using look::Color;
using look::color_of;
using look::with_alpha;

/// A mesh that instances share. Renderers upload it once for each pair of key and version, cut into
/// tiles, and drop it when a list no longer names its key.
struct DrawMesh {
  std::uint64_t key = 0;      ///< who it is, unique among the meshes of a list
  std::uint64_t version = 0;  ///< raised whenever geometry or colors change
  std::shared_ptr<const Mesh> mesh = {};
  /// One color a triangle, or none: then each instance gives its own.
  std::shared_ptr<const std::vector<Color>> colors = {};
};

/// How a surface is drawn.
enum class SurfaceStyle : std::uint8_t {
  solid,  ///< shaded faces
  wire,   ///< edges of triangles only
  both,   ///< faces with their edges upon them
};

/// One placed copy of a mesh.
struct Instance {
  std::uint32_t mesh = 0;  ///< index into `DrawList::meshes`
  Pose pose = {};
  Color color{190, 190, 190, 255};  ///< used where the mesh has no colors; `a` holds in any case
  SurfaceStyle style = SurfaceStyle::solid;
  bool highlighted = false;  ///< drawn brighter, as the chosen one
};

/// A triangle in world coordinates, drawn just above the surface that it lies in.
struct TriangleMark {
  Triangle corners = {};
  Color color{213, 94, 0, 255};
  bool on_top = false;  ///< seen through everything
};

/// A piece of a curve about which surfaces take the list's `glow_color`, the less the farther off.
struct Glow {
  Vec3 a = {};
  Vec3 b = {};
  double radius = 1;  ///< where nothing of the color is left; in pictures 14 pixels at least
};

/// What is looked at: surfaces farther off from it are pale.
struct Focus {
  Vec3 center = {};
  double radius = 1;  ///< within which they are as ever; at twice that they are palest
};

/// A plain ground, a disc square to z that fades out. It is seen from above only.
struct Ground {
  Vec3 center = {};
  double radius = 1;
  Color color{217, 215, 209, 255};
};

struct BoxItem {
  Box box = {};
  Color color{0, 114, 178, 255};
};

enum class BoxStyle : std::uint8_t {
  wire,   ///< twelve edges
  solid,  ///< six faces
  both,   ///< six faces and twelve edges; a translucent color makes only the faces translucent
};

/// Boxes of one body, in its coordinates. A group whose key is not 0 is uploaded once for each pair
/// of key and version.
struct BoxGroup {
  std::uint64_t key = 0;
  std::uint64_t version = 0;
  Pose pose = {};
  BoxStyle style = BoxStyle::wire;
  float width = 1;      ///< of edges, in points (`DrawOptions::density`), as lengths below
  bool on_top = false;  ///< seen through everything
  std::vector<BoxItem> boxes = {};
};

struct Line {
  Vec3 a = {};
  Vec3 b = {};
  Color color{0, 0, 0, 255};
  float width = 1;      ///< in points
  bool on_top = false;  ///< seen through everything
  Color rim{255, 255, 255, 255};
  float rim_width = 0;  ///< of a border beside the line, on either side, in points
};

struct Point {
  Vec3 at = {};
  Color color{0, 0, 0, 255};
  float diameter = 6;          ///< in points
  bool on_top = false;         ///< seen through everything
  Color rim{26, 26, 26, 255};  ///< of points wider than 6
};

/// A disc of constant size with a number, upon everything: a place that is found from afar. Those
/// that would overlap in a picture become one, with the sum of their counts (`markers.h`).
struct Marker {
  Vec3 at = {};
  double reach = 0;         ///< radius of what is there
  bool always = false;      ///< drawn even where what is there is large enough to be seen
  std::uint32_t count = 1;  ///< of what it stands for
  Color color{209, 21, 12, 255};
};

/// How an entry of a key looks.
enum class KeySign : std::uint8_t {
  area,    ///< a surface
  curve,   ///< a contact, which is left out where the picture shows none
  marker,  ///< a disc with a number, left out likewise
};

/// What a color or sign of a picture means.
struct KeyEntry {
  KeySign sign = KeySign::area;
  Color color = {};
  std::string text = {};
  std::vector<Vec3> places = {};  ///< left out where none of them is in the picture; none: never
};

/// Words beside the scene.
struct Captions {
  std::string title = {};          ///< above, at the left
  std::vector<KeyEntry> key = {};  ///< below, at the left
  double meters = 0;               ///< a unit; 0 leaves out the scale bar, below at the right
  bool north = false;              ///< an arrow toward +y above the scale bar
  double covered = 0;              ///< share of the width, at the left, that something else covers
  double covered_right = 0;        ///< likewise
  double covered_below = 0;        ///< of the height
};

/// A number with its unit beside the middle of a segment, on top of everything, unless it would
/// cover a label before it. `stroke_font.h` says which letters there are.
struct Label {
  Vec3 a = {};
  Vec3 b = {};
  std::string text = {};
  Color color{0, 0, 0, 255};
  Color rim{255, 255, 255, 255};  ///< around the letters
  float height = 13;              ///< of digits, in points
};

/// Fills the picture before anything is drawn: a sky above the horizon, haze below it.
struct Background {
  Color lower{241, 243, 244, 255};    ///< at the horizon
  Color upper{164, 194, 222, 255};    ///< straight above
  Color beneath{236, 239, 241, 255};  ///< straight below
};

/// A sun, and a sky that is brighter above.
struct Light {
  Vec3 toward{-0.85, -0.15, 0.8};  ///< from the scene to the light; any length but 0
  float ambient = 0.5F;            ///< share of the light that comes from everywhere, 0 to 1
};

/// One picture. Order within each list does not matter, except that later marks, lines and points
/// lie over earlier ones of equal depth, and earlier labels are written first.
struct DrawList {
  std::vector<DrawMesh> meshes = {};
  std::vector<Instance> instances = {};
  std::vector<TriangleMark> marks = {};
  std::vector<Glow> glows = {};
  Color glow_color{209, 21, 12, 255};
  std::optional<Focus> focus = std::nullopt;
  std::optional<Ground> ground = std::nullopt;
  std::vector<BoxGroup> box_groups = {};
  std::vector<Line> lines = {};
  std::vector<Point> points = {};
  std::vector<Label> labels = {};
  std::vector<Marker> markers = {};
  Captions captions = {};
  Background background;
  Light light;
};

/// Bounds of everything in the list, in world coordinates; empty for an empty list.
/// \pre Every instance names a mesh of the list, and no mesh is null.
/// \cost O(vertices) of the shared meshes; ask once a scene, not once a frame.
[[nodiscard]] Box bounds(const DrawList& list);

/// Bounds of marks, boxes, lines, points and segments of labels, not of grounds, glows and
/// markers; empty
/// where there are none.
[[nodiscard]] Box bounds_beside_meshes(const DrawList& list);

/// Bounds of a box that was moved by a pose; empty for an empty box.
[[nodiscard]] Box moved(const Pose& pose, const Box& box);

/// Throws unless every index is in range and every mesh is there.
/// \errors ErrorKind::usage names the first fault.
void check(const DrawList& list);

}  // namespace soms::view
