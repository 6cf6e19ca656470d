// All hits of rays and segments on many bodies.
#include "soms/base/arithmetic.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/scene/detail/search/body_search.h"
#include "soms/scene/detail/search/line_question.h"
#include "soms/scene/detail/search/measures.h"
#include "soms/scene/detail/search/nearest_body.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

/// What a ray hits of one body.
struct HitsOfBody {
  const Body* body = nullptr;
  std::uint32_t number = 0;
  AllHits hits = {};
};

/// A crossing of one of these.
struct PlacedCrossing {
  const HitsOfBody* of = nullptr;
  std::size_t place = 0;  ///< in its columns

  [[nodiscard]] Bracket t() const { return {of->hits.lower[place], of->hits.upper[place]}; }

  [[nodiscard]] TriangleId first_triangle() const {
    return of->hits.triangle[of->hits.triangle_offsets[place]];
  }
};

/// By exact t, then by body; crossings of one body keep their order, which is right already.
bool is_before(const LineQuestion& question, const PlacedCrossing& x, const PlacedCrossing& y) {
  if (x.of == y.of) {
    return x.place < y.place;
  }
  const std::strong_ordering order = order_of(x.t(), y.t(), [&] {
    return question.compare(*x.of->body, x.first_triangle(), *y.of->body, y.first_triangle());
  });
  if (order != 0) {
    return order < 0;
  }
  return x.of->number < y.of->number;
}

void append_crossing(const PlacedCrossing& crossing, BodyAllHits& all) {
  const AllHits& hits = crossing.of->hits;
  all.lower.push_back(hits.lower[crossing.place]);
  all.upper.push_back(hits.upper[crossing.place]);
  all.kind.push_back(hits.kind[crossing.place]);
  all.body.push_back(crossing.of->number);
  for (std::uint64_t i = hits.triangle_offsets[crossing.place];
       i < hits.triangle_offsets[crossing.place + 1]; ++i) {
    all.triangle.push_back(hits.triangle[i]);
  }
  all.triangle_offsets.push_back(all.triangle.size());
}

/// The crossings of bodies, in the order of a row.
std::vector<PlacedCrossing> sorted_crossings(const LineQuestion& question,
                                             const std::vector<HitsOfBody>& found) {
  std::vector<PlacedCrossing> crossings;
  for (const HitsOfBody& of : found) {
    for (std::size_t place = 0; place < of.hits.kind.size(); ++place) {
      crossings.push_back({&of, place});
    }
  }
  std::sort(
      crossings.begin(), crossings.end(),
      [&](const PlacedCrossing& x, const PlacedCrossing& y) { return is_before(question, x, y); });
  return crossings;
}

/// Appends the row of a line.
void add_row(BodySets sets, const Ray& line, const RayOptions& options, LeftOut left_out,
             const Limits& limits, SearchMemory& memory, BodyAllHits& all) {
  const LineQuestion question(line, options, left_out, limits);
  std::vector<HitsOfBody> found;
  Coverage coverage = Coverage::complete;
  Cost cost;
  double limit = question.limit();
  cost.node_tests += for_each_near_body(
      sets, [&](const Box& box) { return question.key(box); }, limit, memory,
      [&](const Body& body, std::uint32_t number, double /*key*/) {
        if (coverage != Coverage::cut) {
          AllHits hits = question.ask_all(body, number);
          cost += hits.costs[0];
          coverage = hits.coverage[0];
          if (!hits.kind.empty()) {
            found.push_back({&body, number, std::move(hits)});
          }
        }
        if (coverage == Coverage::cut) {
          limit = -std::numeric_limits<double>::infinity();
        }
        return limit;
      });
  for (const PlacedCrossing& crossing : sorted_crossings(question, found)) {
    append_crossing(crossing, all);
  }
  all.offsets.push_back(all.kind.size());
  all.coverage.push_back(coverage);
  all.costs.push_back(cost);
}

/// Appends the rows of a block.
void append_block(const BodyAllHits& part, BodyAllHits& all) {
  append_rows(all.offsets, all.lower, part.offsets, part.lower);
  append(all.upper, part.upper);
  append(all.kind, part.kind);
  append(all.body, part.body);
  append_rows(all.triangle_offsets, all.triangle, part.triangle_offsets, part.triangle);
  append(all.coverage, part.coverage);
  append(all.costs, part.costs);
}

}  // namespace

BodyAllHits all_hits(BodySets sets, std::span<const Ray> lines, const RayOptions& options,
                     LeftOut left_out, const Limits& limits) {
  const PlainArithmetic plain;
  check_left_out(sets, options, left_out);
  static_cast<void>(soms::all_hits(Body(), lines, {}, limits));  // all but checks
  const Limits alone = limits.alone();
  std::vector<BodyAllHits> parts((lines.size() + kPosesOfBlock - 1) / kPosesOfBlock);
  for_each_block(
      lines.size(), limits, [] { return SearchMemory(); },
      [&](SearchMemory& memory, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          add_row(sets, lines[i], options, left_out, alone, memory, parts[begin / kPosesOfBlock]);
        }
      });
  BodyAllHits all;
  for (const BodyAllHits& part : parts) {
    append_block(part, all);
  }
  all.cost = sum_of(all.costs);
  return all;
}

}  // namespace soms::detail
