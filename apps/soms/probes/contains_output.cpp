#include "apps/soms/probes/contains_output.h"

#include "soms/base/text.h"

#include "apps/soms/pairs/pair_report.h"
#include "apps/soms/solid/closed_body.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

namespace soms::command {

PartSideCsv::PartSideCsv(const std::string& path)
    : AnswerCsv(path, "row,part,name,path,first,side,coverage\n") {
}

void PartSideCsv::add(std::uint64_t point, const DividedBody& body,
                      const ContainsPartsBatch& answers, std::size_t k) {
  if (!is_wanted()) {
    return;
  }
  const MeshView& mesh = body.body().shape.mesh();
  for (const PartSide& found : answers.parts_of(k)) {
    const DividedPart& part = body.parts()[found.part];
    const std::string path =
        part.named == Part::kNoParent ? "" : csv_field(part_path_label(mesh, part.named));
    put(fmt::format("{},{},{},{},{},{}\n", point, part_csv_fields(mesh, part.named), path,
                    part.first, name(found.side), name(answers.coverage[k])));
  }
}

}  // namespace soms::command
