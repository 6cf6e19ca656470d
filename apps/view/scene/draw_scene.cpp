#include "apps/view/scene/draw_scene.h"

#include "soms/base/error.h"

#include "apps/cli/text.h"
#include "apps/view/drawing/contact_glow.h"
#include "apps/view/drawing/gap_marks.h"
#include "apps/view/drawing/length.h"
#include "apps/view/scene/contact_look.h"
#include "apps/view/scene/part_boxes.h"
#include "apps/view/scene/scene_key.h"
#include "apps/view/scene/shown_boxes.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace soms::view {

namespace {

/// Width of the curve where surfaces cross and of its rim on either side, in pixels.
constexpr float kCurve = 4;
constexpr float kCurveRim = 2;
/// Opacity of what surfaces hide of the curve, up to so many contacts: more would be a tangle.
constexpr std::uint8_t kHiddenCurve = 26;
constexpr std::size_t kMostHidden = 2000;
/// How far red reaches from a contact at most, in diagonals of the smaller of the parts that touch.
constexpr double kGlowMost = 0.09;
/// Contacts of a mover that are looked at for the place of its marker.
constexpr std::size_t kMostOfMarker = 64;
/// The ground is this part of the scene's diagonal below it, and this many times as wide.
constexpr double kGroundBelow = 2e-4;
constexpr double kGroundWidth = 2.5;
/// Where surfaces begin to be pale, in diagonals of what is looked at.
constexpr double kFocus = 2.5;
/// Opacity of the two nearest triangles: large ones shall not swamp what they belong to.
constexpr std::uint8_t kNearTint = 80;

/// One of four tints of a color, so that movers of one kind that touch are distinguished.
Color tint(Color color, std::uint32_t mover) {
  const int share = static_cast<int>((mover * 2654435761U >> 16U) % 4U) * 14;
  const auto lighter = [share](std::uint8_t c) {
    return static_cast<std::uint8_t>(c + (255 - c) * share / 100);
  };
  return {lighter(color.r), lighter(color.g), lighter(color.b), color.a};
}

/// Makes one draw list.
class Drawing {
 public:
  Drawing(ViewScene& scene, const ViewOptions& options) : scene_(scene), options_(options) {}

  DrawnScene draw() {
    scene_.set_trees(options_.trees);
    add_bodies();
    add_focus();
    add_ground();
    add_boxes();
    add_contacts();
    add_frame_gaps();
    add_nearest();
    list_.captions.key = scene_key(scene_, options_, counts_.gaps_drawn > 0 || nearest_drawn_);
    add_names();
    return {std::move(list_), counts_};
  }

 private:
  /// Index of a body's mesh in the list. A mesh of many bodies is named once.
  std::uint32_t mesh_of(const Body& body, bool by_building) {
    const auto& mesh = body.shape.shared_mesh();
    const auto [entry, added] = meshes_.try_emplace(
        std::pair(mesh.get(), by_building), static_cast<std::uint32_t>(list_.meshes.size()));
    if (added) {
      MeshFactsStore& facts = scene_.mesh_facts();
      DrawMesh drawn;
      drawn.key = 2 * facts.of(mesh).key + (by_building ? 1U : 0U);
      drawn.mesh = mesh;
      if (by_building) {
        drawn.colors = facts.building_colors(mesh);
      }
      list_.meshes.push_back(std::move(drawn));
    }
    return entry->second;
  }

  void add_body(BodyRef ref, Color color, SurfaceStyle style, bool by_building) {
    const Body& body = scene_.body(ref);
    if (body.shape.mesh().triangles.empty()) {
      return;
    }
    const bool beside = options_.touching && has_contact_colors(scene_, ref, *options_.touching);
    list_.instances.push_back({beside ? mesh_beside(ref) : mesh_of(body, by_building), body.pose,
                               color, style, options_.highlighted == ref});
  }

  /// A mesh in the colors of a picture of one contact.
  std::uint32_t mesh_beside(BodyRef ref) {
    const Body& body = scene_.body(ref);
    DrawMesh drawn;
    drawn.mesh = body.shape.shared_mesh();
    drawn.key = 2 * scene_.mesh_facts().of(drawn.mesh).key + 1 + (std::uint64_t{1} << 62U);
    drawn.colors = contact_colors(scene_, ref, *options_.touching, options_.city_colors);
    list_.meshes.push_back(std::move(drawn));
    return static_cast<std::uint32_t>(list_.meshes.size() - 1);
  }

