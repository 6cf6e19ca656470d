#include "soms/io/detail/collada/collada_transform.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace soms::detail {

namespace {

using Reading = Affine (*)(const ColladaDocument&, pugi::xml_node);

/// Cosine and sine of an angle in degrees: multiples of 90 give 0 and 1 to the last bit, and others
/// the same bits on every machine, which mathematical libraries do not.
std::pair<double, double> cosine_and_sine(double degrees) {
  const double turn = std::remainder(degrees, 360.0);  // both remainders are exact
  const double rest = std::remainder(turn, 90.0);
  const double quarters = (turn - rest) / 90;
  const double a = rest * (3.141592653589793 / 180);
  const double square = a * a;
  // Taylor's series for |a| at most pi / 4; the first term left out is below 2^-60.
  double cosine = 1;
  double sine = 1;
  for (int k = 18; k >= 2; k -= 2) {
    cosine = 1 - cosine * square / static_cast<double>(k * (k - 1));
    sine = 1 - sine * square / static_cast<double>(k * (k + 1));
  }
  sine *= a;
  if (quarters == 1) {
    return {-sine, cosine};
  }
  if (quarters == -1) {
    return {sine, -cosine};
  }
  return quarters == 0 ? std::pair(cosine, sine) : std::pair(-cosine, -sine);
}

Vec3 divided(const Vec3& v, double d) {
  return {v.x / d, v.y / d, v.z / d};
}

/// A vector of length 1; the largest coordinate is taken out first, so that squares stay in range.
Vec3 direction(const ColladaDocument& document, pugi::xml_node element, const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0)) {
    document.fail(element, describe(element) + " has a direction of length 0");
  }
  const Vec3 scaled = divided(v, largest);
  return divided(scaled, std::sqrt(dot(scaled, scaled)));
}

Affine read_translate(const ColladaDocument& document, pugi::xml_node element) {
  std::array<double, 3> t{};
  document.read_numbers(element, t);
  return {{1, 0, 0, t[0], 0, 1, 0, t[1], 0, 0, 1, t[2]}};
}

Affine read_scale(const ColladaDocument& document, pugi::xml_node element) {
  std::array<double, 3> s{};
  document.read_numbers(element, s);
  return {{s[0], 0, 0, 0, 0, s[1], 0, 0, 0, 0, s[2], 0}};
}

/// An axis and an angle in degrees; the axis of a rotation by nothing may have no length.
Affine read_rotate(const ColladaDocument& document, pugi::xml_node element) {
  std::array<double, 4> r{};
  document.read_numbers(element, r);
  if (r[3] == 0) {
    return {};
  }
  const Vec3 n = direction(document, element, {r[0], r[1], r[2]});
  const auto [c, s] = cosine_and_sine(r[3]);
  const double d = 1 - c;
  return {{d * n.x * n.x + c, d * n.x * n.y - s * n.z, d * n.x * n.z + s * n.y, 0,
           d * n.y * n.x + s * n.z, d * n.y * n.y + c, d * n.y * n.z - s * n.x, 0,
           d * n.z * n.x - s * n.y, d * n.z * n.y + s * n.x, d * n.z * n.z + c, 0}};
}

/// An angle and two directions: points are moved along `along`, each by its distance from the plane
/// through the origin that the part of `from` square to `along` is normal to, so that `from` turns
/// by the angle toward `along`.
Affine read_skew(const ColladaDocument& document, pugi::xml_node element) {
  std::array<double, 7> k{};
  document.read_numbers(element, k);
  if (k[0] == 0) {
    return {};
  }
  const Vec3 from = direction(document, element, {k[1], k[2], k[3]});
  const Vec3 along = direction(document, element, {k[4], k[5], k[6]});
  const Vec3 normal = direction(document, element, from - along * dot(from, along));
  const double height = dot(from, normal);
  const double reach = dot(from, along);
  const auto [c, s] = cosine_and_sine(k[0]);
  const double turned_height = height * c - reach * s;
  if (!(turned_height > 0)) {
    document.fail(element, describe(element) + " turns its first direction beyond its second");
  }
  const double f = (height * s + reach * c) / turned_height - reach / height;
  const Vec3 by = along * f;
  return {{1 + by.x * normal.x, by.x * normal.y, by.x * normal.z, 0, by.y * normal.x,
           1 + by.y * normal.y, by.y * normal.z, 0, by.z * normal.x, by.z * normal.y,
           1 + by.z * normal.z, 0}};
}

/// A place, a point looked at, and an upward direction: -z of the node looks at the point.
Affine read_lookat(const ColladaDocument& document, pugi::xml_node element) {
  std::array<double, 9> l{};
  document.read_numbers(element, l);
  const Vec3 eye{l[0], l[1], l[2]};
  const Vec3 back = direction(document, element, eye - Vec3{l[3], l[4], l[5]});
  const Vec3 up = direction(document, element, {l[6], l[7], l[8]});
  const Vec3 right = direction(document, element, cross(up, back));
  const Vec3 y = cross(back, right);
  return {{right.x, y.x, back.x, eye.x, right.y, y.y, back.y, eye.y, right.z, y.z, back.z, eye.z}};
}

Reading reading_of(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, Reading>, 6> kReadings = {{
      {"lookat", read_lookat},
      {"matrix", read_matrix},
      {"rotate", read_rotate},
      {"scale", read_scale},
      {"skew", read_skew},
      {"translate", read_translate},
  }};
  const auto* found = std::find_if(kReadings.begin(), kReadings.end(),
                                   [&](const auto& reading) { return reading.first == name; });
  return found == kReadings.end() ? nullptr : found->second;
}

}  // namespace

Affine read_matrix(const ColladaDocument& document, pugi::xml_node element) {
  std::array<double, 16> m{};
  document.read_numbers(element, m);
  if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1) {
    document.fail(element, "the last row of " + describe(element) + " is not 0 0 0 1",
                  "write matrices row by row, without perspective", ErrorKind::unsupported);
  }
  Affine affine;
  std::copy_n(m.begin(), affine.m.size(), affine.m.begin());
  return affine;
}

Affine read_transforms(const ColladaDocument& document, pugi::xml_node node) {
  Affine product;
  for (const pugi::xml_node child : node.children()) {
    if (const Reading read = reading_of(child.name())) {
      product = product * read(document, child);
    }
  }
  return product;
}

}  // namespace soms::detail
