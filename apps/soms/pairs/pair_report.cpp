#include "apps/soms/pairs/pair_report.h"

#include <fmt/format.h>

namespace soms::command {

namespace {

/// What reading the files noted, with the first pose alone, so that rows stay small.
std::string notes_key(const PairReport& report, std::uint64_t pose) {
  return pose > 0 || report.notes.empty() ? std::string() : ",\"notes\":" + json_text(report.notes);
}

/// Where the coordinates lie, likewise.
std::string georeference_key(const PairReport& report, std::uint64_t pose) {
  return pose > 0 || report.georeference.empty()
             ? std::string()
             : ",\"georeference\":" + json_text(georeference_json(report.georeference));
}

/// About the models with the first pose alone; about boxes with each.
std::string warnings_key(const PairReport& report, std::uint64_t pose) {
  Json list = pose == 0 ? warnings_json(report.warnings) : Json::array();
  if (report.boxes_apart) {
    list.push_back({{"kind", name(FrameDoubt::boxes_apart)}});
  }
  return list.empty() ? std::string() : ",\"warnings\":" + json_text(list);
}

}  // namespace

std::string coverage_keys(Coverage coverage, const Cost& cost, std::string_view more) {
  return fmt::format(
      ",\"coverage\":\"{}\",\"cost\":{{\"node_tests\":{},\"triangle_tests\":{},"
      "\"exact_tests\":{}{}}}",
      name(coverage), cost.node_tests, cost.triangle_tests, cost.exact_tests, more);
}

std::string report_keys(const PairReport& report, std::uint64_t pose, bool right) {
  std::string text;
  if (report.verified) {
    text += right ? ",\"verified\":true" : ",\"verified\":false";
  }
  if (report.timed_out) {
    text += ",\"timed_out\":true";
  }
  return text + georeference_key(report, pose) + notes_key(report, pose) +
         warnings_key(report, pose);
}

}  // namespace soms::command
