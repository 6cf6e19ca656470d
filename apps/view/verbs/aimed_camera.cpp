#include "apps/view/verbs/aimed_camera.h"

#include "soms/base/error.h"

#include "apps/cli/parse.h"
#include "apps/view/scene/contact_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

Aim aim_at_mover(std::uint32_t number, bool with_gap, const ViewScene& scene) {
  if (number >= scene.movers()) {
    throw Error(ErrorKind::usage,
                fmt::format("--camera mover:{}: the scene has {} movers", number, scene.movers()),
                "movers are numbered from 0; --count sets how many there are");
  }
  const BodyRef body = mover(number);
  Aim aim{{scene.bounds(body).center()}, scene.bounds(body), body, true};
  if (!with_gap) {
    return aim;
  }
  if (const auto& gap = scene.gap(); gap && (gap->a == body || gap->b == body)) {
    aim.around.grow(gap->distance.point_a);
    aim.around.grow(gap->distance.point_b);
  }
  return aim;
}

constexpr std::size_t kMostAims = 40;

/// The pairs of parts that a choice of --clash names, or all.
std::vector<ContactPair> chosen_pairs(const CameraChoice& choice, const ViewScene& scene) {
  std::vector<ContactPair> pairs = contact_pairs(scene);
  const std::string& clash = choice.clash;
  if (pairs.empty()) {
    throw Error(ErrorKind::usage,
                fmt::format("--{}: nothing touches in this frame",
                            clash.empty() ? std::string("camera contact") : "clash " + clash),
                "choose another --frame, or leave it out");
  }
  if (clash.empty()) {
    return pairs;
  }
  if (clash.find_first_not_of("0123456789") == std::string::npos) {
    const std::uint64_t number = command::parse_count("--clash", clash, 1, pairs.size());
    return {std::move(pairs[number - 1])};
  }
  const auto is_named = [&](const ContactPair& pair) {
    const std::string a = name_of_part(scene, pair.parts.a, pair.parts.part_a);
    const std::string b = name_of_part(scene, pair.parts.b, pair.parts.part_b);
    return clash == a || clash == b || clash == a + "," + b || clash == b + "," + a;
  };
  const auto named = std::find_if(pairs.begin(), pairs.end(), is_named);
  if (named == pairs.end()) {
    throw Error(ErrorKind::usage, fmt::format("--clash {}: no such part touches anything", clash),
                fmt::format("give a number from 1 to {}, the name of a part, or two with a comma",
                            pairs.size()));
  }
  return {std::move(*named)};
}

/// Aims at pairs of parts, in their order.
std::vector<Aim> aims_at_pairs(const ViewScene& scene, const std::vector<ContactPair>& pairs) {
  std::vector<Aim> aims;
  PartBoxes part_boxes(scene);
  for (std::size_t k = 0; k < std::min(pairs.size(), kMostAims); ++k) {
    aims.push_back(aim_at_touches(scene, pairs[k].parts.a, pairs[k].touches, part_boxes));
    aims.back().pair = pairs[k].parts;
  }
  return aims;
}

/// Aims at movers that touch anything, those with most contacts first.
std::vector<Aim> aims_at_movers(const ViewScene& scene, const std::vector<ContactPair>& pairs) {
  std::map<BodyRef, std::vector<const ContactPair*>> of_mover;
  for (const ContactPair& pair : pairs) {
    of_mover[pair.parts.a].push_back(&pair);
    if (pair.parts.b.role == Role::mover) {
      of_mover[pair.parts.b].push_back(&pair);
    }
  }
  std::vector<std::pair<std::size_t, BodyRef>> order;
  order.reserve(of_mover.size());
  for (const auto& [body, touching] : of_mover) {
    std::size_t count = 0;
    for (const ContactPair* const pair : touching) {
      count += pair->touches.size();
    }
    order.emplace_back(count, body);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Aim> aims;
  PartBoxes part_boxes(scene);
  for (std::size_t k = 0; k < std::min(order.size(), kMostAims); ++k) {
    const std::vector<const ContactPair*>& touching = of_mover[order[k].second];
    std::vector<Touch> touches;
    for (const ContactPair* const pair : touching) {
      touches.insert(touches.end(), pair->touches.begin(), pair->touches.end());
    }
    aims.push_back(aim_at_touches(scene, order[k].second, touches, part_boxes));
    aims.back().pair = touching.front()->parts;  // pairs with most contacts are first
  }
  return aims;
}

/// The camera on one of the aims, as chosen.
AimedCamera on_one_of(const std::vector<Aim>& aims, const CameraChoice& choice,
                      const ViewScene& scene, Size size, const Limits& limits) {
  const FitCamera fit = [&](const Box& box, const Vec3& toward) {
    return dollied(fitted(box, toward, size), 1 / choice.zoom);
  };
  return aimed_camera(scene, aims,
                      {choice.bearing, choice.elevation, choice.free_side, choice.may_cut}, fit,
                      limits);
}

}  // namespace

AimedCamera at_mover(const CameraChoice& choice, const ViewScene& scene, Size size,
                     const Limits& limits) {
  return on_one_of({aim_at_mover(choice.mover, choice.with_gap, scene)}, choice, scene, size,
                   limits);
}

AimedCamera at_contact(const CameraChoice& choice, const ViewScene& scene, Size size,
                       const Limits& limits) {
  const std::vector<ContactPair> pairs = chosen_pairs(choice, scene);
  // Of one mover, as a building's services, each pair of parts is a contact of its own.
  const bool by_parts = scene.movers() == 1 || !choice.clash.empty();
  return on_one_of(by_parts ? aims_at_pairs(scene, pairs) : aims_at_movers(scene, pairs), choice,
                   scene, size, limits);
}

}  // namespace soms::view
