// FCL's continuous collision of mesh models in double: conservative advancement, and samples. Its
// headers instantiate nearly all of FCL, which takes a minute and a half to compile.
#include "bench/motion/motion_peers.h"
#include "bench/peers/libraries/fcl_mesh.h"

// clang-format off: with a true `extern`, before the rest.
#include <fcl/narrowphase/detail/convexity_based_algorithm/alloc.h>
#include <fcl/narrowphase/detail/convexity_based_algorithm/list.h>
#include <fcl/narrowphase/detail/convexity_based_algorithm/polytope.h>
#include <fcl/narrowphase/detail/convexity_based_algorithm/simplex.h>
#include <fcl/narrowphase/detail/convexity_based_algorithm/support.h>
#define extern
#include <fcl/narrowphase/continuous_collision.h>
#undef extern

// clang-format on

namespace soms::bench {

namespace {

using Volume = fcl::OBBRSS<double>;

template <fcl::CCDSolverType solver, int iterations>
class FclMotion final : public MotionPeer {
 public:
  FclMotion(const FloatMesh& mover, const FloatMesh& fixed) {
    fill(mover_, mover);
    fill(fixed_, fixed);
  }

  [[nodiscard]] PeerContact find(const Pose& start, const Pose& end,
                                 const Pose& fixed) const override {
    fcl::ContinuousCollisionRequest<double> request;
    request.num_max_iterations = iterations;
    request.ccd_motion_type = fcl::CCDM_LINEAR;
    request.ccd_solver_type = solver;
    request.gjk_solver_type = fcl::GST_LIBCCD;
    fcl::ContinuousCollisionResult<double> result;
    const fcl::Transform3d rest = placed<double>(fixed);
    fcl::continuousCollide(&mover_, placed<double>(start), placed<double>(end), &fixed_, rest, rest,
                           request, result);
    return {result.is_collide, result.time_of_contact};
  }

 private:
  fcl::BVHModel<Volume> mover_;
  fcl::BVHModel<Volume> fixed_;
};

template <class Peer>
std::unique_ptr<MotionPeer> make(const FloatMesh& mover, const FloatMesh& fixed) {
  return std::make_unique<Peer>(mover, fixed);
}

}  // namespace

void add_fcl(std::vector<MotionPeerMaker>& makers) {
  makers.push_back({"fcl-conservative", &make<FclMotion<fcl::CCDC_CONSERVATIVE_ADVANCEMENT, 10>>});
  makers.push_back({"fcl-naive-100", &make<FclMotion<fcl::CCDC_NAIVE, 100>>});
}

}  // namespace soms::bench
