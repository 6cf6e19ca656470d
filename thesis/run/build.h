/// \file
/// What this program was built from.
#pragma once

#include <string_view>

namespace soms::reproduce {

/// The source and the settings of this build, so that a run can be repeated with the same code.
struct Build {
  std::string_view version;  ///< of soms
  std::string_view commit;   ///< 40 hexadecimal digits, "-dirty" after them where files were
                             ///< changed; "unknown" outside a checkout
  std::string_view type;     ///< of CMake: "Release"; may be empty
  std::string_view flags;    ///< of the library, without warnings: "-O3 -DNDEBUG ..."
};

/// This build.
[[nodiscard]] Build this_build();

}  // namespace soms::reproduce
