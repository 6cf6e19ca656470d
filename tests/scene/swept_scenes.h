/// \file
/// Scenes that take swept steps alike.
#pragma once

#include "soms/scene/scene.h"

#include "tests/scene/passages_twin.h"
#include "tests/support/support.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace soms::test {

[[nodiscard]] inline Passages passages_of(const StepReport& report) {
  return {report.environment_passages, report.mover_passages};
}

/// Scenes that have the same done to them, one for each way to take a step.
class Scenes {
 public:
  template <typename Change>
  void change(const Change& change) {
    for (Scene& scene : scenes_) {
      change(scene);
    }
  }

  [[nodiscard]] Scene& front() { return scenes_.front(); }

  /// The same for any threads, coherent or not.
  StepReport step(const StepOptions& given = {.swept = true}) {
    std::optional<StepReport> report;
    for (std::size_t k = 0; k < scenes_.size(); ++k) {
      StepOptions options = given;
      options.coherent = k % 2 == 0;
      const StepReport found = scenes_[k].step(options, {.threads = k < 2 ? 1 : 2});
      if (report) {
        EXPECT_EQ(found, *report) << k;
      }
      report = found;
    }
    return *report;
  }

 private:
  std::vector<Scene> scenes_ = std::vector<Scene>(4);
};

}  // namespace soms::test
