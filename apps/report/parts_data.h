/// \file
/// Many parts as one block of data in a page: each a mesh of its own at its own place.
#pragma once

#include "apps/report/drawn_mesh.h"
#include "apps/report/scene.h"

#include <cstdint>
#include <ostream>
#include <span>
#include <vector>

namespace soms::report {

/// A part that a page may draw.
struct PagePart {
  MeshView mesh;
  bool is_listed = false;  ///< a row names it: it is drawn, whatever that takes
  Detail detail = {};      ///< where all its triangles are kept
};

/// What of parts found room.
struct ShownParts {
  std::uint64_t triangles = 0;
  std::uint64_t triangles_in_all = 0;
  std::uint64_t parts = 0;
  std::uint64_t parts_in_all = 0;
  std::uint64_t simplified = 0;  ///< parts that are drawn with fewer triangles than they have
  std::uint64_t listed = 0;      ///< parts that rows name: all of them are drawn

  [[nodiscard]] bool operator==(const ShownParts&) const = default;
};

/// Chooses how parts are drawn, and writes them. Parts that rows name share the triangles of
/// `limits` fairly, and have at least their box; others share what these leave over, and those with
/// too small a share are left out.
class PartsData {
 public:
  PartsData(std::span<const PagePart> parts, const SceneLimits& limits);

  /// Where lengths of the page begin, and what they are multiplied by.
  [[nodiscard]] const Vec3& origin() const { return origin_; }

  [[nodiscard]] double scale() const { return scale_; }

  [[nodiscard]] Vec3 place(const Vec3& at) const { return (at - origin_) * scale_; }

  /// Half the sides of the box around all parts, as places are.
  [[nodiscard]] Vec3 half() const { return half_; }

  [[nodiscard]] const ShownParts& shown() const { return shown_; }

  /// Number of a part among those in the block; `kNoPart` for one that is left out.
  [[nodiscard]] std::uint32_t number(std::size_t part) const { return number_[part]; }

  /// Writes the element "soms-parts". For each part: number of triangles drawn, and in all; step,
  /// and place of the middle, as floats; the triangles as `put_mesh` has them.
  void write(std::ostream& out) const;

 private:
  void set_frame();
  void draw(const SceneLimits& limits);
  void add(std::size_t part, std::uint64_t share, std::uint64_t bytes);

  std::span<const PagePart> parts_;
  Vec3 origin_;
  double scale_ = 1;
  Vec3 half_;
  std::vector<DrawnMesh> meshes_;
  std::vector<double> steps_;  ///< of the meshes
  std::vector<std::uint32_t> number_;
  ShownParts shown_;
};

}  // namespace soms::report
