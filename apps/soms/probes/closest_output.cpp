#include "apps/soms/probes/closest_output.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/soms/answers/answer_fields.h"
#include "apps/soms/pairs/near_output.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/soms/probes/probe_options.h"
#include "apps/soms/solid/closed_body.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <cmath>

namespace soms::command {

namespace {

constexpr std::size_t kHitsInText = 4;

std::string hits_key(const std::vector<ListedTriangle>& hits) {
  std::string text = ",\"hits\":[";
  for (const ListedTriangle& hit : hits) {
    text += fmt::format("{}{{\"triangle\":{}{}}}", text.back() == '[' ? "" : ",", hit.triangle,
                        detail::json_key("distance", hit.distance));
  }
  return text + "]";
}

/// Numbers of the nearest triangles of a list.
std::string hits_cell(const std::vector<ListedTriangle>& hits, const MeshView& mesh) {
  std::string text;
  for (std::size_t i = 0; i < hits.size() && i < kHitsInText; ++i) {
    text += i == 0 ? "" : ", ";
    text += triangle_label(mesh, hits[i].triangle);
  }
  return hits.size() > kHitsInText ? text + ", ..." : text;
}

std::string distance_cell(const PointAnswer& answer, double at_most) {
  if (answer.hits) {
    const auto& hits = *answer.hits;
    return hits.empty() ? (answer.cut() ? "undecided" : "none")
                        : readable(hits.front().distance.lower);
  }
  const auto& [lower, upper] = answer.closest.distance;
  if (answer.cut()) {
    return std::isfinite(upper) ? "<= " + readable(upper) : "undecided";
  }
  if (answer.closest.farther) {
    return "> " + readable(at_most);
  }
  return std::isfinite(lower) ? readable(lower) : "none";
}

/// " inside", where that is known and requested and says more than a distance of 0.
std::string side_text(const PointAnswer& answer) {
  return answer.side == Side::inside || answer.side == Side::outside
             ? " " + std::string(name(*answer.side))
             : std::string();
}

/// The same in a sentence: ", inside".
std::string side_clause(const PointAnswer& answer) {
  const std::string side = side_text(answer);
  return side.empty() ? side : "," + side;
}

std::string list_text(const PointAnswer& answer, const MeshView& mesh) {
  const std::vector<ListedTriangle>& hits = *answer.hits;
  std::string text = counted(hits.size(), "triangle") + (answer.cut()   ? " so far, out of time"
                                                         : hits.empty() ? " near"
                                                                        : "");
  for (const ListedTriangle& hit : hits) {
    text += fmt::format("\n  {} at distance {}", triangle_label(mesh, hit.triangle),
                        readable(hit.distance.lower));
  }
  return text;
}

std::string place_text(const Closest& answer, const MeshView& mesh) {
  return fmt::format("triangle {} at {}, {}", triangle_label(mesh, *answer.triangle),
                     point_in_text(answer.point),
                     answer.feature == TriangleFeature::vertex ? "a vertex"
                     : answer.feature == TriangleFeature::edge ? "on an edge"
                                                               : "inside its face");
}

}  // namespace

std::string point_keys(const PointAnswer& answer) {
  std::string text = answer.hits ? hits_key(*answer.hits) : field_keys(answer.closest);
  if (answer.side) {
    text += fmt::format(",\"side\":\"{}\"", name(*answer.side));
  }
  return text + coverage_keys(answer.coverage(), answer.closest.cost);
}

std::string point_text(const PointAnswer& answer, const MeshView& mesh, double at_most) {
  if (answer.hits) {
    return list_text(answer, mesh);
  }
  const auto& [lower, upper] = answer.closest.distance;
  if (answer.cut()) {
    return std::isfinite(upper)
               ? fmt::format("undecided, out of time: the distance is from {} to {}",
                             readable(lower), readable(upper))
               : "undecided: out of time";
  }
  if (answer.closest.farther) {
    return "farther than " + readable(at_most) + side_clause(answer);
  }
  if (!answer.closest.triangle) {
    return "no distance: the model has no triangles";
  }
  return (upper == 0 ? "distance 0, on the surface: "
                     : "distance " + readable(lower) + side_clause(answer) + ": ") +
         place_text(answer.closest, mesh);
}

void PointTable::add(std::uint64_t point, const PointAnswer& answer, const MeshView& mesh,
                     double at_most, Console& console) {
  const char* const form =
      answer.side ? "{:>7}  {:<24}  {:<20}  {:<7}  {}" : "{:>7}  {:<16}  {:<20}  {:<7}  {}";
  const auto print = [&](const auto&... cells) {
    console.print(table_line(fmt::format(fmt::runtime(form), cells...)));
  };
  const bool lists = answer.hits.has_value();
  if (rows_ == 0) {
    print("point", "distance", "triangle", lists ? "count" : "feature", lists ? "" : "at");
  }
  if (rows_++ >= kProbesInText) {
    return;
  }
  const std::string distance = distance_cell(answer, at_most) + side_text(answer);
  if (lists) {
    print(point, distance, hits_cell(*answer.hits, mesh), answer.hits->size(), "");
  } else if (answer.closest.triangle) {
    print(point, distance, triangle_label(mesh, *answer.closest.triangle),
          name(answer.closest.feature), point_in_text(answer.closest.point));
  } else {
    print(point, distance, "", "", "");
  }
}

void PointTable::finish(Console& console) const {
  if (rows_ > kProbesInText) {
    console.print(
        fmt::format("   and {} more; --json lists all\n", counted(rows_ - kProbesInText, "point")));
  }
}

PointCsv::PointCsv(const std::string& path) {
  if (!path.empty()) {
    file_.emplace(path);
  }
}

void PointCsv::begin(const MeshView& mesh, const Georeference& georeference, bool lists,
                     bool sides) {
  if (file_) {
    mesh_ = mesh;
    parts_ = PartsOf(mesh);
    georeference_ = lists ? GeoreferenceColumn() : GeoreferenceColumn(georeference);
    file_->stream() << (lists ? "row,triangle,part,name,lower,upper,coverage"
                              : "row," + field_head<Closest>())
                    << (sides ? ",side" : "") << georeference_.head() << '\n';
  }
}

void PointCsv::add(std::uint64_t point, const PointAnswer& answer) {
  if (!file_) {
    return;
  }
  const auto of_triangle = [this](int, std::optional<TriangleId> triangle) {
    return triangle_csv_fields(mesh_, parts_, triangle);
  };
  if (answer.hits) {
    for (const ListedTriangle& hit : *answer.hits) {
      file_->stream() << fmt::format("{},{},{},{},{}\n", point, of_triangle(0, hit.triangle),
                                     hit.distance.lower, hit.distance.upper,
                                     name(answer.coverage()));
    }
  } else {
    Closest closest = answer.closest;
    closest.coverage = answer.coverage();
    file_->stream() << fmt::format(
        "{},{}{}{}\n", point, field_cells(closest, of_triangle),
        answer.side ? "," + std::string(name(*answer.side)) : std::string(), georeference_.field());
  }
  if (!file_->stream().good()) {
    file_->check();
  }
}

void PointCsv::finish() {
  if (file_) {
    file_->commit();
  }
}

}  // namespace soms::command
