#include "apps/soms/pairs/near_output.h"

#include "soms/base/text.h"

#include "apps/cli/text.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <cmath>

namespace soms::command {

namespace {

constexpr const char kForm[] = "{:>6}  {:<16}  {:<20}  {}";

std::string side_in_text(const MeshView& mesh, TriangleId i, const Vec3& at) {
  return fmt::format("triangle {} of {} at {}", triangle_label(mesh, i), printable(mesh.source),
                     point_in_text(at));
}

}  // namespace

std::string near_text(const PairReport& report, const NearPair& pair) {
  return pair.triangles
             ? fmt::format(": {} and {}", side_in_text(report.a, pair.triangles->a, pair.point_a),
                           side_in_text(report.b, pair.triangles->b, pair.point_b))
             : std::string();
}

std::string near_head(std::string_view title) {
  return table_line(fmt::format(kForm, "pose", title, "triangle of A", "triangle of B"));
}

std::string near_row(const PairReport& report, std::uint64_t pose, std::string_view value,
                     const NearPair& pair) {
  const auto label = [&](const MeshView& mesh, TriangleId TrianglePair::*side) {
    return pair.triangles ? triangle_label(mesh, (*pair.triangles).*side) : std::string();
  };
  return table_line(fmt::format(kForm, pose, value, label(report.a, &TrianglePair::a),
                                label(report.b, &TrianglePair::b)));
}

}  // namespace soms::command