  void add_bodies() {
    const bool by_building = options_.city_colors == CityColors::by_building;
    for (std::uint32_t k = 0; options_.city && k < scene_.city_parts(); ++k) {
      add_body(city_part(k), options_.colors.plain_city, options_.city_style, by_building);
    }
    const MoverKinds kinds(scene_);
    for (std::uint32_t k = 0; options_.movers && k < scene_.movers(); ++k) {
      const bool is_other = options_.touching && options_.touching->touching.b == mover(k);
      const bool is_first = options_.touching && options_.touching->touching.a == mover(k);
      add_body(mover(k),
               is_other   ? palette::kOrange
               : is_first ? palette::kBodyA
                          : tint(mover_color(kinds.of(k)), k),
               options_.mover_style, false);
    }
  }

  void add_boxes() {
    ShownBoxes boxes = shown_boxes(scene_, options_);
    counts_.boxes = boxes.boxes;
    for (BoxGroup& group : boxes.groups) {
      counts_.boxes_drawn += group.boxes.size();
      list_.box_groups.push_back(std::move(group));
    }
  }

  void add_mark(BodyRef body, TriangleId i, Color color, bool on_top) {
    list_.marks.push_back({scene_.triangle(body, i), color, on_top});
  }

  /// The triangles of the contacts that are drawn, each once.
  void add_triangles(const std::vector<Touch>& touches) {
    std::vector<std::pair<BodyRef, TriangleId>> touching;
    for (const Touch& touch : touches) {
      touching.emplace_back(touch.a, touch.i);
      touching.emplace_back(touch.b, touch.j);
    }
    std::sort(touching.begin(), touching.end());
    touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
    for (const auto& [body, i] : touching) {
      add_mark(body, i, options_.colors.contact, options_.contacts.on_top);
    }
  }

  /// The innermost parts that the contacts belong to. They are laid under the red triangles.
  void add_parts(const std::vector<Touch>& touches) {
    std::vector<std::pair<BodyRef, std::uint32_t>> parts;
    const auto note = [&](BodyRef body, TriangleId i) {
      const auto& mesh = scene_.body(body).shape.shared_mesh();
      const std::uint32_t part = scene_.mesh_facts().parts(mesh)[i];
      if (part != Part::kNoParent) {
        parts.emplace_back(body, part);
      }
    };
    for (const Touch& touch : touches) {
      note(touch.a, touch.i);
      note(touch.b, touch.j);
    }
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    std::size_t left = options_.contacts.most_of_parts;
    for (const auto& [body, number] : parts) {
      const Part& part = scene_.body(body).shape.mesh().parts[number];
      counts_.part_triangles += part.count;
      if (part.count > left) {
        continue;
      }
      left -= part.count;
      counts_.part_triangles_drawn += part.count;
      for (std::uint32_t k = 0; k < part.count; ++k) {
        add_mark(body, part.first + k, options_.colors.part, options_.contacts.on_top);
      }
    }
  }

  double part_diagonal(BodyRef body, TriangleId triangle) {
    return diagonal(part_boxes_(body, triangle));
  }

  void add_glow(const Touch& touch, const Vec3& a, const Vec3& b) {
    const double most =
        kGlowMost * std::min(part_diagonal(touch.a, touch.i), part_diagonal(touch.b, touch.j));
    if (counts_.contacts_drawn == counts_.contacts) {
      glow_.add(a, b, most);
      return;
    }
    const std::pair bodies(touch.a, touch.b);
    glow_.add(a, b, most, glow_groups_.try_emplace(bodies, glow_groups_.size()).first->second);
  }

  void add_curve(const Vec3& a, const Vec3& b, bool on_top) {
    const Color color = options_.colors.segment;
    curves_.push_back({.a = a,
                       .b = b,
                       .color = color,
                       .width = kCurve,
                       .on_top = on_top,
                       .rim = palette::kPaper,
                       .rim_width = kCurveRim});
  }

  /// All curves with their rims, then once more without: no rim covers a neighbor.
  void draw_curves() {
    const std::size_t pieces = curves_.size();
    list_.lines.insert(list_.lines.end(), curves_.begin(), curves_.end());
    for (Line line : curves_) {
      line.rim = with_alpha(line.color, 0);
      line.rim_width = 1.25F * kCurveRim;  // wider, so nearer than rims of neighbors
      list_.lines.push_back(line);
    }
    for (Line line : curves_) {
      if (pieces <= kMostHidden && !line.on_top) {
        line.color.a = kHiddenCurve;
        line.width = 0.5F * kCurve;
        line.rim_width = 0;
        line.on_top = true;
        list_.lines.push_back(line);
      }
    }
    curves_.clear();
  }

