#include "apps/soms/probes/contains_output.h"

#include "soms/base/text.h"

#include "apps/soms/pairs/pair_report.h"
#include "apps/soms/solid/closed_body.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

namespace soms::command {

SideCsv::SideCsv(const std::string& path, bool winding)
    : AnswerCsv(path, winding ? "point,side,lower,upper,coverage\n" : "point,side,coverage\n") {
}

void SideCsv::add(std::uint64_t point, Side side, const std::optional<Bracket>& winding,
                  Coverage coverage) {
  if (is_wanted()) {
    put(fmt::format("{},{}{},{}\n", point, name(side),
                    winding ? fmt::format(",{},{}", winding->lower, winding->upper) : std::string(),
                    name(coverage)));
  }
}

PartSideCsv::PartSideCsv(const std::string& path)
    : AnswerCsv(path, "point,part,name,path,first,side,coverage\n") {
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
                    part.first, name(found.side), name(answers.coverages[k])));
  }
}

}  // namespace soms::command
