#include "apps/soms/solid/closed_body.h"

#include "soms/base/error.h"
#include "soms/base/text.h"

#include "apps/cli/console.h"

#include <string>
#include <utility>

namespace soms::command {

ClosedBody closed_body(Body body, std::string_view otherwise, Console& console) {
  try {
    return console.run("looking for edges of an odd number of triangles",
                       [&](const Limits& limits) { return ClosedBody(std::move(body), limits); });
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::not_closed) {
      throw;
    }
    throw Error(
        error.kind(), printable(error.place()),
        "soms info lists these edges; close the surface there, or " + std::string(otherwise));
  }
}

}  // namespace soms::command
