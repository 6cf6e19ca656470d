// ODE: trimesh against trimesh (OPCODE trees). It makes contacts; `any` asks for one that need not
// be the best. Sweep and prune as a broad phase; its hash space took a hundred times as long.
#include "bench/peers/libraries/library.h"

#include <ode/ode.h>

#include <utility>

namespace soms::bench {

namespace {

void start_ode() {
  static const bool started = [] {
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    return true;
  }();
  static_cast<void>(started);
}

class OdeBody {
 public:
  explicit OdeBody(const FloatMesh& mesh) : mesh_(mesh), data_(dGeomTriMeshDataCreate()) {
    dGeomTriMeshDataBuildSingle(data_, mesh_.vertices.data(), sizeof mesh_.vertices[0],
                                static_cast<int>(mesh_.vertices.size()), mesh_.triangles.data(),
                                static_cast<int>(3 * mesh_.triangles.size()),
                                sizeof mesh_.triangles[0]);
    geom_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
  }

  ~OdeBody() {
    dGeomDestroy(geom_);
    dGeomTriMeshDataDestroy(data_);
  }

  OdeBody(const OdeBody&) = delete;
  OdeBody& operator=(const OdeBody&) = delete;

  [[nodiscard]] dGeomID geom() const { return geom_; }

 private:
  FloatMesh mesh_;
  dTriMeshDataID data_;
  dGeomID geom_ = nullptr;
};

class OdeMatch final : public Match {
 public:
  OdeMatch(const FloatMesh& mover, const FloatMesh& fixed)
      : OdeMatch(mover, std::make_shared<OdeBody>(fixed)) {}

  OdeMatch(const FloatMesh& mover, std::shared_ptr<OdeBody> fixed)
      : mover_(mover), fixed_(std::move(fixed)) {}

  [[nodiscard]] std::unique_ptr<Match> with(const FloatMesh& mover) const override {
    return std::make_unique<OdeMatch>(mover, fixed_);
  }

  void answer(const Questions& questions, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const auto& m = questions.poses[i].m;
      const dMatrix3 turn{m[0], m[1], m[2], 0, m[4], m[5], m[6], 0, m[8], m[9], m[10], 0};
      dGeomSetPosition(mover_.geom(), m[3], m[7], m[11]);
      dGeomSetRotation(mover_.geom(), turn);
      dContactGeom contact;
      const int flags = 1 | static_cast<int>(CONTACTS_UNIMPORTANT);
      answers[i] =
          dCollide(mover_.geom(), fixed_->geom(), flags, &contact, sizeof contact) > 0 ? 1 : 0;
    }
  }

 private:
  OdeBody mover_;
  std::shared_ptr<OdeBody> fixed_;
};

class OdeMesh final : public Library {
 public:
  [[nodiscard]] std::string name() const override { return "ode-trimesh"; }

  [[nodiscard]] std::string version() const override { return SOMS_BENCH_ODE; }

  [[nodiscard]] bool does(Job job) const override { return job == Job::any; }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    start_ode();
    return std::make_unique<OdeMatch>(mover, fixed);
  }
};

class OdeMovingBoxes final : public MovingBoxes {
 public:
  explicit OdeMovingBoxes(std::span<const FloatBox> boxes)
      : space_(dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ)) {
    for (const FloatBox& b : boxes) {
      geoms_.push_back(dCreateBox(space_, b.upper[0] - b.lower[0], b.upper[1] - b.lower[1],
                                  b.upper[2] - b.lower[2]));
    }
  }

  ~OdeMovingBoxes() override { dSpaceDestroy(space_); }

  OdeMovingBoxes(const OdeMovingBoxes&) = delete;
  OdeMovingBoxes& operator=(const OdeMovingBoxes&) = delete;

  std::uint64_t step(std::span<const FloatBox> boxes) override {
    const auto middle = [](const FloatBox& b, std::size_t axis) {
      return 0.5 * (static_cast<double>(b.lower[axis]) + b.upper[axis]);
    };
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      dGeomSetPosition(geoms_[i], middle(boxes[i], 0), middle(boxes[i], 1), middle(boxes[i], 2));
    }
    boxes_ = boxes;
    count_ = 0;
    dSpaceCollide(space_, this, [](void* self, dGeomID, dGeomID) {
      ++static_cast<OdeMovingBoxes*>(self)->count_;
    });
    return count_;
  }

 private:
  dSpaceID space_;
  std::vector<dGeomID> geoms_;
  std::span<const FloatBox> boxes_;
  std::uint64_t count_ = 0;
};

class OdeBroad final : public Library {
 public:
  [[nodiscard]] std::string name() const override { return "ode-sap"; }

  [[nodiscard]] std::string version() const override { return SOMS_BENCH_ODE; }

  [[nodiscard]] bool does(Job job) const override { return job == Job::broad; }

  [[nodiscard]] std::unique_ptr<MovingBoxes> moving_boxes(
      std::span<const FloatBox> boxes) const override {
    start_ode();
    return std::make_unique<OdeMovingBoxes>(boxes);
  }
};

}  // namespace

}  // namespace soms::bench

extern "C" void soms_bench_peer(soms::bench::Roster& roster, const soms::bench::Loan&) {
  roster.push_back(std::make_unique<soms::bench::OdeMesh>());
  roster.push_back(std::make_unique<soms::bench::OdeBroad>());
}
