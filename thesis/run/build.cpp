#include "thesis/run/build.h"

#include "build_settings.h"
#include "revision.h"

namespace soms::reproduce {

Build this_build() {
  return {.version = SOMS_VERSION,
          .commit = SOMS_COMMIT,
          .type = SOMS_BUILD_TYPE,
          .flags = SOMS_BUILD_FLAGS};
}

}  // namespace soms::reproduce
