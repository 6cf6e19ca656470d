// Embree's rtcCollide. It takes user geometry only, gives pairs of primitives with overlapping
// boxes and leaves the triangle test to the caller, cannot stop early, and knows no pose: a mover's
// boxes are rebuilt and its tree is refitted for every pose (rebuilding at low quality takes
// several times as long).
#include "bench/peers/libraries/embree_device.h"
#include "bench/peers/libraries/embree_surface.h"
#include "bench/peers/libraries/library.h"
#include "bench/peers/libraries/triangle_test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace soms::bench {

namespace {

float down(double v) {
  return std::nextafter(static_cast<float>(v), -std::numeric_limits<float>::infinity());
}

float up(double v) {
  return std::nextafter(static_cast<float>(v), std::numeric_limits<float>::infinity());
}

/// A mesh as user geometry; one that moves keeps its triangles at the present pose.
class EmbreeBody {
 public:
  EmbreeBody(const FloatMesh& mesh, bool moves) : mesh_(mesh) {
    if (moves) {
      place({});
    }
    const EmbreeDevice& device = EmbreeDevice::shared();
    const UnseenBytes unseen;
    scene_ = rtcNewScene(device.get());
    rtcSetSceneFlags(scene_, moves ? RTC_SCENE_FLAG_DYNAMIC : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene_, moves ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_HIGH);
    geometry_ = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryBuildQuality(geometry_, moves ? RTC_BUILD_QUALITY_REFIT : RTC_BUILD_QUALITY_HIGH);
    rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(mesh.triangles.size()));
    rtcSetGeometryUserData(geometry_, this);
    rtcSetGeometryBoundsFunction(geometry_, bounds, nullptr);
    rtcCommitGeometry(geometry_);
    rtcAttachGeometry(scene_, geometry_);
    rtcCommitScene(scene_);
    unseen_ = unseen.taken();
  }

  ~EmbreeBody() {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
  }

  EmbreeBody(const EmbreeBody&) = delete;
  EmbreeBody& operator=(const EmbreeBody&) = delete;

  [[nodiscard]] RTCScene scene() const { return scene_; }

  [[nodiscard]] std::size_t unseen_bytes() const { return unseen_; }

  [[nodiscard]] Triangle triangle(unsigned i) const {
    return placed_.empty() ? mesh_.triangle(i) : placed_[i];
  }

  void move_to(const Pose& pose) {
    place(pose);
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
  }

 private:
  void place(const Pose& pose) {
    placed_.resize(mesh_.triangles.size());
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      placed_[i] = moved(pose, mesh_.triangle(i));
    }
  }

  static void bounds(const RTCBoundsFunctionArguments* request) {
    const Triangle t =
        static_cast<const EmbreeBody*>(request->geometryUserPtr)->triangle(request->primID);
    RTCBounds& b = *request->bounds_o;
    b.lower_x = down(std::min({t.a.x, t.b.x, t.c.x}));
    b.lower_y = down(std::min({t.a.y, t.b.y, t.c.y}));
    b.lower_z = down(std::min({t.a.z, t.b.z, t.c.z}));
    b.upper_x = up(std::max({t.a.x, t.b.x, t.c.x}));
    b.upper_y = up(std::max({t.a.y, t.b.y, t.c.y}));
    b.upper_z = up(std::max({t.a.z, t.b.z, t.c.z}));
  }

  FloatMesh mesh_;
  std::vector<Triangle> placed_;
  RTCScene scene_ = nullptr;
  RTCGeometry geometry_ = nullptr;
  std::size_t unseen_ = 0;
};

class EmbreeMatch final : public Match {
 public:
  EmbreeMatch(const FloatMesh& mover, const FloatMesh& fixed, bool moves, const Loan& loan)
      : EmbreeMatch(mover, std::make_shared<EmbreeBody>(fixed, false), moves, loan) {
    unseen_ += fixed_->unseen_bytes();
  }

  EmbreeMatch(const FloatMesh& mover, std::shared_ptr<EmbreeBody> fixed, bool moves,
              const Loan& loan)
      : mover_(mover, moves),
        fixed_(std::move(fixed)),
        moves_(moves),
        loan_(loan),
        unseen_(mover_.unseen_bytes()) {}

  [[nodiscard]] std::unique_ptr<Match> with(const FloatMesh& mover) const override {
    return std::make_unique<EmbreeMatch>(mover, fixed_, moves_, loan_);
  }

