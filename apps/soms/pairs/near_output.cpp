#include "apps/soms/pairs/near_output.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <cmath>

namespace soms::command {

namespace {

constexpr std::uint64_t kRowsInText = 20;  // that a person may want to read

std::string side_in_text(const MeshView& mesh, TriangleId i, const Vec3& at) {
  return fmt::format("triangle {} of {} at {}", triangle_label(mesh, i), printable(mesh.source),
                     point_in_text(at));
}

}  // namespace

std::string near_text(const PairReport& report, const NearPair& pair) {
  return pair.triangles ? fmt::format(": {} and {}",
                                      side_in_text(report.a, pair.triangles->first, pair.point_a),
                                      side_in_text(report.b, pair.triangles->second, pair.point_b))
                        : std::string();
}

void NearTable::add(const PairReport& report, std::uint64_t pose, std::string_view title,
                    std::string_view value, const NearPair& pair, Console& console) {
  constexpr const char* kForm = "{:>6}  {:<16}  {:<20}  {}";
  const auto print = [&](const auto&... cells) {
    console.print(table_line(fmt::format(fmt::runtime(kForm), cells...)));
  };
  if (rows_ == 0) {
    print("pose", title, "triangle of A", "triangle of B");
  }
  if (rows_++ < kRowsInText) {
    const auto label = [&](const MeshView& mesh, TriangleId TrianglePair::*side) {
      return pair.triangles ? triangle_label(mesh, (*pair.triangles).*side) : std::string();
    };
    print(pose, value, label(report.a, &TrianglePair::first),
          label(report.b, &TrianglePair::second));
  }
}

void NearTable::finish(Console& console) const {
  if (rows_ > kRowsInText) {
    console.print(
        fmt::format("   and {} more; --json lists all\n", counted(rows_ - kRowsInText, "pose")));
  }
}

NearCsv::NearCsv(const std::string& path) {
  if (!path.empty()) {
    file_.emplace(path);
  }
}

void NearCsv::begin(const PairReport& report, std::string_view head) {
  if (file_) {
    report_ = &report;
    parts_a_ = PartsOf(report.a);
    parts_b_ = PartsOf(report.b);
    georeference_ = GeoreferenceColumn(report.georeference);
    file_->stream() << "pose," << head << georeference_.head() << '\n';
  }
}

void NearCsv::put(std::uint64_t pose, std::string_view cells) {
  file_->stream() << fmt::format("{},{}{}\n", pose, cells, georeference_.field());
  if (!file_->stream().good()) {
    file_->check();
  }
}

void NearCsv::finish() {
  if (file_) {
    file_->commit();
  }
}

}  // namespace soms::command
