// CGAL's AABB_tree of triangles with exact predicates. `any` traverses two trees as CGAL's
// Rigid_triangle_mesh_collision_detection does; `all` asks triangle by triangle.
// box_self_intersection_d as a broad phase that keeps nothing between frames.
#include "bench/peers/libraries/cgal_surface.h"
#include "bench/peers/libraries/library.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/internal/AABB_traversal_traits_with_transformation.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>

#include <utility>

namespace soms::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalTriangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, CgalTriangles::const_iterator>;
using Traits = CGAL::AABB_traits<Kernel, Primitive>;
using Placed = CGAL::Do_intersect_traversal_traits_with_transformation<Traits, Kernel>;
using Both = CGAL::Do_intersect_traversal_traits_for_two_trees<Traits, Kernel>;
using Affine = CGAL::Aff_transformation_3<Kernel>;

struct CgalBody {
  CgalTriangles triangles;
  CGAL::AABB_tree<Traits> tree;

  explicit CgalBody(const FloatMesh& mesh) {
    const auto point = [&](std::uint32_t i) {
      const auto& v = mesh.vertices[i];
      return Kernel::Point_3(v[0], v[1], v[2]);
    };
    triangles.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
      triangles.emplace_back(point(t[0]), point(t[1]), point(t[2]));
    }
    tree.insert(triangles.cbegin(), triangles.cend());
    tree.build();
    tree.do_not_accelerate_distance_queries();
  }
};

Affine placed(const Pose& pose) {
  const auto& m = pose.m;
  return Affine(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11]);
}

class CgalMatch final : public Match {
 public:
  CgalMatch(const FloatMesh& mover, const FloatMesh& fixed)
      : CgalMatch(mover, std::make_shared<const CgalBody>(fixed)) {}

  CgalMatch(const FloatMesh& mover, std::shared_ptr<const CgalBody> fixed)
      : mover_(mover), fixed_(std::move(fixed)) {}

  [[nodiscard]] std::unique_ptr<Match> with(const FloatMesh& mover) const override {
    return std::make_unique<CgalMatch>(mover, fixed_);
  }

  void answer(const Questions& questions, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const Pose& pose = questions.poses[i];
      answers[i] =
          questions.job == Job::any ? (any(pose) ? 1 : 0) : static_cast<double>(count(pose));
    }
  }

 private:
  [[nodiscard]] bool any(const Pose& pose) const {
    const CGAL::Interval_nt_advanced::Protector rounding;
    Placed mover(mover_.tree.traits());
    mover.set_transformation(placed(pose));
    const Affine stay(CGAL::IDENTITY);
    Both both(fixed_->tree.traits(), stay, mover);
    fixed_->tree.traversal(mover_.tree, both);
    return both.is_intersection_found();
  }

  [[nodiscard]] std::uint64_t count(const Pose& pose) const {
    const Affine move = placed(pose);
    std::uint64_t count = 0;
    for (const auto& t : mover_.triangles) {
      count += fixed_->tree.number_of_intersected_primitives(t.transform(move));
    }
    return count;
  }

  CgalBody mover_;
  std::shared_ptr<const CgalBody> fixed_;
};

class CgalMesh final : public Library {
 public:
  [[nodiscard]] std::string name() const override { return "cgal-tree"; }

  [[nodiscard]] std::string version() const override { return CGAL_VERSION_STR; }

  [[nodiscard]] bool does(Job job) const override { return job == Job::any || job == Job::all; }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    return std::make_unique<CgalMatch>(mover, fixed);
  }
};

class CgalMovingBoxes final : public MovingBoxes {
 public:
  std::uint64_t step(std::span<const FloatBox> boxes) override {
    boxes_.clear();
    order_.clear();
    for (const FloatBox& b : boxes) {
      auto lower = b.lower;  // the constructor wants them writable
      auto upper = b.upper;
      boxes_.emplace_back(lower.data(), upper.data());
    }
    for (CgalBox& b : boxes_) {
      order_.push_back(&b);
    }
    std::uint64_t count = 0;
    CGAL::box_self_intersection_d(
        order_.begin(), order_.end(), [&count](CgalBox*, CgalBox*) { ++count; },
        std::ptrdiff_t{100});
    return count;
  }

 private:
  using CgalBox = CGAL::Box_intersection_d::Box_d<float, 3>;
  std::vector<CgalBox> boxes_;
  std::vector<CgalBox*> order_;  // pointers are cheaper to sort than boxes
};

class CgalBroad final : public Library {
 public:
  [[nodiscard]] std::string name() const override { return "cgal-boxes"; }

  [[nodiscard]] std::string version() const override { return CGAL_VERSION_STR; }

  [[nodiscard]] bool does(Job job) const override { return job == Job::broad; }

  [[nodiscard]] std::unique_ptr<MovingBoxes> moving_boxes(
      std::span<const FloatBox>) const override {
    return std::make_unique<CgalMovingBoxes>();
  }
};

}  // namespace

}  // namespace soms::bench

extern "C" void soms_bench_peer(soms::bench::Roster& roster, const soms::bench::Loan&) {
  roster.push_back(std::make_unique<soms::bench::CgalMesh>());
  roster.push_back(std::make_unique<soms::bench::CgalBroad>());
  soms::bench::add_cgal_surface(roster);
}
