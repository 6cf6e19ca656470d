#include "apps/soms/probes/ray_output.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/soms/answers/answer_fields.h"
#include "apps/soms/pairs/near_output.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/soms/probes/probe_options.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace soms::command {

namespace {

constexpr std::size_t kCrossingsInText = 4;

/// Functions of each kind of answer as one function of all.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

/// "true", "false", or `unknown` if time ended before a hit was found.
std::string_view hit_word(const RayAnswer& answer, std::string_view unknown) {
  return is_hit(answer) ? "true" : is_cut(answer) ? unknown : "false";
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

/// "enter at 1, leave at 3"
std::string crossings_cell(const Crossings& hits) {
  std::string text;
  for (std::size_t i = 0; i < hits.places.size() && i < kCrossingsInText; ++i) {
    text += fmt::format("{}{} at {}", i == 0 ? "" : ", ", name(hits.places[i].kind),
                        readable(hits.places[i].t.lower));
  }
  text += hits.places.size() > kCrossingsInText ? ", ..." : "";
  return hits.coverage != Coverage::cut ? text
         : text.empty()                 ? "undecided"
                                        : text + ", out of time";
}

std::string t_cell(const ClosestHit& hit) {
  if (!hit.triangle) {
    return hit.coverage == Coverage::cut ? "undecided" : "none";
  }
  return (hit.coverage == Coverage::cut ? "<= " : "") +
         readable(hit.coverage == Coverage::cut ? hit.t.upper : hit.t.lower);
}

std::string titles_in_text(std::string_view noun, const RayAnswer& answer) {
  return std::visit(Overloaded{[&](const ClosestHit&) {
                                 return fmt::format("{:>7}  {:<16}  {:<20}  {:<5}  at", noun, "t",
                                                    "triangle", "side");
                               },
                               [&](const AnyHit&) { return fmt::format("{:>7}  hit", noun); },
                               [&](const Crossings&) {
                                 return fmt::format("{:>7}  {:>9}  crossings", noun, "triangles");
                               }},
                    answer);
}

std::string row_in_text(std::uint64_t ray, const RayAnswer& answer, const MeshView& mesh) {
  return std::visit(
      Overloaded{[&](const ClosestHit& hit) {
                   return hit.triangle
                              ? fmt::format("{:>7}  {:<16}  {:<20}  {:<5}  {}", ray, t_cell(hit),
                                            triangle_label(mesh, *hit.triangle),
                                            hit.front ? "front" : "back", point_in_text(hit.point))
                              : fmt::format("{:>7}  {}", ray, t_cell(hit));
                 },
                 [&](const AnyHit& hit) {
                   return fmt::format("{:>7}  {}", ray,
                                      hit.hit          ? "yes"
                                      : is_cut(answer) ? "undecided"
                                                       : "no");
                 },
                 [&](const Crossings& hits) {
                   return fmt::format("{:>7}  {:>9}  {}", ray, hits.count(), crossings_cell(hits));
                 }},
      answer);
}

std::string columns_of(const RayAnswer& answer) {
  return std::visit(
      Overloaded{[](const ClosestHit&) { return "ray,hit," + field_head<ClosestHit>(); },
                 [](const AnyHit&) { return "ray," + field_head<AnyHit>(); },
                 [](const Crossings&) {
                   return std::string("ray,crossing,lower,upper,kind,triangle,part,name,coverage");
                 }},
      answer);
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

bool is_hit(const RayAnswer& answer) {
  return std::visit(Overloaded{[](const ClosestHit& hit) { return hit.triangle.has_value(); },
                               [](const AnyHit& hit) { return hit.hit; },
                               [](const Crossings& hits) { return !hits.places.empty(); }},
                    answer);
}

bool is_cut(const RayAnswer& answer) {
  return std::visit([](const auto& hit) { return hit.coverage == Coverage::cut; }, answer);
}

std::string ray_keys(const RayAnswer& answer) {
  const std::string keys =
      std::visit(Overloaded{[](const ClosestHit& hit) { return field_keys(hit); },
                            [](const AnyHit& hit) { return field_keys(hit); },
                            [](const Crossings& hits) { return crossings_keys(hits); }},
                 answer);
  return (std::holds_alternative<AnyHit>(answer)
              ? keys
              : fmt::format(",\"hit\":{}{}", hit_word(answer, "null"), keys)) +
         std::visit([](const auto& hit) { return coverage_keys(hit.coverage, hit.cost); }, answer);
}

void RayTable::add(std::string_view noun, const RayAnswer& answer, const MeshView& mesh,
                   Console& console) {
  if (rows_ == 0) {
    console.print(table_line(titles_in_text(noun, answer)));
  }
  if (rows_ < kProbesInText) {
    console.print(table_line(row_in_text(rows_, answer, mesh)));
  }
  ++rows_;
}

RayCsv::RayCsv(const std::string& path) {
  if (!path.empty()) {
    file_.emplace(path);
  }
}

void RayCsv::begin(const MeshView& mesh, const Georeference& georeference, const RayAnswer& like) {
  if (file_) {
    const bool points = std::holds_alternative<ClosestHit>(like);
    georeference_ = points ? GeoreferenceColumn(georeference) : GeoreferenceColumn();
    file_->stream() << columns_of(like) << georeference_.head() << '\n';
    mesh_ = mesh;
    parts_ = PartsOf(mesh);
  }
}

void RayCsv::add(std::uint64_t ray, const RayAnswer& answer) {
  if (!file_) {
    return;
  }
  file_->stream() << rows_of(ray, answer);
  if (!file_->stream().good()) {
    file_->check();
  }
}

std::string RayCsv::rows_of(std::uint64_t ray, const RayAnswer& answer) const {
  const auto of_triangle = [this](int, std::optional<TriangleId> triangle) {
    return triangle_csv_fields(mesh_, parts_, triangle);
  };
  return std::visit(
      Overloaded{[&](const ClosestHit& first) {
                   return fmt::format("{},{},{}{}\n", ray, hit_word(answer, ""),
                                      field_cells(first, of_triangle), georeference_.field());
                 },
                 [&](const AnyHit& any) {
                   return fmt::format("{},{}\n", ray, field_cells(any, of_triangle));
                 },
                 [&](const Crossings& all) {
                   std::string rows;
                   for (std::size_t i = 0; i < all.places.size(); ++i) {
                     const Crossing& place = all.places[i];
                     for (const TriangleId triangle : place.triangles) {
                       rows += fmt::format("{},{},{},{},{},{},{}\n", ray, i, place.t.lower,
                                           place.t.upper, name(place.kind),
                                           of_triangle(0, triangle), name(all.coverage));
                     }
                   }
                   return rows;
                 }},
      answer);
}

void RayCsv::finish() {
  if (file_) {
    file_->commit();
  }
}

}  // namespace soms::command
