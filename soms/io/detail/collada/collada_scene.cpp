#include "soms/io/detail/collada/collada_scene.h"

#include "soms/io/detail/collada/collada_geometry.h"
#include "soms/io/detail/collada/collada_transform.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace soms::detail {

namespace {

/// Elements of a scene that are looked at, beyond those of the file and those that may come with
/// each triangle: a chain of n nodes that each name the next twice shows 2^n, of nothing perhaps.
constexpr std::uint64_t kMostElements = std::uint64_t{1} << 20;
constexpr std::uint64_t kElementsPerTriangle = 64;
/// Of what a node takes while it is open.
constexpr std::uint64_t kBytesOfSetEntry = 64;

/// What is counted and reported in the notes of the mesh.
struct Unreported {
  ColladaLeftOut lines;
  ColladaLeftOut curved;
  ColladaLeftOut thin;
  ColladaLeftOut unknown;
  ColladaLeftOut surplus;
  ColladaLeftOut skins;
  ColladaLeftOut morphs;
  ColladaLeftOut assets;  ///< with a unit or an up axis
};

/// A node whose children are looked at.
struct Frame {
  pugi::xml_node node;
  pugi::xml_node next;  ///< child to be looked at next
  Affine transform;     ///< from the node to the scene
  bool opens_part = false;
  bool several = false;  ///< it shows more than one geometry
};

/// Nodes nest and name each other: one stack, no recursion, whatever the file nests.
class SceneReader {
 public:
  SceneReader(ColladaDocument& document, MeshBuilder& builder)
      : document_(document), builder_(builder) {}

  void show_scene(pugi::xml_node scene);
  void show_all_geometries();
  void write_notes();

 private:
  void enter(pugi::xml_node node);
  void leave();
  void look_at(pugi::xml_node element);
  void show_controller(pugi::xml_node instance);
  [[nodiscard]] pugi::xml_node morph_of(pugi::xml_node controller);
  void show(pugi::xml_node element, const Affine& transform, pugi::xml_node instance);
  [[nodiscard]] const ColladaGeometry& geometry_of(pugi::xml_node element);
  void count_element(pugi::xml_node element);
  void note_asset(pugi::xml_node owner);

