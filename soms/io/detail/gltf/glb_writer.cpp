#include "soms/io/detail/gltf/glb_writer.h"

#include "soms/base/decimal.h"
#include "soms/base/error.h"
#include "soms/base/portable.h"
#include "soms/geometry/part_runs.h"
#include "soms/io/detail/gltf/gltf.h"
#include "soms/io/detail/gltf/gltf_frame.h"
#include "soms/io/detail/json_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace soms::detail {

namespace {

constexpr std::uint64_t kPositionBytes = 12;
constexpr std::size_t kItemsPerTick = 1 << 16;
/// The largest number that fits stays free: it restarts strips.
constexpr std::size_t kMostForShort = 65'535;

/// Not inline: g++ 12 vectorizes double to float to double of two neighbors into nothing.
[[gnu::noinline]] float narrow(double x) {
  return static_cast<float>(x);
}

std::uint64_t padded(std::uint64_t bytes) {
  return (bytes + 3) / 4 * 4;
}

void add_number(std::string& text, const char* before, std::uint64_t number) {
  text.append(before).append(std::to_string(number));
}

void add_vector(std::string& text, const char* before, const std::array<double, 3>& v) {
  text += before;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<char, 32> digits{};
    char* const end = write_shortest(digits.data(), digits.data() + digits.size(), v[axis]);
    text.append(axis == 0 ? "[" : ",").append(digits.data(), end);
  }
  text += ']';
}

/// Nothing for no numbers: glTF has no empty lists.
void add_list(std::string& text, const char* before, const std::vector<std::uint32_t>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    add_number(text, i == 0 ? before : ",", numbers[i]);
  }
  text += numbers.empty() ? "" : "]";
}

/// True if parts stand as the nodes of a tree that is traversed from the outside in: each within
/// its parent, behind the parts before it.
bool nests(const std::vector<Part>& parts) {
  std::vector<std::uint32_t> open;
  const auto end_of = [&](std::uint32_t p) {
    return std::uint64_t{parts[p].first} + parts[p].count;
  };
  for (std::uint32_t p = 0; p < parts.size(); ++p) {
    if (parts[p].count == 0) {
      continue;
    }
    while (!open.empty() && end_of(open.back()) <= parts[p].first) {
      open.pop_back();
    }
    if (parts[p].parent != (open.empty() ? Part::kNoParent : open.back()) ||
        (!open.empty() &&
         (parts[p].first < parts[open.back()].first || end_of(p) > end_of(open.back())))) {
      return false;
    }
    open.push_back(p);
  }
  return true;
}

class GlbWriter {
 public:
  GlbWriter(Output& output, const std::string& name, const MeshView& mesh, const Limits& limits)
      : output_(output),
        name_(name),
        mesh_(mesh),
        limits_(limits),
        origin_(glb_origin(mesh)),
        runs_(part_runs(mesh)) {}

  void write();

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  struct Node {
    std::uint32_t part = Part::kNoParent;  ///< whose name it has
    std::uint32_t run = kNone;             ///< whose triangles it has
    std::vector<std::uint32_t> children = {};
  };

  /// Triangles of a run, and what they use of `order_`.
  [[nodiscard]] std::size_t triangles_end(std::size_t run) const {
    return run + 1 < runs_.size() ? runs_[run + 1].first : mesh_.triangles.size();
  }

  [[nodiscard]] std::size_t vertices_of(std::size_t run) const {
    return first_[run + 1] - first_[run];
  }

  [[nodiscard]] std::uint64_t index_bytes(std::size_t run) const {
    const std::uint64_t size = vertices_of(run) <= kMostForShort ? 2 : 4;
    return padded(3 * size * (triangles_end(run) - runs_[run].first));
  }

  [[nodiscard]] bool order_as_stored();
  void order_as_used();
  void plan_nodes();
  std::uint32_t add_node(const Node& node, std::uint32_t parent);
  [[nodiscard]] std::array<float, 3> position(std::uint32_t vertex) const;
  [[nodiscard]] std::string json(std::uint64_t index_size) const;
  void add_nodes(std::string& text) const;
  void add_accessors(std::string& text) const;
  void put_positions();
  void put_indices(std::size_t run);
  void tick(double share) const;

