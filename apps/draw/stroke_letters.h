/// \file
/// The letters of the stroke font, as paths of a pen. Private to it.
#pragma once

#include <array>
#include <string_view>

namespace soms::look {

/// A letter on a grid on which digits and capitals are 10 high and small letters 6. Its path is a
/// list of `P x y x y ...`, a line through points, and `A x y rx ry from to`, part of an ellipse
/// about a point between two angles in degrees, counter-clockwise from the right.
struct StrokeLetter {
  char letter;
  double width;
  std::string_view path;
};

/// For letters that are not here.
inline constexpr std::string_view kUnknownLetter = "P 0 0 6 0 6 10 0 10 0 0";

inline constexpr std::array kStrokeLetters{
    StrokeLetter{' ', 1, ""},
    StrokeLetter{'.', 0.6, "P 0.3 0 0.3 0.3"},
    StrokeLetter{',', 1, "P 0.9 0.4 0.1 -1.8"},
    StrokeLetter{':', 0.6, "P 0.3 0 0.3 0.3 P 0.3 5 0.3 5.3"},
    StrokeLetter{';', 1, "P 0.9 0.4 0.1 -1.8 P 0.7 5 0.7 5.3"},
    StrokeLetter{'!', 0.6, "P 0.3 0 0.3 0.3 P 0.3 3 0.3 10"},
    StrokeLetter{'?', 5.4, "A 2.7 7.3 2.7 2.7 165 -60 P 4.05 4.96 2.7 3.6 2.7 2.6 P 2.7 0 2.7 0.3"},
    StrokeLetter{'-', 5, "P 0 4.3 5 4.3"},
    StrokeLetter{'+', 5, "P 0 4.3 5 4.3 P 2.5 1.8 2.5 6.8"},
    StrokeLetter{'=', 5, "P 0 3.2 5 3.2 P 0 5.8 5 5.8"},
    StrokeLetter{'/', 4, "P 0 -1 4 10.6"},
    StrokeLetter{'_', 6, "P 0 -1.4 6 -1.4"},
    StrokeLetter{'\'', 0.6, "P 0.3 7.6 0.3 10"},
    StrokeLetter{'"', 2.6, "P 0.3 7.6 0.3 10 P 2.3 7.6 2.3 10"},
    StrokeLetter{'(', 2.4, "A 4.6 4.3 4.6 7 125 235"},
    StrokeLetter{')', 2.4, "A -2.2 4.3 4.6 7 -55 55"},
    StrokeLetter{'[', 2.2, "P 2.2 10.6 0 10.6 0 -2 2.2 -2"},
    StrokeLetter{']', 2.2, "P 0 10.6 2.2 10.6 2.2 -2 0 -2"},
    StrokeLetter{'#', 7, "P 1.4 0 2.8 10 P 4.4 0 5.8 10 P 0 3.2 6.6 3.2 P 0.5 6.8 7 6.8"},
    StrokeLetter{'%', 8, "A 1.9 8 1.9 2 0 360 A 6.1 2 1.9 2 0 360 P 1.4 0 6.6 10"},
    StrokeLetter{'0', 6, "A 3 7 3 3 0 180 P 0 7 0 3 A 3 3 3 3 180 360 P 6 3 6 7"},
    StrokeLetter{'1', 6, "P 1.2 8 3.6 10 3.6 0"},
    StrokeLetter{'2', 6, "A 3 7 3 3 165 -38 P 5.36 5.15 0 0 6 0"},
    StrokeLetter{'3', 6, "A 2.9 7.6 2.5 2.4 155 -90 A 2.9 2.6 3 2.6 90 -155"},
    StrokeLetter{'4', 6, "P 4.6 0 4.6 10 0 3 6.2 3"},
    StrokeLetter{'5', 6, "P 5.4 10 1 10 0.6 5.3 A 2.9 3.2 3 3.2 140 -150"},
    StrokeLetter{'6', 6, "A 3 3.1 3 3.1 0 360 A 5.2 3.1 5.2 6.9 180 95"},
    StrokeLetter{'7', 6, "P 0 10 6 10 2 0"},
    StrokeLetter{'8', 6, "A 3 7.6 2.5 2.4 0 360 A 3 2.6 3 2.6 0 360"},
    StrokeLetter{'9', 6, "A 3 6.9 3 3.1 180 540 A 0.8 6.9 5.2 6.9 360 275"},
    StrokeLetter{'A', 7, "P 0 0 3.5 10 7 0 P 1.2 3.4 5.8 3.4"},
    StrokeLetter{'B', 5.8,
                 "P 0 0 0 10 3 10 A 3 7.6 2.4 2.4 90 -90 P 3 5.2 0 5.2 P 3 5.2 3.2 5.2 "
                 "A 3.2 2.6 2.6 2.6 90 -90 P 3.2 0 0 0"},
    StrokeLetter{'C', 7, "A 4 5 4 5 48 312"},
    StrokeLetter{'D', 6.8, "P 2.5 0 0 0 0 10 2.5 10 A 2.5 5 4.3 5 90 -90"},
    StrokeLetter{'E', 5.4, "P 5.4 10 0 10 0 0 5.4 0 P 0 5.2 4.6 5.2"},
    StrokeLetter{'F', 5.2, "P 5.2 10 0 10 0 0 P 0 5.2 4.4 5.2"},
    StrokeLetter{'G', 7.8, "A 4 5 4 5 48 360 P 8 5 8 4.6 4.8 4.6"},
    StrokeLetter{'H', 6.4, "P 0 0 0 10 P 6.4 0 6.4 10 P 0 5.2 6.4 5.2"},
    StrokeLetter{'I', 1, "P 0.5 0 0.5 10"},
    StrokeLetter{'J', 4, "P 4 10 4 2.6 A 2 2.6 2 2.6 0 -170"},
    StrokeLetter{'K', 6, "P 0 0 0 10 P 5.8 10 0 4 P 2 6 6 0"},
    StrokeLetter{'L', 5, "P 0 10 0 0 5 0"},
    StrokeLetter{'M', 8, "P 0 0 0 10 4 3 8 10 8 0"},
    StrokeLetter{'N', 6.4, "P 0 0 0 10 6.4 0 6.4 10"},
    StrokeLetter{'O', 8, "A 4 5 4 5 0 360"},
    StrokeLetter{'P', 5.8, "P 0 0 0 10 3 10 A 3 7.2 2.8 2.8 90 -90 P 3 4.4 0 4.4"},
    StrokeLetter{'Q', 8, "A 4 5 4 5 0 360 P 5 2.6 8 -0.6"},
    StrokeLetter{'R', 6, "P 0 0 0 10 3 10 A 3 7.2 2.8 2.8 90 -90 P 3 4.4 0 4.4 P 3 4.4 6 0"},
    StrokeLetter{'S', 6, "A 3 7.5 2.6 2.5 30 270 A 3 2.5 3 2.5 90 -155"},
    StrokeLetter{'T', 7, "P 0 10 7 10 P 3.5 10 3.5 0"},
    StrokeLetter{'U', 6.4, "P 0 10 0 3.2 A 3.2 3.2 3.2 3.2 180 360 P 6.4 3.2 6.4 10"},
    StrokeLetter{'V', 6.8, "P 0 10 3.4 0 6.8 10"},
    StrokeLetter{'W', 9.6, "P 0 10 2.4 0 4.8 10 7.2 0 9.6 10"},
    StrokeLetter{'X', 6, "P 0 0 6 10 P 0 10 6 0"},
    StrokeLetter{'Y', 6.6, "P 0 10 3.3 5 6.6 10 P 3.3 5 3.3 0"},
    StrokeLetter{'Z', 6, "P 0 10 6 10 0 0 6 0"},
    StrokeLetter{'a', 5.6, "A 2.8 3 2.8 3 0 360 P 5.6 6 5.6 0"},
    StrokeLetter{'b', 5.6, "P 0 10 0 0 A 2.8 3 2.8 3 0 360"},
    StrokeLetter{'c', 5.2, "A 3 3 3 3 45 315"},
    StrokeLetter{'d', 5.6, "A 2.8 3 2.8 3 0 360 P 5.6 10 5.6 0"},
    StrokeLetter{'e', 6, "P 0 3.1 6 3.1 A 3 3 3 3 2 318"},
    StrokeLetter{'f', 4, "P 1.4 0 1.4 7.8 A 3.4 7.8 2 2.2 180 75 P 0 6 3.4 6"},
    StrokeLetter{'g', 5.6, "A 2.8 3 2.8 3 0 360 P 5.6 6 5.6 -0.2 A 2.8 -0.2 2.8 2.6 0 -150"},
    StrokeLetter{'h', 5, "P 0 0 0 10 P 0 3.5 0 3.5 A 2.5 3.5 2.5 2.5 180 0 P 5 3.5 5 0"},
    StrokeLetter{'i', 1, "P 0.5 0 0.5 6 P 0.5 8.6 0.5 8.6"},
    StrokeLetter{'j', 2, "P 1.5 6 1.5 -1 A 0 -1 1.5 1.6 0 -90 P 1.5 8.6 1.5 8.6"},
    StrokeLetter{'k', 4.8, "P 0 0 0 10 P 4.4 6 0 2.1 P 1.6 3.5 4.8 0"},
    StrokeLetter{'l', 2, "P 0.5 10 0.5 1.5 A 2 1.5 1.5 1.5 180 270"},
    StrokeLetter{'m', 8, "P 0 0 0 6 A 2 4 2 2 180 0 P 4 4 4 0 A 6 4 2 2 180 0 P 8 4 8 0"},
    StrokeLetter{'n', 5, "P 0 0 0 6 A 2.5 3.5 2.5 2.5 180 0 P 5 3.5 5 0"},
    StrokeLetter{'o', 6, "A 3 3 3 3 0 360"},
    StrokeLetter{'p', 5.6, "P 0 6 0 -2.7 A 2.8 3 2.8 3 0 360"},
    StrokeLetter{'q', 5.6, "A 2.8 3 2.8 3 0 360 P 5.6 6 5.6 -2.7"},
    StrokeLetter{'r', 3.6, "P 0 0 0 6 A 2.6 3.4 2.6 2.6 180 68"},
    StrokeLetter{'s', 4.6, "A 2.3 4.45 2 1.55 25 270 A 2.3 1.45 2.3 1.45 90 -155"},
    StrokeLetter{'t', 4, "P 1.4 9 1.4 2 A 3.4 2 2 2 180 285 P 0 6 3.4 6"},
    StrokeLetter{'u', 5, "P 0 6 0 2.5 A 2.5 2.5 2.5 2.5 180 360 P 5 6 5 0"},
    StrokeLetter{'v', 5.2, "P 0 6 2.6 0 5.2 6"},
    StrokeLetter{'w', 8, "P 0 6 2 0 4 6 6 0 8 6"},
    StrokeLetter{'x', 5, "P 0 0 5 6 P 0 6 5 0"},
    StrokeLetter{'y', 5.4, "P 0 6 2.7 0 P 5.4 6 1.6 -2.7"},
    StrokeLetter{'z', 4.8, "P 0 6 4.8 6 0 0 4.8 0"}};

}  // namespace soms::look
