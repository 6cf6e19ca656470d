// Embree's own triangles: the nearest point by rtcPointQuery, which leaves the distance of a
// triangle to the caller, and rays one by one. Built at medium and high quality; robust or not.
#include "bench/peers/libraries/embree_surface.h"

#include "bench/peers/libraries/embree_device.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace soms::bench {

namespace {

/// Ericson 2004, 5.1.5: the region of the triangle that the nearest point is in.
double squared_distance(const Vec3& p, const Triangle& t) {
  const Vec3 ab = t.b - t.a;
  const Vec3 ac = t.c - t.a;
  const Vec3 ap = p - t.a;
  const auto square = [](const Vec3& v) { return dot(v, v); };
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) {
    return square(ap);
  }
  const Vec3 bp = p - t.b;
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) {
    return square(bp);
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    return square(ap - (d1 / (d1 - d3)) * ab);
  }
  const Vec3 cp = p - t.c;
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) {
    return square(cp);
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    return square(ap - (d2 / (d2 - d6)) * ac);
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return square(bp - ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (t.c - t.b));
  }
  const double share = 1 / (va + vb + vc);
  return square(ap - (vb * share) * ab - (vc * share) * ac);
}

/// A body in a scene of its own.
class EmbreeSurface final : public Match {
 public:
  EmbreeSurface(const FloatMesh& mesh, RTCBuildQuality quality, bool robust) : mesh_(mesh) {
    const EmbreeDevice& device = EmbreeDevice::shared();
    const UnseenBytes unseen;
    scene_ = rtcNewScene(device.get());
    rtcSetSceneFlags(scene_, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene_, quality);
    const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, quality);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.vertices.size()));
    for (const auto& v : mesh.vertices) {
      vertices = std::copy(v.begin(), v.end(), vertices);
    }
    auto* corners = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.triangles.size()));
    for (const auto& t : mesh.triangles) {
      corners = std::copy(t.begin(), t.end(), corners);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    unseen_ = unseen.taken();
  }

  ~EmbreeSurface() override { rtcReleaseScene(scene_); }

  EmbreeSurface(const EmbreeSurface&) = delete;
  EmbreeSurface& operator=(const EmbreeSurface&) = delete;

  void answer(const Questions& questions, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      answers[i] = questions.job == Job::closest       ? distance(questions.points[i])
                   : questions.job == Job::closest_hit ? first_hit(questions.rays[i])
                   : any_hit(questions.rays[i])        ? 1
                                                       : 0;
    }
  }

  [[nodiscard]] std::size_t unseen_bytes() const override { return unseen_; }

 private:
  struct Search {
    const FloatMesh* mesh;
    Vec3 point;
    double square = std::numeric_limits<double>::infinity();
  };

  static bool nearer(RTCPointQueryFunctionArguments* found) {
    auto& search = *static_cast<Search*>(found->userPtr);
    const double square = squared_distance(search.point, search.mesh->triangle(found->primID));
    if (!(square < search.square)) {
      return false;
    }
    search.square = square;
    found->query->radius = static_cast<float>(std::sqrt(square));
    return true;
  }

  [[nodiscard]] double distance(const Vec3& point) const {
    Search search{&mesh_, point};
    RTCPointQuery query{static_cast<float>(point.x), static_cast<float>(point.y),
                        static_cast<float>(point.z), 0, std::numeric_limits<float>::infinity()};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_, &query, &context, nearer, &search);
    return std::sqrt(search.square);
  }

  static RTCRay ray_of(const ProbeRay& ray) {
    RTCRay r{};
    r.org_x = static_cast<float>(ray.origin.x);
    r.org_y = static_cast<float>(ray.origin.y);
    r.org_z = static_cast<float>(ray.origin.z);
    r.dir_x = static_cast<float>(ray.direction.x);
    r.dir_y = static_cast<float>(ray.direction.y);
    r.dir_z = static_cast<float>(ray.direction.z);
    r.tfar = std::numeric_limits<float>::infinity();
    r.mask = ~0U;
    return r;
  }

  [[nodiscard]] double first_hit(const ProbeRay& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit hit{ray_of(ray), {}};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &hit);
    return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kMiss : static_cast<double>(hit.ray.tfar);
  }

  [[nodiscard]] bool any_hit(const ProbeRay& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay r = ray_of(ray);
    rtcOccluded1(scene_, &context, &r);
    return r.tfar < 0;
  }

  FloatMesh mesh_;
  RTCScene scene_ = nullptr;
  std::size_t unseen_ = 0;
};

/// `embree-medium`, `embree-high`, and with watertight rays `embree-robust-medium`, `-high`.
class EmbreeProbes final : public Library {
 public:
  EmbreeProbes(bool high, bool robust) : high_(high), robust_(robust) {}

  [[nodiscard]] std::string name() const override {
    return std::string(robust_ ? "embree-robust-" : "embree-") + (high_ ? "high" : "medium");
  }

  [[nodiscard]] std::string version() const override { return RTC_VERSION_STRING; }

  [[nodiscard]] bool does(Job job) const override {
    return job == Job::closest_hit || job == Job::any_hit || (job == Job::closest && !robust_);
  }

  [[nodiscard]] Precision precision() const override { return Precision::floats; }

  [[nodiscard]] bool watertight() const override { return robust_; }

  [[nodiscard]] std::unique_ptr<Match> prepare_probes(Job, const FloatMesh& body) const override {
    return std::make_unique<EmbreeSurface>(
        body, high_ ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM, robust_);
  }

 private:
  bool high_;
  bool robust_;
};

}  // namespace

void add_embree_surface(Roster& roster) {
  for (const bool robust : {false, true}) {
    for (const bool high : {false, true}) {
      roster.push_back(std::make_unique<EmbreeProbes>(high, robust));
    }
  }
}

}  // namespace soms::bench
