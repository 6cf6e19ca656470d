#include "soms/io/detail/gltf/gltf.h"

#include "soms/io/detail/cityjson/cityjson.h"
#include "soms/io/detail/gltf/glb_chunks.h"
#include "soms/io/detail/gltf/gltf_accessor.h"
#include "soms/io/detail/gltf/gltf_buffers.h"
#include "soms/io/detail/gltf/gltf_corners.h"
#include "soms/io/detail/gltf/gltf_features.h"
#include "soms/io/detail/gltf/gltf_frame.h"
#include "soms/io/detail/gltf/gltf_meshes.h"
#include "soms/io/detail/gltf/gltf_scene.h"
#include "soms/io/detail/json_document.h"
#include "soms/io/detail/json_numbers.h"
#include "soms/io/detail/left_out.h"
#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/text.h"
#include "soms/io/detail/tiles/tileset.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

/// True for extensions that are read, or that change nothing that is.
bool is_harmless(std::string_view extension) {
  constexpr std::array<std::string_view, 9> kParts = {"KHR_mesh_quantization",
                                                      kVisibility,
                                                      "_materials_",
                                                      "_texture_",
                                                      "_lights_",
                                                      "_techniques_",
                                                      "EXT_mesh_features",
                                                      "EXT_structural_metadata",
                                                      "CESIUM_primitive_outline"};
  return std::any_of(kParts.begin(), kParts.end(), [&](std::string_view part) {
    return extension.find(part) != std::string_view::npos;
  });
}

/// True if a list of texts has this one.
bool lists(const JsonValue& root, std::string_view list, std::string_view wanted) {
  const std::optional<JsonValue> names = root.find(list);
  for (std::size_t i = 0; names && i < names->size(); ++i) {
    if (names->at(i).text() == wanted) {
      return true;
    }
  }
  return false;
}

/// Later versions 2.x can be read as 2.0 unless they say that they cannot.
void check_version(const JsonValue& root) {
  const JsonValue asset = root.at("asset");
  const JsonValue version = asset.at("version");
  const std::optional<JsonValue> least = asset.find("minVersion");
  if (!version.text().starts_with("2.") || (least && least->text() != "2.0")) {
    const JsonValue wrong = least ? *least : version;
    wrong.fail(ErrorKind::unsupported,
               "version " + in_quotes(wrong.text()) + " is not read, only 2.0",
               "save the model as glTF 2.0");
  }
}

constexpr std::string_view kCenter = "CESIUM_RTC";

/// What a document states as the center of its coordinates.
std::optional<JsonValue> center_of(const JsonValue& root) {
  const std::optional<JsonValue> extensions = root.find("extensions");
  return extensions ? extensions->find(kCenter) : std::nullopt;
}

void check_extensions(const JsonValue& root, bool in_tile) {
  const std::optional<JsonValue> required = root.find("extensionsRequired");
  for (std::size_t i = 0; required && i < required->size(); ++i) {
    const std::string_view name = required->at(i).text();
    if (!is_harmless(name) && !(in_tile && name == kCenter)) {
      refuse_required_extension(required->at(i), name);
    }
  }
  if (!in_tile && center_of(root)) {
    refuse_extension(root.at("extensions"), kCenter);
  }
}

/// From the axes of a glTF in a tile to those of the mesh.
Affine frame_of(const JsonValue& root, const GltfTile& tile) {
  Affine frame = tile.frame;
  if (const std::optional<JsonValue> stated = center_of(root)) {
    const auto [x, y, z] = json_numbers<3>(stated->at("center"));
    frame = frame * Affine{{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z}};
  }
  return tile.turned ? frame * Affine{{1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0}} : frame;
}

class GltfReader {
 public:
  /// `notes`: what was left out around the document; `tile`: null for a document of its own.
  GltfReader(Source& source, const JsonDocument& document, std::optional<std::string_view> chunk,
             std::vector<std::string> notes, const GltfTile* tile)
      : source_(source),
        root_(document.root()),
        buffers_(source, chunk),
        accessors_(source, buffers_,
                   lists(root_, "extensionsUsed", "KHR_mesh_quantization") ||
                       lists(root_, "extensionsRequired", "KHR_mesh_quantization")),
        meshes_(source, accessors_),
        builder_(source),
        features_(source, root_, buffers_, accessors_, tile != nullptr ? tile->batches : nullptr,
                  builder_),
        tile_(tile),
        notes_(std::move(notes)) {}

  Mesh read();

 private:
  /// The mesh of a node, if it has one.
  [[nodiscard]] const GltfMesh* mesh_of(const PlacedNode& node);
  void reserve(const std::vector<PlacedNode>& nodes);
  [[nodiscard]] bool add_node(const PlacedNode& node);
  void add_positions(const GltfAccessor& accessor, const PlacedNode& node, const Affine& world);
  void add_triangles(const GltfPrimitive& primitive, const GltfMesh& mesh, std::uint32_t first,
                     bool turned);
  void tick(std::uint64_t items);
  void add_notes();

