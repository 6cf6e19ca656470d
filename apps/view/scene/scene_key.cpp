#include "apps/view/scene/scene_key.h"

#include "soms/base/text.h"

#include "apps/view/scene/contact_look.h"

#include <map>
#include <utility>

namespace soms::view {

namespace {

/// Kinds of movers and bodies at rest that the key names.
constexpr std::size_t kMostNames = 4;
constexpr std::size_t kMostOfCity = 2;

/// One picture's key.
class KeyWriter {
 public:
  KeyWriter(const ViewScene& scene, const ViewOptions& options)
      : scene_(scene), options_(options) {}

  std::vector<KeyEntry> write(bool nearest) {
    if (options_.touching) {
      add_touching(*options_.touching);
    }
    if (!options_.touching || !options_.touching->alone) {
      add_movers();
      add_city();
    }
    add_boxes();
    if (nearest) {
      add(KeySign::area, options_.colors.gap, "nearest points");
    }
    if (!scene_.contacts().empty()) {
      add(KeySign::curve, options_.colors.contact,
          options_.trace && options_.trace->found ? "surfaces that touch" : "contact");
      add(KeySign::marker, options_.colors.contact, "n movers in contact");
    }
    return std::move(key_);
  }

 private:
  void add(KeySign sign, Color color, const std::string& text) {
    color.a = 255;
    key_.push_back({sign, color, text});
  }

  void add_touching(const TouchingPair& pair) {
    const PartPair& parts = pair.touching;
    add(KeySign::area, palette::kBodyA, name_of_part(scene_, parts.a, parts.part_a));
    add(KeySign::area, color_of_other(scene_, pair), name_of_part(scene_, parts.b, parts.part_b));
  }

  /// True for a mover that the contact's entries have named.
  [[nodiscard]] bool is_named(std::uint32_t k) const {
    return options_.touching &&
           (options_.touching->touching.a == mover(k) || options_.touching->touching.b == mover(k));
  }

  void add_movers() {
    const MoverKinds kinds(scene_);
    std::map<std::size_t, KeyEntry> entries;
    for (std::uint32_t k = 0; options_.movers && k < scene_.movers(); ++k) {
      const Body& body = scene_.body(mover(k));
      if (is_named(k) || body.shape.mesh().triangles.empty()) {
        continue;
      }
      const std::size_t kind = kinds.of(k);
      KeyEntry& entry = entries[kind];
      if (entry.text.empty()) {
        entry.color = mover_color(kind);
        entry.text = body.name.empty() ? std::string("moves") : printable(body.name);
      }
      entry.places.push_back(scene_.bounds(mover(k)).center());
    }
    for (auto& [kind, entry] : entries) {
      if (kind < kMostNames) {
        key_.push_back(std::move(entry));
      }
    }
  }

  void add_city() {
    if (!options_.city || scene_.city_parts() == 0) {
      return;
    }
    const bool is_other = options_.touching && options_.touching->touching.b == city_part(0) &&
                          options_.touching->touching.part_b == Part::kNoParent;
    if (is_other && scene_.city_parts() == 1) {
      return;
    }
    std::string names;
    for (std::uint32_t k = 0; k < scene_.city_parts() && k < kMostOfCity; ++k) {
      names += (k > 0 ? ", " : "") + printable(scene_.body(city_part(k)).name);
    }
    const bool all = scene_.city_parts() <= kMostOfCity && !names.empty();
    add(KeySign::area, palette::kBodyB, all ? names : "at rest");
  }

  void add_boxes() {
    if (options_.level) {
      add(KeySign::area, options_.colors.level,
          "boxes of level " + std::to_string(options_.level->level));
    }
    if (options_.trace && options_.trace->visited) {
      add(KeySign::area, options_.colors.visited, "boxes visited");
    }
    if (options_.trace && options_.trace->pruned) {
      add(KeySign::area, options_.colors.pruned, "boxes pruned");
    }
    if (options_.trace && options_.trace->found) {
      add(KeySign::area, options_.colors.found, "boxes that collide");
    }
  }

  const ViewScene& scene_;
  const ViewOptions& options_;
  std::vector<KeyEntry> key_;
};

}  // namespace

MoverKinds::MoverKinds(const ViewScene& scene) {
  std::map<const Mesh*, std::size_t> kinds;
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    const Mesh* const mesh = scene.body(mover(k)).shape.shared_mesh().get();
    kinds_.push_back(kinds.try_emplace(mesh, kinds.size()).first->second);
  }
  count_ = kinds.size();
}

std::vector<KeyEntry> scene_key(const ViewScene& scene, const ViewOptions& options, bool nearest) {
  return options.key ? KeyWriter(scene, options).write(nearest) : std::vector<KeyEntry>{};
}

}  // namespace soms::view
