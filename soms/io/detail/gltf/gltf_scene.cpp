#include "soms/io/detail/gltf/gltf_scene.h"

#include "soms/io/detail/json_numbers.h"
#include "soms/io/detail/left_out.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace soms::detail {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

template <std::size_t N>
std::array<double, N> numbers_or(const JsonValue& node, std::string_view key,
                                 const std::array<double, N>& otherwise) {
  const std::optional<JsonValue> list = node.find(key);
  return list ? json_numbers<N>(*list) : otherwise;
}

/// Scale, then rotation, then translation.
Affine placement_of(const JsonValue& node) {
  const auto t = numbers_or<3>(node, "translation", {0, 0, 0});
  const auto s = numbers_or<3>(node, "scale", {1, 1, 1});
  const auto [x, y, z, w] = numbers_or<4>(node, "rotation", {0, 0, 0, 1});
  const double n = ((w * w + x * x) + y * y) + z * z;
  constexpr double kRounding = 0.02;  // exporters that store few digits are off by less
  if (!(std::abs(n - 1) <= kRounding)) {
    node.at("rotation").fail("the quaternion does not have length 1");
  }
  const double q = 2 / n;
  return {{(1 - q * (y * y + z * z)) * s[0], q * (x * y - w * z) * s[1], q * (x * z + w * y) * s[2],
           t[0], q * (x * y + w * z) * s[0], (1 - q * (x * x + z * z)) * s[1],
           q * (y * z - w * x) * s[2], t[1], q * (x * z - w * y) * s[0], q * (y * z + w * x) * s[1],
           (1 - q * (x * x + y * y)) * s[2], t[2]}};
}

Affine local_of(const JsonValue& node) {
  const std::optional<JsonValue> matrix = node.find("matrix");
  if (!matrix) {
    return placement_of(node);
  }
  for (const char* const key : {"translation", "rotation", "scale"}) {
    if (node.find(key)) {
      node.fail("both a matrix and a " + std::string(key));
    }
  }
  return json_matrix(*matrix);
}

bool is_hidden(const JsonValue& node) {
  const std::optional<JsonValue> extensions = node.find("extensions");
  const std::optional<JsonValue> stated = extensions ? extensions->find(kVisibility) : std::nullopt;
  const std::optional<JsonValue> visible = stated ? stated->find("visible") : std::nullopt;
  return visible && !visible->boolean();
}

class NodePlacer {
 public:
  NodePlacer(Source& source, const JsonValue& root, std::vector<std::string>& notes)
      : source_(source), root_(root), notes_(notes), nodes_(root.find("nodes")) {}

  std::vector<PlacedNode> place();

 private:
  template <class T>
  void reserve(std::vector<T>& items, std::size_t count) {
    if (!source_.budget.take(count * sizeof(T))) {
      source_.fail_memory(count * sizeof(T));
    }
    items.reserve(count);
  }

  /// Number of a node that a list names.
  [[nodiscard]] std::uint32_t node_of(const JsonValue& reference) const {
    static_cast<void>(reference.referred("nodes"));
    return static_cast<std::uint32_t>(reference.whole());
  }

  void find_parents();
  [[nodiscard]] std::optional<JsonValue> scene();
  void begin_at(const JsonValue& roots);
  void begin_at_all();
  void note_unplaced();

  struct Open {
    std::uint32_t node = 0;
    std::uint32_t within = kNone;  ///< number of the placed node around it
  };

  Source& source_;
  JsonValue root_;
  std::vector<std::string>& notes_;
  std::optional<JsonValue> nodes_;
  std::vector<std::uint32_t> parents_;
  std::vector<std::uint8_t> is_placed_;
  std::vector<Open> open_;  ///< to be placed, the next one last
};

/// Nodes that have at most one parent each, and roots that have none, are trees: nothing that is
/// reached from a root goes in circles.
void NodePlacer::find_parents() {
  const std::size_t count = nodes_->size();
  if (count >= kNone) {
    nodes_->fail("too many nodes");
  }
  reserve(parents_, count);
  parents_.resize(count, kNone);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::optional<JsonValue> children = nodes_->at(i).find("children");
    for (std::size_t k = 0; children && k < children->size(); ++k) {
      const JsonValue reference = children->at(k);
      std::uint32_t& parent = parents_[node_of(reference)];
      if (parent != kNone) {
        reference.fail("nodes[" + std::to_string(reference.whole()) + "] is a child of nodes[" +
                       std::to_string(parent) + "] already");
      }
      parent = i;
    }
  }
}