  Output& output_;
  const std::string& name_;
  MeshView mesh_;
  const Limits& limits_;
  Vec3 origin_;
  std::vector<PartRun> runs_;
  std::vector<std::uint32_t> order_;    ///< vertices as they are written
  std::vector<std::size_t> first_{0};   ///< of each run in `order_`, and the end
  std::vector<std::uint32_t> numbers_;  ///< of vertices, in the run at hand
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> roots_;
};

void GlbWriter::tick(double share) const {
  check(limits_);
  if (limits_.progress) {
    limits_.progress(share);
  }
}

/// All vertices as they are, where each run uses others, behind those of the run before it.
bool GlbWriter::order_as_stored() {
  std::vector<std::size_t> first{0};
  std::uint32_t end = 0;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    std::uint32_t least = kNone;
    std::uint32_t most = 0;
    for (std::size_t i = runs_[run].first; i < triangles_end(run); ++i) {
      const auto& [a, b, c] = mesh_.triangles[i];
      least = std::min({least, a, b, c});
      most = std::max({most, a, b, c});
    }
    if (run > 0 && least < end) {
      return false;
    }
    if (run > 0) {
      first.push_back(least);
    }
    end = most + 1;
  }
  order_.resize(mesh_.vertices.size());
  std::iota(order_.begin(), order_.end(), 0U);
  first.push_back(order_.size());
  first_ = std::move(first);
  return true;
}

/// The vertices that each run uses, in the order of the mesh.
void GlbWriter::order_as_used() {
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    check(limits_);
    const auto begin = static_cast<std::ptrdiff_t>(order_.size());
    for (std::size_t i = runs_[run].first; i < triangles_end(run); ++i) {
      order_.insert(order_.end(), mesh_.triangles[i].begin(), mesh_.triangles[i].end());
    }
    std::sort(order_.begin() + begin, order_.end());
    order_.erase(std::unique(order_.begin() + begin, order_.end()), order_.end());
    first_.push_back(order_.size());
  }
}

std::uint32_t GlbWriter::add_node(const Node& node, std::uint32_t parent) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(node);
  (parent == kNone ? roots_ : nodes_[parent].children).push_back(number);
  return number;
}

/// Nodes in the order of the triangles: each part before what is within it.
void GlbWriter::plan_nodes() {
  const bool nested = nests(mesh_.parts);
  std::vector<std::uint32_t> node_of(nested ? mesh_.parts.size() : 0, kNone);
  std::uint32_t next = 0;
  for (std::uint32_t run = 0; run < runs_.size(); ++run) {
    const std::uint32_t part = runs_[run].part;
    if (!nested || part == Part::kNoParent) {
      add_node({part, run}, kNone);
      continue;
    }
    for (; next < node_of.size(); ++next) {
      const Part& begun = mesh_.parts[next];
      if (begun.count > 0 && begun.first > runs_[run].first) {
        break;
      }
      if (begun.count > 0) {
        const std::uint32_t parent =
            begun.parent == Part::kNoParent ? kNone : node_of[begun.parent];
        node_of[next] = add_node({next}, parent);
      }
    }
    Node& node = nodes_[node_of[part]];
    if (node.run == kNone && node.children.empty()) {
      node.run = run;
    } else {
      add_node({Part::kNoParent, run}, node_of[part]);  // triangles behind those of inner parts
    }
  }
}

std::array<float, 3> GlbWriter::position(std::uint32_t vertex) const {
  std::array<float, 3> place{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    place[axis] = narrow(mesh_.vertices[vertex][axis] - origin_[axis]);
    if (!std::isfinite(place[axis])) {
      const bool finite = std::isfinite(mesh_.vertices[vertex][axis]);
      throw Error(finite ? ErrorKind::out_of_range : ErrorKind::not_finite,
                  name_ + ": vertex " + std::to_string(vertex) +
                      (finite ? " has a coordinate that a float cannot hold" : " is not finite"),
                  finite ? "write PLY, OBJ or OFF, or text STL" : "repair the vertex");
    }
  }
  return place;
}

