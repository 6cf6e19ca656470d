#include "apps/soms/model_output.h"

#include "soms/base/error.h"

#include "apps/support/console.h"
#include "apps/support/parse.h"
#include "apps/support/text.h"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>
#include <system_error>

namespace soms::command {

namespace {

const Choices<MeshFormat>& formats() {
  static const Choices<MeshFormat> choices{{"ply", MeshFormat::ply},
                                           {"ply-ascii", MeshFormat::ply_ascii},
                                           {"obj", MeshFormat::obj},
                                           {"stl", MeshFormat::stl},
                                           {"stl-ascii", MeshFormat::stl_ascii},
                                           {"off", MeshFormat::off},
                                           {"3ds", MeshFormat::three_ds},
                                           {"glb", MeshFormat::glb}};
  return choices;
}

/// What holds floats only, as said in messages; empty for formats that keep doubles.
std::string_view float_format(MeshFormat format) {
  switch (format) {
    case MeshFormat::stl:
      return "binary STL";
    case MeshFormat::three_ds:
      return "3DS";
    case MeshFormat::glb:
      return "GLB";
    default:
      return {};
  }
}

}  // namespace

void add_format(CLI::App& app, ModelOutput& output) {
  add_choice<MeshFormat>(app, "--format", output.format, formats(),
                         "how it is written, if not as the name says");
}

MeshFormat format_of(const ModelOutput& output) {
  if (output.format) {
    return *output.format;
  }
  if (output.path == "-") {
    return MeshFormat::ply;
  }
  try {
    return format_for(output.path);
  } catch (const Error& error) {
    std::error_code ignored;
    if (std::filesystem::is_directory(output.path, ignored)) {
      throw Error(ErrorKind::usage, output.path + ": this is a folder",
                  "give the name of a file in it");
    }
    throw Error(ErrorKind::usage, error.place(), error.remedy());  // the name is an argument
  }
}

void check(const ModelOutput& output, const Console& console) {
  if (output.path.empty()) {
    throw Error(ErrorKind::usage, "the name of the output is empty", "give a file");
  }
  if (output.path == "-" && console.shared().json) {
    throw Error(ErrorKind::usage, "--json and the model cannot both go to standard output",
                "write the model to a file");
  }
}

void write_model(const Mesh& mesh, const ModelOutput& output, const Console& console) {
  const MeshFormat format = format_of(output);
  OutputFile file(output.path);
  console.run("writing " + file.name(), [&](const Parallel& parallel) {
    try {
      write_mesh(file.stream(), file.name(), mesh, format, parallel);
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cannot_write) {
        file.check();  // knows the reason
      }
      throw;
    }
  });
  file.commit();
  const std::string_view floats = float_format(format);
  const std::uint64_t rounded = floats.empty() ? 0 : count_rounded(mesh, format);
  if (rounded != 0) {
    console.note(fmt::format("{}: {} holds floats: {} of {} vertices were rounded", file.name(),
                             floats, with_commas(rounded), with_commas(mesh.vertices.size())));
  }
  if (format == MeshFormat::glb && (mesh.up == UpAxis::x || mesh.up == UpAxis::z)) {
    console.note(
        fmt::format("{}: other programs take y for up in GLB; coordinates were kept, with {} up",
                    file.name(), mesh.up == UpAxis::x ? "x" : "z"));
  }
  if (format == MeshFormat::glb && mesh.unit > 0 && mesh.unit != 1) {
    console.note(fmt::format("{}: other programs take GLB for meters; numbers were kept, of {:g} m",
                             file.name(), mesh.unit));
  }
}

std::string format_name(MeshFormat format) {
  for (const auto& [name, value] : formats()) {
    if (value == format) {
      return name;
    }
  }
  return {};
}

}  // namespace soms::command
