/// \file
/// A body that is small beside another one goes down the other's tree as one box first: most of
/// its queries end there, before anything is made ready for pairs of nodes.
///
/// Proof. In the terms of relative_pose.h, a point u of x lies in x's box, whose center is the
/// tree's origin, so |(N u)_i| <= r_i, the sum of |N_ij| times half side j. With v = o + q of an
/// axis-aligned node of y, |q_i - c_i| <= h_i for the box of its lane, z_i = (D - o)_i + (N u)_i -
/// q_i gives |c_i - (D - o)_i| <= h_i + r_i + W. In float, in units of 2^-24 T, T = r_0 + r_1 + r_2
/// + the node's L1 radius: D - o is rounded once (1), the difference of centers (1), r_i (1) and
/// two sums (2); what the doubles lose is in the slack. The margin is 2^-19 T, 32 of them, and the
/// slack. Held against a min/max grid, D stays a double, and r_i alone is rounded: 2^-19 of the sum
/// of r, and the slack, of which half is W; the other half is more than what the ends of the box
/// and of the triangles, sums of two doubles, lose. Floats that underflow lose 2^-150 each, doubles
/// 2^-1075: the slack has 2^-100 and W's 2^-1064 for them.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/engine/pair_list.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <array>

namespace soms::detail {

/// The box of all of x, along the axes of y's tree and in the units of its layout.
struct SingleBox {
  std::array<double, 3> center;  ///< relative to y's origin, in the mesh's units
  std::array<float, 3> half;
  float size;  ///< longest of `half`
  float sum;   ///< all of them
  float slack;
  double scale;           ///< turns the mesh's units into those of the layout
  layout::PlanBox place;  ///< above y's ground plan, once `find_place` has found it

  /// The box at pose `i` of several; `placed` if y has a ground plan, so that its place is there,
  /// too.
  void take(const RelativePoses& poses, std::size_t i, bool placed);

  /// Whether the box is so small beside a tree that it should go down alone.
  [[nodiscard]] bool pays(const WideNode& root) const;

  /// Finds `place`, if y has a ground plan. What follows needs it.
  void find_place(const WideTree& y);

  /// True only if y's height grid, if it has one, knows that nothing of its mesh meets the box.
  [[nodiscard]] bool clear_of(const WideTree& y) const;

  /// Appends the nodes and leaves of y that the box may meet, as partners of x's root: leaves,
  /// oriented nodes, and nodes about as large as the box. `stack` is empty before and after.
  void descend(const WideTree& y, PairList& stack, PairList& seeds, Cost& cost) const;

  /// Puts where `descend` begins into `index` and the empty stack; false where nothing is met.
  [[nodiscard]] bool begin(const WideTree& y, std::uint32_t& index, PairList& stack) const;

  /// One node of the way of `descend`. Turns `index`
  /// into the next node, which starts to load; false where there is none.
  [[nodiscard]] bool step(const WideNode* nodes, std::uint32_t& index, PairList& stack,
                          PairList& seeds, Cost& cost) const;

 private:
  /// Lanes of an axis-aligned node whose boxes may meet this one.
  [[nodiscard]] std::uint32_t meets(const WideNode& node) const;
};

}  // namespace soms::detail
