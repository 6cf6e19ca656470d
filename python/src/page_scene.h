/// \file
/// Bodies of Python, and what answers say of them, as the scene of a report's page.
#pragma once

#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/scene/contact_spans.h"
#include "soms/scene/step_report.h"

#include "apps/report/scene.h"
#include "python/src/arrays.h"
#include "python/src/call.h"
#include "python/src/objects.h"
#include "python/src/scene/bodies.h"
#include "python/src/scene/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::python {

/// Bodies at steps, and what answers say of them.
class PageScene {
 public:
  /// `given`: a scene, a body or bodies; with `poses`, two bodies of which the first moves.
  /// \errors ErrorKind::usage.
  PageScene(const py::object& given, const py::object& poses);

  /// \errors ErrorKind::usage unless there are as many poses, or none were given and it is one.
  void check_steps(std::size_t entries) const;

  /// \errors ErrorKind::usage for the report of another scene.
  void add_step(const StepReport& report);

  /// \errors ErrorKind::usage unless there are two bodies, and for triangles that they have not.
  void add_overlap(std::size_t step, std::span<const TrianglePair> pairs, Coverage coverage);
  void add_distance(std::size_t step, const Distance& distance);

  [[nodiscard]] std::string title() const;

  /// What is drawn. This must stay as long as it does.
  [[nodiscard]] report::Scene scene() const;

 private:
  /// Pairs of triangles of two bodies at a step, of which the first are kept.
  struct Sample {
    std::vector<TrianglePair> pairs;
    std::uint64_t pairs_in_all = 0;
  };

  void add_body(Body body, std::string name, bool moves);
  void add_scene(HeldScene& held);
  void check_pair() const;
  [[nodiscard]] Pose pose_of_body(std::size_t body, std::size_t step) const;
  [[nodiscard]] std::uint32_t number_of(const soms::SceneBody& body) const;
  void follow(std::size_t step, StepReport report);
  void add_gap(std::uint32_t a, std::uint32_t b, std::size_t step, const Bracket& distance,
               const Vec3& point_a, const Vec3& point_b);
  void add_rows(report::Scene& scene) const;

  std::vector<Body> bodies_;
  std::vector<std::string> names_;
  std::vector<bool> moves_;
  std::map<soms::SceneBody, std::uint32_t> numbers_;  ///< places in `bodies_`
  std::optional<Rows<Pose>> poses_;                   ///< of the first body
  std::size_t steps_ = 1;
  ContactSpans spans_;
  std::map<std::array<std::size_t, 3>, Sample> samples_;  ///< by step, body and body
  std::vector<report::SceneGap> gaps_;
  bool lists_contacts_ = false;
  bool complete_ = true;
};

}  // namespace soms::python
