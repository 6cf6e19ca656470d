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
  return fmt::format("{},{},{}", relation_name(answer.relation), answer.surfaces_meet,
                     answer.why == Undecided::none ? std::string_view() : reason_name(answer.why));
}

std::string path_field(const MeshView& mesh, std::uint32_t part) {
  return csv_field(part_path_label(mesh, part));
}

}  // namespace

SolidCsv::SolidCsv(const std::string& path)
    : AnswerCsv(path, "pose,relation,surfaces_meet,why,coverage\n") {
}

void SolidCsv::add(std::uint64_t pose, const Solid& answer) {
  if (is_wanted()) {
    put(fmt::format("{},{},{}\n", pose, solid_fields(answer), name(answer.coverage)));
  }
}

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
