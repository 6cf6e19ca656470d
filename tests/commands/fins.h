/// \file
/// Models of many parts that all cross: rows of upright fins.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

namespace soms::test {

/// `parts` parts of `fins` upright triangles each as OBJ, named PREFIX0, PREFIX1, ... Those along x
/// and those along y cross each other, every fin every fin, at heights from 0 to 9 and around
/// (part of y, part of x).
[[nodiscard]] inline std::string fins_obj(const std::string& prefix, int parts, int fins,
                                          bool along_x) {
  std::string text;
  int vertex = 1;
  for (int p = 0; p < parts; ++p) {
    text += fmt::format("o {}{}\n", prefix, p);
    for (int f = 0; f < fins; ++f) {
      const double at = p + 0.5 * f / fins;
      for (const auto& [along, z] :
           {std::pair(-1000, 0), std::pair(2000, 0), std::pair(500, 9000)}) {
        text += along_x ? fmt::format("v {} {} {}\n", along, at, z)
                        : fmt::format("v {} {} {}\n", at, along, z);
      }
      text += fmt::format("f {} {} {}\n", vertex, vertex + 1, vertex + 2);
      vertex += 3;
    }
  }
  return text;
}

}  // namespace soms::test
