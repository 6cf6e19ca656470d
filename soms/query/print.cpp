#include "soms/query/print.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/geometry/print.h"
#include "soms/query/closest.h"
#include "soms/query/contains.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/distance.h"
#include "soms/query/first_contact.h"
#include "soms/query/overlap.h"
#include "soms/query/ray.h"
#include "soms/query/signed_closest.h"
#include "soms/query/solid.h"
#include "soms/query/within.h"
#include "soms/tree/print.h"

#include <algorithm>

namespace soms {

namespace {

std::string pairs_in_words(const std::vector<TrianglePair>& pairs) {
  return printed_count(pairs.size(), "pair", "pairs");
}

/// Poses with an overlap, of all.
std::string hits_in_words(const std::vector<std::uint8_t>& any) {
  const auto hits = std::count(any.begin(), any.end(), 1);
  return std::to_string(hits) + " of " + printed_count(any.size(), "pose", "poses") +
         " with an overlap";
}

/// Rays with a hit, of all.
std::string rays_in_words(std::ptrdiff_t hits, std::size_t rays) {
  return std::to_string(hits) + " of " + printed_count(rays, "ray hits", "rays hit");
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Body& value) {
  return out << PrintedFields("Body")
                    .item(quoted_text(value.name))
                    .item(printed(value.shape))
                    .item(printed(value.pose));
}

std::ostream& operator<<(std::ostream& out, const ClosedBody& value) {
  return out << PrintedFields("ClosedBody").item(printed(value.body()));
}

std::ostream& operator<<(std::ostream& out, const ContainsBatch& value) {
  const auto inside = std::count(value.side.begin(), value.side.end(), Side::inside);
  const auto on = std::count(value.side.begin(), value.side.end(), Side::on);
  return out << PrintedFields("ContainsBatch")
                    .item(std::to_string(inside) + " of " +
                          printed_count(value.size(), "point", "points") + " inside, " +
                          std::to_string(on) + " on the surface")
                    .add("coverage", detail::coverage_of(value.coverage))
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const ClosestBatch& value) {
  return out << PrintedFields("ClosestBatch")
                    .item(printed_count(value.size(), "point", "points"))
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const ClosestOptions& value) {
  return out << PrintedFields("ClosestOptions").add("at_most", value.at_most);
}

std::ostream& operator<<(std::ostream& out, const NearTriangles& value) {
  return out << PrintedFields("NearTriangles")
                    .item(printed_count(value.size(), "point", "points"))
                    .item(printed_count(value.triangle.size(), "triangle", "triangles"))
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const DistanceBatch& value) {
  return out << PrintedFields("DistanceBatch")
                    .item(printed_count(value.size(), "pose", "poses"))
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const DistanceOptions& value) {
  return out << PrintedFields("DistanceOptions").add("at_most", value.at_most);
}

std::ostream& operator<<(std::ostream& out, const FirstContactOptions& value) {
  return out << PrintedFields("FirstContactOptions").add("within", value.within);
}

std::ostream& operator<<(std::ostream& out, const RigidMotion& value) {
  return out << PrintedFields("RigidMotion")
                    .item(value.straight() ? "straight" : "turning")
                    .add("start", value.start())
                    .add("end", value.end())
                    .add("pivot", value.pivot());
}

std::ostream& operator<<(std::ostream& out, const WithinBatch& value) {
  const auto near = std::count(value.within.begin(), value.within.end(), 1);
  return out << PrintedFields("WithinBatch")
                    .item(std::to_string(near) + " of " +
                          printed_count(value.size(), "pose", "poses") + " within the clearance")
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const OverlapBatch& value) {
  return out << PrintedFields("OverlapBatch")
                    .item(hits_in_words(value.any))
                    .item(pairs_in_words(value.pairs))
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const OverlapOptions& value) {
  PrintedFields fields("OverlapOptions");
  fields.add("mode", value.mode);
  if (value.limit != std::numeric_limits<std::uint64_t>::max()) {
    fields.add("limit", value.limit);
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const Ray& value) {
  if (value.end) {
    return out << PrintedFields("Ray").add("origin", value.origin).add("end", *value.end);
  }
  return out << PrintedFields("Ray")
                    .add("origin", value.origin)
                    .add("direction", value.direction)
                    .add("length", value.length);
}

std::ostream& operator<<(std::ostream& out, const RayOptions& value) {
  PrintedFields fields("RayOptions");
  if (value.skip) {
    fields.add("skip", *value.skip);
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const ClosestHitBatch& value) {
  const auto hits = std::count_if(value.triangle.begin(), value.triangle.end(),
                                  [](const auto& triangle) { return triangle.has_value(); });
  return out << PrintedFields("ClosestHitBatch")
                    .item(rays_in_words(hits, value.size()))
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const AnyHitBatch& value) {
  const auto hits = std::count(value.hit.begin(), value.hit.end(), 1);
  return out << PrintedFields("AnyHitBatch")
                    .item(rays_in_words(hits, value.size()))
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const AllHits& value) {
  return out << PrintedFields("AllHits")
                    .item(printed_count(value.lower.size(), "crossing", "crossings") + " of " +
                          printed_count(value.size(), "ray", "rays"))
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const SignedClosestBatch& value) {
  return out << PrintedFields("SignedClosestBatch")
                    .item(printed_count(value.size(), "point", "points"))
                    .add("cost", value.closest.cost);
}

std::ostream& operator<<(std::ostream& out, const SolidBatch& value) {
  const auto apart = std::count(value.relation.begin(), value.relation.end(), Relation::clear);
  return out << PrintedFields("SolidBatch")
                    .item(std::to_string(apart) + " of " +
                          printed_count(value.size(), "pose", "poses") + " clear")
                    .add("cost", value.cost);
}

}  // namespace soms
