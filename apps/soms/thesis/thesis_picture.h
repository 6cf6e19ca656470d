/// \file
/// Tests of `thesis`, shown by soms-view: in a window, or as pictures of chosen frames.
#pragma once

#include "apps/soms/thesis/thesis.h"
#include "apps/soms/thesis/thesis_run.h"

#include <vector>

namespace soms::command {

class Console;

/// Opens a window in which the first of these tests runs; returns soms-view's exit status.
/// \errors ErrorKind::unsupported without soms-view.
[[nodiscard]] int show_trip(const ThesisTrip& what, const ThesisOptions& options,
                            const Console& console);

/// Pictures of a test, in the folder of --picture: the first frame in which roots overlap, the
/// first with a contact, and the last, with the boxes that the traversal visited.
class ThesisPictures {
 public:
  /// Makes sure that soms-view and the folder are there; nothing without --picture.
  /// \errors ErrorKind::unsupported without soms-view; ErrorKind::cannot_write.
  explicit ThesisPictures(const ThesisOptions& options);

  /// Draws the tests; returns soms-view's exit status, 0 without --picture.
  [[nodiscard]] int draw(const std::vector<ThesisResult>& results, const Console& console) const;

 private:
  const ThesisOptions& options_;
};

}  // namespace soms::command
