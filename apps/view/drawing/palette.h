/// \file
/// Colors that people who see fewer colors tell apart too.
#pragma once

#include "apps/draw/look.h"
#include "apps/view/drawing/draw_list.h"

#include <cstddef>

namespace soms::view {

/// The colors of the window and its pictures, which have one light look: those of
/// apps/draw/look.h where a color has a meaning, else eight by Okabe and Ito and a violet. Only
/// contacts are red: of surfaces, or of boxes beside surfaces that are violet.
/// \source Okabe, Ito 2008, Color Universal Design.
namespace palette {

inline constexpr Color kBlack{0, 0, 0, 255};
inline constexpr Color kOrange{230, 159, 0, 255};
inline constexpr Color kSkyBlue{86, 180, 233, 255};
inline constexpr Color kGreen{0, 158, 115, 255};
inline constexpr Color kYellow{240, 228, 66, 255};
inline constexpr Color kBlue{0, 114, 178, 255};
inline constexpr Color kPurple{204, 121, 167, 255};
inline constexpr Color kViolet{122, 34, 230, 255};

inline constexpr Color kBodyA = color_of(look::kBodyA.light);
inline constexpr Color kBodyB = color_of(look::kBodyB.light);
inline constexpr Color kContact = color_of(look::kContact.light);
inline constexpr Color kGap = color_of(look::kNearest.light);
inline constexpr Color kFree = color_of(look::kFree.light);
inline constexpr Color kInk = color_of(look::kInk.light);
inline constexpr Color kPaper = color_of(look::kPaper.light);  ///< sets marks off from any surface
inline constexpr Color kGround = color_of(look::kGround.light);
inline constexpr Color kSkyLow = color_of(look::kSkyLow.light);
inline constexpr Color kSkyHigh = color_of(look::kSkyHigh.light);

}  // namespace palette

/// A shade of sand for building or part number `i`: neighbors in number differ in lightness, and
/// none looks like a mark.
[[nodiscard]] Color part_color(std::size_t i);

/// The color of number `i` among things that are distinguished, such as movers: strong and
/// different for `i` below 6, then again from the start.
[[nodiscard]] Color mover_color(std::size_t i);

/// The color of a tree level or another ordered quantity, `t` from 0 to 1, dark blue to yellow.
[[nodiscard]] Color ordered_color(double t);

/// One color for each triangle of a mesh by its part; all of the first color where it has none.
[[nodiscard]] std::vector<Color> colors_by_part(const Mesh& mesh);

}  // namespace soms::view
