#include "soms/kinematics/print.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/geometry/print.h"
#include "soms/kinematics/primitive_meshes.h"
#include "soms/kinematics/robot.h"

namespace soms {

std::ostream& operator<<(std::ostream& out, const Mimic& value) {
  return out << PrintedFields("Mimic")
                    .add("joint", value.joint)
                    .add("multiplier", value.multiplier)
                    .add("offset", value.offset);
}

std::ostream& operator<<(std::ostream& out, const Joint& value) {
  PrintedFields fields("Joint");
  fields.item(printed(value.name))
      .add("type", value.type)
      .add("parent", value.parent)
      .add("child", value.child)
      .add("origin", value.origin)
      .add("axis", value.axis)
      .add("lower", value.lower)
      .add("upper", value.upper);
  if (value.mimic) {
    fields.add("mimic", *value.mimic);
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const Link& value) {
  return out << PrintedFields("Link")
                    .item(printed(value.name))
                    .item(printed_count(value.collisions.size(), "mesh", "meshes"));
}

std::ostream& operator<<(std::ostream& out, const LinkPair& value) {
  return out << PrintedFields("LinkPair").add("a", value.a).add("b", value.b);
}

std::ostream& operator<<(std::ostream& out, const NamedState& value) {
  return out << PrintedFields("NamedState")
                    .item(printed(value.name))
                    .add("group", value.group)
                    .item(printed_count(value.values.size(), "value", "values"));
}

std::ostream& operator<<(std::ostream& out, const Robot& value) {
  PrintedFields fields("Robot");
  fields.item(printed(value.name))
      .item(printed_count(value.links.size(), "link", "links"))
      .item(printed_count(value.joints.size(), "joint", "joints"));
  if (value.allowed) {
    fields.item(printed_count(value.allowed->size(), "allowed pair", "allowed pairs"));
  }
  return out << fields;
}

std::ostream& operator<<(std::ostream& out, const RobotFault& value) {
  return out << PrintedFields("RobotFault")
                    .add("kind", value.kind)
                    .add("what", value.what)
                    .add("remedy", value.remedy);
}

std::ostream& operator<<(std::ostream& out, const PrimitiveMesh& value) {
  return out << PrintedFields("PrimitiveMesh").add("mesh", value.mesh).add("error", value.error);
}

}  // namespace soms
