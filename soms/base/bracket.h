/// \file
/// Two doubles that enclose a real number.
#pragma once

namespace soms {

/// A closed interval of doubles that holds the number meant. As the answer of a complete query it
/// is the narrowest one. `lower` is the largest double that is not above the number and `upper` the
/// least that is not below it, so they are equal or neighbors.
struct Bracket {
  double lower = 0;
  double upper = 0;

  [[nodiscard]] bool operator==(const Bracket&) const = default;
};

}  // namespace soms