  void add_crossing(const Touch& touch, bool segments, bool glow, bool on_top) {
    const CommonPoints crossing = scene_.common_points(touch);
    const auto p = crossing.points();
    if (p.size() == 1 && segments) {
      list_.points.push_back({p[0], options_.colors.segment, 3 * kCurve, on_top, palette::kPaper});
    }
    for (std::size_t k = 0; k < (p.size() == 2 ? 1 : p.size()); ++k) {
      const Vec3& next = p[(k + 1) % p.size()];
      if (glow) {
        add_glow(touch, p[k], next);
      }
      if (segments && p.size() > 1) {
        add_curve(p[k], next, on_top);
      }
    }
    for (std::size_t k = 2; k < p.size() && segments; ++k) {
      list_.marks.push_back({{p[0], p[k - 1], p[k]}, options_.colors.contact, on_top});
    }
  }

  /// A line from the middle of the mover to what it touches.
  void add_line(const Touch& touch) {
    const CommonPoints crossing = scene_.common_points(touch);
    if (!crossing.empty()) {
      list_.lines.push_back({scene_.bounds(touch.a).center(), crossing.corners[0],
                             options_.colors.line, 1, options_.contacts.on_top});
    }
  }

  /// A marker for each touching mover, where it touches: a city shows from afar where it is hit.
  void add_markers() {
    std::map<std::uint32_t, std::pair<std::size_t, Box>> places;
    const auto note = [&](BodyRef body, const Touch& touch) {
      auto& [count, box] = places[body.index];
      if (body.role == Role::mover && ++count <= kMostOfMarker) {
        for (const Vec3& p : scene_.common_points(touch).points()) {
          box.grow(p);
        }
      }
    };
    for (const Touch& touch : scene_.contacts()) {
      note(touch.a, touch);
      if (touch.b.role == Role::mover) {
        note(touch.b, touch);
      }
    }
    for (const auto& [number, place] : places) {
      const Box& box = place.second;
      list_.markers.push_back({.at = box.center(),
                               .reach = 0.5 * diagonal(box),
                               .always = options_.contacts.all_markers,
                               .color = options_.colors.contact});
    }
  }

  void add_contacts() {
    const ContactMarks& marks = options_.contacts;
    std::vector<Touch> touches = drawn_contacts(scene_, marks.most);
    if (marks.glow || marks.triangles || marks.parts || marks.segments || marks.lines) {
      counts_.contacts = scene_.contacts().size();
      counts_.contacts_drawn = touches.size();
    }
    if (options_.touching && options_.touching->alone) {
      keep_contacts_of(scene_, options_.touching->touching, touches);
    }
    if (marks.parts) {
      add_parts(touches);
    }
    if (marks.triangles) {
      add_triangles(touches);
    }
    for (const Touch& touch : touches) {
      if (marks.segments || marks.glow) {
        add_crossing(touch, marks.segments, marks.glow, marks.on_top);
      }
      if (marks.lines) {
        add_line(touch);
      }
    }
    if (marks.markers && !(options_.touching && options_.touching->alone)) {
      add_markers();
    }
    if (options_.chosen) {
      add_chosen(*options_.chosen);
    }
    draw_curves();
    list_.glows = glow_.glows();
    list_.glow_color = options_.colors.contact;
  }

  /// The nearest first: of lengths that would cover each other theirs is written.
  void add_frame_gaps() {
    if (!options_.frame_gaps.shown) {
      return;
    }
    const std::vector<Gap>& gaps = scene_.frame_gaps();
    counts_.gaps = gaps.size();
    counts_.gaps_drawn = std::min(gaps.size(), options_.frame_gaps.most);
    for (std::size_t k = 0; k < counts_.gaps_drawn; ++k) {
      add_gap(list_, {.point_a = gaps[k].distance.point_a,
                      .point_b = gaps[k].distance.point_b,
                      .length = meters_in_text(gaps[k]),
                      .color = options_.colors.gap});
    }
  }

  /// True if the gap of these two is drawn as one of the frame.
  [[nodiscard]] bool is_drawn(const Gap& gap) const {
    const auto begin = scene_.frame_gaps().begin();
    return std::any_of(begin, begin + static_cast<std::ptrdiff_t>(counts_.gaps_drawn),
                       [&](const Gap& drawn) {
                         return std::minmax(drawn.a, drawn.b) == std::minmax(gap.a, gap.b);
                       });
  }

