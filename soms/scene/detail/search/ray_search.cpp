// The first hit of rays and segments on many bodies.
#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/describe/columns.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/scene/detail/search/body_search.h"
#include "soms/scene/detail/search/line_question.h"
#include "soms/scene/detail/search/nearest_body.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace soms::detail {

namespace {

BodyHit first(BodySets sets, const Ray& line, const RayOptions& options, LeftOut left_out,
              const Limits& limits, SearchMemory& memory) {
  const LineQuestion question(line, options, left_out, limits);
  NearestBody nearest(question);
  nearest.run(sets, memory);
  BodyHit answer;
  if (nearest.found()) {
    answer = *nearest.found();
  }
  answer.coverage = Coverage::complete;
  if (nearest.cut()) {
    answer.coverage = Coverage::cut;
    answer.t.lower = std::min(answer.t.lower, nearest.at_least());
  }
  answer.cost = nearest.cost();
  return answer;
}

AnyHit any(BodySets sets, const Ray& line, const RayOptions& options, LeftOut left_out,
           const Limits& limits, SearchMemory& memory) {
  const LineQuestion question(line, options, left_out, limits);
  double limit = question.limit();
  AnyHit answer;
  answer.cost.node_tests += for_each_near_body(
      sets, [&](const Box& box) { return question.key(box); }, limit, memory,
      [&](const Body& body, std::uint32_t number, double /*key*/) {
        const AnyHit here = question.ask_any(body, number);
        answer.hit = here.hit;
        answer.coverage = here.coverage;
        answer.cost += here.cost;
        if (here.hit || here.coverage == Coverage::cut) {
          limit = -std::numeric_limits<double>::infinity();
        }
        return limit;
      });
  return answer;
}

/// `ask(line, memory)` for each line, shared by threads, instead of what `batch` has.
template <Described Answer, class Ask>
BatchOf<Answer> for_all(std::span<const Ray> lines, const Limits& limits, BatchOf<Answer> batch,
                        const Ask& ask) {
  for_each_block(
      lines.size(), limits, [] { return SearchMemory(); },
      [&](SearchMemory& memory, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          put_columns(ask(lines[i], memory), i, batch);
        }
      });
  sum_costs<Answer>(batch);
  return batch;
}

}  // namespace

void check_left_out(BodySets sets, const RayOptions& options, LeftOut left_out) {
  check_left_out(sets, left_out);
  if (!options.skip) {
    return;
  }
  if (!left_out) {
    throw Error(ErrorKind::usage, "ray options: a triangle to skip is of no body",
                "name the body as the one to leave out: only its triangle is then");
  }
  const std::size_t count = body_of(sets, *left_out).shape.mesh().triangles.size();
  if (*options.skip >= count) {
    throw Error(ErrorKind::usage,
                "ray options: body " + std::to_string(*left_out) + " has no triangle " +
                    std::to_string(*options.skip) + " to skip",
                "triangles are numbered from 0");
  }
}

BodyHit closest_hit(BodySets sets, const Ray& line, const RayOptions& options, LeftOut left_out,
                    const Limits& limits) {
  const PlainArithmetic plain;
  check_left_out(sets, options, left_out);
  static_cast<void>(soms::closest_hit(Body(), line));  // all but checks
  SearchMemory memory;
  return first(sets, line, options, left_out, limits, memory);
}

AnyHit any_hit(BodySets sets, const Ray& line, const RayOptions& options, LeftOut left_out,
               const Limits& limits) {
  const PlainArithmetic plain;
  check_left_out(sets, options, left_out);
  static_cast<void>(soms::any_hit(Body(), line));  // all but checks
  SearchMemory memory;
  return any(sets, line, options, left_out, limits, memory);
}

// What a body without triangles answers is checked, and its columns are of the right size.

BodyHitBatch closest_hit(BodySets sets, std::span<const Ray> lines, const RayOptions& options,
                         LeftOut left_out, const Limits& limits) {
  const PlainArithmetic plain;
  check_left_out(sets, options, left_out);
  BodyHitBatch batch{soms::closest_hit(Body(), lines, {}, limits), {}};
  batch.body.resize(lines.size());
  const Limits alone = limits.alone();
  return for_all<BodyHit>(lines, limits, std::move(batch),
                          [&](const Ray& line, SearchMemory& memory) {
                            return first(sets, line, options, left_out, alone, memory);
                          });
}

AnyHitBatch any_hit(BodySets sets, std::span<const Ray> lines, const RayOptions& options,
                    LeftOut left_out, const Limits& limits) {
  const PlainArithmetic plain;
  check_left_out(sets, options, left_out);
  AnyHitBatch batch = soms::any_hit(Body(), lines, {}, limits);
  const Limits alone = limits.alone();
  return for_all<AnyHit>(lines, limits, std::move(batch),
                         [&](const Ray& line, SearchMemory& memory) {
                           return any(sets, line, options, left_out, alone, memory);
                         });
}

}  // namespace soms::detail
