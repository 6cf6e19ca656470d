/// \file
/// The order of comparisons where each mover is done at its first contact.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// A pair of bodies, by places in the lists of the scene.
struct Candidate {
  std::uint32_t mover = 0;
  std::uint32_t other = 0;

  [[nodiscard]] auto operator<=>(const Candidate&) const = default;
};

/// Rounds of comparisons. In each round every mover that touches nothing yet has the first of its
/// candidates compared that was not compared before, so a mover is compared with no more bodies
/// than if it went through its candidates alone and stopped at the first contact; and no pair is
/// compared twice. Which pairs a round compares depends on the rounds before it, not on threads.
class FirstContacts {
 public:
  /// Forgets which of the movers, in so many places, touch something.
  void start(std::size_t movers);

  /// Begins with new candidates, sorted; the span must last until the rounds are over. `mutual`:
  /// `other` is a mover, too, for which the pair counts as well.
  void begin(std::span<const Candidate> candidates, bool mutual);

  /// Numbers of the candidates to compare now, none twice; none at all when the rounds are over.
  /// The span is valid until the next call.
  [[nodiscard]] std::span<const std::uint32_t> next_round();

  /// The bodies of candidate `k`, of the last round, touch.
  void touch(std::uint32_t k);

  /// Gives back memory that is far more than the last step needed.
  void give_back();

  [[nodiscard]] std::size_t memory() const;

 private:
  std::span<const Candidate> candidates_;
  bool mutual_ = false;
  std::uint32_t round_ = 0;
  std::vector<std::uint8_t> touching_;  ///< of each mover
  std::vector<std::size_t> ends_;       ///< of each mover's candidates in `lists_`
  std::vector<std::size_t> next_;       ///< of each mover: first not known to be compared
  std::vector<std::uint32_t> lists_;    ///< candidates, ascending for each mover
  std::vector<std::uint32_t> rounds_;   ///< of each candidate: when it was compared; 0: not yet
  std::vector<std::uint32_t> active_;   ///< movers that still have candidates
  std::vector<std::uint32_t> now_;      ///< candidates of this round
  std::size_t most_candidates_ = 0;     ///< of this step
};

}  // namespace soms::detail