std::optional<JsonValue> NodePlacer::scene() {
  const std::optional<JsonValue> stated = root_.find("scene");
  const std::optional<JsonValue> scenes = root_.find("scenes");
  const std::size_t count = scenes ? scenes->size() : 0;
  if (!stated && count == 0) {
    notes_.emplace_back("the file has no scene: all nodes were read");
    return std::nullopt;
  }
  const JsonValue scene = stated ? stated->referred("scenes") : scenes->at(std::size_t{0});
  if (count > 1) {
    notes_.push_back(
        "the file has " + std::to_string(count) + " scenes; only scene " +
        std::to_string(stated ? stated->whole() : 0) +
        (stated ? ", the default, was read" : " was read, because none is the default"));
  }
  return scene;
}

void NodePlacer::begin_at(const JsonValue& roots) {
  reserve(open_, parents_.size());
  for (std::size_t i = roots.size(); i-- > 0;) {
    const JsonValue reference = roots.at(i);
    std::uint32_t& parent = parents_[node_of(reference)];
    if (parent != kNone) {
      reference.fail(
          "nodes[" + std::to_string(reference.whole()) +
          "] is a child of another node or listed twice; a scene lists each of its roots once");
    }
    parent = static_cast<std::uint32_t>(reference.whole());
    open_.push_back({parent, kNone});
  }
}

void NodePlacer::begin_at_all() {
  reserve(open_, parents_.size());
  for (auto i = static_cast<std::uint32_t>(parents_.size()); i-- > 0;) {
    if (parents_[i] == kNone) {
      open_.push_back({i, kNone});
    }
  }
}

/// A mesh that the scene shows may have other places, in which it does not.
void NodePlacer::note_unplaced() {
  LeftOut unplaced;
  for (std::uint32_t i = 0; i < is_placed_.size(); ++i) {
    if (is_placed_[i] == 0 && nodes_->at(i).find("mesh")) {
      unplaced.add([&] { return "at nodes[" + std::to_string(i) + "]"; });
    }
  }
  add_note(notes_, unplaced, "nodes with a mesh that are not in the scene");
}

std::vector<PlacedNode> NodePlacer::place() {
  if (nodes_) {
    find_parents();
  }
  const std::optional<JsonValue> shown = scene();
  if (shown && shown->find("nodes")) {
    begin_at(shown->at("nodes"));
  } else if (!shown) {
    begin_at_all();
  }
  std::vector<PlacedNode> placed;
  reserve(placed, parents_.size());
  reserve(is_placed_, parents_.size());
  is_placed_.resize(parents_.size(), 0);
  while (!open_.empty()) {
    if (placed.size() % kRowsPerTick == 0) {
      check(source_.limits);
    }
    const auto [number, within] = open_.back();
    open_.pop_back();
    is_placed_[number] = 1;
    const JsonValue node = nodes_->at(number);
    const Affine local = local_of(node);
    const auto here = static_cast<std::uint32_t>(placed.size());
    if (within == kNone) {
      placed.push_back({node, 0, local, is_hidden(node)});
    } else {
      const PlacedNode& outer = placed[within];
      placed.push_back(
          {node, outer.depth + 1, outer.world * local, outer.hidden || is_hidden(node)});
    }
    const std::optional<JsonValue> children = node.find("children");
    for (std::size_t k = children ? children->size() : 0; k-- > 0;) {
      open_.push_back({static_cast<std::uint32_t>(children->at(k).whole()), here});
    }
  }
  if (!shown && placed.size() < parents_.size()) {
    nodes_->fail("some nodes form a cycle");
  }
  note_unplaced();
  return placed;
}

}  // namespace

std::vector<PlacedNode> place_nodes(Source& source, const JsonValue& root,
                                    std::vector<std::string>& notes) {
  return NodePlacer(source, root, notes).place();
}

}  // namespace soms::detail
