/// \file
/// How far red reaches about contacts: as far as their curves are wide.
#pragma once

#include "soms/base/vector.h"

#include "apps/view/drawing/draw_list.h"

#include <cstddef>
#include <vector>

namespace soms::view {

/// The curves of contacts, piece by piece. Pieces whose ends meet are one curve.
class ContactGlow {
 public:
  /// Adds a piece whose red reaches no farther than `most`. Where pieces are a selection, whose
  /// ends do not meet, `group` says what belongs together.
  void add(const Vec3& a, const Vec3& b, double most) { pieces_.push_back({a, b, most, kNoGroup}); }

  void add(const Vec3& a, const Vec3& b, double most, std::size_t group) {
    pieces_.push_back({a, b, most, group});
  }

  /// Red about each curve, three tenths of its width far: of a ring its diameter, of a straight
  /// scratch next to nothing, for which pictures have a least width. Of many short pieces about one
  /// place one is left. \cost Nearly linear.
  [[nodiscard]] std::vector<Glow> glows() const;

 private:
  static constexpr std::size_t kNoGroup = static_cast<std::size_t>(-1);

  struct Piece {
    Vec3 a;
    Vec3 b;
    double most = 0;
    std::size_t group = kNoGroup;
  };

  [[nodiscard]] std::vector<std::size_t> curve_of_pieces() const;

  std::vector<Piece> pieces_;
};

}  // namespace soms::view
