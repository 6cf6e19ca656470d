#include "soms/generate/detail/vehicles.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace soms::detail {

namespace {

/// A slice of a body across the vehicle: heights and half widths of its corners.
struct Slice {
  double x;
  double belly;  ///< height of the underside
  double waist;  ///< height of the widest place
  double belt;   ///< height below the windows, or of the edge of the bonnet
  double roof;
  double wide;  ///< half widths: at the waist, the belt, and the roof
  double belt_wide;
  double roof_wide;
};

constexpr std::size_t kSlices = 16;
constexpr std::size_t kSliceCorners = 8;
constexpr std::size_t kWheels = 4;
constexpr std::size_t kMirrors = 2;
constexpr std::size_t kTrims = 6;  ///< lamps before and behind, two bumpers

/// A body from nose to tail, with its wheels.
struct VehiclePlan {
  std::array<Slice, kSlices> slices;
  double front_axle;
  double rear_axle;
  double track;  ///< half of it
  double radius;
  double mirror_x;
  double mirror_y;
  double mirror_z;
  double lamp_z;
};

/// 4.5 x 2 x 1.46 m with mirrors: bonnet, windshield, roof, rear window, boot, arches over wheels.
constexpr VehiclePlan kSedan{{{{2.25, .32, .46, .58, .63, .62, .56, .48},
                               {2.13, .22, .50, .69, .74, .82, .77, .66},
                               {1.76, .21, .52, .76, .82, .88, .82, .70},
                               {1.64, .60, .66, .79, .85, .90, .83, .71},
                               {1.08, .60, .68, .86, .91, .90, .84, .72},
                               {0.96, .21, .52, .88, .93, .89, .84, .72},
                               {0.82, .21, .52, .90, .95, .89, .84, .72},
                               {0.02, .21, .52, .93, 1.41, .89, .84, .60},
                               {-0.35, .21, .52, .94, 1.46, .89, .84, .61},
                               {-0.94, .21, .52, .95, 1.41, .89, .84, .60},
                               {-1.06, .60, .68, .96, 1.37, .90, .84, .60},
                               {-1.62, .60, .68, .96, 1.03, .90, .83, .70},
                               {-1.74, .23, .52, .96, 1.00, .89, .82, .70},
                               {-2.10, .26, .54, .94, .98, .85, .78, .68},
                               {-2.20, .30, .56, .88, .92, .78, .72, .62},
                               {-2.25, .36, .54, .70, .74, .68, .62, .54}}},
                             1.36,
                             -1.34,
                             .79,
                             .32,
                             .66,
                             .93,
                             .98,
                             .64};

/// 5.1 x 2.2 x 2.1 m with mirrors: short nose, sloping windshield, a long box.
constexpr VehiclePlan kVan{{{{2.55, .34, .48, .66, .72, .74, .68, .60},
                             {2.44, .26, .56, .90, .96, .90, .84, .74},
                             {2.06, .25, .58, 1.00, 1.06, .96, .90, .78},
                             {1.94, .66, .74, 1.03, 1.10, .98, .92, .79},
                             {1.84, .66, .76, 1.06, 1.14, .98, .93, .80},
                             {1.32, .66, .78, 1.16, 1.62, .98, .95, .82},
                             {1.20, .25, .62, 1.18, 1.73, .98, .96, .82},
                             {0.98, .25, .62, 1.20, 1.94, .98, .96, .82},
                             {0.66, .25, .62, 1.22, 2.06, .98, .96, .83},
                             {-0.60, .25, .62, 1.24, 2.10, .98, .96, .84},
                             {-1.18, .25, .62, 1.24, 2.10, .98, .96, .84},
                             {-1.30, .66, .80, 1.24, 2.10, .98, .96, .84},
                             {-1.92, .66, .80, 1.24, 2.09, .98, .96, .84},
                             {-2.04, .27, .62, 1.24, 2.09, .98, .96, .84},
                             {-2.50, .29, .62, 1.22, 2.06, .95, .92, .80},
                             {-2.55, .34, .62, 1.18, 1.98, .90, .87, .75}}},
                           1.63,
                           -1.61,
                           .87,
                           .35,
                           1.24,
                           1.03,
                           1.26,
                           .74};

const VehiclePlan& plan_of(Vehicle kind) {
  return kind == Vehicle::sedan ? kSedan : kVan;
}

std::size_t wheel_corners(Finish finish) {
  return finish == Finish::full ? 16 : 10;
}

/// Opens a part where names are wanted.
class NamedParts {
 public:
  NamedParts(Mesh& mesh, bool names) : mesh_(mesh), names_(names) {}

  template <class Add>
  void add(const std::string& name, Add&& make) {
    if (!names_) {
      make();
      return;
    }
    const std::uint32_t part = open_part(mesh_, name);
    make();
    close_part(mesh_, part);
  }

