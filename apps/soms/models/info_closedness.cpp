#include "apps/soms/models/info_closedness.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/soms/models/info_defects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace soms::command {

namespace {

std::uint64_t closed_among(const std::vector<PartClosedness>& parts) {
  return static_cast<std::uint64_t>(
      std::count_if(parts.begin(), parts.end(), [](const auto& part) { return part.closed; }));
}

}  // namespace

Json closedness_json(const ExaminedMesh& mesh, const Closedness& found) {
  Json parts;  // null where unknown
  if (found.parts.size() == mesh.parts.size()) {
    parts = Json::array();
    for (const PartClosedness& part : found.parts) {
      parts.push_back({{"closed", part.closed}, {"odd_edges", part.odd_edges}});
    }
  }
  return {{"closed", found.whole.closed},
          {"odd_edges", found.whole.odd_edges},
          {"odd_proper_edges", found.whole.odd_proper_edges},
          {"connected_parts", found.connected.size()},
          {"closed_connected_parts", closed_among(found.connected)},
          {"parts", parts},
          {"places", edge_places(mesh, found.places)}};
}

std::string describe_closedness(const Closedness& found) {
  const std::uint64_t odd = found.whole.odd_edges;
  if (odd == 0) {
    return "defined: every edge belongs to an even number of triangles";
  }
  const std::string edges = fmt::format("{} {} to an odd number of triangles", counted(odd, "edge"),
                                        odd == 1 ? "belongs" : "belong");
  if (found.whole.closed) {
    return fmt::format("defined: {}, but together they cancel out", edges);
  }
  const std::size_t parts = found.connected.size();
  return fmt::format("not defined: {}", edges) +
         (parts == 1 ? std::string()
                     : fmt::format("; {} of {} connected parts are closed",
                                   with_commas(closed_among(found.connected)), with_commas(parts)));
}

void print_odd_edges(const ExaminedMesh& mesh, const Closedness& found, std::uint64_t open_edges,
                     Console& console) {
  if (found.whole.odd_edges != open_edges || found.whole.degenerate != 0) {
    print_edges(mesh, "edges of an odd number of triangles", found.places, found.whole.odd_edges,
                console);
  }
}

}  // namespace soms::command
