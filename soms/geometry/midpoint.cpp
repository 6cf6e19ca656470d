#include "soms/geometry/midpoint.h"

#include "soms/base/box.h"

namespace soms {

Vec3 midpoint(const Triangle& t, Midpoint kind, int c_vertex) {
  const Triangle turned = c_vertex == 0   ? Triangle{t.b, t.c, t.a}
                          : c_vertex == 1 ? Triangle{t.c, t.a, t.b}
                                          : t;
  switch (kind) {
    case Midpoint::thesis:
      return 0.5 * (0.5 * (turned.a + turned.b) + turned.c);
    case Midpoint::centroid: {
      const Vec3 sum = (turned.a + turned.b) + turned.c;
      return {sum.x / 3, sum.y / 3, sum.z / 3};
    }
    case Midpoint::aabb:
      return bounds(t).center();
  }
  return {};
}

}  // namespace soms
