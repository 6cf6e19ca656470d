/// \file
/// `simulate -o FILE.png`: a frame drawn by soms-view from a recording.
#pragma once

#include "apps/cli/temporary_folder.h"
#include "apps/soms/simulate/simulate.h"
#include "apps/soms/simulate/simulate_run.h"

#include <optional>
#include <string>

namespace soms::command {

/// Throws ErrorKind::usage for a picture of a frame that will not be.
void check_picture_frame(const SimulateOptions& options);

/// The recording that a picture is drawn from: that of --record, or one that goes with the object.
class Picture {
 public:
  /// Nothing where no picture is requested. \errors ErrorKind::usage for --picture-frame alone, or
  /// a recording that cannot be read again; unsupported where soms-view is missing;
  /// cannot_write where no picture can be.
  explicit Picture(const SimulateOptions& options);

  /// The file to record to; empty where nothing is.
  [[nodiscard]] const std::string& recording() const { return recording_; }

  /// Draws the picture; returns soms-view's exit status, nothing where none is requested or no
  /// frame is there. \errors As `draw_frame`.
  [[nodiscard]] std::optional<int> draw(const Outcome& outcome, const Console& console) const;

 private:
  const SimulateOptions& options_;
  std::optional<TemporaryFolder> folder_;  ///< ours; nothing where the recording is kept
  std::string recording_;
};

}  // namespace soms::command
