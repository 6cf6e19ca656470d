#include "apps/view/verbs/render_camera.h"

#include "soms/base/error.h"

#include "apps/cli/parse.h"
#include "apps/view/drawing/length.h"
#include "apps/view/drawing/visibility.h"
#include "apps/view/sight/aim.h"
#include "apps/view/verbs/aimed_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>
#include <vector>

namespace soms::view {

namespace {

constexpr double kMostZoom = 1e6;  ///< farther on, rounding would make eye and target one point
constexpr const char* kCameraRemedy =
    "give for example scene,southwest,1.5x or contact or \"0 -50 20 0 0 0\"; see --help";

struct NamedSide {
  std::string_view name;
  double bearing;
  double elevation;
};

constexpr std::array kSides{
    NamedSide{"north", 0, 20},   NamedSide{"northeast", 45, 30},
    NamedSide{"east", 90, 20},   NamedSide{"southeast", 135, 30},
    NamedSide{"south", 180, 20}, NamedSide{"southwest", 225, 30},
    NamedSide{"west", 270, 20},  NamedSide{"northwest", 315, 30},
    NamedSide{"top", 180, 90},
};

[[noreturn]] void refuse(const std::string& word) {
  throw Error(ErrorKind::usage, fmt::format("--camera: {}", word), kCameraRemedy);
}

std::vector<std::string> words_of(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

double number(const std::string& text) {
  return command::parse_number("--camera", text);
}

bool starts_a_number(const std::string& word) {
  return word.find_first_not_of("+-.0123456789") != 0;
}

bool read_side(const std::string& word, CameraChoice& choice) {
  for (const NamedSide& side : kSides) {
    if (side.name == word) {
      choice.bearing = side.bearing;
      choice.elevation = side.elevation;
      choice.free_side = false;
      return true;
    }
  }
  const std::size_t colon = word.find(':');
  if (colon == std::string::npos || !starts_a_number(word)) {
    return false;
  }
  choice.bearing = number(word.substr(0, colon));
  choice.elevation = number(word.substr(colon + 1));
  choice.free_side = false;
  if (std::abs(choice.elevation) > 90) {
    refuse(word + ": the elevation is beyond 90 degrees");
  }
  return true;
}

bool read_subject(const std::string& word, CameraChoice& choice) {
  if (word == "scene") {
    choice.subject = CameraChoice::Subject::scene;
  } else if (word == "contact") {
    choice.subject = CameraChoice::Subject::contact;
  } else if (word == "gap") {
    choice.subject = CameraChoice::Subject::gap;
  } else if (word == "mover" || word.starts_with("mover:")) {
    choice.subject = CameraChoice::Subject::mover;
    choice.mover = word == "mover" ? 0
                                   : static_cast<std::uint32_t>(command::parse_count(
                                         "--camera mover", word.substr(6), 0, 0xfffffffe));
  } else {
    return false;
  }
  return true;
}

bool read_zoom(const std::string& word, CameraChoice& choice) {
  if (!starts_a_number(word) || !word.ends_with('x')) {
    return false;
  }
  choice.zoom = number(word.substr(0, word.size() - 1));
  if (!(choice.zoom >= 1 / kMostZoom && choice.zoom <= kMostZoom)) {
    refuse(word + ": the zoom is not between a millionth and a million");
  }
  return true;
}

/// A camera on a gap, from the side where most of the way is free and its segment looks longest.
Camera at_gap(const CameraChoice& choice, const ViewScene& scene, Size size, const Limits& limits) {
  const std::optional<Gap> gap = choice.with_gap ? scene.gap() : std::nullopt;
  if (!gap) {
    throw Error(ErrorKind::usage, "--camera gap: no gap is drawn in this picture",
                "name two models that touch nowhere, without --no-gap");
  }
  const Box around =
      surroundings(*gap, scene.bounds(gap->a), scene.bounds(gap->b), scene_bounds(scene));
  const Vec3 along = gap->distance.point_b - gap->distance.point_a;
  const auto from = [&](double bearing, double elevation) {
    return dollied(fitted(around, toward_eye(bearing, elevation), size), 1 / choice.zoom);
  };
  Camera best = from(choice.bearing, choice.elevation);
  double most = -1;
  for (const double elevation : {25.0, 45.0, 65.0}) {
    for (int turn = 0; choice.free_side && turn < 8; ++turn) {
      check_stop(limits);
      const Camera camera = from(choice.bearing + 45 * turn, elevation);
      const Vec3 line = around.center() - camera.eye;
      const double whole = length(line);
      const auto first = scene.pick({camera.eye, line * (1 / whole)});
      const double free = first ? std::min(1.0, first->distance / whole) : 1;
      const double seen = free * length(cross(along, line)) / whole;
      if (seen > most) {
        best = camera;
        most = seen;
      }
    }
  }
  return best;
}

/// The corners of a body's triangles that are farthest out on each side of a picture, and nearest.
/// Of a picture with these from the same direction no other corner is out either.
void add_outermost(const Body& body, const Frustum& view, const Box& within,
                   std::vector<Vec3>& points) {
  const std::array<Vec3, 5> inward{view.forward, view.inward[0], view.inward[1], view.inward[2],
                                   view.inward[3]};
  std::array<Vec3, 5> outermost;
  std::array<double, 5> least;
  least.fill(std::numeric_limits<double>::infinity());
  for (const auto& corners : body.shape.mesh().triangles) {
    for (const std::uint32_t v : corners) {
      const Vec3 p = body.pose.apply(body.shape.mesh().vertices[v]);
      if (!within.empty() && !within.contains({p, p})) {
        continue;
      }
      for (std::size_t side = 0; side < inward.size(); ++side) {
        const double in = dot(inward[side], p - view.eye);
        if (in < least[side]) {
          least[side] = in;
          outermost[side] = p;
        }
      }
    }
  }
  points.insert(points.end(), outermost.begin(), outermost.end());
}

/// Points that show how far a scene reaches: corners of triangles, evenly chosen where there are
/// many beside those farthest out, or of the boxes of the city's trees, and those of the framed
/// movers' boxes. Of the city what is within a box, unless that is empty.
std::vector<Vec3> sample_of(const ViewScene& scene, std::span<const std::uint32_t> framed,
                            bool boxes, const Box& within, const Frustum& view) {
  constexpr std::size_t kMost = 200'000;
  std::vector<Vec3> points;
  const auto add_box = [&](const Box& box) {
    for (int i = 0; i < 8 && !box.empty(); ++i) {
      points.push_back({(i & 1) != 0 ? box.upper.x : box.lower.x,
                        (i & 2) != 0 ? box.upper.y : box.lower.y,
                        (i & 4) != 0 ? box.upper.z : box.lower.z});
    }
  };
  for (std::uint32_t k = 0; k < scene.city_parts(); ++k) {
    if (boxes) {
      add_box(scene.bounds(city_part(k)));
      continue;
    }
    const Body& body = scene.body(city_part(k));
    const auto& triangles = body.shape.mesh().triangles;
    const std::size_t step = triangles.size() / kMost + 1;
    if (step > 1) {
      add_outermost(body, view, within, points);
    }
    for (std::size_t i = 0; i < triangles.size(); i += step) {
      for (const std::uint32_t v : triangles[i]) {
        const Vec3 p = body.pose.apply(body.shape.mesh().vertices[v]);
        if (within.empty() || within.contains({p, p})) {
          points.push_back(p);
        }
      }
    }
  }
  for (const std::uint32_t k : framed) {
    add_box(scene.bounds(mover(k)));
  }
  return points;
}

}  // namespace

CameraChoice parse_camera(const std::string& text) {
  CameraChoice choice;
  const std::vector<std::string> words = words_of(text);
  if (words.empty()) {
    refuse("the value is empty");
  }
  const bool plain = std::all_of(words.begin(), words.end(), [](const std::string& word) {
    return starts_a_number(word) && !word.ends_with('x') && word.find(':') == std::string::npos;
  });
  if (plain) {
    if (words.size() != 6) {
      refuse(fmt::format("{} numbers instead of 6", words.size()));
    }
    choice.subject = CameraChoice::Subject::place;
    choice.eye = {number(words[0]), number(words[1]), number(words[2])};
    choice.target = {number(words[3]), number(words[4]), number(words[5])};
    if (choice.eye == choice.target) {
      refuse("the eye and the point that it looks at are the same");
    }
    return choice;
  }
  for (const std::string& word : words) {
    if (!read_side(word, choice) && !read_subject(word, choice) && !read_zoom(word, choice)) {
      refuse(fmt::format("{} is not a subject, side or zoom", word));
    }
  }
  return choice;
}

std::vector<std::uint32_t> astray_movers(const ViewScene& scene) {
  constexpr std::uint32_t kOneOf = 20;
  std::vector<std::uint32_t> astray;
  if (scene.city_parts() == 0) {
    return astray;
  }
  const Box city = scene.bounds();
  const double room = diagonal(city);
  const Vec3 margin{room, room, room};
  const Box about{city.lower - margin, city.upper + margin};
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    const Vec3 center = scene.bounds(mover(k)).center();
    if (!about.contains({center, center})) {
      astray.push_back(k);
    }
  }
  if (astray.size() * kOneOf > scene.movers()) {
    astray.clear();
  }
  return astray;
}

std::optional<DensePlace> place_in(const CameraChoice& choice, const ViewScene& scene) {
  const bool open = choice.subject == CameraChoice::Subject::scene && choice.free_side;
  return open && !choice.boxes ? dense_place(scene) : std::nullopt;
}

std::optional<CityBulk> bulk_in(const CameraChoice& choice, const ViewScene& scene) {
  return choice.free_side && !choice.boxes ? city_bulk(scene) : std::nullopt;
}

CameraChoice::Subject subject_of(const CameraChoice& choice, const ViewScene& scene) {
  using Subject = CameraChoice::Subject;
  if (choice.subject != Subject::open) {
    return choice.subject;
  }
  return choice.boxes                     ? Subject::scene
         : !scene.contacts().empty()      ? Subject::contact
         : choice.with_gap && scene.gap() ? Subject::gap
                                          : Subject::scene;
}

AimedCamera aimed_by(const CameraChoice& choice, const ViewScene& scene, Size size,
                     const Vec3& origin, const Limits& limits) {
  switch (subject_of(choice, scene)) {
    case CameraChoice::Subject::place:
      return {{choice.eye + origin, choice.target + origin}, {}};
    case CameraChoice::Subject::mover:
      return at_mover(choice, scene, size, limits);
    case CameraChoice::Subject::gap:
      return {at_gap(choice, scene, size, limits), {}};
    case CameraChoice::Subject::contact:
      return at_contact(choice, scene, size, limits);
    case CameraChoice::Subject::scene:
    case CameraChoice::Subject::open:
      break;
  }
  const Vec3 back = toward_eye(choice.bearing, choice.elevation);
  if (const auto place = place_in(choice, scene)) {
    return {dollied(fitted(place->box, back, size), 1 / choice.zoom), {}};
  }
  const std::vector<std::uint32_t> astray = astray_movers(scene);
  std::vector<std::uint32_t> framed_movers;
  const std::optional<CityBulk> near = bulk_in(choice, scene);
  const Box within = near ? near->box : Box{};
  Box bulk = near ? near->box : scene.bounds();
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    if (!std::binary_search(astray.begin(), astray.end(), k)) {
      framed_movers.push_back(k);
      bulk.grow(scene.bounds(mover(k)));
    }
  }
  const Camera whole = fitted(bulk, back, size);
  const std::vector<Vec3> sample =
      sample_of(scene, framed_movers, choice.boxes, within, frustum(whole, size));
  return {dollied(framed(whole, sample, size), 1 / choice.zoom), {}};
}

Camera place_camera(const CameraChoice& choice, const ViewScene& scene, Size size,
                    const Vec3& origin, const Limits& limits) {
  return aimed_by(choice, scene, size, origin, limits).camera;
}

}  // namespace soms::view
