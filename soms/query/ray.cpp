#include "soms/query/ray.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/describe/columns.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/ray/ray_line.h"
#include "soms/query/detail/ray/ray_traversal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

namespace soms {

namespace {

using detail::line_of;
using detail::RayFrame;
using detail::RayLine;

/// Rays that a thread takes at a time: some hundred microseconds' work.
constexpr std::size_t kRaysOfBlock = 1024;

/// "ray 3", or "ray" of a single one.
std::string name_of(const char* what, std::optional<std::size_t> index) {
  std::string name = what;
  if (index) {
    name += " ";
    name += std::to_string(*index);
  }
  return name;
}

void check_place(const Vec3& p, const char* what, const char* which,
                 std::optional<std::size_t> index) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::abs(p[axis]) <= kMaxCoordinate) {
      continue;
    }
    const std::string place = name_of(what, index) + ": " + which + " " + "xyz"[axis];
    if (std::isfinite(p[axis])) {
      throw Error(ErrorKind::out_of_range, place + " is beyond 2^300",
                  "use a larger unit of length");
    }
    throw Error(ErrorKind::not_finite, place + " is not a finite number",
                "give three finite coordinates");
  }
}

void check_one(const Ray& ray, std::optional<std::size_t> index) {
  if (ray.end) {
    check_place(ray.origin, "segment", "start", index);
    check_place(*ray.end, "segment", "end", index);
    return;
  }
  check_place(ray.origin, "ray", "origin", index);
  const Vec3& d = ray.direction;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(d[axis])) {
      throw Error(ErrorKind::not_finite,
                  name_of("ray", index) + ": direction " + "xyz"[axis] + " is not a finite number",
                  "give three finite components");
    }
  }
  if (d == Vec3{}) {
    throw Error(ErrorKind::usage, name_of("ray", index) + ": the direction is zero",
                "give a direction, or use a segment");
  }
  if (!(ray.length >= 0)) {
    throw Error(ErrorKind::usage,
                name_of("ray", index) + ": the length is negative or not a number",
                "give a length of 0 or more, or infinity");
  }
}

void check_body(const Body& body, const RayOptions& options) {
  detail::check_pose(body.pose, body.shape);
  const std::size_t count = body.shape.mesh().triangles.size();
  if (options.skip && *options.skip >= count) {
    throw Error(ErrorKind::usage,
                "ray options: skip names triangle " + std::to_string(*options.skip) +
                    ", the mesh has " + std::to_string(count),
                "give a triangle of the mesh");
  }
}

/// Answers rays by one goal, in chunks on any thread. `take(begin, answers)` is called
/// for each chunk.
template <class Goal, class Take>
void answer_all(const Body& body, std::span<const Ray> rays, const RayOptions& options,
                const Limits& limits, const Take& take) {
  check_stop(limits);
  std::optional<RayFrame> frame;
  if (!detail::is_empty(body.shape)) {
    frame.emplace(body.shape.layout(), body.pose);
  }

  struct Memory {
    std::unique_ptr<detail::RayMemory<Goal>> rays;
    std::vector<RayLine> lines;
    std::vector<typename Goal::Answer> answers;
  };

  detail::MemoryPool<Memory> pool;
  for_each_chunk(
      rays.size(), kRaysOfBlock, limits.without_deadline(),
      [&](std::size_t begin, std::size_t end) {
        auto place = pool.take([&] {
          return Memory{
              frame ? detail::ray_memory<Goal>(body, *frame, options.skip) : nullptr, {}, {}};
        });
        Memory& memory = place->memory;
        memory.answers.assign(end - begin, {});
        memory.lines.clear();
        for (std::size_t i = begin; i < end; ++i) {
          memory.lines.push_back(line_of(rays[i]));
        }
        if (memory.rays) {
          detail::Limit limit(limits);
          memory.rays->answer(memory.lines, memory.answers, limit);
        } else {
          for (auto& answer : memory.answers) {
            answer.coverage = Coverage::complete;
          }
        }
        take(begin, std::span(memory.answers));
        pool.give_back(std::move(place));
      });
}

void check_all(const Body& body, std::span<const Ray> rays, const RayOptions& options) {
  check_body(body, options);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    check_one(rays[i], i);
  }
}

