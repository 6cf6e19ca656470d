#include "soms/robot/print.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/clash/print.h"
#include "soms/motion/print_motion.h"
#include "soms/query/print.h"
#include "soms/robot/robot_path.h"
#include "soms/robot/robot_query.h"

namespace soms {

std::ostream& operator<<(std::ostream& out, const RobotPair& value) {
  return out << PrintedFields("RobotPair")
                    .add("link", value.link)
                    .add(value.cell ? "cell" : "link", value.other);
}

std::ostream& operator<<(std::ostream& out, const RobotContact& value) {
  return out << PrintedFields("RobotContact")
                    .add("pair", value.pair)
                    .add("surfaces_meet", value.surfaces_meet);
}

std::ostream& operator<<(std::ostream& out, const RobotGap& value) {
  PrintedFields fields("RobotGap");
  fields.add("distance", value.distance);
  if (value.pair) {
    fields.add("pair", *value.pair);
  }
  if (value.points) {
    fields.add("from", value.points->front()).add("to", value.points->back());
  }
  return out << fields.add("farther", value.farther);
}

std::ostream& operator<<(std::ostream& out, const RobotOptions& value) {
  return out << PrintedFields("RobotOptions")
                    .add("first_contact", value.first_contact)
                    .add("distance", value.distance)
                    .add("at_most", value.at_most);
}

std::ostream& operator<<(std::ostream& out, const RobotModelOptions& value) {
  return out << PrintedFields("RobotModelOptions")
                    .add("base", value.base)
                    .item(printed_count(value.ignored.size(), "ignored pair", "ignored pairs"))
                    .item(printed_count(value.off_cell.size(), "link", "links") + " off the cell");
}

std::ostream& operator<<(std::ostream& out, const RobotAttachment& value) {
  return out << PrintedFields("RobotAttachment")
                    .add("name", value.name)
                    .add("link", value.link)
                    .item(printed_count(value.meshes.size(), "mesh", "meshes"))
                    .add("pose", value.pose)
                    .item(printed_count(value.touching.size(), "link", "links") +
                          " that it may touch");
}

std::ostream& operator<<(std::ostream& out, const RobotMeshPart& value) {
  PrintedFields fields("RobotMeshPart");
  fields.add("mesh", value.mesh);
  return value.part == Part::kNoParent ? out << fields.item("no part")
                                       : out << fields.add("part", value.part);
}

std::ostream& operator<<(std::ostream& out, const RobotBody& value) {
  return out << PrintedFields("RobotBody")
                    .add("owner", value.owner)
                    .add("name", value.name)
                    .add("part", value.part)
                    .item(
                        printed_count(value.connected.size(), "connected part", "connected parts"));
}

std::ostream& operator<<(std::ostream& out, const RobotPathOptions& value) {
  return out << PrintedFields("RobotPathOptions")
                    .add("states", value.states)
                    .add("first_blocked", value.first_blocked);
}

std::ostream& operator<<(std::ostream& out, const RobotSegment& value) {
  PrintedFields fields("RobotSegment");
  fields.add("verdict", value.verdict).add("t", value.t);
  if (value.pair) {
    fields.add("pair", *value.pair);
  }
  if (value.point) {
    fields.add("point", *value.point);
  }
  return out << fields.add("undecided", value.undecided)
                    .add("coverage", value.coverage)
                    .add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const RobotPath& value) {
  PrintedFields fields("RobotPath");
  fields.item(printed_count(value.states.size(), "state", "states"))
      .item(printed_count(value.segments.size(), "segment", "segments"));
  if (value.blocked) {
    fields.add("blocked", *value.blocked);
  }
  return out << fields.add("cost", value.cost);
}

std::ostream& operator<<(std::ostream& out, const RobotAnswer& value) {
  PrintedFields fields("RobotAnswer");
  fields.add("verdict", value.verdict)
      .item(printed_count(value.contacts.size(), "contact", "contacts"))
      .add("undecided", value.undecided)
      .item(printed_count(value.beyond_limits.size(), "joint", "joints") + " beyond limits");
  if (value.gap) {
    fields.add("gap", *value.gap);
  }
  return out << fields.add("coverage", value.coverage).add("cost", value.cost);
}

}  // namespace soms