  ColladaDocument& document_;
  MeshBuilder& builder_;
  std::vector<Frame> stack_;
  std::set<const void*> open_;  ///< the nodes on the stack
  std::map<const void*, ColladaGeometry> geometries_;
  Unreported unreported_;
  std::uint64_t elements_ = 0;
};

/// Elements of a node or a scene that are read elsewhere, or show no surface.
bool is_known_in_node(std::string_view name) {
  constexpr std::array<std::string_view, 11> kKnown = {
      "asset",  "extra", "evaluate_scene", "instance_camera", "instance_light", "lookat", "matrix",
      "rotate", "scale", "skew",           "translate"};
  return std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end();
}

bool shows_several(pugi::xml_node node) {
  std::size_t shown = 0;
  for (const pugi::xml_node child : node.children()) {
    const std::string_view name = child.name();
    if (name == "instance_geometry" || name == "instance_controller") {
      ++shown;
    }
  }
  return shown > 1;
}

std::uint64_t faces_with_triangles(const MeshView& mesh) {
  std::uint64_t count = mesh.triangles.empty() ? 0 : 1;
  for (std::size_t i = 1; i < mesh.triangles.size(); ++i) {
    if (mesh.faces.empty() || mesh.faces[i] != mesh.faces[i - 1]) {
      ++count;
    }
  }
  return count;
}

/// As how many elements one counts: long attributes and texts, and very many of them or of
/// children, take time again each time that the element is shown.
std::uint64_t weight_of(pugi::xml_node element) {
  constexpr std::uint64_t kBytesPerElement = 64;
  constexpr std::uint64_t kBytesPerItem = 16;
  std::uint64_t bytes = 0;
  for (const pugi::xml_attribute attribute : element.attributes()) {
    bytes += kBytesPerItem + std::strlen(attribute.name()) + std::strlen(attribute.value());
  }
  for (const pugi::xml_node child : element.children()) {
    bytes += kBytesPerItem + std::strlen(child.name()) + std::strlen(child.value());
  }
  return 1 + bytes / kBytesPerElement;
}

void SceneReader::count_element(pugi::xml_node element) {
  const std::uint64_t before = elements_;
  elements_ += weight_of(element);
  if (elements_ / kRowsPerTick != before / kRowsPerTick) {
    document_.tick(element);
  }
  // The elements of a file, however they count, are fewer than its bytes.
  if (elements_ > document_.source().bytes.size() + kMostElements +
                      kElementsPerTriangle * builder_.triangle_count()) {
    document_.fail(element, "the scene is too large: nodes are instantiated too many times",
                   "export it without <instance_node>, or split it", ErrorKind::out_of_range);
  }
}

void SceneReader::note_asset(pugi::xml_node owner) {
  const pugi::xml_node asset = owner.child("asset");
  if (asset.child("unit") || asset.child("up_axis")) {
    unreported_.assets.add(asset);
  }
}

void SceneReader::enter(pugi::xml_node node) {
  if (!open_.insert(node.internal_object()).second) {
    document_.fail(node, describe(node) + " contains itself, through <instance_node>");
  }
  document_.take(2 * sizeof(Frame) + kBytesOfSetEntry);
  note_asset(node);
  Frame frame;
  frame.node = node;
  frame.next = node.first_child();
  frame.transform = read_transforms(document_, node);
  frame.several = shows_several(node);
  if (!stack_.empty()) {
    frame.transform = stack_.back().transform * frame.transform;
    const std::string_view name = label_of(node);
    if (!name.empty()) {
      builder_.open_part(name);
      frame.opens_part = true;
    }
  }
  stack_.push_back(frame);
}

void SceneReader::leave() {
  const Frame& frame = stack_.back();
  if (frame.opens_part) {
    builder_.close_part();
  }
  open_.erase(frame.node.internal_object());
  document_.source().budget.give_back(2 * sizeof(Frame) + kBytesOfSetEntry);
  stack_.pop_back();
}

const ColladaGeometry& SceneReader::geometry_of(pugi::xml_node element) {
  const auto found = geometries_.find(element.internal_object());
  if (found != geometries_.end()) {
    return found->second;
  }
  document_.take(2 * sizeof(ColladaGeometry));
  note_asset(element);
  ColladaGeometry geometry = read_geometry(document_, element);
  unreported_.lines.add(geometry.lines);
  unreported_.curved.add(geometry.curved);
  unreported_.unknown.add(geometry.unknown);
  unreported_.surplus.add(geometry.surplus);
  unreported_.thin.add(element, geometry.faces - faces_with_triangles(geometry.mesh));
  return geometries_.emplace(element.internal_object(), std::move(geometry)).first->second;
}

void SceneReader::show(pugi::xml_node element, const Affine& transform, pugi::xml_node instance) {
  count_element(element);
  const ColladaGeometry& geometry = geometry_of(element);
  // One part a node is enough, unless it has no name or shows several geometries.
  const bool named = !label_of(element).empty() &&
                     (stack_.empty() || stack_.back().several || !stack_.back().opens_part);
  if (named) {
    builder_.open_part(label_of(element));
  }
  const auto first = static_cast<std::uint32_t>(builder_.vertices().size());
  const bool moved = transform != Affine{};
  for (const Vec3& stored : geometry.mesh.vertices) {
    const Vec3 v = moved ? transform.apply(stored) : stored;
    if (!fit_for_mesh(v)) {
      const CoordinateFault fault = describe_fault(v);
      document_.fail(instance, describe(element) + " under its transforms: " + fault.what,
                     fault.remedy, fault.kind);
    }
    builder_.add_vertex(v);
  }
  builder_.add_instance(geometry.mesh, first, geometry.faces, transform.mirrors());
  if (named) {
    builder_.close_part();
  }
}

/// The morph of a controller, which is shown in its base shape.
pugi::xml_node SceneReader::morph_of(pugi::xml_node controller) {
  const pugi::xml_node morph = controller.child("morph");
  if (!morph) {
    document_.fail(controller, describe(controller) + " is not a morph");
  }
  unreported_.morphs.add(morph);
  count_element(morph);
  return morph;
}

/// A skin in the shape that it was bound in, which stands in the scene's axes whatever the node's
/// transforms are; a morph in its base shape. A skin may be that of a morph.
void SceneReader::show_controller(pugi::xml_node instance) {
  const pugi::xml_node controller = document_.referred(instance, "url", "controller");
  count_element(controller);
  if (const pugi::xml_node skin = controller.child("skin")) {
    unreported_.skins.add(skin);
    count_element(skin);
    Affine bound;
    if (const pugi::xml_node matrix = skin.child("bind_shape_matrix")) {
      count_element(matrix);
      bound = read_matrix(document_, matrix);
    }
    pugi::xml_node owner = skin;
    if (!document_.refers_to(skin, "source", "geometry") &&
        document_.refers_to(skin, "source", "controller")) {
      const pugi::xml_node base = document_.referred(skin, "source", "controller");
      count_element(base);
      owner = morph_of(base);
    }
    show(document_.referred(owner, "source", "geometry"), bound, instance);
    return;
  }
  if (!controller.child("morph")) {
    document_.fail(controller, describe(controller) + " is neither a skin nor a morph");
  }
  show(document_.referred(morph_of(controller), "source", "geometry"), stack_.back().transform,
       instance);
}

void SceneReader::look_at(pugi::xml_node element) {
  count_element(element);
  const std::string_view name = element.name();
  if (name == "node") {
    enter(element);
  } else if (name == "instance_node") {
    const pugi::xml_node node = document_.referred(element, "url", "node");
    count_element(node);
    enter(node);
  } else if (name == "instance_geometry") {
    show(document_.referred(element, "url", "geometry"), stack_.back().transform, element);
  } else if (name == "instance_controller") {
    show_controller(element);
  } else if (element.type() == pugi::node_element && !is_known_in_node(name)) {
    unreported_.unknown.add(element);
  }
}

void SceneReader::show_scene(pugi::xml_node scene) {
  enter(scene);
  while (!stack_.empty()) {
    Frame& frame = stack_.back();
    if (!frame.next) {
      leave();
      continue;
    }
    const pugi::xml_node element = std::exchange(frame.next, frame.next.next_sibling());
    look_at(element);
  }
}

/// A file without a scene is a library: each geometry once, where it is stored.
void SceneReader::show_all_geometries() {
  builder_.note("the file has no scene: every geometry is read once");
  for (const pugi::xml_node library : document_.root().children("library_geometries")) {
    for (const pugi::xml_node geometry : library.children("geometry")) {
      show(geometry, Affine{}, geometry);
    }
  }
}

void SceneReader::write_notes() {
  ColladaLeftOut unseen;
  document_.for_each("geometry", [&](pugi::xml_node geometry) {
    if (geometries_.count(geometry.internal_object()) == 0) {
      unseen.add(geometry);
    }
  });
  ColladaLeftOut animations;
  for (const pugi::xml_node library : document_.root().children("library_animations")) {
    for (const pugi::xml_node animation : library.children("animation")) {
      animations.add(animation);
    }
  }
  const auto tell = [&](const ColladaLeftOut& left_out, std::string_view what) {
    builder_.note(left_out.in_line(document_), what);
  };
  tell(unreported_.thin, kThinFaces);
  tell(unreported_.lines, "lines, which are not triangles");
  tell(unreported_.curved, "splines, curved surfaces and hulls, not read");
  builder_.note(unreported_.unknown.by_name(document_), "unknown elements, not read");
  tell(unreported_.surplus, "surplus numbers after the last position");
  tell(unreported_.skins, "skins read in their bind shape, not posed");
  tell(unreported_.morphs, "morphs read in their base shape");
  tell(unseen, "geometries that are not in the scene");
  tell(unreported_.assets, "units and up axes of parts of the file, not applied");
  tell(animations, "animations, not applied");
}

}  // namespace

void show_scene(ColladaDocument& document, pugi::xml_node scene, MeshBuilder& builder) {
  SceneReader reader(document, builder);
  if (scene) {
    reader.show_scene(scene);
  } else {
    reader.show_all_geometries();
  }
  reader.write_notes();
}

}  // namespace soms::detail
