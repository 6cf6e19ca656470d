/// \file
/// The page of motions: what `motion` writes to -o FILE.html.
#pragma once

#include "soms/motion/first_contact.h"

#include "apps/report/page.h"
#include "apps/soms/pairs/pair_page.h"

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace soms::command {

/// An answer in words.
struct MotionSaid {
  std::string verdict = {};     ///< "t = 0.5", as a cell of a table
  std::string sentence = {};    ///< what A is, with the times
  std::string triangle_a = {};  ///< as labels; empty: the answer names none
  std::string triangle_b = {};
};

/// Remembers answers as they come, however many: of as many motions as a page has room for, those
/// that are not free before the others.
class MotionPage {
 public:
  /// The meshes of `models` must stay. B rests at `resting`.
  MotionPage(PageModels models, const Pose& resting);

  /// Adds the answer of the next motion; triangles have the numbers of the meshes.
  void add(const RigidMotion& motion, const FirstContact& answer, const MotionSaid& said);

  /// Writes the page of the answers so far.
  void write(std::ostream& out, const PairReport& report, const RowTotals& totals) const;

 private:
  struct Kept {
    report::SceneMotion shown;
    TrianglePair triangles;  ///< where `shown` has a place
    std::string triangle_a;
    std::string triangle_b;
  };

  [[nodiscard]] std::vector<Kept> chosen() const;
  [[nodiscard]] std::string lead(const std::vector<Kept>& motions) const;
  [[nodiscard]] report::Scene scene(const std::vector<Kept>& motions) const;
  [[nodiscard]] report::Table table(const std::vector<Kept>& motions) const;

  PageModels models_;
  Pose resting_;
  bool complete_ = true;  ///< no answer was cut
  Cost cost_;
  std::uint64_t motions_ = 0;
  std::uint64_t blocked_in_all_ = 0;
  std::vector<Kept> blocked_;  ///< the first of them
  std::vector<Kept> free_;     ///< likewise
};

}  // namespace soms::command
