#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/generate/detail/counts.h"
#include "soms/generate/detail/refine.h"
#include "soms/generate/detail/solids.h"
#include "soms/generate/detail/vehicles.h"
#include "soms/generate/shapes.h"

#include <string>
#include <utility>

namespace soms {

namespace {

using detail::Corner;
using detail::Frame;
using detail::Outline;

/// Runs `add`, which appends triangles, as one named part.
template <class Add>
void part(Mesh& mesh, std::string name, Add&& add) {
  const std::uint32_t id = detail::open_part(mesh, std::move(name));
  add();
  detail::close_part(mesh, id);
}

void box(Mesh& mesh, std::string name, const Vec3& center, const Vec3& half) {
  part(mesh, std::move(name), [&] { detail::add_box(mesh, {center}, half); });
}

void ellipsoid(Mesh& mesh, std::string name, const Vec3& center, const Vec3& radii,
               std::uint32_t around, std::uint32_t rings) {
  part(mesh, std::move(name), [&] { detail::add_ellipsoid(mesh, {center}, radii, around, rings); });
}

const char* side_name(double y) {
  return y > 0 ? "_left" : "_right";
}

/// 4.5 x 1.8 x 1.45 m without its mirrors: a hull with bonnet and boot, a cabin, wheels, lamps.
void add_car(Mesh& mesh) {
  // Outlines of (z, x), extruded across the car: counter-clockwise from the first corner.
  const Outline hull{{0.22, 2.2},  {0.22, -2.2}, {0.55, -2.25}, {0.90, -2.05},
                     {0.94, -1.2}, {0.92, 0.9},  {0.72, 2.05},  {0.50, 2.25}};
  part(mesh, "hull", [&] { detail::add_prism(mesh, detail::crosswise({}), hull, -0.86, 0.86); });
  const Outline sill{{-1.45, -0.84}, {1.1, -0.84}, {1.1, 0.84}, {-1.45, 0.84}};
  const Outline roof{{-1.0, -0.66}, {0.35, -0.66}, {0.35, 0.66}, {-1.0, 0.66}};
  part(mesh, "cabin", [&] { detail::add_frustum(mesh, {}, sill, roof, 0.9, 1.45); });
  const Outline rim = detail::regular(18, 0.32);
  for (const double x : {1.35, -1.35}) {
    for (const double y : {0.8, -0.8}) {
      part(mesh, std::string("wheel") + (x > 0 ? "_front" : "_rear") + side_name(y), [&] {
        detail::add_prism(mesh, detail::crosswise({{x, y, 0.32}}), rim, -0.1, 0.1);
      });
    }
  }
  for (const double y : {0.91, -0.91}) {
    box(mesh, std::string("mirror") + side_name(y), {0.75, y, 1.0}, {0.06, 0.08, 0.06});
  }
  for (const double y : {0.6, -0.6}) {
    box(mesh, std::string("lamp") + side_name(y), {2.16, y, 0.62}, {0.05, 0.16, 0.07});
  }
  box(mesh, "bumper_front", {2.17, 0, 0.36}, {0.08, 0.84, 0.08});
  box(mesh, "bumper_rear", {-2.17, 0, 0.36}, {0.08, 0.84, 0.08});
}

/// 1.75 m tall, in mid step: head, neck, trunk, arms with hands, legs with shoes.
void add_person(Mesh& mesh) {
  ellipsoid(mesh, "head", {0.02, 0, 1.62}, {0.1, 0.085, 0.13}, 8, 5);
  part(mesh, "neck", [&] {
    detail::add_prism(mesh, {{0, 0, 1.45}}, detail::regular(6, 0.055), 0, 0.09);
  });
  ellipsoid(mesh, "trunk", {0, 0, 1.18}, {0.13, 0.21, 0.32}, 10, 5);
  for (const double y : {0.1, -0.1}) {
    const double step = y > 0 ? 0.12 : -0.12;
    const std::string side = side_name(y);
    const Outline hip = detail::regular(8, 0.085);
    Outline ankle = detail::regular(8, 0.05);
    for (Corner& c : ankle) {
      c.x += step;
    }
    part(mesh, "leg" + side, [&] {
      detail::add_frustum(mesh, {{0, y, 0}}, ankle, hip, 0.07, 0.95);
    });
    box(mesh, "shoe" + side, {step + 0.03, y, 0.04}, {0.08, 0.045, 0.04});
    const Outline shoulder = detail::regular(6, 0.05);
    Outline wrist = detail::regular(6, 0.035);
    for (Corner& c : wrist) {
      c.x -= 0.8 * step;
    }
    const double out = y > 0 ? 0.27 : -0.27;
    part(mesh, "arm" + side, [&] {
      detail::add_frustum(mesh, {{0, out, 0}}, wrist, shoulder, 0.85, 1.42);
    });
    ellipsoid(mesh, "hand" + side, {-0.8 * step, out, 0.8}, {0.045, 0.03, 0.07}, 6, 3);
  }
}

/// Four arms with rotors about a round body, on two skids.
void add_drone(Mesh& mesh) {
  ellipsoid(mesh, "body", {0, 0, 0}, {0.17, 0.13, 0.07}, 8, 3);
  const char* const corners[] = {"_front_left", "_rear_left", "_rear_right", "_front_right"};
  for (std::size_t i = 0; i < 4; ++i) {
    const Frame arm = detail::upright({}, detail::on_circle(2 * i + 1, 8));
    part(mesh, std::string("arm") + corners[i], [&] {
      detail::add_box(mesh, arm.moved(0.19, 0, 0.02), {0.17, 0.014, 0.014});
    });
    part(mesh, std::string("rotor") + corners[i], [&] {
      detail::add_prism(mesh, arm.moved(0.35, 0, 0.07), detail::regular(8, 0.13), -0.01, 0.01);
    });
  }
  for (const double y : {0.1, -0.1}) {
    box(mesh, std::string("skid") + side_name(y), {0, y, -0.11}, {0.14, 0.012, 0.05});
  }
  box(mesh, "camera", {0.15, 0, -0.05}, {0.04, 0.03, 0.03});
}

void add_sedan(Mesh& mesh) {
  detail::add_vehicle(mesh, {}, detail::Vehicle::sedan, detail::Finish::full, 1, true);
}

void add_van(Mesh& mesh) {
  detail::add_vehicle(mesh, {}, detail::Vehicle::van, detail::Finish::full, 1, true);
}

struct Blueprint {
  void (*add)(Mesh&);
  std::uint64_t least;
  std::uint64_t usual;
};

Blueprint blueprint(MoverKind kind) {
  switch (kind) {
    case MoverKind::car:
      return {add_car, 384, 1000};
    case MoverKind::person:
      return {add_person, 392, 600};
    case MoverKind::sedan:
    case MoverKind::van: {
      const std::uint64_t count = detail::vehicle_triangles(detail::Finish::full);
      return {kind == MoverKind::van ? add_van : add_sedan, count, count};
    }
    default:
      return {add_drone, 244, 308};
  }
}

}  // namespace

Mesh generate_mover(MoverKind kind, std::uint64_t triangles) {
  const PlainArithmetic plain;
  const Blueprint plan = blueprint(kind);
  const std::uint64_t wanted = triangles == 0 ? plan.usual : triangles;
  detail::check_closed_count(std::string(name(kind)), wanted, plan.least);
  Mesh mesh;
  mesh.unit = 1;
  mesh.up = UpAxis::z;
  mesh.source = "generated " + std::string(name(kind));
  plan.add(mesh);
  detail::refine(mesh, wanted);
  return mesh;
}

}  // namespace soms