  void answer(const Questions& questions, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (moves_) {
        mover_.move_to(questions.poses[i]);
      }
      first_only_ = questions.job == Job::any;
      count_ = 0;
      rtcCollide(mover_.scene(), fixed_->scene(), candidates, this);
      answers[i] = static_cast<double>(count_);
    }
  }

  [[nodiscard]] std::size_t unseen_bytes() const override { return unseen_; }

 private:
  static void candidates(void* self, RTCCollision* pairs, unsigned count) {
    auto& match = *static_cast<EmbreeMatch*>(self);
    for (unsigned i = 0; i < count && !(match.first_only_ && match.count_ != 0); ++i) {
      match.count_ += triangles_touch(match.mover_.triangle(pairs[i].primID0),
                                      match.fixed_->triangle(pairs[i].primID1), match.loan_)
                          ? 1U
                          : 0U;
    }
  }

  EmbreeBody mover_;
  std::shared_ptr<EmbreeBody> fixed_;
  bool moves_;
  Loan loan_;
  std::size_t unseen_;  // of the fixed body, too, where this match built it
  bool first_only_ = false;
  std::uint64_t count_ = 0;
};

/// `embree-refit` pays for moving, `embree-still` has both trees standing at their best quality.
class EmbreeMesh final : public Library {
 public:
  EmbreeMesh(bool moves, const Loan& loan) : moves_(moves), loan_(loan) {}

  [[nodiscard]] std::string name() const override {
    return moves_ ? "embree-refit" : "embree-still";
  }

  [[nodiscard]] std::string version() const override { return RTC_VERSION_STRING; }

  [[nodiscard]] bool does(Job job) const override {
    return moves_ ? job == Job::any || job == Job::all : job == Job::still;
  }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    return std::make_unique<EmbreeMatch>(mover, fixed, moves_, loan_);
  }

 private:
  bool moves_;
  Loan loan_;
};

/// All boxes in one scene, rebuilt or refitted in each frame, against itself.
class EmbreeMovingBoxes final : public MovingBoxes {
 public:
  EmbreeMovingBoxes(std::span<const FloatBox> boxes, RTCBuildQuality quality) : boxes_(boxes) {
    const RTCDevice device = EmbreeDevice::shared().get();
    scene_ = rtcNewScene(device);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
    geometry_ = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryBuildQuality(geometry_, quality);
    rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry_, this);
    rtcSetGeometryBoundsFunction(
        geometry_,
        [](const RTCBoundsFunctionArguments* request) {
          const FloatBox& b = static_cast<const EmbreeMovingBoxes*>(request->geometryUserPtr)
                                  ->boxes_[request->primID];
          *request->bounds_o = {b.lower[0], b.lower[1], b.lower[2], 0,
                                b.upper[0], b.upper[1], b.upper[2], 0};
        },
        nullptr);
    rtcCommitGeometry(geometry_);
    rtcAttachGeometry(scene_, geometry_);
    rtcCommitScene(scene_);
  }

  ~EmbreeMovingBoxes() override {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
  }

  EmbreeMovingBoxes(const EmbreeMovingBoxes&) = delete;
  EmbreeMovingBoxes& operator=(const EmbreeMovingBoxes&) = delete;

  std::uint64_t step(std::span<const FloatBox> boxes) override {
    boxes_ = boxes;
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
    count_ = 0;
    rtcCollide(scene_, scene_, candidates, this);
    return count_;
  }

 private:
  /// A scene against itself gives each pair in both orders.
  static void candidates(void* self, RTCCollision* pairs, unsigned count) {
    auto& moving_boxes = *static_cast<EmbreeMovingBoxes*>(self);
    for (unsigned i = 0; i < count; ++i) {
      const unsigned a = pairs[i].primID0;
      const unsigned b = pairs[i].primID1;
      moving_boxes.count_ +=
          a < b && overlaps(moving_boxes.boxes_[a], moving_boxes.boxes_[b]) ? 1U : 0U;
    }
  }

  std::span<const FloatBox> boxes_;
  RTCScene scene_ = nullptr;
  RTCGeometry geometry_ = nullptr;
  std::uint64_t count_ = 0;
};

class EmbreeBroad final : public Library {
 public:
  explicit EmbreeBroad(bool refits) : refits_(refits) {}

  [[nodiscard]] std::string name() const override {
    return refits_ ? "embree-boxes-refit" : "embree-boxes-rebuild";
  }

  [[nodiscard]] std::string version() const override { return RTC_VERSION_STRING; }

  [[nodiscard]] bool does(Job job) const override { return job == Job::broad; }

  [[nodiscard]] bool keeps_tree() const override { return refits_; }

  [[nodiscard]] std::unique_ptr<MovingBoxes> moving_boxes(
      std::span<const FloatBox> boxes) const override {
    return std::make_unique<EmbreeMovingBoxes>(
        boxes, refits_ ? RTC_BUILD_QUALITY_REFIT : RTC_BUILD_QUALITY_LOW);
  }

 private:
  bool refits_;
};

}  // namespace

}  // namespace soms::bench

extern "C" void soms_bench_peer(soms::bench::Roster& roster, const soms::bench::Loan& loan) {
  using namespace soms::bench;
  roster.push_back(std::make_unique<EmbreeMesh>(true, loan));
  roster.push_back(std::make_unique<EmbreeMesh>(false, loan));
  roster.push_back(std::make_unique<EmbreeBroad>(true));
  roster.push_back(std::make_unique<EmbreeBroad>(false));
  add_embree_surface(roster);
}
