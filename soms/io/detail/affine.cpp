#include "soms/io/detail/affine.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

Vec3 Affine::apply(const Vec3& p) const {
  return {((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3],
          ((m[4] * p.x + m[5] * p.y) + m[6] * p.z) + m[7],
          ((m[8] * p.x + m[9] * p.y) + m[10] * p.z) + m[11]};
}

bool Affine::mirrors() const {
  const auto row = [&](std::size_t i) {
    const Vec3 r{m[4 * i], m[4 * i + 1], m[4 * i + 2]};
    // Rows of any size: only the sign of the determinant counts.
    const double largest = std::max({std::abs(r.x), std::abs(r.y), std::abs(r.z)});
    return largest > 0 ? Vec3{r.x / largest, r.y / largest, r.z / largest} : r;
  };
  return dot(cross(row(0), row(1)), row(2)) < 0;
}

Affine operator*(const Affine& a, const Affine& b) {
  Affine product;
  for (std::size_t i = 0; i < 12; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) {
      product.m[i + k] = ((a.m[i] * b.m[k] + a.m[i + 1] * b.m[k + 4]) + a.m[i + 2] * b.m[k + 8]) +
                         (k == 3 ? a.m[i + 3] : 0);
    }
  }
  return product;
}

}  // namespace soms::detail
