#include "apps/soms/solid/solid_output.h"

#include "soms/base/text.h"

#include "apps/soms/pairs/pair_report.h"
#include "apps/soms/solid/solid_text.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

namespace soms::command {

namespace {

/// "relation,surfaces_meet,why"
std::string solid_fields(const Solid& answer) {
  return fmt::format("{},{},{}", name(answer.relation), answer.surfaces_meet, name(answer.why));
}

std::string path_field(const MeshView& mesh, std::uint32_t part) {
  return csv_field(part_path_label(mesh, part));
}

}  // namespace

SolidPartCsv::SolidPartCsv(const std::string& path)
    : AnswerCsv(path,
                "pose,part_a,name_a,path_a,part_b,name_b,path_b,relation,surfaces_meet,why,"
                "odd_edges_a,odd_edges_b,coverage\n") {
}

void SolidPartCsv::add(std::uint64_t pose, const MeshView& a, const MeshView& b,
                       std::span<const SolidPair> pairs) {
  if (!is_wanted()) {
    return;
  }
  for (const SolidPair& pair : pairs) {
    const Solid& answer = pair.answer;
    put(fmt::format("{},{},{},{},{},{},{},{},{}\n", pose, part_csv_fields(a, pair.a->part),
                    path_field(a, pair.a->part), part_csv_fields(b, pair.b->part),
                    path_field(b, pair.b->part), solid_fields(answer), pair.a->odd_edges,
                    pair.b->odd_edges, name(answer.coverage)));
  }
}

}  // namespace soms::command
