#include "bench/self/self_peers.h"

#if SOMS_BENCH_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <utility>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

class CgalSelf : public soms::bench::SelfPeer {
 public:
  CgalSelf(std::span<const soms::Vec3> vertices,
           std::span<const std::array<std::uint32_t, 3>> triangles) {
    std::vector<Surface::Vertex_index> names;
    for (const soms::Vec3& v : vertices) {
      names.push_back(surface_.add_vertex({v.x, v.y, v.z}));
    }
    for (const auto& [a, b, c] : triangles) {
      const bool names_twice = a == b || b == c || c == a;
      if (names_twice || surface_.add_face(names[a], names[b], names[c]) == Surface::null_face()) {
        ++left_out_;
      }
    }
  }

  [[nodiscard]] std::size_t left_out() const override { return left_out_; }

  [[nodiscard]] std::size_t find() const override {
    std::vector<std::pair<Surface::Face_index, Surface::Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(surface_, std::back_inserter(pairs));
    return pairs.size();
  }

 private:
  Surface surface_;
  std::size_t left_out_ = 0;
};

}  // namespace
#endif

extern "C" soms::bench::SelfPeer* soms_bench_self_peer(
    std::span<const soms::Vec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles) {
#if SOMS_BENCH_CGAL
  return new CgalSelf(vertices, triangles);
#else
  static_cast<void>(vertices);
  static_cast<void>(triangles);
  return nullptr;
#endif
}
