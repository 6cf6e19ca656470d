/// \file
/// Cameras named on the command line.
#pragma once

#include "soms/base/parallel.h"

#include "apps/view/drawing/camera.h"
#include "apps/view/scene/view_scene.h"
#include "apps/view/sight/aim.h"
#include "apps/view/sight/bulk.h"
#include "apps/view/sight/dense_place.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::view {

/// Where a picture is taken from: a side of a box, or a place.
struct CameraChoice {
  enum class Subject : std::uint8_t {
    scene,    ///< all of it
    mover,    ///< one mover
    gap,      ///< where two bodies are nearest
    contact,  ///< the mover with most contacts that can be seen
    place,    ///< `eye` and `target`
    open,     ///< nobody chose: a contact, else a gap, else all
  };

  Subject subject = Subject::scene;
  std::uint32_t mover = 0;
  std::string clash = {};  ///< for contacts: number or names of the parts; empty: any
  double bearing = 215;    ///< of the eye from the subject, degrees from north (+y) to east (+x)
  double elevation = 30;   ///< of the eye, degrees above the horizon
  bool free_side = true;   ///< for movers and contacts: look for a side with nothing between
  double zoom = 1;         ///< above 1 goes nearer
  bool with_gap = false;   ///< the gap is drawn: it shall fit, too
  bool may_cut = false;    ///< for movers and contacts: leave out what hides them from every side
  bool boxes = false;      ///< for scenes: the bodies' boxes shall fit, not only their triangles
  Vec3 eye = {};
  Vec3 target = {};
};

/// Reads a camera: `SUBJECT[,SIDE][,ZOOM]` in any order, or six numbers. A subject is scene,
/// contact, gap, or mover and its number (mover:3); a side is north, northeast and so on, top, or
/// bearing:elevation in degrees; a zoom is a factor with an x (2x). Six numbers are the eye and
/// what it looks at. \errors ErrorKind::usage.
[[nodiscard]] CameraChoice parse_camera(const std::string& text);

/// The subject of a choice that names none: a contact, else the gap that is drawn, else the scene;
/// of boxes always the scene.
[[nodiscard]] CameraChoice::Subject subject_of(const CameraChoice& choice, const ViewScene& scene);

/// The camera for a picture of a scene, and what it looks at: empty unless that is a mover or a
/// contact. Six numbers count from `origin`.
/// \errors ErrorKind::usage for a mover that is not there, and for contacts or a gap where there
///         are none; ErrorKind::cancelled; as `ViewScene::gap`.
[[nodiscard]] AimedCamera aimed_by(const CameraChoice& choice, const ViewScene& scene, Size size,
                                   const Vec3& origin, const Limits& limits = {});

/// The camera of `aimed_by`.
[[nodiscard]] Camera place_camera(const CameraChoice& choice, const ViewScene& scene, Size size,
                                  const Vec3& origin, const Limits& limits = {});

/// The place that a picture of a sparse scene is of, unless a side is named or boxes are drawn.
[[nodiscard]] std::optional<DensePlace> place_in(const CameraChoice& choice,
                                                 const ViewScene& scene);

/// The bulk of the city that a picture of it is framed by, unless a side is named or boxes are
/// drawn.
[[nodiscard]] std::optional<CityBulk> bulk_in(const CameraChoice& choice, const ViewScene& scene);

/// Movers farther from the city than the city is large, in order; none if they are more than one in
/// twenty. Pictures of the scene are framed without them.
[[nodiscard]] std::vector<std::uint32_t> astray_movers(const ViewScene& scene);

}  // namespace soms::view
