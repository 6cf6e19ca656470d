#include "soms/io/detail/json_numbers.h"

#include <cmath>

namespace soms::detail {

Affine json_matrix(const JsonValue& list) {
  const std::array<double, 16> c = json_numbers<16>(list);
  constexpr double kRoundedAway = 1e-6;
  if (std::abs(c[3]) > kRoundedAway || std::abs(c[7]) > kRoundedAway ||
      std::abs(c[11]) > kRoundedAway || std::abs(c[15] - 1) > kRoundedAway) {
    list.fail("the last row is not 0 0 0 1");
  }
  return {{c[0], c[4], c[8], c[12], c[1], c[5], c[9], c[13], c[2], c[6], c[10], c[14]}};
}

}  // namespace soms::detail
