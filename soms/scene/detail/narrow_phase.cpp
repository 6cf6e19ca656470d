#include "soms/scene/detail/narrow_phase.h"

#include "soms/base/parallel.h"
#include "soms/scene/detail/kept_memory.h"

#include <algorithm>
#include <utility>

namespace soms::detail {

namespace {

/// Questions that one thread takes at a time: enough for a batch, few enough that no thread is left
/// with most of the work. Depends on the questions alone, as answers are joined by chunks.
std::size_t chunk_of(std::size_t questions) {
  return std::clamp<std::size_t>(questions / 16, 1, 64);
}

Overlap ask_pair(const BodyPair& question, const PairQuery& query, const Limits& limits) {
  const auto& [mover, other] = question;
  if (query.method == nullptr) {
    return overlap(*mover, *other, query.options, limits);
  }
  const Pose* const pose = &mover->pose;
  OverlapBatch batch =
      query.method->ask(mover->shape, std::span(&pose, 1), *other, query.options, limits);
  return {batch.any[0] != 0, std::move(batch.pairs), batch.coverage[0], batch.costs[0]};
}

}  // namespace

NarrowPhase::NarrowPhase() = default;
NarrowPhase::~NarrowPhase() = default;
NarrowPhase::NarrowPhase(NarrowPhase&&) noexcept = default;
NarrowPhase& NarrowPhase::operator=(NarrowPhase&&) noexcept = default;

void NarrowPhase::order_by_shape(std::span<const BodyPair> questions) {
  const std::size_t count = questions.size();
  numbers_.clear();
  shapes_.resize(count);
  ends_.clear();
  for (std::size_t k = 0; k < count; ++k) {
    const auto next = static_cast<std::uint32_t>(ends_.size());
    const WideTree& layout = questions[k].mover->shape.layout();
    shapes_[k] = numbers_.try_emplace(&layout, next).first->second;
    if (shapes_[k] == next) {
      ends_.push_back(0);
    }
    ++ends_[shapes_[k]];
  }
  std::uint32_t end = 0;
  for (std::uint32_t& number : ends_) {
    end += std::exchange(number, end);
  }
  places_.resize(count);
  ordered_.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    places_[k] = ends_[shapes_[k]]++;
    ordered_[places_[k]] = questions[k];
  }
}

/// The batches of a chunk, in the order in which each begins. `memory` is reused.
std::span<NarrowPhase::Batch> NarrowPhase::gather(std::span<const BodyPair> questions,
                                                  std::vector<Batch>& memory) {
  std::size_t count = 0;
  for (std::uint32_t k = 0; k < questions.size(); ++k) {
    const Body& mover = *questions[k].mover;
    const WideTree* const layout = &mover.shape.layout();
    std::size_t at = 0;
    while (at < count && (memory[at].layout != layout || memory[at].other != questions[k].other)) {
      ++at;
    }
    if (at == count) {
      if (++count > memory.size()) {
        memory.emplace_back();
      }
      memory[at].layout = layout;
      memory[at].other = questions[k].other;
      memory[at].questions.clear();
      memory[at].poses.clear();
    }
    memory[at].questions.push_back(k);
    memory[at].poses.push_back(&mover.pose);
  }
  return std::span(memory).first(count);
}

void NarrowPhase::ask_one_by_one(std::span<const BodyPair> questions, const PairQuery& query,
                                 const Limits& limits, Chunk& chunk) {
  chunk.alone.clear();
  for (const BodyPair& question : questions) {
    chunk.alone.push_back(ask_pair(question, query, limits));
    chunk.cost += chunk.alone.back().cost;
  }
  for (const Overlap& answer : chunk.alone) {
    chunk.answers.emplace_back(answer.pairs);
  }
}

/// By batches, which is faster where movers share shapes.
void NarrowPhase::ask_together(std::span<const BodyPair> questions, const PairQuery& query,
                               const Limits& limits, Chunk& chunk) {
  chunk.alone.clear();
  chunk.answers.resize(questions.size());
  OverlapRun run;
  for (Batch& batch : gather(questions, chunk.batches)) {
    if (batch.questions.size() == 1) {
      const std::uint32_t k = batch.questions[0];
      chunk.alone.push_back(ask_pair(questions[k], query, limits));
      chunk.answers[k] = chunk.alone.back().pairs;  // stays where it is when `alone` grows
      chunk.cost += chunk.alone.back().cost;
      continue;
    }
    const Shape& shape = questions[batch.questions[0]].mover->shape;
    if (query.method != nullptr) {
      batch.answers = query.method->ask(shape, batch.poses, *batch.other, query.options, limits);
    } else {
      run.ask(shape, batch.poses, *batch.other, query.options, limits, batch.answers);
    }
    for (std::size_t p = 0; p < batch.questions.size(); ++p) {
      chunk.answers[batch.questions[p]] = batch.answers.pairs_of(p);
    }
    chunk.cost += batch.answers.cost;
  }
}

Cost NarrowPhase::ask(std::span<const BodyPair> questions, const PairQuery& query,
                      const Limits& limits) {
  order_by_shape(questions);
  chunk_ = chunk_of(questions.size());
  const std::size_t count = (questions.size() + chunk_ - 1) / chunk_;
  if (chunks_.size() < count) {
    chunks_.resize(count);
  }
  // A single pair of large meshes is split inside; many pairs are shared out. Where one pair will
  // do, which one would depend on the threads inside.
  const bool few = questions.size() < kFewQuestions;
  const bool split = few && query.options.mode == OverlapMode::all;
  const Limits whole = limits.silent();
  const Limits shared = split ? whole.alone() : whole;
  const Limits inside = (split ? whole : whole.alone()).without_deadline();  // no pair is cut
  for_each_chunk(questions.size(), chunk_, shared, [&](std::size_t begin, std::size_t end) {
    Chunk& chunk = chunks_[begin / chunk_];
    chunk.answers.clear();
    chunk.cost = {};
    const std::span part = std::span<const BodyPair>(ordered_).subspan(begin, end - begin);
    if (few) {
      ask_one_by_one(part, query, inside, chunk);
    } else {
      ask_together(part, query, inside, chunk);
    }
  });
  Cost cost;
  for (std::size_t k = 0; k < count; ++k) {
    cost += chunks_[k].cost;
  }
  return cost;
}

std::span<const TrianglePair> NarrowPhase::pairs_of(std::size_t k) const {
  const std::size_t place = places_[k];
  return chunks_[place / chunk_].answers[place % chunk_];
}

std::size_t NarrowPhase::memory() const {
  std::size_t size = numbers_.size() * (sizeof(*numbers_.begin()) + 2 * sizeof(void*)) +
                     numbers_.bucket_count() * sizeof(void*) + bytes(shapes_) + bytes(ends_) +
                     bytes(places_) + bytes(ordered_) + bytes(chunks_);
  for (const Chunk& chunk : chunks_) {
    size += bytes(chunk.batches) + bytes(chunk.alone) + bytes(chunk.answers);
    for (const Overlap& answer : chunk.alone) {
      size += bytes(answer.pairs);
    }
    for (const Batch& batch : chunk.batches) {
      const OverlapBatch& answers = batch.answers;
      size += bytes(batch.questions) + bytes(batch.poses) + bytes(answers.any) +
              bytes(answers.coverage) + bytes(answers.offsets) + bytes(answers.pairs) +
              bytes(answers.costs);
    }
  }
  return size;
}

}  // namespace soms::detail
