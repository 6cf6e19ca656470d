#include "apps/view/scene/contact_look.h"

#include "soms/base/common_box.h"
#include "soms/base/text.h"
#include "soms/geometry/parts_of.h"

#include "apps/view/drawing/length.h"
#include "apps/world/part_names.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace soms::view {

namespace {

constexpr Color kPaleA{206, 216, 226, 255};
constexpr Color kPaleB{226, 223, 216, 255};
constexpr float kNameHeight = 15;
/// Names stand above a corner that is up and away from the other; this much away.
constexpr double kAside = 0.8;
/// What is larger than this many diagonals of what is looked at is all around it.
constexpr double kAllAround = 8;

/// Bounds of a part at its body's pose.
Box box_of_part(const ViewScene& scene, BodyRef ref, std::uint32_t part) {
  if (part == Part::kNoParent) {
    return scene.bounds(ref);
  }
  const Part& run = scene.body(ref).shape.mesh().parts[part];
  Box box;
  for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
    const Triangle t = scene.triangle(ref, i);
    box.grow(t.a);
    box.grow(t.b);
    box.grow(t.c);
  }
  return box;
}

/// What of a part is about the contact, so that its name is in the picture.
Box box_about(const Box& box, const Box& around) {
  const Vec3 margin = around.extent() * 0.5;
  const Box near = common_box(box, {around.lower - margin, around.upper + margin});
  return around.empty() || near.empty() ? box : near;
}

/// The corner of a part that is farthest up and away from the other of the two; nothing where no
/// corner is about the contact.
std::optional<Vec3> corner_toward(const ViewScene& scene, BodyRef ref, std::uint32_t part,
                                  const Box& within, const Vec3& toward) {
  const Body& body = scene.body(ref);
  const MeshView& mesh = body.shape.mesh();
  const auto all = static_cast<std::uint32_t>(mesh.triangles.size());
  const std::uint32_t first = part == Part::kNoParent ? 0 : mesh.parts[part].first;
  const std::uint32_t count = part == Part::kNoParent ? all : mesh.parts[part].count;
  std::optional<Vec3> best;
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const std::uint32_t v : mesh.triangles[i]) {
      const Vec3 p = body.pose.apply(mesh.vertices[v]);
      if (within.contains({p, p}) && (!best || dot(toward, p) > dot(toward, *best))) {
        best = p;
      }
    }
  }
  return best;
}

Label name_at(const ViewScene& scene, BodyRef ref, std::uint32_t part, const Box& box,
              const Box& other) {
  const Vec3 center = box.center();
  const Vec3 off{center.x - other.center().x, center.y - other.center().y, 0};
  const double far = length(off);
  const Vec3 toward = (far > 0 ? off * (kAside / far) : Vec3{}) + Vec3{0, 0, 1};
  const Vec3 top{center.x, center.y, box.upper.z};
  const Vec3 at = corner_toward(scene, ref, part, box, toward).value_or(top);
  return {.a = at,
          .b = at,
          .text = name_of_part(scene, ref, part),
          .color = palette::kInk,
          .height = kNameHeight};
}

}  // namespace

std::vector<ContactPair> contact_pairs(const ViewScene& scene) {
  std::map<const MeshView*, PartsOf> parts;
  const auto part_at = [&](BodyRef body, TriangleId triangle) {
    const MeshView& mesh = scene.body(body).shape.mesh();
    return parts.try_emplace(&mesh, mesh).first->second(triangle);
  };
  std::map<PartPair, std::vector<Touch>> touches;
  for (const Touch& touch : scene.contacts()) {
    const PartPair pair{touch.a, touch.b, part_at(touch.a, touch.i), part_at(touch.b, touch.j)};
    touches[pair].push_back(touch);
  }
  std::vector<ContactPair> pairs;
  pairs.reserve(touches.size());
  for (auto& [pair, of_pair] : touches) {
    pairs.push_back({pair, std::move(of_pair)});
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const ContactPair& a, const ContactPair& b) {
    return a.touches.size() > b.touches.size();
  });
  return pairs;
}

std::string name_of_part(const ViewScene& scene, BodyRef body, std::uint32_t part) {
  const Body& named = scene.body(body);
  if (body.role == Role::mover && scene.movers() > 1) {
    return printable(named.name) + " " + std::to_string(body.index);
  }
  return printable(part == Part::kNoParent ? named.name
                                           : command::part_label(named.shape.mesh(), part));
}

bool has_contact_colors(const ViewScene& scene, BodyRef body, const TouchingPair& pair) {
  const PartPair& parts = pair.touching;
  const bool has_parts = scene.body(body).shape.mesh().parts.size() > 1;
  if (pair.alone) {
    return has_parts;
  }
  return parts.b == body && body.role == Role::city && parts.part_b != Part::kNoParent && has_parts;
}

std::shared_ptr<const std::vector<Color>> contact_colors(ViewScene& scene, BodyRef body,
                                                         const TouchingPair& pair,
                                                         CityColors colors) {
  const auto& mesh = scene.body(body).shape.shared_mesh();
  const PartPair& parts = pair.touching;
  const bool is_a = parts.a == body;
  std::vector<Color> all;
  if (pair.alone) {
    all.assign(mesh->triangles.size(), body.role == Role::mover ? kPaleA : kPaleB);
  } else if (colors == CityColors::by_building) {
    all = *scene.mesh_facts().building_colors(mesh);
  } else {
    all.assign(mesh->triangles.size(), ViewColors{}.plain_city);
  }
  const std::uint32_t part = is_a ? parts.part_a : parts.part_b;
  if (part != Part::kNoParent && (is_a || parts.b == body)) {
    const Part& run = mesh->parts[part];
    std::fill_n(all.begin() + static_cast<std::ptrdiff_t>(run.first), run.count,
                is_a ? palette::kBodyA : palette::kOrange);
  }
  return std::make_shared<const std::vector<Color>>(std::move(all));
}

Color color_of_other(const ViewScene& scene, const TouchingPair& pair) {
  const BodyRef other = pair.touching.b;
  return other.role == Role::mover || has_contact_colors(scene, other, pair) ? palette::kOrange
                                                                             : palette::kBodyB;
}

void keep_contacts_of(const ViewScene& scene, const PartPair& pair, std::vector<Touch>& touches) {
  const PartsOf parts_a(scene.body(pair.a).shape.mesh());
  const PartsOf parts_b(scene.body(pair.b).shape.mesh());
  const auto is_other = [&](const Touch& touch) {
    return touch.a != pair.a || touch.b != pair.b || parts_a(touch.i) != pair.part_a ||
           parts_b(touch.j) != pair.part_b;
  };
  touches.erase(std::remove_if(touches.begin(), touches.end(), is_other), touches.end());
}

std::vector<Label> contact_names(const ViewScene& scene, const TouchingPair& pair) {
  const PartPair& parts = pair.touching;
  const Box whole_b = box_of_part(scene, parts.b, parts.part_b);
  const Box a = box_about(box_of_part(scene, parts.a, parts.part_a), pair.around);
  const Box b = box_about(whole_b, pair.around);
  std::vector<Label> names{name_at(scene, parts.a, parts.part_a, a, b)};
  // Of what is all around the contact, such as a street, the key has the name.
  if (diagonal(whole_b) < kAllAround * diagonal(pair.around)) {
    names.push_back(name_at(scene, parts.b, parts.part_b, b, a));
  }
  return names;
}

}  // namespace soms::view
