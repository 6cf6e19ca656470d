#include "thesis/program/draw_frames.h"

#include "soms/base/error.h"
#include "soms/io/write_mesh.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/rule/rules.h"

#include "apps/cli/child.h"
#include "apps/cli/temporary_folder.h"
#include "apps/output/json.h"
#include "apps/output/output.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

/// Longer than any of our runs takes; a driver that hangs shall not hold the run.
constexpr const char* kTimeout = "120";

reproduce::DrawnFrames trouble(std::string reason) {
  while (!reason.empty() && reason.back() == '\n') {
    reason.pop_back();
  }
  return {.trouble = std::move(reason)};
}

void write_poses(const std::filesystem::path& path, const std::vector<Vec3>& offsets) {
  OutputFile file(path);
  file.stream() << "x,y,z\n";
  for (const Vec3& by : offsets) {
    file.stream() << fmt::format("{},{},{}\n", by.x, by.y, by.z);
  }
  file.commit();
}

/// The trees and the traversal, as --tree takes them.
std::string tree_of(const reproduce::DrawRequest& request) {
  const TraversalOptions& traversal = request.traversal;
  std::string keys =
      fmt::format("rule={},midpoint=thesis,empty-side=stop,leaf={},levels={},traversal={}",
                  entry(request.build.rule).kebab, request.build.per_leaf, request.build.level,
                  entry(traversal.traversal).kebab);
  if (traversal.traversal == Traversal::e_node) {
    keys += fmt::format(",descent={}", entry(traversal.descent).kebab);
  }
  return keys;
}

std::vector<std::string> words_for(const reproduce::DrawRequest& request,
                                   const std::filesystem::path& folder) {
  std::vector<std::string> words{"time-frames",
                                 "--json",
                                 "--quiet",
                                 "--timeout",
                                 kTimeout,
                                 "--threads",
                                 "1",
                                 "--tree",
                                 tree_of(request),
                                 "--mover-levels",
                                 std::to_string(request.moving_level)};
  words.insert(words.end(), {"--mover", (folder / "moving.ply").string(), "--pose",
                             (folder / "poses.csv").string(), (folder / "still.ply").string()});
  return words;
}

/// Frames are four levels deep.
constexpr int kDeepestAnswer = 8;

reproduce::CollisionTime collision_of(const Json& times) {
  return {.move = times.at("move_ms").get<double>(), .query = times.at("query_ms").get<double>()};
}

}  // namespace

reproduce::DrawnFrames parse_drawn_frames(const std::string& text) {
  try {
    const Json answer = parse_json(text, kDeepestAnswer).value;
    reproduce::DrawnFrames drawn{.device = answer.at("device").get<std::string>(),
                                 .width = answer.at("width").get<int>(),
                                 .height = answer.at("height").get<int>(),
                                 .passes = answer.at("passes").get<int>()};
    for (const Json& frame : answer.at("frames")) {
      drawn.frames.push_back({.alone = collision_of(frame.at("alone")),
                              .drawn = collision_of(frame.at("drawn")),
                              .draw = frame.at("drawn").at("draw_ms").get<double>(),
                              .contacts = frame.at("contacts").get<std::size_t>()});
    }
    return drawn;
  } catch (const Json::exception&) {
    return trouble("soms-view gave an answer that is not understood; rebuild it");
  }
}

reproduce::DrawnFrames draw_frames(const reproduce::DrawRequest& request) {
  std::filesystem::path program;
  try {
    program = viewer_program();
  } catch (const Error& error) {
    return trouble(error.what());
  }
  const TemporaryFolder folder("drive");
  write_mesh(folder.path() / "still.ply", *request.still, MeshFormat::ply);
  write_mesh(folder.path() / "moving.ply", *request.moving, MeshFormat::ply);
  write_poses(folder.path() / "poses.csv", request.offsets);
  const ChildAnswer answer = answer_of(program, words_for(request, folder.path()));
  return answer.status == 0 ? parse_drawn_frames(answer.text) : trouble(answer.text);
}

}  // namespace soms::command
