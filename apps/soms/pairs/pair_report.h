/// \file
/// What is reported beside the answers about two models, whatever the question is.
#pragma once

#include "soms/base/vector.h"
#include "soms/query/answer.h"

#include "apps/model/file_numbers.h"
#include "apps/model/frame_warnings.h"
#include "apps/model/georeference.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// Two models at rows of poses, and how answers about them are reported.
struct PairReport {
  MeshView a;  ///< as its file is: triangles of answers have its numbers
  MeshView b;
  ModelShape left_a = {};  ///< what takes part, for pages and for `in_files`
  ModelShape left_b = {};
  bool single = true;      ///< one pose: reported at length; else a line a pose
  bool verified = false;   ///< compared with brute force
  bool lists_rows = true;  ///< an answer a row is printed; else it is in files alone
  bool interrupted = false;
  bool timed_out = false;                   ///< --timeout ended the run; there may be more poses
  std::vector<std::string> notes = {};      ///< of the models' files; JSON gives them with pose 0
  std::vector<FrameWarning> warnings = {};  ///< about the models; JSON gives them with pose 0
  Georeference georeference = {};  ///< of coordinates in answers; JSON gives it with pose 0
  std::string read_a = {};         ///< ", --up y": the options that A was scaled or turned by
  std::string read_b = {};
  double gap = 0;                 ///< of the boxes, at the pose that is reported next; 0: they meet
  bool one_box_in_other = false;  ///< the box of one model holds that of the other, likewise
  bool boxes_apart = false;       ///< that gap is a `FrameDoubt`
};

/// The keys "coverage" and "cost" of JSON, with a comma before. `more` are further counts, each
/// with a comma before.
[[nodiscard]] std::string coverage_keys(Coverage coverage, const Cost& cost,
                                        std::string_view more = {});

/// The keys "verified", "timed_out", "georeference", "notes" and "warnings" of pose number `pose`,
/// those that apply, each with a comma before. `right` says whether brute force agrees, where
/// requested.
[[nodiscard]] std::string report_keys(const PairReport& report, std::uint64_t pose, bool right);

}  // namespace soms::command
