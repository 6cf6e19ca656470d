/// \file
/// A renderer for tests: draws nothing and records its calls.
#pragma once

#include "apps/view/drawing/renderer.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>

namespace soms::view {

/// Remembers the last list and counts; its pictures show the lower background color.
class RecordingRenderer final : public Renderer {
 public:
  void draw(const DrawList& list, const Camera& camera, Size size,
            const DrawOptions& options = {}) override;

  void present() override { ++presented_; }

  [[nodiscard]] Picture read_pixels() override;

  [[nodiscard]] DrawStatistics statistics() const override { return statistics_; }

  [[nodiscard]] std::size_t drawn() const { return drawn_; }

  [[nodiscard]] std::size_t presented() const { return presented_; }

  [[nodiscard]] const DrawList& list() const { return list_; }

  [[nodiscard]] const Camera& camera() const { return camera_; }

  [[nodiscard]] Size size() const { return size_; }

  [[nodiscard]] const DrawOptions& options() const { return options_; }

 private:
  std::size_t drawn_ = 0;
  std::size_t presented_ = 0;
  DrawList list_;
  Camera camera_;
  Size size_{0, 0};
  DrawOptions options_;
  DrawStatistics statistics_;
  std::set<std::pair<std::uint64_t, std::uint64_t>> uploaded_;
};

}  // namespace soms::view
