/// \file
/// Models of many parts that all cross: rows of upright fins.
#pragma once

#include <string>

namespace soms::test {

/// `parts` parts of `fins` upright triangles each as OBJ, named PREFIX0, PREFIX1, ... Those along x
/// and those along y cross each other, every fin every fin, at heights from 0 to 9 and around
/// (part of y, part of x).
[[nodiscard]] inline std::string fins_obj(const std::string& prefix, int parts, int fins,
                                          bool along_x) {
  std::string text;
  int vertex = 1;
  for (int p = 0; p < parts; ++p) {
    text += "o " + prefix + std::to_string(p) + "\n";
    for (int f = 0; f < fins; ++f) {
      const std::string at = std::to_string(p + 0.5 * f / fins);
      for (const char* corner : {"-1000 0", "2000 0", "500 9000"}) {
        const std::string words(corner);
        const std::string along = words.substr(0, words.find(' '));
        const std::string z = words.substr(words.find(' ') + 1);
        text += along_x ? "v " + along + " " + at + " " + z + "\n"
                        : "v " + at + " " + along + " " + z + "\n";
      }
      text += "f " + std::to_string(vertex) + " " + std::to_string(vertex + 1) + " " +
              std::to_string(vertex + 2) + "\n";
      vertex += 3;
    }
  }
  return text;
}

}  // namespace soms::test
