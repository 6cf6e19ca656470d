#include "apps/soms/pairs/motion_rows.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/model/part_filter.h"
#include "apps/model/shapes.h"
#include "apps/model/stated_options.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace soms::command {

namespace {

PoseSource source_of(const std::string& option, const std::optional<std::string>& text,
                     const Console& console) {
  return text ? PoseSource(option, *text, console) : PoseSource();
}

/// A pose of B. \errors ErrorKind::usage for a file of several poses.
Pose pose_of_b(const std::string& option, const std::optional<std::string>& text,
               const Console& console) {
  PoseSource source = source_of(option, text, console);
  if (!source.is_constant()) {
    throw Error(ErrorKind::usage,
                option + ": " + source.name() + " has several poses, and B has one there",
                "give one pose");
  }
  return source.next().value_or(Pose());
}

}  // namespace

MotionSource::MotionSource(const MotionVerbOptions& options, const Console& console)
    : path_(options.path ? std::optional(PoseSource("--path", *options.path, console))
                         : std::nullopt),
      ends_(source_of("--from", options.from, console), source_of("--to", options.to, console)),
      by_(options.by),
      pivot_(options.pivot.value_or(Vec3{})) {
  if (path_ && path_->is_constant()) {
    throw Error(ErrorKind::usage, "--path: " + path_->name() + " has one pose",
                "give a file of two poses or more, or --from and --to");
  }
}

bool MotionSource::is_single() {
  return !path_ && ends_.is_single();
}

std::optional<RigidMotion> MotionSource::next() {
  if (path_) {
    return next_of_path();
  }
  const std::optional<std::pair<Pose, Pose>> row = ends_.next();
  if (!row) {
    return std::nullopt;
  }
  return by_ ? RigidMotion::along(row->first, *by_)
             : RigidMotion::between(row->first, row->second, pivot_);
}

std::optional<RigidMotion> MotionSource::next_of_path() {
  if (!last_) {
    last_ = path_->next();
  }
  const std::optional<Pose> end = path_->next();
  if (!last_ || !end) {
    return std::nullopt;
  }
  const RigidMotion motion = RigidMotion::between(*last_, *end, pivot_);
  last_ = end;
  return motion;
}

MotionRows::MotionRows(const MotionVerbOptions& options, Console& console)
    : options_(options),
      console_(console),
      source_(options, console),
      a_(load_model_shape(options.a, options.model_a, {.build = options.build}, console)),
      b_(load_model_shape(options.b, options.model_b, {.build = options.build}, console)),
      fixed_(b_.shape, pose_of_b("--pose-b", options.pose_b, console)),
      way_of_b_(options.to_b ? std::optional(RigidMotion::between(
                                   fixed_.pose, pose_of_b("--to-b", options.to_b, console), {}))
                             : std::nullopt),
      report_{.a = a_.file_mesh(),
              .b = b_.file_mesh(),
              .left_a = a_,
              .left_b = b_,
              .single = source_.is_stated() || (!console.shared().json && source_.is_single()),
              .read_a = stated_options(options.model_a, "--scale", "--up"),
              .read_b = stated_options(options.model_b, "--scale-b", "--up-b")} {
  const std::array<MeshView, 2> meshes{report_.a, report_.b};
  report_.notes = notes_of(meshes);
  report_.georeference = options.pose_b || options.to_b
                             ? Georeference()
                             : georeference_of(std::vector<MeshView>{report_.b});
  if (options.model_a.parts) {
    options.model_a.parts->finish(console);
  }
}

void MotionRows::begin() {
  NamedFrame a = named_frame(report_.a, options_.model_a, "--scale", "--up");
  a.is_posed = true;
  report_.warnings =
      frame_warnings(a, named_frame(report_.b, options_.model_b, "--scale-b", "--up-b"));
  tell_warnings(report_.warnings, options_.model_a.strict, console_);
}

void MotionRows::clear() {
  before_ += block_.size();
  block_.clear();
}

/// A motion that is none is named by its number.
bool MotionRows::read() {
  try {
    const std::optional<RigidMotion> motion = source_.next();
    if (motion) {
      check_range(motion->start(), a_.shape.bounds());
      check_range(motion->end(), a_.shape.bounds());
      block_.push_back(*motion);
    }
    return motion.has_value();
  } catch (const Error& error) {
    if (report_.single || error.kind() == ErrorKind::cancelled ||
        error.kind() == ErrorKind::timed_out) {
      throw;
    }
    throw Error(error.kind(), fmt::format("motion {}: {}", before_ + block_.size(), error.place()),
                error.remedy());
  }
}

void MotionRows::report(const AnsweredRow& row) {
  report_.timed_out = row.last;
}

bool MotionRows::end(RunEnd end) {
  report_.interrupted = end == RunEnd::interrupted;
  report_.timed_out = end == RunEnd::out_of_time;
  return true;
}

}  // namespace soms::command
