/// \file
/// Answers of the verb `overlap` as text and as JSON Lines.
#pragma once

#include "soms/query/overlap.h"

#include "apps/support/frame_warnings.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace soms::command {

class Console;
struct PartPair;

/// What is reported about the answer of one pose, and how.
struct OverlapReport {
  const Mesh& a;
  const Mesh& b;
  OverlapMode mode = OverlapMode::all;
  bool list_pairs = true;
  bool single = true;                     ///< one pose: pairs are listed; else a line a pose
  bool verified = false;                  ///< compared with brute force
  Traversal traversal = Traversal::fast;  ///< counts of any other are reported
  bool interrupted = false;
  bool timed_out = false;                   ///< --timeout ended the run; there may be more poses
  bool by_part = false;                     ///< pairs of parts are listed, not of triangles
  std::vector<std::string> notes = {};      ///< of the models' files; JSON gives them with pose 0
  std::vector<FrameWarning> warnings = {};  ///< about the models; JSON gives them with pose 0
  std::string read_a = {};  ///< ", --up y": the options that A was scaled or turned by
  std::string read_b = {};
  double gap = 0;            ///< of the boxes, at the pose that is reported next; 0: they meet
  bool boxes_apart = false;  ///< that gap is a `FrameDoubt`
};

/// Totals over all poses.
struct OverlapTotals {
  std::uint64_t poses = 0;
  std::uint64_t overlapping = 0;
  std::uint64_t undecided = 0;  ///< cut before any pair was found
  std::uint64_t wrong = 0;      ///< differ from brute force

  void add(const Overlap& answer);
};

/// Prints the answer of pose number `pose`: JSON with --json, text without. `right` says whether
/// brute force agrees, where requested. `parts` are those of the answer, for `report.by_part`.
void print_answer(const OverlapReport& report, std::uint64_t pose, const Overlap& answer,
                  bool right, Console& console, std::span<const PartPair> parts = {});

/// Prints a line over all poses, where there may be several and no JSON is requested.
void print_totals(const OverlapReport& report, const OverlapTotals& totals, Console& console);

}  // namespace soms::command
