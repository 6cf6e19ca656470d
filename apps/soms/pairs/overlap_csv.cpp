#include "apps/soms/pairs/overlap_csv.h"

#include "soms/base/text.h"

#include "apps/model/georeference.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <string>

namespace soms::command {

namespace {

std::string fields_of(const Vec3& v) {
  return fmt::format("{},{},{}", v.x, v.y, v.z);
}

std::string row_of(const OverlapReport& report, std::uint64_t pose, const PartPair& pair) {
  return fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{}", pose, part_csv_fields(report.pair.a, pair.a),
      csv_field(part_path_label(report.pair.a, pair.a)), part_csv_fields(report.pair.b, pair.b),
      csv_field(part_path_label(report.pair.b, pair.b)), pair.count, pair.first.first,
      pair.first.second, fields_of(pair.box.center()), fields_of(pair.box.lower),
      fields_of(pair.box.upper));
}

}  // namespace

void write_csv_head(std::ostream& out, const OverlapReport& report) {
  out << (report.by_part ? "pose,part_a,name_a,path_a,part_b,name_b,path_b,count,triangle_a,"
                           "triangle_b,x,y,z,x_min,y_min,z_min,x_max,y_max,z_max"
                         : "pose,triangle_a,part_a,name_a,triangle_b,part_b,name_b")
      << (report.by_part ? GeoreferenceColumn(report.pair.georeference).head() : "") << '\n';
}

void write_csv_rows(std::ostream& out, const OverlapReport& report, std::uint64_t pose,
                    const PosedParts& a, const PosedParts& b, const Overlap& answer,
                    std::span<const PartPair> parts) {
  if (report.by_part) {
    const GeoreferenceColumn georeference(report.pair.georeference);
    for (const PartPair& pair : parts) {
      out << row_of(report, pose, pair) << georeference.field() << '\n';
    }
    return;
  }
  for (const auto& [i, j] : answer.pairs) {
    out << fmt::format("{},{},{},{},{}\n", pose, i, part_csv_fields(a.mesh, a.parts(i)), j,
                       part_csv_fields(b.mesh, b.parts(j)));
  }
}

}  // namespace soms::command
