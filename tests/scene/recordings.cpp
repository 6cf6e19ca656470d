#include "tests/scene/recordings.h"

#include "soms/scene/detail/recording_format.h"

#include "tests/scene/random_bodies.h"

#include <cmath>
#include <memory>
#include <sstream>

namespace soms::test {

namespace {

RecordedMesh recorded(const MeshView& mesh, const std::string& name) {
  RecordedMesh result;
  result.name = name;
  result.source = "models/" + name + ".ply";
  result.file_size = 1234;
  result.scale = 0.5;
  result.up = UpAxis::y;
  result.triangles = mesh.triangles.size();
  result.hash = corner_hash(mesh);
  return result;
}

}  // namespace

Recorded record_scene(Rng& rng, std::uint64_t movers, std::uint64_t frames, RecordingEnding ending,
                      double clearance, bool swept) {
  Recorded result;
  Scene scene;
  result.head.title = "test";
  result.head.clearance = clearance;
  result.head.swept = swept;
  result.head.frames_requested = frames;
  std::vector<Shape>& shapes = result.shapes;
  for (int k = 0; k < 3; ++k) {
    shapes.emplace_back(random_mesh(rng));
    const std::string name = "model " + std::to_string(k);
    result.head.models.push_back(recorded(shapes.back().mesh(), name));
    const Pose pose = random_pose(rng, 3);
    scene.add_environment(Body(shapes.back(), pose));
    result.head.environment.push_back({result.head.models.back(), pose});
  }
  for (std::uint64_t k = 0; k < movers; ++k) {
    result.head.movers.push_back(static_cast<std::uint32_t>(rng.below(shapes.size())));
    scene.add_mover(Body(shapes[result.head.movers.back()]));
  }
  std::ostringstream out;
  RecordingWriter writer(out, result.head);
  std::vector<Pose> poses(movers);
  for (std::uint64_t frame = 0; frame < frames; ++frame) {
    for (MoverId k = 0; k < movers; ++k) {
      if (frame == 0 || rng.below(3) != 0) {
        poses[k] = random_pose(rng, 4);
      }
      scene.set_pose(k, poses[k]);
    }
    StepReport report = scene.step({.clearance = clearance, .swept = swept});
    writer.add(poses, report);
    result.frames.push_back({poses, std::move(report.environment), std::move(report.movers),
                             std::move(report.environment_gaps), std::move(report.mover_gaps),
                             std::move(report.environment_passages),
                             std::move(report.mover_passages)});
  }
  writer.finish(ending);
  result.end = writer.so_far();
  result.bytes = out.str();
  return result;
}

Recorded record_drive() {
  constexpr std::uint64_t kFrames = 66;
  Recorded result;
  result.head.title = "drive";
  result.head.models.resize(1);
  result.head.models[0].name = "car";
  result.head.models[0].triangles = 100;
  result.head.environment = {{result.head.models[0], Pose::translation(1, 2, 3)}};
  result.head.movers = {0, 0};
  std::ostringstream out;
  RecordingWriter writer(out, result.head);
  for (std::uint64_t frame = 0; frame < kFrames; ++frame) {
    RecordedFrame now;
    const std::uint64_t moves = frame / 4;
    now.poses = {Pose::translation(static_cast<double>(moves), 0, 0), Pose{}};
    StepReport report;
    if (frame % 7 == 6) {
      report.environment = {{0, 0, static_cast<TriangleId>(frame), 5}, {1, 0, 2, 3}};
      report.movers = {{0, 1, 99, 7}};
    }
    now.environment = report.environment;
    now.movers = report.movers;
    writer.add(now.poses, report);
    result.frames.push_back(std::move(now));
  }
  writer.finish(RecordingEnding::complete);
  result.end = writer.so_far();
  result.bytes = out.str();
  return result;
}

Recorded record_approach() {
  constexpr std::uint64_t kFrames = 66;
  Recorded result;
  result.head.title = "approach";
  result.head.models.resize(1);
  result.head.models[0].name = "cube";
  result.head.models[0].triangles = 12;
  result.head.environment = {{result.head.models[0], Pose{}}};
  result.head.movers = {0, 0};
  result.head.clearance = 2;
  std::ostringstream out;
  RecordingWriter writer(out, result.head);
  for (std::uint64_t frame = 0; frame < kFrames; ++frame) {
    RecordedFrame now;
    const double x = frame < 60 ? 8 : static_cast<double>(65 - frame) / 2;
    now.poses = {Pose::translation(x, 0, 0), Pose::translation(0, 0, 1)};
    if (x == 0) {
      now.environment = {{0, 0, 3, 5}};
      now.movers = {{0, 1, 4, 7}};
    } else if (x <= 2) {
      now.environment_gaps = {{0, 0, 3, 5, {x, x}, {1 + x, 0.5, 0.5}, {1, 0.5, 0.5}}};
      now.mover_gaps = {{0, 1, 4, 7, {x, x}, {1 + x, 0.5, 1}, {1, 0.5, 1}}};
    }
    StepReport report;
    report.clearance = result.head.clearance;
    report.environment = now.environment;
    report.movers = now.movers;
    report.environment_gaps = now.environment_gaps;
    report.mover_gaps = now.mover_gaps;
    writer.add(now.poses, report);
    result.frames.push_back(std::move(now));
  }
  writer.finish(RecordingEnding::complete);
  result.end = writer.so_far();
  result.bytes = out.str();
  return result;
}

Recorded record_passages() {
  Recorded result;
  result.head.title = "passages";
  result.head.swept = true;
  result.head.models.resize(1);
  result.head.models[0].triangles = 12;
  result.head.environment = {{result.head.models[0], Pose{}}};
  result.head.movers = {0, 0};
  std::ostringstream out;
  RecordingWriter writer(out, result.head);
  for (const double x : {-8.0, 8.0, -8.0}) {
    RecordedFrame now;
    now.poses = {Pose::translation(x, 0, 0), Pose::translation(0, -x, 0)};
    StepReport report;
    report.swept = true;
    if (!result.frames.empty()) {
      report.environment_passages = {
          {0, 0, 1, 2, ContactVerdict::contact, {0.4, 0.5}, {1, 0.5, 0.25}}};
      report.mover_passages = {{0, 1, 3, 4, ContactVerdict::grazing, {0.25, HUGE_VAL}, {0, 0, 1}}};
    }
    now.environment_passages = report.environment_passages;
    now.mover_passages = report.mover_passages;
    writer.add(now.poses, report);
    result.frames.push_back(std::move(now));
  }
  writer.finish(RecordingEnding::complete);
  result.end = writer.so_far();
  result.bytes = out.str();
  return result;
}

Recorded record_nothing(std::uint64_t frames) {
  Recorded result;
  result.frames.resize(frames);
  std::ostringstream out;
  RecordingWriter writer(out, result.head);
  for (std::uint64_t frame = 0; frame < frames; ++frame) {
    writer.add({}, {});
  }
  writer.finish(RecordingEnding::complete);
  result.end = writer.so_far();
  result.bytes = out.str();
  return result;
}

Replay replay_of(const std::string& bytes) {
  return Replay(std::make_unique<std::istringstream>(bytes), "run");
}

std::string forged(const std::string& bytes, std::size_t begin,
                   const std::function<void(std::string& content)>& change) {
  const auto length =
      static_cast<std::size_t>(detail::get<std::uint64_t>(bytes.data() + begin + 16));
  std::string content = bytes.substr(begin + detail::kChunkHeadSize, length);
  const std::string rest = bytes.substr(begin + detail::kChunkHeadSize + length + 8);
  std::string head = bytes.substr(begin, 16);
  change(content);
  detail::put(head, static_cast<std::uint64_t>(content.size()));
  detail::put(head, detail::hash_of(head));
  detail::put(content, detail::hash_of(content));
  return bytes.substr(0, begin) + head + content + rest;
}

std::size_t second_chunk(const std::string& bytes) {
  return detail::kFileHeadSize + detail::kChunkHeadSize + 8 +
         static_cast<std::size_t>(
             detail::get<std::uint64_t>(bytes.data() + detail::kFileHeadSize + 16));
}

std::vector<RecordedFrame> frames_of(Replay& replay) {
  std::vector<RecordedFrame> frames;
  for (std::uint64_t i = 0; i < replay.frames(); ++i) {
    frames.push_back(replay.frame(i));
  }
  return frames;
}

}  // namespace soms::test
