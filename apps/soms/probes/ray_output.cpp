#include "apps/soms/probes/ray_output.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
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

std::string t_key(const Bracket& t) {
  return fmt::format("\"t\":[{},{}]", json_number(t.lower), json_number(t.upper));
}

std::string first_hit_keys(const ClosestHit& hit) {
  std::string text = "," + t_key(hit.t);
  if (hit.triangle) {
    text += fmt::format(",\"triangle\":{},\"at\":[{},{},{}],\"front\":{}", *hit.triangle,
                        hit.point.x, hit.point.y, hit.point.z, hit.front);
  }
  return text;
}

std::string crossings_keys(const Crossings& hits) {
  std::string text = ",\"hits\":[";
  for (const Crossing& place : hits.places) {
    text +=
        fmt::format("{}{{{},\"triangles\":[{}],\"kind\":\"{}\"}}", text.back() == '[' ? "" : ",",
                    t_key(place.t), fmt::join(place.triangles, ","), name(place.kind));
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

std::string_view columns_of(const RayAnswer& answer) {
  return std::visit(
      Overloaded{[](const ClosestHit&) -> std::string_view {
                   return "ray,hit,lower,upper,coverage,triangle,part,name,x,y,z,front";
                 },
                 [](const AnyHit&) -> std::string_view { return "ray,hit,coverage"; },
                 [](const Crossings&) -> std::string_view {
                   return "ray,crossing,lower,upper,kind,coverage,triangle,part,name";
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

std::string_view name(CrossingKind kind) {
  switch (kind) {
    case CrossingKind::enter:
      return "enter";
    case CrossingKind::leave:
      return "leave";
    case CrossingKind::graze:
      break;
  }
  return "graze";
}

std::string ray_keys(const RayAnswer& answer) {
  const std::string keys =
      std::visit(Overloaded{[](const ClosestHit& hit) { return first_hit_keys(hit); },
                            [](const AnyHit&) { return std::string(); },
                            [](const Crossings& hits) { return crossings_keys(hits); }},
                 answer);
  return fmt::format(",\"hit\":{}{}", hit_word(answer, "null"), keys) +
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
  const auto hit = [&] { return hit_word(answer, ""); };
  return std::visit(
      Overloaded{[&](const ClosestHit& first) {
                   return fmt::format(
                       "{},{},{},{},{},{},{}{}\n", ray, hit(), first.t.lower, first.t.upper,
                       name(first.coverage), triangle_csv_fields(mesh_, parts_, first.triangle),
                       first.triangle ? fmt::format("{},{},{},{}", first.point.x, first.point.y,
                                                    first.point.z, first.front)
                                      : std::string(",,,"),
                       georeference_.field());
                 },
                 [&](const AnyHit& any) {
                   return fmt::format("{},{},{}\n", ray, hit(), name(any.coverage));
                 },
                 [&](const Crossings& all) {
                   std::string rows;
                   for (std::size_t i = 0; i < all.places.size(); ++i) {
                     const Crossing& place = all.places[i];
                     for (const TriangleId triangle : place.triangles) {
                       rows += fmt::format("{},{},{},{},{},{},{}\n", ray, i, place.t.lower,
                                           place.t.upper, name(place.kind), name(all.coverage),
                                           triangle_csv_fields(mesh_, parts_, triangle));
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
