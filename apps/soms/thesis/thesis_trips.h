/// \file
/// What `thesis` moves past what: the models, upright and with their trees, and where the moving
/// one is in each frame.
#pragma once

#include "soms/geometry/mesh.h"

#include "apps/model/frame_warnings.h"
#include "thesis/trips/frames.h"

#include <cstddef>
#include <string>
#include <vector>

namespace soms::command {

class Console;
struct ThesisOptions;

/// How a model is come by again.
struct ThesisFile {
  std::string path = {};        ///< empty: a model of the thesis, which may have none
  double scale = 1;             ///< of its coordinates
  bool scale_is_given = false;  ///< 1, too, is the user's word about the unit
  UpAxis up = UpAxis::unknown;  ///< axis of the file that was turned to z; unknown: none was
};

/// Levels of a tree by their numbers.
struct LevelsOfTree {
  int last = 0;  ///< 0: no limit
  int root = 1;  ///< 1 or 0
};

/// A test of one model against another.
struct ThesisTrip {
  reproduce::Trip trip = {};
  ThesisFile still_file = {};
  ThesisFile moving_file = {};
  std::string still_title = {};   ///< for people
  std::string moving_title = {};  ///< likewise
  std::size_t up = 2;             ///< up axis of both: 1 (y) or 2 (z)
  bool stand_in = false;          ///< a model was made in the place of one of the thesis
  LevelsOfTree still_levels = {};
  LevelsOfTree moving_levels = {};
};

/// All trips, and what is to be said of the models.
struct ThesisTrips {
  std::vector<ThesisTrip> trips = {};
  std::vector<std::string> remarks = {};
  std::vector<FrameWarning> warnings = {};
};

/// Reads or makes the models, builds their trees and lays out the tests.
/// Warns of units that differ.
/// \errors As `read_model`, `tell_warnings` and `reproduce::find_models`; ErrorKind::timed_out.
[[nodiscard]] ThesisTrips thesis_trips(const ThesisOptions& options, const Console& console);

}  // namespace soms::command
