#include "soms/clash/part_keys.h"

#include "soms/base/hash.h"
#include "soms/geometry/parts_of.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace soms {

namespace {

/// Between two names of a path, and before what is added to a name: in no name of a file.
constexpr char kBetween = '\x1f';

/// What the file calls a part: its id or, behind a mark, its path.
std::string given_name(const MeshView& mesh, std::uint32_t part) {
  if (part == Part::kNoParent) {
    return {};
  }
  if (!mesh.parts[part].id.empty()) {
    return mesh.parts[part].id;
  }
  std::string name;
  for (const std::string& step : part_path(mesh, part)) {
    name += kBetween + step;
  }
  return name;
}

void add_text(Fnv1a& hash, std::string_view text) {
  for (const char c : text) {
    hash.add_byte(static_cast<std::uint8_t>(c));
  }
}

/// Of a triangle's corners, whichever comes first.
std::uint64_t triangle_key(const Triangle& t) {
  std::array<std::array<double, 3>, 3> corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& v = k == 0 ? t.a : k == 1 ? t.b : t.c;
    corners[k] = {v.x + 0.0, v.y + 0.0, v.z + 0.0};  // -0 is 0
  }
  std::sort(corners.begin(), corners.end());
  Fnv1a hash;
  for (const auto& corner : corners) {
    for (const double x : corner) {
      hash.add(x);
    }
  }
  return hash.value();
}

/// Of all triangles of a part, in whatever order.
std::uint64_t shape_key(const PartBody& part) {
  const MeshView& mesh = part.body.shape.mesh();
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    sum += triangle_key(mesh.triangle(static_cast<TriangleId>(i)));
  }
  return sum;
}

}  // namespace

std::vector<std::uint64_t> part_keys(std::span<const MeshPart> parts) {
  std::vector<std::string> names;
  std::unordered_map<std::string, std::size_t> uses;
  for (const MeshPart& part : parts) {
    names.push_back(given_name(part.mesh, part.part->part));
    ++uses[names.back()];
  }
  std::map<std::pair<std::string, std::uint64_t>, std::uint64_t> alike;
  std::vector<std::uint64_t> keys;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Fnv1a hash;
    add_text(hash, names[k]);
    if (names[k].empty() || uses[names[k]] > 1) {
      const std::uint64_t shape = shape_key(*parts[k].part);
      hash.add(shape);
      hash.add(alike[{names[k], shape}]++);
    }
    keys.push_back(hash.value());
  }
  return keys;
}

std::uint64_t clash_key(std::uint64_t a, std::uint64_t b) {
  Fnv1a hash;
  hash.add(std::min(a, b));
  hash.add(std::max(a, b));
  return hash.value();
}

}  // namespace soms
