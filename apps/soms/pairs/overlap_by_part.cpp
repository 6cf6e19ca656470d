#include "apps/soms/pairs/overlap_by_part.h"

#include "soms/base/text.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/output/json.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

namespace soms::command {

namespace {

constexpr std::size_t kPieceOfParts = std::size_t{1} << 16;  // bytes handed on at once

std::string pairs_of_parts(std::size_t count) {
  return with_commas(count) + (count == 1 ? " pair of parts" : " pairs of parts");
}

}  // namespace

void print_parts_as_text(const OverlapReport& report, const Overlap& answer,
                         std::span<const PartPair> parts, Console& console) {
  const char* const at_least = answer.coverage == Coverage::cut ? "at least " : "";
  console.print(fmt::format("{}{} of triangles overlap{}, in {}{}{}\n", at_least,
                            counted(answer.pairs.size(), "pair"),
                            answer.pairs.size() == 1 ? "s" : "", at_least,
                            pairs_of_parts(parts.size()), report.pair.single ? ":" : ""));
  if (!report.pair.single) {
    return;
  }
  for (const PartPair& pair : parts) {
    const Vec3 at = pair.box.center();
    console.print(fmt::format("  {} and {}: {} of triangles around ({}, {}, {})\n",
                              part_in_text(report.pair.a, pair.a),
                              part_in_text(report.pair.b, pair.b), counted(pair.count, "pair"),
                              readable(at.x), readable(at.y), readable(at.z)));
  }
}

void print_parts_as_json(const OverlapReport& report, std::span<const PartPair> parts,
                         Console& console) {
  std::string piece = ",\"parts\":[";
  for (const PartPair& pair : parts) {
    piece += json_text({{"a", part_as_json(report.pair.a, pair.a)},
                        {"b", part_as_json(report.pair.b, pair.b)},
                        {"count", pair.count},
                        {"first", {pair.first.first, pair.first.second}},
                        {"box", json_box(pair.box)}});
    piece += &pair == &parts.back() ? "" : ",";
    if (piece.size() > kPieceOfParts) {
      console.print(piece);
      piece.clear();
    }
  }
  console.print(piece + "]");
}

}  // namespace soms::command