 private:
  Mesh& mesh_;
  bool names_;
};

/// Counter-clockwise as seen from ahead.
std::array<Corner, kSliceCorners> corners_of(const Slice& s) {
  const double low = 0.92 * s.wide;
  return {{{low, s.belly},
           {s.wide, s.waist},
           {s.belt_wide, s.belt},
           {s.roof_wide, s.roof},
           {-s.roof_wide, s.roof},
           {-s.belt_wide, s.belt},
           {-s.wide, s.waist},
           {-low, s.belly}}};
}

/// The closed surface through all slices.
void add_vehicle_body(Mesh& mesh, const Frame& frame, std::span<const Slice> slices,
                      double stretch) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Slice& s : slices) {
    for (const Corner& c : corners_of(s)) {
      mesh.vertices.push_back(frame.at(stretch * s.x, c.x, c.y));
    }
  }
  const auto n = static_cast<std::uint32_t>(kSliceCorners);
  const std::uint32_t last = first + n * static_cast<std::uint32_t>(slices.size() - 1);
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({first, first + i, first + i + 1});
    mesh.triangles.push_back({last, last + i + 1, last + i});
  }
  for (std::uint32_t ring = first; ring < last; ring += n) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = i + 1 == n ? 0 : i + 1;
      mesh.triangles.push_back({ring + i, ring + n + i, ring + n + j});
      mesh.triangles.push_back({ring + i, ring + n + j, ring + j});
    }
  }
}

void add_vehicle_wheels(Mesh& mesh, NamedParts& parts, const Frame& frame, const VehiclePlan& plan,
                        Finish finish, double stretch) {
  const Outline tire = regular(wheel_corners(finish), plan.radius);
  const Outline hub = regular(8, 0.55 * plan.radius);
  for (const double x : {plan.front_axle, plan.rear_axle}) {
    for (const double y : {plan.track, -plan.track}) {
      const std::string place =
          std::string(x > 0 ? "_front" : "_rear") + (y > 0 ? "_left" : "_right");
      const Frame at = crosswise(frame.moved(stretch * x, y, plan.radius));
      parts.add("wheel" + place, [&] { add_prism(mesh, at, tire, -0.11, 0.11); });
      if (finish == Finish::full) {
        const double out = y > 0 ? 0.11 : -0.13;
        parts.add("hub" + place, [&] { add_prism(mesh, at, hub, out, out + 0.02); });
      }
    }
  }
}

void add_trims(Mesh& mesh, NamedParts& parts, const Frame& frame, const VehiclePlan& plan,
               double stretch) {
  const auto box = [&](const std::string& name, const Vec3& center, const Vec3& half) {
    const Frame at = frame.moved(stretch * center.x, center.y, center.z);
    parts.add(name, [&] { add_box(mesh, at, half); });
  };
  const double nose = plan.slices.front().x - 0.1;
  const double tail = plan.slices.back().x + 0.06;
  const double wide = plan.slices[1].wide;
  const double rear = plan.slices[kSlices - 2].wide;
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "_left" : "_right";
    box("lamp_front" + name, {nose, side * (wide - 0.4), plan.lamp_z}, {0.09, 0.14, 0.06});
    box("lamp_rear" + name, {tail, side * (rear - 0.2), plan.lamp_z + 0.14}, {0.08, 0.1, 0.08});
  }
  box("bumper_front", {nose + 0.04, 0, plan.lamp_z - 0.26}, {0.1, wide, 0.07});
  box("bumper_rear", {tail, 0, plan.lamp_z - 0.22}, {0.1, rear, 0.07});
}

}  // namespace

std::uint64_t vehicle_triangles(Finish finish) {
  const std::uint64_t body = 2 * kSliceCorners * (kSlices - 1) + 2 * (kSliceCorners - 2);
  const std::uint64_t hubs = finish == Finish::full ? kWheels * prism_triangles(8) : 0;
  const std::uint64_t boxes = kMirrors + (finish == Finish::full ? kTrims : 0);
  return body + kWheels * prism_triangles(wheel_corners(finish)) + hubs + boxes * 12;
}

void add_vehicle(Mesh& mesh, const Frame& frame, Vehicle kind, Finish finish, double stretch,
                 bool names) {
  const VehiclePlan& plan = plan_of(kind);
  NamedParts parts(mesh, names);
  parts.add("body", [&] { add_vehicle_body(mesh, frame, plan.slices, stretch); });
  add_vehicle_wheels(mesh, parts, frame, plan, finish, stretch);
  for (const double side : {1.0, -1.0}) {
    const Frame at = frame.moved(stretch * plan.mirror_x, side * plan.mirror_y, plan.mirror_z);
    parts.add(side > 0 ? "mirror_left" : "mirror_right", [&] {
      add_box(mesh, at, {0.06, 0.09, 0.07});
    });
  }
  if (finish == Finish::full) {
    add_trims(mesh, parts, frame, plan, stretch);
  }
}

}  // namespace soms::detail
