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

/// What a camera looks at: the part that must not be hidden, and what shall be in the picture.
struct Aim {
  Vec3 point;
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
  Aim aim{scene.bounds(body).center(), scene.bounds(body), body};
  if (!with_gap) {
    return aim;
  }
  if (const auto& gap = scene.gap(); gap && (gap->a == body || gap->b == body)) {
    aim.around.grow(gap->distance.point_a);
    aim.around.grow(gap->distance.point_b);
  }
  return aim;
}

/// Movers that touch anything, those with most contacts first.
std::vector<Aim> aims_at_contacts(const ViewScene& scene) {
  constexpr std::size_t kMost = 40;
  std::map<BodyRef, std::pair<std::size_t, Box>> touching;
  const auto note = [&](BodyRef body, TriangleId i) {
    auto& [count, box] = touching[body];
    ++count;
    box.grow(bounds(scene.triangle(body, i)));
  };
  for (const Touch& touch : scene.contacts()) {
    note(touch.a, touch.i);
    if (touch.b.role == Role::mover) {
      note(touch.b, touch.j);
    }
  }
  if (touching.empty()) {
    throw Error(ErrorKind::usage, "--camera contact: nothing touches in this frame",
                "choose another --frame, or leave out contact");
  }
  std::vector<std::pair<std::size_t, BodyRef>> order;
  order.reserve(touching.size());
  for (const auto& [body, facts] : touching) {
    order.emplace_back(facts.first, body);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Aim> aims;
  for (std::size_t i = 0; i < std::min(order.size(), kMost); ++i) {
    const BodyRef body = order[i].second;
    aims.push_back({touching[body].second.center(), scene.bounds(body), body});
  }
  return aims;
}

/// A camera, and which part of the way to its subject is free, 0 to 1.
struct Aimed {
  Camera camera;
  double free = 0;
};

/// A camera on the subject's surroundings, from the first side where nothing stands between.
Aimed aimed(const CameraChoice& choice, const Aim& aim, const ViewScene& scene, Size size,
            const Parallel& parallel) {
  const Vec3 e = aim.around.extent() * 0.5;
  const Box wide{aim.around.center() - e * 2, aim.around.center() + e * 2};
  const auto from = [&](double bearing, double elevation) {
    return dollied(fitted(wide, toward_eye(bearing, elevation), size), 1 / choice.zoom);
  };
  Aimed best{from(choice.bearing, choice.elevation), choice.free_side ? -1.0 : 1.0};
  for (const double elevation : {25.0, 45.0, 65.0}) {
    for (int turn = 0; choice.free_side && turn < 8; ++turn) {
      check_stop(parallel);
      const Camera camera = from(choice.bearing + 45 * turn, elevation);
      const Vec3 line = aim.point - camera.eye;
      const double whole = line_length(line);
      const auto first = scene.pick({camera.eye, line * (1 / whole)});
      if (!first || first->body == aim.body || first->distance > 0.98 * whole) {
        return {camera, 1};
      }
      if (first->distance > best.free * whole) {
        best = {camera, first->distance / whole};
      }
    }
  }
  return best;
}

/// The mover with most contacts of those that can be seen; of all where none can.
Camera at_contact(const CameraChoice& choice, const ViewScene& scene, Size size,
                  const Parallel& parallel) {
  Aimed best;
  best.free = -2;
  for (const Aim& aim : aims_at_contacts(scene)) {
    const Aimed here = aimed(choice, aim, scene, size, parallel);
    if (here.free > best.free) {
      best = here;
    }
    if (best.free >= 1) {
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
/// many beside those farthest out, or of the boxes of the city's trees, and those of the movers'
/// boxes.
std::vector<Vec3> sample_of(const ViewScene& scene, bool boxes, const Frustum& view) {
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
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
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
  const Camera whole = fitted(scene_bounds(scene), back, size);
  const std::vector<Vec3> sample = sample_of(scene, choice.boxes, frustum(whole, size));
  return dollied(framed(whole, sample, size), 1 / choice.zoom);
}

}  // namespace soms::view
