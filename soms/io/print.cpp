#include "soms/io/print.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/io/crs.h"
#include "soms/io/formats.h"
#include "soms/io/read_mesh.h"
#include "soms/io/robot.h"
#include "soms/io/rows.h"
#include "soms/io/write_mesh.h"

namespace soms {

std::ostream& operator<<(std::ostream& out, const Column& value) {
  return out << PrintedFields("Column")
                    .add("name", value.name)
                    .add("may_be_infinite", value.may_be_infinite);
}

std::ostream& operator<<(std::ostream& out, const CrsAxes& value) {
  return out << PrintedFields("CrsAxes").add("unit", value.unit).add("angles", value.angles);
}

std::ostream& operator<<(std::ostream& out, const ReadOptions& value) {
  PrintedFields fields("ReadOptions");
  fields.add("allow_empty", value.allow_empty)
      .add("max_memory", value.max_memory)
      .add("import_seconds", value.import_seconds)
      .add("strict", value.strict);
  if (value.lod) {
    fields.add("lod", *value.lod);
  }
  return out << fields.add("surfaces", value.surfaces);
}

std::ostream& operator<<(std::ostream& out, const ReadableFormat& value) {
  return out << PrintedFields("ReadableFormat").item(value.name).item(quoted_text(value.extension));
}

std::ostream& operator<<(std::ostream& out, const RobotReadOptions& value) {
  return out << PrintedFields("RobotReadOptions")
                    .add("srdf", value.srdf.string())
                    .item(printed_count(value.packages.size(), "package", "packages"))
                    .item(printed_count(value.package_path.size(), "folder", "folders") +
                          " of packages")
                    .add("tessellation_error", value.tessellation_error)
                    .add("max_memory", value.max_memory)
                    .add("strict", value.strict);
}

std::ostream& operator<<(std::ostream& out, const WritableFormat& value) {
  return out << PrintedFields("WritableFormat")
                    .add("format", value.format)
                    .add("name", value.name)
                    .add("title", value.title)
                    .add("extension", value.extension)
                    .add("doubles", value.doubles)
                    .add("names", value.names)
                    .add("unit_and_axis", value.unit_and_axis);
}

std::ostream& operator<<(std::ostream& out, const Rounding& value) {
  return out << PrintedFields("Rounding").add("count", value.count).add("most", value.most);
}

}  // namespace soms
