#include "apps/report/packed.h"

#include <cmath>
#include <vector>

namespace soms::report {

namespace {

using Multiples = std::array<std::int64_t, 3>;

Multiples multiples_of(const Vec3& v, double step) {
  return {std::llround(v.x / step), std::llround(v.y / step), std::llround(v.z / step)};
}

void put_difference(Base64Writer& data, const Multiples& now, const Multiples& before) {
  for (std::size_t axis = 0; axis < now.size(); ++axis) {
    put_signed(data, now[axis] - before[axis]);
  }
}

}  // namespace

void put_unsigned(Base64Writer& data, std::uint64_t value) {
  for (; value >= 0x80U; value >>= 7U) {
    data.put(static_cast<std::uint8_t>((value & 0x7fU) | 0x80U));
  }
  data.put(static_cast<std::uint8_t>(value));
}

void put_signed(Base64Writer& data, std::int64_t value) {
  const auto twice = static_cast<std::uint64_t>(value) << 1U;
  put_unsigned(data, value < 0 ? ~twice : twice);
}

double step_of(double size, int bits) {
  // A page's sizes lie between 2^-1000 and 2^1000, so that no step is 0 or infinite.
  return size > 0 ? std::exp2(std::ceil(std::log2(size)) - bits) : 1;
}

void put_mesh(Base64Writer& data, const DrawnMesh& mesh, double step) {
  constexpr std::uint64_t kNew = ~std::uint64_t{0};
  std::vector<std::uint64_t> number(mesh.vertices.size() / 3, kNew);
  std::uint64_t count = 0;
  Multiples before{};
  for (const std::uint32_t index : mesh.indices) {
    if (number[index] != kNew) {
      put_unsigned(data, count - number[index]);
      continue;
    }
    number[index] = count++;
    const float* const at = &mesh.vertices[3 * std::size_t{index}];
    const Multiples now = multiples_of({at[0], at[1], at[2]}, step);
    put_unsigned(data, 0);
    put_difference(data, now, before);
    before = now;
  }
}

void put_points(Base64Writer& data, std::span<const Vec3> points, double step) {
  Multiples before{};
  for (const Vec3& point : points) {
    const Multiples now = multiples_of(point, step);
    put_difference(data, now, before);
    before = now;
  }
}

void put_lines(Base64Writer& data, std::span<const std::array<Vec3, 2>> lines, const Vec3& place,
               double step) {
  Multiples before{};
  for (const auto& [from, to] : lines) {
    const Multiples start = multiples_of(from - place, step);
    put_difference(data, start, before);
    put_difference(data, multiples_of(to - place, step), start);
    before = start;
  }
}

void PackedPath::put(const Vec3& place, std::array<double, 4> turn) {
  double along = 0;
  for (std::size_t k = 0; k < turn.size(); ++k) {
    along += turn[k] * static_cast<double>(before_[3 + k]);
  }
  const Multiples at = multiples_of(place, step_);
  for (std::size_t k = 0; k < before_.size(); ++k) {
    const std::int64_t now =
        k < 3 ? at[k] : std::llround((along < 0 ? -turn[k - 3] : turn[k - 3]) * kTurns);
    const std::int64_t change = now - before_[k];
    put_signed(data_, change - change_[k]);
    change_[k] = begun_ ? change : 0;
    before_[k] = now;
  }
  begun_ = true;
}

}  // namespace soms::report