  [[nodiscard]] bool hidden(BodyRef body) const {
    return body.role == Role::city ? !options_.city : !options_.movers;
  }

  /// The gap of the pair, if it is known, and the two triangles that are nearest.
  void add_nearest() {
    static const std::optional<Gap> kNone;
    const std::optional<Gap>& gap = options_.gap ? scene_.gap() : kNone;
    if (gap && gap->known() && !hidden(gap->a) && !hidden(gap->b)) {
      nearest_drawn_ = true;
      const Distance& near = gap->distance;
      const Color tint = with_alpha(options_.colors.gap, kNearTint);
      for (const auto& [body, i] :
           {std::pair(gap->a, near.triangles->a), std::pair(gap->b, near.triangles->b)}) {
        add_mark(body, i, tint, false);
        const Triangle t = scene_.triangle(body, i);
        for (const auto& [from, to] :
             {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)}) {
          list_.lines.push_back({.a = from, .b = to, .color = options_.colors.gap});
        }
      }
      if (!is_drawn(*gap)) {
        add_gap(list_, {.point_a = near.point_a,
                        .point_b = near.point_b,
                        .length = options_.in_meters ? meters_in_text(*gap) : length_in_text(*gap),
                        .color = options_.colors.gap});
      }
    }
  }

  /// Its triangles' outlines, in another color than the contact: a wall's reach far off. Painted
  /// whole, it would cover all.
  void add_chosen(const Touch& touch) {
    for (const auto& [body, i] : {std::pair(touch.a, touch.i), std::pair(touch.b, touch.j)}) {
      const Triangle t = scene_.triangle(body, i);
      for (const auto& [from, to] :
           {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)}) {
        list_.lines.push_back({from, to, palette::kInk, 1, true, palette::kPaper, 1});
      }
    }
    add_crossing(touch, true, false, true);
  }

  void add_names() {
    if (options_.touching && options_.key) {
      const std::vector<Label> names = contact_names(scene_, *options_.touching);
      list_.labels.insert(list_.labels.end(), names.begin(), names.end());
    }
  }

  void add_focus() {
    if (options_.focus && !options_.focus->empty()) {
      list_.focus = Focus{options_.focus->center(), kFocus * diagonal(*options_.focus)};
    }
  }

  void add_ground() {
    const Box all = scene_.bounds();
    if (!options_.ground || all.empty()) {
      return;
    }
    const double whole = diagonal(all);
    const Vec3 center = all.center();
    list_.ground = Ground{{center.x, center.y, all.lower.z - kGroundBelow * whole},
                          kGroundWidth * whole,
                          palette::kGround};
  }

  ViewScene& scene_;
  const ViewOptions& options_;
  DrawList list_;
  ShownCounts counts_;
  std::map<std::pair<const Mesh*, bool>, std::uint32_t> meshes_;
  PartBoxes part_boxes_{scene_};
  ContactGlow glow_;
  std::map<std::pair<BodyRef, BodyRef>, std::size_t> glow_groups_;
  std::vector<Line> curves_;
  bool nearest_drawn_ = false;
};

}  // namespace

std::vector<Touch> drawn_contacts(const ViewScene& scene, std::size_t most) {
  const std::vector<Touch>& all = scene.contacts();
  if (all.size() <= most) {
    return all;
  }
  // Evenly over the sorted list, so that every place keeps some.
  std::vector<Touch> some;
  some.reserve(most);
  for (std::size_t k = 0; k < most; ++k) {
    some.push_back(all[k * all.size() / most]);
  }
  return some;
}

DrawnScene draw_scene(ViewScene& scene, const ViewOptions& options) {
  ViewOptions colored = options;
  colored.colors = colors_in(options);
  return Drawing(scene, colored).draw();
}

DrawList make_draw_list(ViewScene& scene, const ViewOptions& options) {
  return draw_scene(scene, options).list;
}

std::vector<std::string> left_out(const ShownCounts& counts) {
  std::vector<std::string> lines;
  const auto add = [&](std::uint64_t drawn, std::uint64_t all, const char* what) {
    if (drawn < all) {
      lines.push_back(command::with_commas(drawn) + " of " + command::with_commas(all) + what);
    }
  };
  add(counts.contacts_drawn, counts.contacts, " contacts");
  add(counts.gaps_drawn, counts.gaps, " gaps");
  add(counts.part_triangles_drawn, counts.part_triangles, " triangles of parts");
  add(counts.boxes_drawn, counts.boxes, " boxes");
  return lines;
}

}  // namespace soms::view
