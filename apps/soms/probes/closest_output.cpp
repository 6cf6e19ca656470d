#include "apps/soms/probes/closest_output.h"

#include "apps/cli/text.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <cmath>

namespace soms::command {

namespace {

constexpr std::size_t kHitsInText = 4;

template <class... Cells>
std::string cells(bool wide, const Cells&... values) {
  return table_line(wide ? fmt::format("{:>7}  {:<24}  {:<20}  {:<7}  {}", values...)
                         : fmt::format("{:>7}  {:<16}  {:<20}  {:<7}  {}", values...));
}

/// Numbers of the nearest triangles of a list.
std::string hits_cell(std::span<const ListedTriangle> hits, const MeshView& mesh) {
  std::string text;
  for (std::size_t i = 0; i < hits.size() && i < kHitsInText; ++i) {
    text += i == 0 ? "" : ", ";
    text += triangle_label(mesh, hits[i].triangle);
  }
  return hits.size() > kHitsInText ? text + ", ..." : text;
}

std::string distance_cell(const Closest& answer, double at_most, int digits) {
  const auto& [lower, upper] = answer.distance;
  if (answer.coverage == Coverage::cut) {
    return std::isfinite(upper) ? "<= " + readable(upper, digits) : "undecided";
  }
  if (answer.farther) {
    return "> " + readable(at_most);
  }
  return std::isfinite(lower) ? readable(lower, digits) : "none";
}

/// " inside", where that is known and requested and says more than a distance of 0.
std::string side_text(std::optional<Side> side) {
  return side == Side::inside || side == Side::outside ? " " + std::string(name(*side))
                                                       : std::string();
}

/// The same in a sentence: ", inside".
std::string side_clause(std::optional<Side> side) {
  const std::string text = side_text(side);
  return text.empty() ? text : "," + text;
}

std::string place_text(const Closest& answer, const MeshView& mesh) {
  return fmt::format("triangle {} at {}, {}", triangle_label(mesh, *answer.triangle),
                     point_in_text(answer.point),
                     answer.feature == TriangleFeature::vertex ? "a vertex"
                     : answer.feature == TriangleFeature::edge ? "on an edge"
                                                               : "inside its face");
}

}  // namespace

std::string point_text(const Closest& answer, std::optional<Side> side, const MeshView& mesh,
                       double at_most) {
  const auto& [lower, upper] = answer.distance;
  if (answer.coverage == Coverage::cut) {
    return std::isfinite(upper)
               ? fmt::format("undecided, out of time: the distance is from {} to {}",
                             readable(lower), readable(upper))
               : "undecided: out of time";
  }
  if (answer.farther) {
    return "farther than " + readable(at_most) + side_clause(side);
  }
  if (!answer.triangle) {
    return "no distance: the model has no triangles";
  }
  return (upper == 0 ? "distance 0, on the surface: "
                     : "distance " + readable(lower) + side_clause(side) + ": ") +
         place_text(answer, mesh);
}

std::string list_text(std::span<const ListedTriangle> hits, bool cut, const MeshView& mesh) {
  std::string text = counted(hits.size(), "triangle") + (cut            ? " so far, out of time"
                                                         : hits.empty() ? " near"
                                                                        : "");
  for (const ListedTriangle& hit : hits) {
    text += fmt::format("\n  {} at distance {}", triangle_label(mesh, hit.triangle),
                        readable(hit.distance.lower));
  }
  return text;
}

std::string point_head(bool sides) {
  return cells(sides, "point", "distance", "triangle", "feature", "at");
}

std::string point_row(std::uint64_t point, const Closest& answer, std::optional<Side> side,
                      const MeshView& mesh, double at_most, int digits) {
  const std::string distance = distance_cell(answer, at_most, digits) + side_text(side);
  const bool wide = side.has_value();
  return answer.triangle ? cells(wide, point, distance, triangle_label(mesh, *answer.triangle),
                                 name(answer.feature), point_in_text(answer.point, digits))
                         : cells(wide, point, distance, "", "", "");
}

std::string list_head() {
  return cells(false, "point", "distance", "triangle", "count", "");
}

std::string list_row(std::uint64_t point, std::span<const ListedTriangle> hits, bool cut,
                     const MeshView& mesh, int digits) {
  const std::string distance = !hits.empty() ? readable(hits.front().distance.lower, digits)
                               : cut         ? "undecided"
                                             : "none";
  return cells(false, point, distance, hits_cell(hits, mesh), hits.size(), "");
}

}  // namespace soms::command
