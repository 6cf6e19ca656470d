/// \file
/// Many pairs of bodies queried in one call.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/body.h"
#include "soms/query/detail/overlap_run.h"
#include "soms/query/overlap.h"
#include "soms/query/overlap_method.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace soms::detail {

/// Which triangles of two bodies touch? Bodies stay where they are until it is answered; their
/// poses have passed their checks.
struct BodyPair {
  const Body* mover = nullptr;
  const Body* other = nullptr;
};

/// Fewer questions than this are each worth all threads.
inline constexpr std::size_t kFewQuestions = 4;

/// The question about every pair, and what answers it if not `overlap`.
struct PairQuery {
  OverlapOptions options = {};
  const OverlapMethod* method = nullptr;
};

/// Brings questions about the same shape together, asks them as batches on the threads given, and
/// hands out the answers in the order of the questions. Keeps its memory from call to call.
class NarrowPhase {
 public:
  NarrowPhase();
  ~NarrowPhase();  // in its source: clang 14 for WebAssembly calls an implicit one that it leaves
                   // out
  NarrowPhase(NarrowPhase&&) noexcept;
  NarrowPhase& operator=(NarrowPhase&&) noexcept;

  /// Answers depend on each question alone. \errors As `overlap`.
  Cost ask(std::span<const BodyPair> questions, const PairQuery& query, const Limits& limits);

  /// Pairs of question `k` of the last call.
  [[nodiscard]] std::span<const TrianglePair> pairs_of(std::size_t k) const;

  [[nodiscard]] std::size_t memory() const;

 private:
  /// Questions of one chunk about the same shape and the same other body.
  struct Batch {
    const WideTree* layout = nullptr;
    const Body* other = nullptr;
    std::vector<std::uint32_t> questions;
    std::vector<const Pose*> poses;
    OverlapBatch answers;
  };

  /// One chunk of questions and its answers.
  struct Chunk {
    std::vector<Batch> batches;
    std::vector<Overlap> alone;
    std::vector<std::span<const TrianglePair>> answers;  ///< of each question
    Cost cost;
  };

  void order_by_shape(std::span<const BodyPair> questions);
  [[nodiscard]] static std::span<Batch> gather(std::span<const BodyPair> questions,
                                               std::vector<Batch>& memory);
  static void ask_one_by_one(std::span<const BodyPair> questions, const PairQuery& query,
                             const Limits& limits, Chunk& chunk);
  static void ask_together(std::span<const BodyPair> questions, const PairQuery& query,
                           const Limits& limits, Chunk& chunk);

  std::unordered_map<const WideTree*, std::uint32_t> numbers_;  ///< of shapes, as they come
  std::vector<std::uint32_t> shapes_;                           ///< of each question
  std::vector<std::uint32_t> ends_;    ///< of each shape's questions in the order of asking
  std::vector<std::uint32_t> places_;  ///< of each question in that order
  std::vector<BodyPair> ordered_;      ///< the questions in that order
  std::size_t chunk_ = 1;              ///< questions of a chunk
  std::vector<Chunk> chunks_;
};

}  // namespace soms::detail