  Source& source_;
  JsonValue root_;
  GltfBuffers buffers_;
  GltfAccessors accessors_;
  GltfMeshes meshes_;
  MeshBuilder builder_;
  GltfFeatures features_;
  const GltfTile* tile_;
  Affine frame_;                      ///< of the tile
  std::vector<std::uint32_t> first_;  ///< vertices of a mesh's positions, for one node
  std::uint64_t items_ = 0;           ///< vertices and triangles of the whole scene
  std::uint64_t done_ = 0;
  LeftOut skinned_;
  LeftOut hidden_;
  std::vector<std::string> notes_;
};

void GltfReader::tick(std::uint64_t items) {
  done_ += items;
  const double share = static_cast<double>(done_) / static_cast<double>(items_);
  source_.tick(static_cast<std::size_t>(share * static_cast<double>(source_.bytes.size())));
}

const GltfMesh* GltfReader::mesh_of(const PlacedNode& node) {
  const std::optional<JsonValue> reference = node.json.find("mesh");
  return reference ? &meshes_.mesh(*reference) : nullptr;
}

/// Room for all instances, which costs nothing where it is not there: before one is read.
void GltfReader::reserve(const std::vector<PlacedNode>& nodes) {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  for (const PlacedNode& node : nodes) {
    const GltfMesh* const mesh = mesh_of(node);
    if (mesh == nullptr) {
      continue;
    }
    const std::optional<JsonValue> extensions = node.json.find("extensions");
    if (extensions && extensions->find("EXT_mesh_gpu_instancing")) {
      refuse_extension(node.json, "EXT_mesh_gpu_instancing");
    }
    if (node.hidden) {
      hidden_.add([&] { return "in " + node.json.path(); });
    }
    if (node.json.find("skin")) {
      skinned_.add([&] { return "in " + node.json.path(); });
    }
    vertices += mesh->vertices;
    triangles += mesh->triangles;
    if (vertices > kMaxPrimitives || triangles > kMaxPrimitives) {
      node.json.fail(ErrorKind::out_of_range,
                     "with this node, more than 2^31 - 1 vertices or triangles", "split the model");
    }
  }
  builder_.reserve_vertices(vertices);
  builder_.reserve_triangles(triangles);
  items_ = vertices + triangles;
}

void GltfReader::add_positions(const GltfAccessor& accessor, const PlacedNode& node,
                               const Affine& world) {
  const bool moves = world != Affine{};
  GltfCursor cursor(accessor);
  for (std::uint64_t i = 0; i < accessor.count; ++i) {
    if (i % kRowsPerTick == 0) {
      tick(std::min<std::uint64_t>(kRowsPerTick, accessor.count - i));
    }
    const Vec3 stored = gltf_vector(cursor.next(), accessor);
    if (!fit_for_mesh(stored)) [[unlikely]] {
      const CoordinateFault fault = describe_fault(stored);
      accessor.json.fail(fault.kind, "element " + std::to_string(i) + ": " + fault.what,
                         fault.remedy);
    }
    const Vec3 v = moves ? world.apply(stored) : stored;
    if (!fit_for_mesh(v)) [[unlikely]] {
      const CoordinateFault fault = describe_fault(v);
      node.json.fail(fault.kind,
                     "element " + std::to_string(i) + " of " + accessor.json.path() +
                         ", placed by this node: " + fault.what,
                     "repair the transforms of the nodes");
    }
    builder_.add_vertex(v);
  }
}

void GltfReader::add_triangles(const GltfPrimitive& primitive, const GltfMesh& mesh,
                               std::uint32_t first, bool turned) {
  const std::uint64_t positions = mesh.positions[primitive.positions]->count;
  GltfCorners corners(primitive, positions, first);
  features_.begin(primitive.json, positions);
  std::array<std::uint32_t, 3> last{};
  for (std::uint64_t i = 0; i < primitive.triangles; ++i) {
    if (i % kRowsPerTick == 0) {
      tick(std::min<std::uint64_t>(kRowsPerTick, primitive.triangles - i));
    }
    if (i == 0 || primitive.mode == GltfMode::triangles) {
      last = {corners.next(), corners.next(), corners.next()};
    } else {
      // The corners of the file in their order: a strip drops its oldest, a fan keeps its first.
      last = {primitive.mode == GltfMode::fan ? last[0] : last[1], last[2], corners.next()};
    }
    features_.enter(last[0] - first, last[1] - first, last[2] - first);
    const bool odd = primitive.mode == GltfMode::strip && i % 2 == 1;
    if (odd != turned) {
      builder_.add_triangle(last[0], last[2], last[1]);
    } else {
      builder_.add_triangle(last[0], last[1], last[2]);
    }
  }
  features_.end();
}

