#include "soms/query/detail/self/neighbors.h"

#include "soms/query/detail/self/neighbor_overlap.h"

#include <bit>

namespace soms::detail {

namespace {

constexpr CommonPlace place_of(std::uint32_t common) {
  using Kind = CommonPlace::Kind;
  std::uint32_t rows = 0;
  std::uint32_t columns = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      if ((common >> (3 * i + k) & 1U) != 0) {
        if ((rows >> i & 1U) != 0 || (columns >> k & 1U) != 0) {
          return {Kind::unclear, 0, 0};
        }
        rows |= 1U << i;
        columns |= 1U << k;
      }
    }
  }
  switch (std::popcount(rows)) {
    case 0:
      return {Kind::nothing, 0, 0};
    case 1:
      return {Kind::corner, static_cast<std::uint8_t>(std::countr_zero(rows)),
              static_cast<std::uint8_t>(std::countr_zero(columns))};
    case 2:
      return {Kind::edge, static_cast<std::uint8_t>(std::countr_one(rows)),
              static_cast<std::uint8_t>(std::countr_one(columns))};
    default:
      return {Kind::duplicate, 0, 0};
  }
}

struct CommonPlaces {
  std::array<CommonPlace, 512> entries;

  constexpr CommonPlaces() {
    for (std::uint32_t common = 0; common < entries.size(); ++common) {
      entries[common] = place_of(common);
    }
  }
};

constexpr CommonPlaces kPlaces;

}  // namespace

const CommonPlace& common_place(std::uint32_t common) {
  return kPlaces.entries[common];
}

Neighbors::Set::Set(const CornerNames& corners) {
  for (const std::uint32_t name : corners) {
    if (!has(name)) {
      add(name);
    }
  }
}

bool Neighbors::Set::has(std::uint32_t name) const {
  for (std::uint32_t i = 0; i < count; ++i) {
    if (names[i] == name) {
      return true;
    }
  }
  return false;
}

Neighbors::Neighbors(const CornerNames& a, const CornerNames& b) {
  const Set of_a(a);
  const Set of_b(b);
  for (std::uint32_t i = 0; i < of_a.count; ++i) {
    (of_b.has(of_a.names[i]) ? common_ : own_a_).add(of_a.names[i]);
  }
  for (std::uint32_t i = 0; i < of_b.count; ++i) {
    if (!of_a.has(of_b.names[i])) {
      own_b_.add(of_b.names[i]);
    }
  }
}

bool Neighbors::share_more(std::span<const Vec3> vertices) const {
  if (own_a_.count == 0 || own_b_.count == 0) {
    // One of them is the hull of the common corners.
    return false;
  }
  const Vec3& v = vertices[common_.names[0]];
  const Vec3& p = vertices[own_a_.names[0]];
  const Vec3& r = vertices[own_b_.names[0]];
  return common_.count == 2
             ? share_beyond_edge(v, vertices[common_.names[1]], p, r)
             : share_beyond_corner(v, p, vertices[own_a_.last()], r, vertices[own_b_.last()]);
}

}  // namespace soms::detail
