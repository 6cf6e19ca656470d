/// \file
/// Which parts of a scene touch each other, and how the two of a contact look in a picture of it:
/// colors of their own, and names.
#pragma once

#include "apps/view/drawing/draw_list.h"
#include "apps/view/scene/touch.h"
#include "apps/view/scene/view_options.h"
#include "apps/view/scene/view_scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace soms::view {

/// Two parts with all their contacts, at least one.
struct ContactPair {
  PartPair parts;
  std::vector<Touch> touches;
};

/// The pairs of parts that touch, the one with most pairs of triangles first; of equal ones the
/// first by body and part. \cost O(n log n) for n contacts.
[[nodiscard]] std::vector<ContactPair> contact_pairs(const ViewScene& scene);

/// What a body or its part is called in words: "car 712" of several movers, else the part's name,
/// else the body's; printable.
[[nodiscard]] std::string name_of_part(const ViewScene& scene, BodyRef body, std::uint32_t part);

/// True if triangles of a body have colors of their own in a picture of a contact: where a part of
/// it touches, or where what does not touch is pale.
[[nodiscard]] bool has_contact_colors(const ViewScene& scene, BodyRef body,
                                      const TouchingPair& pair);

/// One color a triangle: the touching part's, and of the rest `colors`, or pale ones.
[[nodiscard]] std::shared_ptr<const std::vector<Color>> contact_colors(ViewScene& scene,
                                                                       BodyRef body,
                                                                       const TouchingPair& pair,
                                                                       CityColors colors);

/// The color of the second: sand of a whole body at rest, else orange.
[[nodiscard]] Color color_of_other(const ViewScene& scene, const TouchingPair& pair);

/// Removes all contacts but those of a pair of parts.
void keep_contacts_of(const ViewScene& scene, const PartPair& pair, std::vector<Touch>& touches);

/// The names of both, above them; of what is far larger than what is looked at, none.
[[nodiscard]] std::vector<Label> contact_names(const ViewScene& scene, const TouchingPair& pair);

}  // namespace soms::view