/// Opens the node's part and says so. A node with neither name nor mesh is none, nor is one whose
/// mesh is of features: these are parts.
bool GltfReader::add_node(const PlacedNode& node) {
  const GltfMesh* const mesh = mesh_of(node);
  std::optional<JsonValue> name = node.json.find("name");
  if (!name && mesh != nullptr) {
    name = node.json.at("mesh").referred("meshes").find("name");
  }
  const bool all_features =
      mesh != nullptr && !mesh->primitives.empty() &&
      std::all_of(mesh->primitives.begin(), mesh->primitives.end(),
                  [&](const GltfPrimitive& p) { return features_.has(p.json); });
  const bool is_part = !all_features && (name || mesh != nullptr);
  if (is_part) {
    builder_.open_part(name ? name->text() : std::string_view());
  }
  if (mesh == nullptr) {
    return is_part;
  }
  // The joints alone place a skin: glTF has its node's transform ignored.
  const Affine local = node.json.find("skin") ? Affine{} : node.world;
  const Affine world = tile_ != nullptr ? frame_ * local : local;
  first_.clear();
  for (const GltfAccessor* const positions : mesh->positions) {
    first_.push_back(static_cast<std::uint32_t>(builder_.vertices().size()));
    add_positions(*positions, node, world);
  }
  const bool turned = world.mirrors();
  for (const GltfPrimitive& primitive : mesh->primitives) {
    add_triangles(primitive, *mesh, first_[primitive.positions], turned);
  }
  return is_part;
}

void GltfReader::add_notes() {
  const auto length_of = [&](std::string_view list) {
    const std::optional<JsonValue> items = root_.find(list);
    return items ? items->size() : std::size_t{0};
  };
  LeftOut unused;
  const std::size_t meshes = length_of("meshes");
  std::size_t first = 0;
  while (first < meshes && meshes_.has(first)) {
    ++first;
  }
  unused.add([&] { return "at meshes[" + std::to_string(first) + "]"; }, meshes - meshes_.count());
  meshes_.add_notes(notes_);
  features_.add_notes(notes_);
  for (std::string& text : notes_) {
    builder_.note(std::move(text));
  }
  builder_.note(unused, "meshes that no node of the scene uses");
  builder_.note(skinned_, "skins read in their bind shape, not posed by their joints");
  builder_.note(hidden_,
                "nodes with a mesh that the file hides (KHR_node_visibility), read all the same");
  builder_.note(buffers_.surplus(), "surplus bytes after the stated length of a buffer");
  LeftOut animations;
  animations.add([] { return "at animations[0]"; }, length_of("animations"));
  builder_.note(animations, "animations, not applied");
}

Mesh GltfReader::read() {
  check_version(root_);
  check_extensions(root_, tile_ != nullptr);
  frame_ = tile_ != nullptr ? frame_of(root_, *tile_) : Affine{};
  const std::vector<PlacedNode> nodes = place_nodes(source_, root_, notes_);
  reserve(nodes);
  std::vector<bool> is_part;  // of the nodes that are open
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i % kRowsPerTick == 0) {
      check(source_.limits);
    }
    for (; is_part.size() > nodes[i].depth; is_part.pop_back()) {
      if (is_part.back()) {
        builder_.close_part();
      }
    }
    is_part.push_back(add_node(nodes[i]));
  }
  add_notes();
  Mesh mesh = builder_.finish();
  // One part without a name says nothing.
  if (mesh.parts.size() == 1 && mesh.parts.front().name.empty()) {
    mesh.parts.clear();
  }
  if (tile_ == nullptr) {
    read_gltf_frame(root_, mesh);
  }
  return mesh;
}

Mesh read_binary_gltf(Source& source, std::size_t begin, std::size_t end, const GltfTile* tile) {
  const GlbChunks chunks = glb_chunks(source, begin, end);
  const JsonDocument document(source, chunks.json, chunks.json_at, true);
  std::vector<std::string> notes;
  add_note(notes, chunks.others, "chunks other than JSON and BIN, not read");
  // A tile fills what is in it up to a multiple of eight bytes.
  constexpr std::uint64_t kMostPadding = 7;
  if (tile == nullptr || chunks.surplus.count() > kMostPadding) {
    add_note(notes, chunks.surplus, "surplus bytes after the stated length of the file");
  }
  return GltfReader(source, document, chunks.binary, std::move(notes), tile).read();
}

}  // namespace

bool is_glb(std::string_view bytes) {
  return bytes.starts_with(glb::kMagic);
}

bool is_gltf(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && bytes[begin] == '{' &&
         bytes.find("\"asset\"", begin) != std::string_view::npos && !is_cityjson(bytes) &&
         !is_tileset(bytes);
}

Mesh read_gltf(Source& source) {
  const JsonDocument document(source, source.bytes, 0, false);
  return GltfReader(source, document, std::nullopt, {}, nullptr).read();
}

Mesh read_glb(Source& source) {
  return read_binary_gltf(source, 0, source.bytes.size(), nullptr);
}

Mesh read_gltf_tile(Source& source, std::size_t begin, std::size_t end, const GltfTile& tile) {
  if (is_glb(source.bytes.substr(begin))) {
    return read_binary_gltf(source, begin, end, &tile);
  }
  const JsonDocument document(source, source.bytes.substr(begin, end - begin), begin, false);
  return GltfReader(source, document, std::nullopt, {}, &tile).read();
}

}  // namespace soms::detail
