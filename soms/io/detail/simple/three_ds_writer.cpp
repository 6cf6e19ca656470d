#include "soms/io/detail/simple/three_ds_writer.h"

#include "soms/base/error.h"
#include "soms/base/portable.h"
#include "soms/geometry/part_runs.h"
#include "soms/io/detail/simple/three_ds_chunks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

constexpr std::size_t kMostItems = 65'535;  // counts and indices have 16 bits
constexpr std::size_t kLongestName = 10;    // what 3D Studio shows and keeps
constexpr std::uint64_t kNumberChunk = three_ds::kChunkHeader + 4;  // holds one number
constexpr std::uint64_t kBeforeEditor = three_ds::kChunkHeader + kNumberChunk;
constexpr std::uint64_t kLongestEditor =
    std::numeric_limits<std::uint32_t>::max() - kBeforeEditor;  // lengths have 32 bits
constexpr std::uint64_t kRelease = 3;
constexpr std::uint64_t kAllEdgesVisible = 7;

/// Names that are ASCII, short enough and different from one another.
class ObjectNames {
 public:
  /// The name for an object that is to be called `wanted`: cut, and numbered if it is taken.
  std::string next(std::string_view wanted);

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, std::uint64_t> numbers_;  ///< last number used behind a beginning
};

std::string ObjectNames::next(std::string_view wanted) {
  std::string name(wanted.substr(0, kLongestName));
  for (char& c : name) {
    c = c < ' ' || c > '~' ? '_' : c;
  }
  if (name.empty()) {
    name = "object";
  }
  if (taken_.insert(name).second) {
    return name;
  }
  // Numbers of nine digits suffice: each object of a file below 4 GiB takes 50 bytes.
  std::uint64_t end = 10;
  for (std::size_t digits = 1;; ++digits, end *= 10) {
    const std::string begin = name.substr(0, kLongestName - 1 - digits) + '_';
    std::uint64_t& last =
        numbers_.try_emplace(begin + std::string(digits, '#'), end / 10 - 1).first->second;
    last = std::max<std::uint64_t>(last, 1);  // the first of a name has no number
    while (++last < end) {
      std::string numbered = begin + std::to_string(last);
      if (taken_.insert(numbered).second) {
        return numbered;
      }
    }
    last = end - 1;
  }
}

/// Consecutive triangles that become one object.
struct Object {
  std::size_t first = 0;
  std::size_t count = 0;
  std::size_t vertices = 0;  ///< that the triangles use, each counted once
  std::string name = {};

  [[nodiscard]] std::uint64_t vertex_list() const {
    return three_ds::kChunkHeader + 2 + std::uint64_t{12} * vertices;
  }

  [[nodiscard]] std::uint64_t face_list() const {
    return three_ds::kChunkHeader + 2 + std::uint64_t{8} * count;
  }

  [[nodiscard]] std::uint64_t triangles() const {
    return three_ds::kChunkHeader + vertex_list() + face_list();
  }

  [[nodiscard]] std::uint64_t length() const {
    return three_ds::kChunkHeader + name.size() + 1 + triangles();
  }
};

/// The objects that a mesh becomes.
class ThreeDsPlan {
 public:
  /// `name` of the file, for messages. \errors ErrorKind::out_of_range, cancelled.
  ThreeDsPlan(const std::string& name, const MeshView& mesh, const Limits& limits);

  [[nodiscard]] const std::vector<Object>& objects() const { return objects_; }

  /// Length of the chunk that holds them.
  [[nodiscard]] std::uint64_t editor() const { return editor_; }

  /// Parts whose first object could not have their name as it is.
  [[nodiscard]] std::uint64_t renamed() const { return renamed_; }

 private:
  void plan_run(std::size_t first, std::size_t end, std::string_view part);

  const std::string& name_;
  MeshView mesh_;
  const Limits& limits_;
  ObjectNames names_;
  std::vector<Object> objects_;
  std::uint64_t editor_ = three_ds::kChunkHeader + 2 * kNumberChunk;
  std::uint64_t renamed_ = 0;
  std::vector<std::uint32_t> last_use_;  ///< of vertices: the last object that uses it
};

ThreeDsPlan::ThreeDsPlan(const std::string& name, const MeshView& mesh, const Limits& limits)
    : name_(name),
      mesh_(mesh),
      limits_(limits),
      last_use_(mesh.vertices.size(), std::numeric_limits<std::uint32_t>::max()) {
  const std::vector<PartRun> runs = part_runs(mesh_);
  std::vector<bool> seen(mesh.parts.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t end = i + 1 < runs.size() ? runs[i + 1].first : mesh_.triangles.size();
    const std::uint32_t part = runs[i].part;
    const bool named = part != Part::kNoParent && !mesh_.parts[part].name.empty();
    const std::string_view wanted = named ? std::string_view(mesh_.parts[part].name) : "";
    const std::size_t object = objects_.size();
    plan_run(runs[i].first, end, wanted);
    if (named && !seen[part]) {
      seen[part] = true;
      renamed_ += objects_.size() > object && objects_[object].name != wanted ? 1U : 0U;
    }
  }
}

