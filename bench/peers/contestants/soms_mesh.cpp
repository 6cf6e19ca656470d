#include "soms/query/overlap.h"

#include "bench/peers/contestants/contestant.h"

namespace soms::bench {

namespace {

Shape shape_of(const FloatMesh& mesh) {
  Mesh wide;
  wide.vertices.reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) {
    wide.vertices.push_back({v[0], v[1], v[2]});
  }
  wide.triangles = mesh.triangles;
  return Shape(std::move(wide));
}

constexpr OverlapOptions kAny{.mode = OverlapMode::any};

class SomsSingle final : public Match {
 public:
  SomsSingle(const FloatMesh& mover, const FloatMesh& fixed)
      : mover_(shape_of(mover)), fixed_(shape_of(fixed)) {}

  void any(std::span<const Pose> poses, std::span<std::uint8_t> touches) override {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      mover_.pose = poses[i];
      touches[i] = overlap(mover_, fixed_, kAny).any ? 1 : 0;
    }
  }

 private:
  Body mover_;
  Body fixed_;
};

class SomsBatch final : public Match {
 public:
  SomsBatch(const FloatMesh& mover, const FloatMesh& fixed)
      : mover_(shape_of(mover)), fixed_(shape_of(fixed)) {}

  void any(std::span<const Pose> poses, std::span<std::uint8_t> touches) override {
    const OverlapBatch batch = overlap(mover_, poses, fixed_, kAny);
    std::copy(batch.any.begin(), batch.any.end(), touches.begin());
  }

 private:
  Shape mover_;
  Body fixed_;
};

template <class SomsMatch>
class Soms final : public Contestant {
 public:
  explicit Soms(std::string name) : name_(std::move(name)) {}

  [[nodiscard]] std::string name() const override { return name_; }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    return std::make_unique<SomsMatch>(mover, fixed);
  }

 private:
  std::string name_;
};

}  // namespace

void add_soms(Roster& roster) {
  roster.push_back(std::make_unique<Soms<SomsSingle>>("soms"));
  roster.push_back(std::make_unique<Soms<SomsBatch>>("soms-batch"));
}

}  // namespace soms::bench
