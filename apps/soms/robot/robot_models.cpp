#include "apps/soms/robot/robot_models.h"

#include "soms/base/error.h"
#include "soms/io/robot.h"

#include "apps/cli/console.h"
#include "apps/cli/suggest.h"
#include "apps/cli/text.h"
#include "apps/model/part_filter.h"
#include "apps/rows/pose_source.h"
#include "apps/soms/clash/clash_models.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace soms::command {

namespace {

/// Folders of ROS_PACKAGE_PATH.
std::vector<std::filesystem::path> package_path() {
  const char* const text = std::getenv("ROS_PACKAGE_PATH");
  std::vector<std::filesystem::path> folders;
  std::string_view rest = text == nullptr ? std::string_view() : std::string_view(text);
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
    if (!folder.empty()) {
      folders.emplace_back(folder);
    }
  }
  return folders;
}

RobotReadOptions read_options(const RobotModelsOptions& options, const Console& console) {
  RobotReadOptions read{.srdf = options.srdf,
                        .package_path = package_path(),
                        .tessellation_error = options.round_error,
                        .max_memory = console.shared().max_memory,
                        .strict = options.reading.strict};
  for (const std::string& text : options.packages) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == text.size()) {
      throw Error(ErrorKind::usage, "--package: " + text + " is no package",
                  "give NAME=DIR, as --package panda_description=/opt/panda_description");
    }
    read.packages.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  return read;
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  if (const std::size_t at = text.find(what); at != std::string::npos) {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// An error of reading with the options of the command in place of the library's.
Error in_words_of_robot(const Error& error) {
  std::string remedy = replaced(error.remedy(), "`strict`", "--strict");
  remedy = replaced(remedy, "name its folder by the option for packages",
                    "name its folder by --package NAME=DIR");
  remedy = replaced(remedy, "allow a greater error", "allow a greater error by --round-error");
  return {error.kind(), error.place(), remedy};
}

Robot read_named_robot(const RobotModelsOptions& options, const Console& console) {
  const RobotReadOptions read = read_options(options, console);
  return console.run("reading " + printable(options.urdf), [&](const Limits& limits) {
    try {
      return read_robot(options.urdf, read, limits);
    } catch (const Error& error) {
      throw in_words_of_robot(error);
    }
  });
}

LinkPair ignored_pair(const Robot& robot, const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    throw Error(ErrorKind::usage, "--ignore-pair: " + text + " is no pair of links",
                "give two links with a comma between: --ignore-pair wrist,tool");
  }
  const auto a = RobotModels::link_named(robot, "--ignore-pair", text.substr(0, comma));
  const auto b = RobotModels::link_named(robot, "--ignore-pair", text.substr(comma + 1));
  if (a == b) {
    throw Error(ErrorKind::usage, "--ignore-pair: " + text + " names one link", "name two links");
  }
  return {std::min(a, b), std::max(a, b)};
}

RobotModelOptions model_options(const RobotModelsOptions& options, const Robot& robot,
                                const Console& console) {
  RobotModelOptions model;
  if (options.base) {
    PoseSource source("--base", *options.base, console);
    model.base = source.next().value_or(Pose{});
    if (!source.is_constant()) {
      throw Error(ErrorKind::usage, source.name() + ": has more than one pose",
                  "give one pose of the root link");
    }
  }
  for (const std::string& text : options.ignored) {
    model.ignored.push_back(ignored_pair(robot, text));
  }
  for (const std::string& name : options.off_cell) {
    model.off_cell.push_back(RobotModels::link_named(robot, "--off-cell", name));
  }
  return model;
}

/// Names of the cell's parts, and of all bodies that are open.
void name_bodies(RobotModels& models) {
  for (const RobotBody& body : models.model.cell_bodies()) {
    models.cell_files.push_back(models.cell[body.mesh].source);
    std::vector<std::string> labels{body_label(models.cell[body.mesh], body.part.part, {})};
    for (const RobotMeshPart& other : body.joined) {
      labels.push_back(body_label(models.cell[other.mesh], other.part, {}));
    }
    models.cell_names.push_back(joined_label(labels));
  }
  for (const RobotBody& body : models.model.link_bodies()) {
    if (!body.part.closed) {
      models.open.push_back(models.model.link_names()[body.owner]);
    }
  }
  models.open.erase(std::unique(models.open.begin(), models.open.end()), models.open.end());
  for (const RobotBody& body : models.model.cell_bodies()) {
    if (!body.part.closed) {
      models.open.push_back(models.cell_names[body.owner] + " of the cell");
    }
  }
}

/// The frame of a robot: URDF has meters, and z is up.
NamedFrame robot_frame(const std::string& file) {
  return {.file = file, .frame = {.unit = 1, .up = UpAxis::z}, .built_in = true};
}

}  // namespace

std::uint32_t RobotModels::link_named(const Robot& robot, const std::string& option,
                                      const std::string& name) {
  std::vector<std::string> names;
  for (const Link& link : robot.links) {
    names.push_back(link.name);
  }
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw Error(ErrorKind::usage, option + ": " + name + " is no link of the robot",
                "name one of its links, such as " + names.front());
  }
  return static_cast<std::uint32_t>(found - names.begin());
}

RobotModels read_robot_models(const RobotModelsOptions& options, Console& console) {
  Robot robot = read_named_robot(options, console);
  const RobotModelOptions model = model_options(options, robot, console);
  if (!model.off_cell.empty() && options.cell.empty()) {
    throw Error(ErrorKind::usage, "--off-cell has no effect without --cell",
                "leave it out, or also give --cell FILE");
  }
  if (!options.reading.crs.empty() && options.cell.empty()) {
    throw Error(ErrorKind::usage, "--crs has no effect without --cell",
                "leave it out, or also give --cell FILE");
  }
  std::vector<Mesh> cell;
  std::vector<NamedFrame> frames;
  const auto [files, notes] = model_files(options.cell, console);
  for (const std::string& file : files) {
    cell.push_back(read_model_of_set(file, options.reading, console));
    frames.push_back(named_frame(cell.back(), options.reading, "--scale", "--up"));
  }
  for (NamedFrame& frame : frames) {
    frame.is_shared = frames.size() > 1;
  }
  if (options.reading.parts) {
    options.reading.parts->finish(console);
  }
  RobotModel built = console.run("building trees", [&](const Limits& limits) {
    return RobotModel(robot, cell, model, limits);
  });
  RobotModels models{.robot = std::move(robot), .cell = std::move(cell), .model = std::move(built)};
  models.notes = notes;
  name_bodies(models);
  if (!frames.empty()) {
    models.warnings = world_warnings({robot_frame(options.urdf)}, frames);
  }
  for (const std::string& note : models.robot.notes) {
    console.note(printable(note));
    models.notes.push_back(note);
  }
  const std::vector<MeshView> meshes(models.cell.begin(), models.cell.end());
  const std::vector<std::string> more = notes_of(meshes);
  models.notes.insert(models.notes.end(), more.begin(), more.end());
  tell_warnings(models.warnings, options.reading.strict, console);
  return models;
}

}  // namespace soms::command
