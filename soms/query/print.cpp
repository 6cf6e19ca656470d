#include "soms/query/print.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/geometry/print.h"
#include "soms/query/closest.h"
#include "soms/query/contains.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/overlap.h"
#include "soms/query/ray.h"
#include "soms/query/signed_closest.h"
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

std::ostream& operator<<(std::ostream& out, const NearTriangles& value) {
  return out << PrintedFields("NearTriangles")
                    .item(printed_count(value.size(), "point", "points"))
                    .item(printed_count(value.triangle.size(), "triangle", "triangles"))
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const OverlapBatch& value) {
  return out << PrintedFields("OverlapBatch")
                    .item(hits_in_words(value.any))
                    .item(pairs_in_words(value.pairs))
                    .add("cost", value.cost);
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

}  // namespace soms
