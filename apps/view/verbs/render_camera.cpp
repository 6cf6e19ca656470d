#include "apps/view/verbs/render_camera.h"

#include "soms/base/error.h"

#include "apps/support/parse.h"
#include "apps/view/drawing/visibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>
#include <vector>

namespace soms::view {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
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

Vec3 toward_eye(double bearing, double elevation) {
  const double level = std::cos(elevation * kDegree);
  return {level * std::sin(bearing * kDegree), level * std::cos(bearing * kDegree),
          std::sin(elevation * kDegree)};
}

double line_length(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

/// What a camera looks at: what must not be hidden, and what shall be in the picture.
struct Aim {
  std::vector<Vec3> points;
  Box around;
  BodyRef body;
};

Aim aim_at_mover(std::uint32_t number, bool with_gap, const ViewScene& scene) {
  if (number >= scene.movers()) {
    throw Error(ErrorKind::usage,
                fmt::format("--camera mover:{}: the scene has {} movers", number, scene.movers()),
                "movers are numbered from 0; --count sets how many there are");
  }
  const BodyRef body = mover(number);
  Aim aim{{scene.bounds(body).center()}, scene.bounds(body), body};
  if (!with_gap) {
    return aim;
  }
  if (const auto& gap = scene.gap(); gap && (gap->a == body || gap->b == body)) {
    aim.around.grow(gap->distance.point_a);
    aim.around.grow(gap->distance.point_b);
  }
  return aim;
}

/// Places on the curves of contacts, evenly over their list.
std::vector<Vec3> places_of(const std::vector<Touch>& touches, const ViewScene& scene) {
  constexpr std::size_t kMost = 24;
  std::vector<Vec3> places;
  const std::size_t count = std::min(touches.size(), kMost);
  for (std::size_t k = 0; k < count; ++k) {
    const Crossing crossing = scene.crossing(touches[k * touches.size() / count]);
    const auto points = crossing.points();
    Vec3 sum;
    for (const Vec3& p : points) {
      sum += p * (1 / static_cast<double>(points.size()));
    }
    if (!points.empty()) {
      places.push_back(sum);
    }
  }
  return places;
}

/// Movers that touch anything, those with most contacts first.
std::vector<Aim> aims_at_contacts(const ViewScene& scene) {
  constexpr std::size_t kMost = 40;
  std::map<BodyRef, std::vector<Touch>> touching;
  for (const Touch& touch : scene.contacts()) {
    touching[touch.a].push_back(touch);
    if (touch.b.role == Role::mover) {
      touching[touch.b].push_back(touch);
    }
  }
  if (touching.empty()) {
    throw Error(ErrorKind::usage, "--camera contact: nothing touches in this frame",
                "choose another --frame, or leave out contact");
  }
  std::vector<std::pair<std::size_t, BodyRef>> order;
  order.reserve(touching.size());
  for (const auto& [body, touches] : touching) {
    order.emplace_back(touches.size(), body);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Aim> aims;
  for (std::size_t i = 0; i < std::min(order.size(), kMost); ++i) {
    const BodyRef body = order[i].second;
    aims.push_back({places_of(touching[body], scene), scene.bounds(body), body});
  }
  return aims;
}

/// A camera, and the share of what must not be hidden that it sees, 0 to 1.
struct Aimed {
  Camera camera;
  double free = 0;
};

/// Share of an aim's points that are seen from the eye. The body that is looked at does not hide
/// its own middle; it hides points on it that are farther than a small part of its size behind its
/// surface. From an eye with a roof above it, as in a house, a third of that.
double seen_share(const Aim& aim, const Vec3& eye, const ViewScene& scene) {
  constexpr double kThin = 0.02;
  constexpr double kUnderRoof = 1.0 / 3;
  if (aim.points.empty()) {
    return 0;
  }
  std::vector<Ray> rays;
  for (const Vec3& point : aim.points) {
    rays.push_back({eye, point - eye});
  }
  rays.push_back({eye, {0, 0, 1}});
  const std::vector<SurfaceHit> hits = scene.first_hits(rays);
  const double thin = kThin * line_length(aim.around.extent());
  const bool middle = aim.points.size() == 1;
  std::size_t seen = 0;
  for (std::size_t k = 0; k < aim.points.size(); ++k) {
    const double whole = line_length(rays[k].direction);
    const bool own = middle && hits[k].body == aim.body;
    seen += own || hits[k].t * whole > whole - thin ? 1U : 0U;
  }
  return (hits.back().body ? kUnderRoof : 1.0) * static_cast<double>(seen) /
         static_cast<double>(aim.points.size());
}

/// Share of the sky that is free above a subject: 1 in the open, little in a yard, 0 indoors.
double open_sky(const Aim& aim, const ViewScene& scene) {
  constexpr int kAround = 8;
  const Vec3 center = aim.around.center();
  const Vec3 above{center.x, center.y, aim.around.upper.z + 0.1 * line_length(aim.around.extent())};
  std::vector<Ray> rays{{above, {0, 0, 1}}};
  for (int k = 0; k < kAround; ++k) {
    rays.push_back({above, toward_eye(360.0 * k / kAround, 40)});
  }
  const std::vector<SurfaceHit> hits = scene.first_hits(rays);
  const auto free = std::count_if(hits.begin(), hits.end(),
                                  [](const SurfaceHit& hit) { return !hit.body.has_value(); });
  return static_cast<double>(free) / static_cast<double>(hits.size());
}

/// A camera on the subject's surroundings, from the side from which most of what matters is seen;
/// of sides that are about alike the first.
Aimed aimed(const CameraChoice& choice, const Aim& aim, const ViewScene& scene, Size size,
            const Parallel& parallel) {
  constexpr double kSurroundings = 1.5;  // half of the picture's box, in extents of the subject
  constexpr double kMuchBetter = 0.2;
  const Vec3 half = aim.around.extent() * kSurroundings;
  const Box wide{aim.around.center() - half, aim.around.center() + half};
  const auto from = [&](double bearing, double elevation) {
    return dollied(fitted(wide, toward_eye(bearing, elevation), size), 1 / choice.zoom);
  };
  Aimed best{from(choice.bearing, choice.elevation), choice.free_side ? -1.0 : 1.0};
  for (const double elevation : {25.0, 45.0, 65.0}) {
    for (int turn = 0; choice.free_side && turn < 16; ++turn) {
      check_stop(parallel);
      const Camera camera = from(choice.bearing + 22.5 * turn, elevation);
      const double free = seen_share(aim, camera.eye, scene);
      if (free > best.free + kMuchBetter || (best.free < 0 && free >= 0)) {
        best = {camera, free};
      }
    }
  }
  return best;
}

/// The mover with most contacts of those that are seen well, in the open; else the one that is seen
/// best.
Camera at_contact(const CameraChoice& choice, const ViewScene& scene, Size size,
                  const Parallel& parallel) {
  constexpr double kEnough = 0.45;  // of its curve, whose rear the mover itself hides
  constexpr double kIndoors = 0.2;  // what a contact indoors counts
  Aimed best;
  best.free = -2;
  for (const Aim& aim : aims_at_contacts(scene)) {
    Aimed here = aimed(choice, aim, scene, size, parallel);
    here.free *= kIndoors + (1 - kIndoors) * open_sky(aim, scene);
    if (here.free > best.free) {
      best = here;
    }
    if (best.free >= kEnough) {
      break;
    }
  }
  return best.camera;
}

/// A camera on a gap, from the side where most of the way is free and its segment looks longest.
Camera at_gap(const CameraChoice& choice, const ViewScene& scene, Size size,
              const Parallel& parallel) {
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
      check_stop(parallel);
      const Camera camera = from(choice.bearing + 45 * turn, elevation);
      const Vec3 line = around.center() - camera.eye;
      const double whole = line_length(line);
      const auto first = scene.pick({camera.eye, line * (1 / whole)});
      const double free = first ? std::min(1.0, first->distance / whole) : 1;
      const double seen = free * line_length(cross(along, line)) / whole;
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
void add_outermost(const Body& body, const Frustum& view, std::vector<Vec3>& points) {
  const std::array<Vec3, 5> inward{view.forward, view.inward[0], view.inward[1], view.inward[2],
                                   view.inward[3]};
  std::array<Vec3, 5> outermost;
  std::array<double, 5> least;
  least.fill(std::numeric_limits<double>::infinity());
  for (const auto& corners : body.shape.mesh().triangles) {
    for (const std::uint32_t v : corners) {
      const Vec3 p = body.pose.apply(body.shape.mesh().vertices[v]);
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
/// movers' boxes.
std::vector<Vec3> sample_of(const ViewScene& scene, std::span<const std::uint32_t> framed,
                            bool boxes, const Frustum& view) {
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
      add_outermost(body, view, points);
    }
    for (std::size_t i = 0; i < triangles.size(); i += step) {
      for (const std::uint32_t v : triangles[i]) {
        points.push_back(body.pose.apply(body.shape.mesh().vertices[v]));
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

Box scene_bounds(const ViewScene& scene) {
  Box box = scene.bounds();
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    box.grow(scene.bounds(mover(k)));
  }
  return box;
}

std::vector<std::uint32_t> astray_movers(const ViewScene& scene) {
  constexpr std::uint32_t kOneOf = 20;
  std::vector<std::uint32_t> astray;
  if (scene.city_parts() == 0) {
    return astray;
  }
  const Box city = scene.bounds();
  const double room = line_length(city.extent());
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

Camera place_camera(const CameraChoice& choice, const ViewScene& scene, Size size,
                    const Vec3& origin, const Parallel& parallel) {
  switch (choice.subject) {
    case CameraChoice::Subject::place:
      return {choice.eye + origin, choice.target + origin};
    case CameraChoice::Subject::mover:
      return aimed(choice, aim_at_mover(choice.mover, choice.with_gap, scene), scene, size,
                   parallel)
          .camera;
    case CameraChoice::Subject::gap:
      return at_gap(choice, scene, size, parallel);
    case CameraChoice::Subject::contact:
      return at_contact(choice, scene, size, parallel);
    case CameraChoice::Subject::scene:
      break;
  }
  const Vec3 back = toward_eye(choice.bearing, choice.elevation);
  const std::vector<std::uint32_t> astray = astray_movers(scene);
  std::vector<std::uint32_t> framed_movers;
  Box bulk = scene.bounds();
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    if (!std::binary_search(astray.begin(), astray.end(), k)) {
      framed_movers.push_back(k);
      bulk.grow(scene.bounds(mover(k)));
    }
  }
  const Camera whole = fitted(bulk, back, size);
  const std::vector<Vec3> sample =
      sample_of(scene, framed_movers, choice.boxes, frustum(whole, size));
  return dollied(framed(whole, sample, size), 1 / choice.zoom);
}

}  // namespace soms::view