/// The answer for one ray.
template <class Goal>
typename Goal::Answer answer_one(const Body& body, const Ray& ray, const RayOptions& options,
                                 const Limits& limits) {
  const PlainArithmetic plain;
  check_body(body, options);
  check_one(ray, std::nullopt);
  if (detail::is_empty(body.shape)) {
    typename Goal::Answer answer;
    answer.coverage = Coverage::complete;
    return answer;
  }
  detail::Limit limit(limits);
  return detail::answer_ray<Goal>(body, options.skip, line_of(ray), limit);
}

template <class Goal>
BatchOf<typename Goal::Answer> batch_of(const Body& body, std::span<const Ray> rays,
                                        const RayOptions& options, const Limits& limits) {
  using Answer = typename Goal::Answer;
  const PlainArithmetic plain;
  check_all(body, rays, options);
  BatchOf<Answer> batch;
  resize_columns<Answer>(batch, rays.size());
  answer_all<Goal>(body, rays, options, limits,
                   [&](std::size_t i, std::span<const Answer> answers) {
                     for (const Answer& answer : answers) {
                       put_columns(answer, i++, batch);
                     }
                   });
  sum_costs<Answer>(batch);
  return batch;
}

/// Appends one ray's row.
void append_row(const detail::AllHitsGoal::Answer& answer, AllHits& hits) {
  for (const detail::FoundCrossing& crossing : answer.row.crossings) {
    hits.lower.push_back(crossing.t.lower);
    hits.upper.push_back(crossing.t.upper);
    hits.kind.push_back(crossing.kind);
    hits.triangle_offsets.push_back(hits.triangle_offsets.back() + crossing.triangles);
  }
  detail::append(hits.triangle, answer.row.triangles);
  hits.offsets.push_back(hits.lower.size());
  hits.coverage.push_back(answer.coverage);
  hits.costs.push_back(answer.cost);
}

/// Appends the rows of a chunk.
void append_rows_of(const AllHits& part, AllHits& hits) {
  detail::append_rows(hits.offsets, hits.lower, part.offsets, part.lower);
  detail::append(hits.upper, part.upper);
  detail::append(hits.kind, part.kind);
  detail::append_rows(hits.triangle_offsets, hits.triangle, part.triangle_offsets, part.triangle);
  detail::append(hits.coverage, part.coverage);
  detail::append(hits.costs, part.costs);
}

AllHits all_of(const Body& body, std::span<const Ray> rays, const RayOptions& options,
               const Limits& limits) {
  const PlainArithmetic plain;
  check_all(body, rays, options);
  std::vector<AllHits> parts((rays.size() + kRaysOfBlock - 1) / kRaysOfBlock);
  answer_all<detail::AllHitsGoal>(
      body, rays, options, limits,
      [&](std::size_t begin, std::span<const detail::AllHitsGoal::Answer> answers) {
        for (const auto& answer : answers) {
          append_row(answer, parts[begin / kRaysOfBlock]);
        }
      });
  AllHits hits;
  for (const AllHits& part : parts) {
    append_rows_of(part, hits);
  }
  hits.cost = detail::sum_of(hits.costs);
  return hits;
}

}  // namespace

ClosestHit closest_hit(const Body& body, const Ray& ray, const RayOptions& options,
                       const Limits& limits) {
  return answer_one<detail::ClosestHitGoal>(body, ray, options, limits);
}

ClosestHit ClosestHitBatch::at(std::size_t i) const {
  return row_of<ClosestHit>(*this, i);
}

ClosestHitBatch closest_hit(const Body& body, std::span<const Ray> rays, const RayOptions& options,
                            const Limits& limits) {
  return batch_of<detail::ClosestHitGoal>(body, rays, options, limits);
}

AnyHit any_hit(const Body& body, const Ray& ray, const RayOptions& options, const Limits& limits) {
  return answer_one<detail::AnyHitGoal>(body, ray, options, limits);
}

AnyHit AnyHitBatch::at(std::size_t i) const {
  return row_of<AnyHit>(*this, i);
}

AnyHitBatch any_hit(const Body& body, std::span<const Ray> rays, const RayOptions& options,
                    const Limits& limits) {
  return batch_of<detail::AnyHitGoal>(body, rays, options, limits);
}

bool sees(const Body& body, const Vec3& a, const Vec3& b) {
  return !any_hit(body, Ray::between(a, b)).hit;
}

AllHits all_hits(const Body& body, std::span<const Ray> rays, const RayOptions& options,
                 const Limits& limits) {
  return all_of(body, rays, options, limits);
}

}  // namespace soms
