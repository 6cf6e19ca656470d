/// \file
/// Rows of motions of a model beside another one that rests.
#pragma once

#include "soms/motion/rigid_motion.h"

#include "apps/rows/pose_source.h"
#include "apps/rows/row_run.h"
#include "apps/soms/pairs/motion.h"
#include "apps/soms/pairs/pair_report.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::command {

/// Motions of --from with --to or --by, or from each pose of --path to the next.
class MotionSource {
 public:
  /// \errors As `PoseSource`; ErrorKind::usage for a path of one pose.
  MotionSource(const MotionVerbOptions& options, const Console& console);

  /// The options themselves have the only motion, and no file.
  [[nodiscard]] bool is_stated() const { return !path_ && ends_.is_stated(); }

  /// There is one row. Waits for the second one of files.
  [[nodiscard]] bool is_single();

  [[nodiscard]] bool ready() { return path_ ? path_->ready() : ends_.ready(); }

  /// The next motion, or nothing at the end. \errors As `PosePairs::next` and RigidMotion.
  [[nodiscard]] std::optional<RigidMotion> next();

 private:
  [[nodiscard]] std::optional<RigidMotion> next_of_path();

  std::optional<PoseSource> path_;
  PosePairs ends_;  ///< where no path is given
  std::optional<Vec3> by_;
  Vec3 pivot_;
  std::optional<Pose> last_;  ///< of the path: where the next motion starts
};

class MotionRows : public Rows {
 public:
  /// Opens the poses and reads the models.
  MotionRows(const MotionVerbOptions& options, Console& console);

  [[nodiscard]] const MotionVerbOptions& options() const { return options_; }

  [[nodiscard]] const PairReport& pair() const { return report_; }

  [[nodiscard]] const Shape& mover() const { return a_.shape; }

  /// Where B rests, or starts.
  [[nodiscard]] const Body& fixed() const { return fixed_; }

  /// The way of B, if it moves: the same for all motions.
  [[nodiscard]] const std::optional<RigidMotion>& way_of_b() const { return way_of_b_; }

  [[nodiscard]] const std::vector<RigidMotion>& block() const { return block_; }

  /// Rows of the input before the block.
  [[nodiscard]] std::uint64_t before() const { return before_; }

  void begin() override;

  [[nodiscard]] bool is_single() const override { return report_.single; }

  void clear() override;

  bool ready() override { return source_.ready(); }

  bool read() override;
  void report(const AnsweredRow& row) override;
  bool end(RunEnd end) override;

 private:
  MotionVerbOptions options_;
  Console& console_;
  MotionSource source_;
  ModelShape a_;
  ModelShape b_;
  Body fixed_;
  std::optional<RigidMotion> way_of_b_;
  PairReport report_;
  std::vector<RigidMotion> block_;
  std::uint64_t before_ = 0;
};

}  // namespace soms::command
