/// \file
/// Colors that people who see fewer colors tell apart too.
#pragma once

#include "apps/view/drawing/draw_list.h"

#include <cstddef>

namespace soms::view {

/// Eight colors by Okabe and Ito. `vermilion` is for what touches, and for nothing else. Gaps are
/// drawn in ink on paper, as on report pages and maps.
/// \source Okabe, Ito 2008, Color Universal Design.
namespace palette {

inline constexpr Color kBlack{0, 0, 0, 255};
inline constexpr Color kOrange{230, 159, 0, 255};
inline constexpr Color kSkyBlue{86, 180, 233, 255};
inline constexpr Color kGreen{0, 158, 115, 255};
inline constexpr Color kYellow{240, 228, 66, 255};
inline constexpr Color kBlue{0, 114, 178, 255};
inline constexpr Color kVermilion{213, 94, 0, 255};
inline constexpr Color kPurple{204, 121, 167, 255};

inline constexpr Color kContact{222, 32, 12, 255};  ///< red of contacts: vermilion, stronger
inline constexpr Color kGap{43, 42, 40, 255};       ///< ink
inline constexpr Color kPaper{255, 255, 255, 255};  ///< sets ink off from any surface

}  // namespace palette

/// A muted color for building or part number `i`: neighbors in number differ, none looks like a
/// mark.
[[nodiscard]] Color part_color(std::size_t i);

/// The color of number `i` among things that are distinguished, such as movers: strong and
/// different for `i` below 6, then again from the start.
[[nodiscard]] Color mover_color(std::size_t i);

/// The color of a tree level or another ordered quantity, `t` from 0 to 1, dark blue to yellow.
[[nodiscard]] Color ordered_color(double t);

/// One color for each triangle of a mesh by its part; all of the first color where it has none.
[[nodiscard]] std::vector<Color> colors_by_part(const Mesh& mesh);

}  // namespace soms::view