/// Cuts triangles `[first, end)`, which are of one part, into objects.
void ThreeDsPlan::plan_run(std::size_t first, std::size_t end, std::string_view part) {
  while (first < end) {
    check(limits_);
    Object object{first, 0, 0, names_.next(part)};
    const auto mark = static_cast<std::uint32_t>(objects_.size());
    for (; first < end && object.count < kMostItems; ++first, ++object.count) {
      std::array<std::uint32_t, 3> corners = mesh_.triangles[first];
      std::sort(corners.begin(), corners.end());
      const auto last = std::unique(corners.begin(), corners.end());
      const auto fresh = static_cast<std::size_t>(
          std::count_if(corners.begin(), last, [&](auto v) { return last_use_[v] != mark; }));
      if (object.vertices + fresh > kMostItems) {
        break;
      }
      object.vertices += fresh;
      for (const std::uint32_t v : mesh_.triangles[first]) {
        last_use_[v] = mark;
      }
    }
    editor_ += object.length();
    if (editor_ > kLongestEditor) {
      throw Error(ErrorKind::out_of_range, name_ + ": a 3DS file must be smaller than 4 GiB",
                  "write PLY, OBJ, OFF or STL");
    }
    objects_.push_back(std::move(object));
  }
}

class ThreeDsWriter {
 public:
  ThreeDsWriter(Output& output, const std::string& name, const MeshView& mesh, const Limits& limits)
      : output_(output), name_(name), mesh_(mesh), limits_(limits) {}

  void write();

 private:
  void put_chunk(std::uint16_t name, std::uint64_t length);
  void put_version(std::uint16_t name);
  void put_coordinate(double value, std::size_t vertex);
  void put_object(const Object& object);
  void tick(double share) const;

  Output& output_;
  const std::string& name_;
  MeshView mesh_;
  const Limits& limits_;
  std::vector<std::uint32_t> numbers_;  ///< of vertices, in the object that is written
};

void ThreeDsWriter::tick(double share) const {
  check(limits_);
  if (limits_.progress) {
    limits_.progress(share);
  }
}

void ThreeDsWriter::put_chunk(std::uint16_t name, std::uint64_t length) {
  output_.put_bits(name, 2);
  output_.put_bits(length, 4);
}

void ThreeDsWriter::put_version(std::uint16_t name) {
  put_chunk(name, kNumberChunk);
  output_.put_bits(kRelease, 4);
}

void ThreeDsWriter::put_coordinate(double value, std::size_t vertex) {
  const auto narrow = static_cast<float>(value);
  if (!std::isfinite(narrow)) {
    throw Error(
        ErrorKind::out_of_range,
        name_ + ": vertex " + std::to_string(vertex) + " has a coordinate that a float cannot hold",
        "write PLY, OBJ or OFF, or text STL");
  }
  output_.put_bits(bit_cast<std::uint32_t>(narrow), 4);
}

void ThreeDsWriter::put_object(const Object& object) {
  std::vector<std::uint32_t> used;
  used.reserve(3 * object.count);
  for (std::size_t i = object.first; i < object.first + object.count; ++i) {
    used.insert(used.end(), mesh_.triangles[i].begin(), mesh_.triangles[i].end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());

  put_chunk(three_ds::kObject, object.length());
  output_.put(object.name);
  output_.put('\0');
  put_chunk(three_ds::kTriangles, object.triangles());
  put_chunk(three_ds::kVertexList, object.vertex_list());
  output_.put_bits(used.size(), 2);
  for (std::size_t i = 0; i < used.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      put_coordinate(mesh_.vertices[used[i]][axis], used[i]);
    }
    numbers_[used[i]] = static_cast<std::uint32_t>(i);
  }
  put_chunk(three_ds::kFaceList, object.face_list());
  output_.put_bits(object.count, 2);
  for (std::size_t i = object.first; i < object.first + object.count; ++i) {
    for (const std::uint32_t v : mesh_.triangles[i]) {
      output_.put_bits(numbers_[v], 2);
    }
    output_.put_bits(kAllEdgesVisible, 2);
  }
}

void ThreeDsWriter::write() {
  tick(0);
  const ThreeDsPlan plan(name_, mesh_, limits_);
  numbers_.resize(mesh_.vertices.size());
  put_chunk(three_ds::kMain, kBeforeEditor + plan.editor());
  put_version(three_ds::kVersion);
  put_chunk(three_ds::kEditor, plan.editor());
  put_version(three_ds::kMeshVersion);
  put_chunk(three_ds::kMasterScale, kNumberChunk);
  output_.put_bits(bit_cast<std::uint32_t>(1.0F), 4);
  for (const Object& object : plan.objects()) {
    tick(static_cast<double>(object.first) / static_cast<double>(mesh_.triangles.size()));
    put_object(object);
  }
}

}  // namespace

void write_three_ds(Output& output, const std::string& name, const MeshView& mesh,
                    const Limits& limits) {
  ThreeDsWriter(output, name, mesh, limits).write();
}

std::uint64_t renamed_in_three_ds(const MeshView& mesh) {
  const std::string none;
  const Limits alone;
  return ThreeDsPlan(none, mesh, alone).renamed();
}

}  // namespace soms::detail
