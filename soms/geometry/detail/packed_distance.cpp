#include "soms/geometry/detail/packed_distance.h"

#include <span>

namespace soms::detail {

PackedDistance::PackedDistance(const SquaredDistance& squared)
    : of_numerator_(static_cast<std::uint32_t>(squared.numerator.size())),
      exponent_(squared.exponent) {
  words_.reserve(squared.numerator.size() + squared.denominator.size());
  for (const Integer* number : {&squared.numerator, &squared.denominator}) {
    for (std::size_t i = 0; i < number->size(); ++i) {
      words_.push_back(number->word(i));
    }
  }
}

SquaredDistance PackedDistance::unpacked() const {
  const std::span<const std::uint64_t> words(words_);
  return {Integer(words.first(of_numerator_)), Integer(words.subspan(of_numerator_)), exponent_};
}

}  // namespace soms::detail