void GlbWriter::add_nodes(std::string& text) const {
  add_list(text, ",\"scenes\":[{\"nodes\":[", roots_);
  text += "}],\"nodes\":[";
  std::vector<bool> is_root(nodes_.size());
  for (const std::uint32_t root : roots_) {
    is_root[root] = true;
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    std::string inside;
    if (node.part != Part::kNoParent && !mesh_.parts[node.part].name.empty()) {
      inside += ",\"name\":" + json_text(mesh_.parts[node.part].name);
    }
    if (node.run != kNone) {
      add_number(inside, ",\"mesh\":", node.run);
    }
    add_list(inside, ",\"children\":[", node.children);
    if (is_root[i] && origin_ != Vec3{}) {
      add_vector(inside, ",\"translation\":", {origin_.x, origin_.y, origin_.z});
    }
    text.append(i == 0 ? "{" : ",{").append(inside, 1).append("}");
  }
  text += "],\"meshes\":[";
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    text += run == 0 ? "" : ",";
    add_number(text, "{\"primitives\":[{\"attributes\":{\"POSITION\":", 2 * run);
    add_number(text, "},\"indices\":", 2 * run + 1);
    text += "}]}";
  }
}

/// Two accessors a run: positions with their bounds, which glTF wants, and indices.
void GlbWriter::add_accessors(std::string& text) const {
  std::uint64_t index_offset = 0;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    std::array<double, 3> lower{};
    std::array<double, 3> upper{};
    for (std::size_t i = first_[run]; i < first_[run + 1]; ++i) {
      const std::array<float, 3> place = position(order_[i]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = place[axis];
        lower[axis] = i == first_[run] ? x : std::min(lower[axis], x);
        upper[axis] = i == first_[run] ? x : std::max(upper[axis], x);
      }
    }
    text += run == 0 ? "" : ",";
    add_number(text, "{\"bufferView\":0,\"byteOffset\":", kPositionBytes * first_[run]);
    add_number(text, ",\"componentType\":5126,\"type\":\"VEC3\",\"count\":", vertices_of(run));
    add_vector(text, ",\"min\":", lower);
    add_vector(text, ",\"max\":", upper);
    add_number(text, "},{\"bufferView\":1,\"byteOffset\":", index_offset);
    add_number(text, ",\"componentType\":", vertices_of(run) <= kMostForShort ? 5123 : 5125);
    add_number(text,
               ",\"type\":\"SCALAR\",\"count\":", 3 * (triangles_end(run) - runs_[run].first));
    text += '}';
    index_offset += index_bytes(run);
  }
}

std::string GlbWriter::json(std::uint64_t index_size) const {
  std::string text = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"soms\"";
  text += gltf_frame_extras(mesh_);
  text += "},\"scene\":0";
  if (runs_.empty()) {
    return text + ",\"scenes\":[{}]}";
  }
  add_nodes(text);
  text += "],\"accessors\":[";
  add_accessors(text);
  const std::uint64_t position_size = kPositionBytes * order_.size();
  add_number(text,
             "],\"bufferViews\":[{\"buffer\":0,\"target\":34962,\"byteStride\":", kPositionBytes);
  add_number(text, ",\"byteLength\":", position_size);
  add_number(text, "},{\"buffer\":0,\"target\":34963,\"byteOffset\":", position_size);
  add_number(text, ",\"byteLength\":", index_size);
  add_number(text, "}],\"buffers\":[{\"byteLength\":", position_size + index_size);
  return text + "}]}";
}

void GlbWriter::put_positions() {
  for (std::size_t i = 0; i < order_.size(); ++i) {
    if (i % kItemsPerTick == 0) {
      tick(0.5 * static_cast<double>(i) / static_cast<double>(order_.size()));
    }
    for (const float x : position(order_[i])) {
      output_.put_bits(bit_cast<std::uint32_t>(x), 4);
    }
  }
}

