// CGAL's nearest point by an AABB_tree of triangles with its tree of corners, and
// Side_of_triangle_mesh, both with exact predicates and rounded constructions.
#include "bench/peers/libraries/cgal_surface.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <cmath>

namespace soms::bench {

namespace {

using SurfaceKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceTriangles = std::vector<SurfaceKernel::Triangle_3>;
using SurfacePrimitive =
    CGAL::AABB_triangle_primitive<SurfaceKernel, SurfaceTriangles::const_iterator>;
using SurfaceMesh = CGAL::Surface_mesh<SurfaceKernel::Point_3>;

SurfaceKernel::Point_3 point_of(const Vec3& p) {
  return {p.x, p.y, p.z};
}

class CgalNearest final : public Match {
 public:
  explicit CgalNearest(const FloatMesh& mesh) {
    triangles_.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle t = mesh.triangle(i);
      triangles_.emplace_back(point_of(t.a), point_of(t.b), point_of(t.c));
    }
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
    tree_.accelerate_distance_queries();
  }

  void answer(const Questions& questions, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      answers[i] = std::sqrt(tree_.squared_distance(point_of(questions.points[i])));
    }
  }

 private:
  SurfaceTriangles triangles_;
  CGAL::AABB_tree<CGAL::AABB_traits<SurfaceKernel, SurfacePrimitive>> tree_;
};

class CgalSide final : public Match {
 public:
  explicit CgalSide(const FloatMesh& mesh) : mesh_(connected(mesh)), side_(mesh_) {
    side_(SurfaceKernel::Point_3(mesh.vertices[0][0], mesh.vertices[0][1], mesh.vertices[0][2]));
  }

  void answer(const Questions& questions, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const CGAL::Bounded_side side = side_(point_of(questions.points[i]));
      answers[i] = side == CGAL::ON_BOUNDED_SIDE ? 1 : side == CGAL::ON_BOUNDARY ? kOnSurface : 0;
    }
  }

 private:
  static SurfaceMesh connected(const FloatMesh& mesh) {
    SurfaceMesh result;
    for (const auto& v : mesh.vertices) {
      result.add_vertex(SurfaceKernel::Point_3(v[0], v[1], v[2]));
    }
    for (const auto& t : mesh.triangles) {
      result.add_face(SurfaceMesh::Vertex_index(t[0]), SurfaceMesh::Vertex_index(t[1]),
                      SurfaceMesh::Vertex_index(t[2]));
    }
    return result;
  }

  SurfaceMesh mesh_;
  CGAL::Side_of_triangle_mesh<SurfaceMesh, SurfaceKernel> side_;
};

class CgalProbes final : public Library {
 public:
  explicit CgalProbes(Job job) : job_(job) {}

  [[nodiscard]] std::string name() const override {
    return job_ == Job::closest ? "cgal-closest" : "cgal-side";
  }

  [[nodiscard]] std::string version() const override { return CGAL_VERSION_STR; }

  [[nodiscard]] bool does(Job job) const override { return job == job_; }

  [[nodiscard]] Precision precision() const override {
    return job_ == Job::closest ? Precision::doubles : Precision::exact;
  }

  [[nodiscard]] std::unique_ptr<Match> prepare_probes(Job, const FloatMesh& body) const override {
    if (job_ == Job::closest) {
      return std::make_unique<CgalNearest>(body);
    }
    return std::make_unique<CgalSide>(body);
  }

 private:
  Job job_;
};

}  // namespace

void add_cgal_surface(Roster& roster) {
  roster.push_back(std::make_unique<CgalProbes>(Job::closest));
  roster.push_back(std::make_unique<CgalProbes>(Job::contains));
}

}  // namespace soms::bench
