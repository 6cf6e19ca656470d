#include "apps/soms/probes/ray_output.h"

#include "apps/cli/text.h"
#include "apps/soms/answers/answer_fields.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace soms::command {

namespace {

constexpr std::size_t kCrossingsInText = 4;

/// "enter at 1, leave at 3"
std::string crossings_cell(const Crossings& hits, int digits) {
  std::string text;
  for (std::size_t i = 0; i < hits.places.size() && i < kCrossingsInText; ++i) {
    text += fmt::format("{}{} at {}", i == 0 ? "" : ", ", name(hits.places[i].kind),
                        readable(hits.places[i].t.lower, digits));
  }
  text += hits.places.size() > kCrossingsInText ? ", ..." : "";
  return hits.coverage != Coverage::cut ? text
         : text.empty()                 ? "undecided"
                                        : text + ", out of time";
}

std::string t_cell(const ClosestHit& hit, int digits) {
  if (!hit.triangle) {
    return hit.coverage == Coverage::cut ? "undecided" : "none";
  }
  return (hit.coverage == Coverage::cut ? "<= " : "") +
         readable(hit.coverage == Coverage::cut ? hit.t.upper : hit.t.lower, digits);
}

}  // namespace

std::size_t Crossings::count() const {
  std::size_t count = 0;
  for (const Crossing& place : places) {
    count += place.triangles.size();
  }
  return count;
}

Crossings crossings_of(const AllHits& hits, std::size_t ray) {
  Crossings found{.coverage = hits.coverage[ray], .cost = hits.costs[ray]};
  for (std::size_t i = hits.offsets[ray]; i < hits.offsets[ray + 1]; ++i) {
    Crossing place{.t = {hits.lower[i], hits.upper[i]}, .kind = hits.kind[i]};
    for (std::size_t k = hits.triangle_offsets[i]; k < hits.triangle_offsets[i + 1]; ++k) {
      place.triangles.push_back(hits.triangle[k]);
    }
    found.places.push_back(std::move(place));
  }
  return found;
}

std::string crossings_keys(const Crossings& hits) {
  std::string text = ",\"hits\":[";
  for (const Crossing& place : hits.places) {
    text += fmt::format("{}{{\"kind\":\"{}\"{},\"triangles\":[{}]}}", text.back() == '[' ? "" : ",",
                        name(place.kind), detail::json_key("t", place.t),
                        fmt::join(place.triangles, ","));
  }
  return text + fmt::format("],\"count\":{}", hits.count());
}

std::string closest_hit_head(std::string_view noun) {
  return table_line(fmt::format("{:>7}  {:<16}  {:<20}  {:<5}  at", noun, "t", "triangle", "side"));
}

std::string any_hit_head(std::string_view noun) {
  return table_line(fmt::format("{:>7}  hit", noun));
}

std::string crossings_head(std::string_view noun) {
  return table_line(fmt::format("{:>7}  {:>9}  crossings", noun, "triangles"));
}

std::string text_of(std::uint64_t ray, const ClosestHit& hit, const MeshView& mesh, int digits) {
  return table_line(
      hit.triangle ? fmt::format("{:>7}  {:<16}  {:<20}  {:<5}  {}", ray, t_cell(hit, digits),
                                 triangle_label(mesh, *hit.triangle), hit.front ? "front" : "back",
                                 point_in_text(hit.point, digits))
                   : fmt::format("{:>7}  {}", ray, t_cell(hit, digits)));
}

std::string text_of(std::uint64_t ray, const AnyHit& hit) {
  return table_line(fmt::format("{:>7}  {}", ray,
                                hit.hit                         ? "yes"
                                : hit.coverage == Coverage::cut ? "undecided"
                                                                : "no"));
}

std::string text_of(std::uint64_t ray, const Crossings& hits, int digits) {
  return table_line(
      fmt::format("{:>7}  {:>9}  {}", ray, hits.count(), crossings_cell(hits, digits)));
}

}  // namespace soms::command