void GlbWriter::put_indices(std::size_t run) {
  for (std::size_t i = first_[run]; i < first_[run + 1]; ++i) {
    numbers_[order_[i]] = static_cast<std::uint32_t>(i - first_[run]);
  }
  const std::size_t size = vertices_of(run) <= kMostForShort ? 2 : 4;
  const auto count = static_cast<double>(mesh_.triangles.size());
  for (std::size_t i = runs_[run].first; i < triangles_end(run); ++i) {
    if (i % kItemsPerTick == 0) {
      tick(0.5 + 0.5 * static_cast<double>(i) / count);
    }
    for (const std::uint32_t v : mesh_.triangles[i]) {
      output_.put_bits(numbers_[v], size);
    }
  }
  const std::uint64_t bytes = 3 * size * (triangles_end(run) - runs_[run].first);
  output_.put_bits(0, static_cast<std::size_t>(padded(bytes) - bytes));
}

void GlbWriter::write() {
  tick(0);
  if (!runs_.empty()) {
    if (!order_as_stored()) {
      order_as_used();
    }
    plan_nodes();
  }
  std::uint64_t index_size = 0;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    index_size += index_bytes(run);
  }
  const std::uint64_t binary = kPositionBytes * order_.size() + index_size;
  std::string text = json(index_size);
  text.resize(static_cast<std::size_t>(padded(text.size())), ' ');
  const std::uint64_t size = glb::kHeader + glb::kChunkHeader + text.size() +
                             (binary > 0 ? glb::kChunkHeader + binary : 0);
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorKind::out_of_range, name_ + ": a GLB file must be smaller than 4 GiB",
                "write PLY, OBJ, OFF or STL");
  }
  output_.put(glb::kMagic);
  output_.put_bits(glb::kVersion, 4);
  output_.put_bits(size, 4);
  output_.put_bits(text.size(), 4);
  output_.put_bits(glb::kJson, 4);
  output_.put(text);
  if (binary > 0) {
    output_.put_bits(binary, 4);
    output_.put_bits(glb::kBinary, 4);
    put_positions();
    numbers_.resize(mesh_.vertices.size());
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      put_indices(run);
    }
  }
}

/// One axis of `glb_origin`.
double origin_of(const MeshView& mesh, std::size_t axis, double lower, double upper) {
  const double extent = upper - lower;
  // Nothing is won near the origin.
  constexpr double kFar = 4;
  if (std::max(std::abs(lower), std::abs(upper)) < kFar * extent) {
    return 0;
  }
  const bool exact = std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
      const double x = mesh.vertices[v][axis];
      return double{narrow(x)} == x;
    });
  });
  if (exact || extent == 0) {
    return exact ? 0 : lower;
  }
  // As coarse as the mesh is large: what is left of coordinates on a finer grid stays on it.
  const double grid = std::ldexp(1.0, std::ilogb(extent));
  return std::floor((lower + 0.5 * extent) / grid + 0.5) * grid;
}

}  // namespace

Vec3 glb_origin(const MeshView& mesh) {
  if (mesh.triangles.empty()) {
    return {};
  }
  const Box box = bounds(mesh);
  return {origin_of(mesh, 0, box.lower.x, box.upper.x),
          origin_of(mesh, 1, box.lower.y, box.upper.y),
          origin_of(mesh, 2, box.lower.z, box.upper.z)};
}

Vec3 glb_read_back(const Vec3& vertex, const Vec3& origin) {
  const auto back = [](double x, double shift) { return double{narrow(x - shift)} + shift; };
  return {back(vertex.x, origin.x), back(vertex.y, origin.y), back(vertex.z, origin.z)};
}

void write_glb(Output& output, const std::string& name, const MeshView& mesh,
               const Limits& limits) {
  GlbWriter(output, name, mesh, limits).write();
}

}  // namespace soms::detail
