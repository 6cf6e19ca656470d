/// \file
/// What queries of points and rays say of many bodies: the answers of single bodies, and which body
/// each is about. `BodyIndex` and `Scene` have the same ones; they differ in how they name a body.
#pragma once

#include "soms/describe/columns.h"
#include "soms/describe/fields.h"
#include "soms/query/closest.h"
#include "soms/query/ray.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace soms {

namespace detail {

template <class Answer>
concept AnswerWithBatch = requires {
  typename Fields<Answer>::Batch;
};

template <class Answer>
concept ListOfAnswers = !AnswerWithBatch<Answer>;

/// Columns of answers that each have an entry.
template <class Answer>
concept AnswersInColumns = requires(const Answer& answers) {
  answers.at(0);
};

/// One name, where there is one; a column of such; or a column of names, one for each crossing.
template <class Answer, class Name>
using NamesOf = std::conditional_t<
    AnswerWithBatch<Answer>, std::optional<Name>,
    std::vector<std::conditional_t<AnswersInColumns<Answer>, std::optional<Name>, Name>>>;

}  // namespace detail

/// An answer about many bodies: that of the body that it names. `Answer` is what a query of a
/// single body returns: Closest, ClosestHit, a batch of either, or AllHits. `Name` is what a body
/// is called by.
///
/// The nearest point is `farther` where those of all bodies are. The bracket of a single answer is
/// [infinity, infinity] where no body has a triangle, or none is hit. A crossing of AllHits is of
/// one body.
template <class Answer, class Name>
struct OfBodies : Answer {
  /// Which body: the least name among the bodies at exactly this distance or t. Nothing where no
  /// triangle is named. n of a batch, m of AllHits.
  detail::NamesOf<Answer, Name> body = {};

  [[nodiscard]] bool operator==(const OfBodies&) const = default;

  /// The answer for an entry of a batch.
  [[nodiscard]] auto at(std::size_t entry) const requires detail::AnswersInColumns<Answer> {
    using Single = decltype(std::declval<const Answer&>().at(0));
    return row_of<OfBodies<Single, Name>>(*this, entry);
  }
};

/// What channels call an answer about many bodies and what it means, then its batch.
template <class Answer, class Name>
inline constexpr std::array<const char*, 4> kNamesOfBodies = {};

template <detail::AnswerWithBatch Answer, class Name>
struct Fields<OfBodies<Answer, Name>> {
  static constexpr const char* kName = kNamesOfBodies<Answer, Name>[0];
  static constexpr const char* kMeaning = kNamesOfBodies<Answer, Name>[1];
  static constexpr const char* kBatchName = kNamesOfBodies<Answer, Name>[2];
  static constexpr const char* kBatchMeaning = kNamesOfBodies<Answer, Name>[3];
  static constexpr const char* kRows = Fields<Answer>::kRows;
  using Base = Answer;
  using Batch = OfBodies<typename Fields<Answer>::Batch, Name>;
  static constexpr auto kList =
      std::tuple(field("body", &OfBodies<Answer, Name>::body, &Batch::body, "Which body it is."));
};

template <class Name>
struct Fields<OfBodies<AllHits, Name>> {
  static constexpr const char* kName = kNamesOfBodies<AllHits, Name>[0];
  static constexpr const char* kMeaning = kNamesOfBodies<AllHits, Name>[1];
  using Base = AllHits;
  static constexpr auto kList =
      std::tuple(list("body", &OfBodies<AllHits, Name>::body, "m", "The body of each crossing."));
};

/// The answers of a BodyIndex name a body by its number.
using BodyClosest = OfBodies<Closest, std::uint32_t>;
using BodyClosestBatch = OfBodies<ClosestBatch, std::uint32_t>;
using BodyHit = OfBodies<ClosestHit, std::uint32_t>;
using BodyHitBatch = OfBodies<ClosestHitBatch, std::uint32_t>;
using BodyAllHits = OfBodies<AllHits, std::uint32_t>;

template <>
inline constexpr std::array<const char*, 4> kNamesOfBodies<Closest, std::uint32_t> = {
    "BodyClosest", "Answer of closest about a BodyIndex.", "BodyClosestBatch",
    "Answers of closest about a BodyIndex."};
template <>
inline constexpr std::array<const char*, 4> kNamesOfBodies<ClosestHit, std::uint32_t> = {
    "BodyHit", "Answer of closest_hit about a BodyIndex.", "BodyHitBatch",
    "Answers of closest_hit about a BodyIndex."};
template <>
inline constexpr std::array<const char*, 4> kNamesOfBodies<AllHits, std::uint32_t> = {
    "BodyAllHits", "All places where n rays meet many bodies."};

}  // namespace soms
