/// \file
/// Closed test bodies of an exact number of triangles.
#pragma once

#include "soms/base/words.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <string_view>

namespace soms {

/// (2,3) torus knot of tube radius 0.4 scaled to reach 1; exactly `triangles`, at least 18 and
/// even. A closed tube has no other counts, and no tube is closed by fewer than 3 rings of 3
/// points. The same bits on every machine. \errors  ErrorKind::usage naming the least and nearest
/// possible count.
[[nodiscard]] Mesh generate_knot(std::uint64_t triangles);

/// UV sphere of radius 1 about the origin; exactly `triangles`, at least 8 and even. The same bits
/// on every machine.
/// \errors  ErrorKind::usage naming the least and nearest possible count.
[[nodiscard]] Mesh generate_sphere(std::uint64_t triangles);

/// Kinds of movers that are generated.
enum class MoverKind { car, person, drone, sedan, van };

template <>
inline constexpr auto kWords<MoverKind> = words("MoverKind", "What kind of mover it is.", "car",
                                                "person", "drone", "sedan", "van");

/// A mover in meters, z up, standing on z = 0 (drone: hovering about the origin), heading +x. Every
/// part (wheel, arm, rotor) is a closed surface of its own. Exactly `triangles`, even; 0 gives the
/// default count (car 1,000, person 600, drone 308, sedan and van 700).
///
/// A sedan is a car of more shape, with arches over round wheels. The built-in movers are the
/// plainer cars, whose counts are recorded.
///
/// \shape   car 4.5 x 1.98 x 1.45 m with its mirrors, person 0.4 x 0.63 x 1.75 m, drone 0.75 m
/// across
///          and 0.24 m high. Sedan 4.58 x 2.04 x 1.46 m, van 5.18 x 2.24 x 2.1 m.
/// \errors  ErrorKind::usage naming the least count (car 384, person 392, drone 244, sedan and van
///          700) and the nearest possible one.
[[nodiscard]] Mesh generate_mover(MoverKind kind, std::uint64_t triangles = 0);

}  // namespace soms
