/// \file
/// The functions behind the table of experiments, one file each (or one for those of a kind).
#pragma once

#include "reproduce/experiment.h"

namespace soms::reproduce {

/// Objects of the thesis: vertices and faces of each PLY file. \source thesis, table 3.1.
[[nodiscard]] Result table_3_1(const Context& context);

/// The orientation tests: axis and direction of each. \source thesis, table 3.2.
[[nodiscard]] Result table_3_2(const Context& context);

/// The object and from where its like comes at it. \source thesis, figure 3.8.
[[nodiscard]] Result figure_3_8(const Context& context);

/// What pruning saves, in counts and as a picture. \source thesis, figure 4.35.
[[nodiscard]] Result figure_4_35(const Context& context);

/// The tests right, left and top by the generic traversal, frame by frame. \source thesis, figures
/// 5.6, 5.7 and 5.8.
[[nodiscard]] Result figure_5_6(const Context& context);
[[nodiscard]] Result figure_5_7(const Context& context);
[[nodiscard]] Result figure_5_8(const Context& context);

/// E-Node explained step by step. \source thesis, figure 5.9.
[[nodiscard]] Result figure_5_9(const Context& context);

/// E-Node against the traversal after Larsson. \source thesis, figure 5.10.
[[nodiscard]] Result figure_5_10(const Context& context);

/// The tests from the sides of which the thesis has no figure, as figures 5.6 to 5.8.
[[nodiscard]] Result orientation_bottom(const Context& context);
[[nodiscard]] Result orientation_front(const Context& context);
[[nodiscard]] Result orientation_back(const Context& context);

/// Every walk of two trees on the orientation tests and the city drives.
[[nodiscard]] Result traversals(const Context& context);

}  // namespace soms::reproduce
