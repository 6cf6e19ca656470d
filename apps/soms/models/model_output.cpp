#include "apps/soms/models/model_output.h"

#include "soms/base/error.h"
#include "soms/io/formats.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

namespace soms::command {

namespace {

Choices<MeshFormat> formats() {
  Choices<MeshFormat> choices;
  for (const WritableFormat& row : writable_formats()) {
    choices.emplace_back(row.name, row.format);
  }
  return choices;
}

const char* name_of(UpAxis up) {
  return up == UpAxis::x ? "x" : up == UpAxis::y ? "y" : "z";
}

/// "a, b and c".
std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  }
  return text;
}

/// ".stl" for text STL, too.
std::string extension_of(MeshFormat format) {
  const std::string_view name = entry(format).name;
  return fmt::format(".{}", name.substr(0, name.find('-')));
}

/// Parts whose triangles do not follow each other.
std::uint64_t split_parts(const MeshView& mesh) {
  std::set<std::uint32_t> split;
  for (const Part& part : mesh.parts) {
    if (part.continues != Part::kNoParent) {
      split.insert(part.continues);
    }
  }
  return split.size();
}

/// A name that says another format than the one that is written would be refused by readers.
void check_name(const std::string& path, MeshFormat format) {
  std::string said;
  try {
    said = extension_of(format_for(path));
  } catch (const Error&) {
    return;  // it says nothing
  }
  if (said != extension_of(format)) {
    throw Error(
        ErrorKind::usage,
        fmt::format("--format {} does not match the extension {}", format_name(format), said),
        fmt::format("use the extension {}, or leave --format out", extension_of(format)));
  }
}

}  // namespace

void add_format(Parser& parser, ModelOutput& output) {
  add_choice<MeshFormat>(parser, "--format", output.format, formats(),
                         "format (default: by file extension)");
}

MeshFormat format_of(const ModelOutput& output) {
  if (output.format) {
    check_name(output.path, *output.format);
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
      throw Error(ErrorKind::usage, output.path + ": is a folder",
                  "give the name of a file in the folder");
    }
    if (std::filesystem::exists(output.path, ignored) &&
        !std::filesystem::is_regular_file(output.path, ignored)) {
      throw Error(ErrorKind::usage, output.path + ": the name does not determine a format",
                  "choose a format with --format");
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

void write_model(const MeshView& mesh, const ModelOutput& output, const Console& console) {
  const MeshFormat format = format_of(output);
  OutputFile file(output.path);
  console.run("writing " + file.name(), [&](const Limits& limits) {
    try {
      write_mesh(file.stream(), file.name(), mesh, format, limits);
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cannot_write) {
        file.check();  // knows the reason
      }
      throw;
    }
  });
  file.commit();
  if (const std::uint64_t names = file.other_names(); names != 0) {
    console.note(fmt::format(
        "{}: the replaced file had {}, which {} the old content", file.name(),
        counted(names, "other name") + (names == 1 ? " (a hard link)" : " (hard links)"),
        names == 1 ? "keeps" : "keep"));
  }
  if (const Rounding rounded = rounding(mesh, format); rounded.count != 0) {
    console.note(
        fmt::format("{}: {} stores floats: {} of {} vertices were rounded, by at most {:.2g}",
                    file.name(), entry(format).title, with_commas(rounded.count),
                    with_commas(mesh.vertices.size()), rounded.most));
  }
  if (format == MeshFormat::glb && (mesh.up == UpAxis::x || mesh.up == UpAxis::z)) {
    console.note(
        fmt::format("{}: in GLB other programs take y as up; coordinates were kept, with {} up",
                    file.name(), name_of(mesh.up)));
  }
  if (format == MeshFormat::glb && mesh.up == UpAxis::unknown) {
    console.note(
        fmt::format("{}: in GLB other programs take y as up; this model does not state its up axis",
                    file.name()));
  }
  if (format == MeshFormat::glb && mesh.unit > 0 && mesh.unit != 1) {
    console.note(fmt::format(
        "{}: in GLB other programs assume meters; coordinates were kept, in units of {:g} m",
        file.name(), mesh.unit));
  }
}

void note_losses(const MeshView& mesh, const ModelOutput& output, const Console& console) {
  const WritableFormat& format = entry(format_of(output));
  std::vector<std::string> lost;
  if (!format.unit_and_axis && mesh.unit > 0) {
    lost.push_back(fmt::format("the unit ({:g} m)", mesh.unit));
  }
  if (!format.unit_and_axis && mesh.up != UpAxis::unknown) {
    lost.push_back(fmt::format("the up axis ({})", name_of(mesh.up)));
  }
  if (!format.unit_and_axis && !mesh.georeference.empty()) {
    lost.push_back(fmt::format("the georeference ({})", printable(describe(mesh.georeference))));
  }
  const auto named = std::count_if(mesh.parts.begin(), mesh.parts.end(),
                                   [](const Part& part) { return !part.name.empty(); });
  if (!format.names && named > 0) {
    lost.push_back("the names of " + counted(static_cast<std::uint64_t>(named), "part"));
  }
  if (const std::uint64_t renamed = count_renamed(mesh, format.format); renamed != 0) {
    lost.push_back(fmt::format(
        "{} of {} ({})", with_commas(renamed), counted(static_cast<std::uint64_t>(named), "name"),
        format.format == MeshFormat::obj ? "numbered, as groups of one name are one"
                                         : "cut or changed to fit 10 characters"));
  }
  if (const std::uint64_t split = split_parts(mesh);
      split != 0 && format.names && format.format != MeshFormat::obj) {
    lost.push_back(counted(split, "part") + " in one piece");
  }
  if (!lost.empty()) {
    console.note(fmt::format("{}: {} does not keep {}",
                             output.path == "-" ? "standard output" : output.path, format.title,
                             joined(lost)));
  }
}

std::string format_name(MeshFormat format) {
  return std::string(entry(format).name);
}

}  // namespace soms::command
