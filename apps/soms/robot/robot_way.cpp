#include "apps/soms/robot/robot_way.h"

#include "soms/base/text.h"

#include "apps/cli/text.h"
#include "apps/soms/robot/robot_output.h"

#include <fmt/format.h>

#include <cmath>

namespace soms::command {

namespace {

/// Where a way is not free: ", from 0.5 of the way on: arm and cell: wall".
std::string place_in_text(const RobotModels& models, const RobotSegment& segment) {
  const bool is_known = std::isfinite(segment.t.upper);
  const std::string pair = segment.pair ? ": " + pair_in_text(models, *segment.pair) : "";
  return fmt::format("{} of the way{}{}", readable(is_known ? segment.t.upper : segment.t.lower),
                     is_known ? "" : " on", pair);
}

}  // namespace

bool touches(const RobotSegment& segment) {
  return segment.verdict == ContactVerdict::contact || segment.verdict == ContactVerdict::started;
}

bool is_open(const RobotSegment& segment) {
  return segment.verdict == ContactVerdict::grazing;
}

void PathTotals::add(const RobotWay& way) {
  free += way.segment.verdict == ContactVerdict::free ? 1U : 0U;
  contact += touches(way.segment) ? 1U : 0U;
  undecided += is_open(way.segment) ? 1U : 0U;
  cut += way.segment.coverage == Coverage::cut ? 1U : 0U;
  if (way.segment.verdict != ContactVerdict::free && !blocked) {
    blocked = way;
  }
}

void PathTotals::add(std::uint64_t number, const RobotAnswer& answer) {
  if (answer.verdict != RobotVerdict::free && !state) {
    state = number;
    state_is_open = answer.verdict == RobotVerdict::undecided;
  }
}

std::string way_in_text(const RobotModels& models, const RobotWay& way) {
  const RobotSegment& segment = way.segment;
  if (segment.verdict == ContactVerdict::contact && segment.t.upper < 1) {
    return fmt::format("  from state {}: contact at {}\n", way.from,
                       place_in_text(models, segment));
  }
  if (is_open(segment)) {
    return fmt::format("  from state {}: undecided from {}\n", way.from,
                       place_in_text(models, segment));
  }
  return {};
}

std::string path_in_text(const RobotModels& models, const PathTotals& totals) {
  const auto between = [&](const char* what) {
    const RobotWay& way = *totals.blocked;
    return fmt::format("path: {} between states {} and {}, {} {}\n", what, way.from, way.from + 1,
                       touches(way.segment) ? "at" : "from", place_in_text(models, way.segment));
  };
  const bool is_on_the_way =
      totals.blocked && (!totals.state || *totals.state > totals.blocked->from);
  if (is_on_the_way && touches(totals.blocked->segment) && totals.blocked->segment.t.upper < 1) {
    return between("blocked");
  }
  if (is_on_the_way && is_open(totals.blocked->segment) && totals.blocked->segment.undecided == 0) {
    return between("undecided");
  }
  if (totals.state) {
    return totals.state_is_open ? fmt::format("path: undecided from state {} on\n", *totals.state)
                                : fmt::format("path: blocked at state {}\n", *totals.state);
  }
  return "path: free, between its states too\n";
}

Json way_as_json(const RobotModels& models, const RobotWay& way) {
  const RobotSegment& segment = way.segment;
  Json json = {{"from", way.from},
               {"verdict", name(segment.verdict)},
               {"lower", segment.t.lower},
               {"upper", std::isfinite(segment.t.upper) ? Json(segment.t.upper) : Json()}};
  if (segment.pair) {
    json.update(pair_as_json(models, *segment.pair));
  }
  if (segment.point) {
    json["point"] = {segment.point->x, segment.point->y, segment.point->z};
  }
  json["coverage"] = name(segment.coverage);
  return json;
}

Json path_as_json(const RobotModels& models, const PathTotals& totals) {
  return {{"free", totals.free},
          {"contact", totals.contact},
          {"undecided", totals.undecided},
          {"blocked", totals.blocked ? way_as_json(models, *totals.blocked) : Json()}};
}

std::string way_csv_header() {
  return ",way,way_lower,way_upper,way_a,way_b";
}

std::string way_as_csv(const RobotModels& models, const std::optional<RobotWay>& way) {
  if (!way) {
    return ",,,,,";
  }
  const RobotSegment& segment = way->segment;
  return fmt::format(",{},{},{},{}", name(segment.verdict), shortest(segment.t.lower),
                     shortest(segment.t.upper), pair_as_csv(models, segment.pair));
}

}  // namespace soms::command
