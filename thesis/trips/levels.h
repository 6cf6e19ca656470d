/// \file
/// How deep the trees of the thesis are.
#pragma once

namespace soms::reproduce {

/// Greatest levels of the thesis: 15 for its PLY objects, 13 for its urban scene.
/// \source  thesis, tables 5.3 and 5.9 by their captions.
inline constexpr int kObjectLevel = 15;
inline constexpr int kSceneLevel = 13;

}  // namespace soms::reproduce
