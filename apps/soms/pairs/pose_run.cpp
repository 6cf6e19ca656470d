#include "apps/soms/pairs/pose_run.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/model/shapes.h"
#include "apps/model/stated_options.h"
#include "apps/report/placing.h"
#include "apps/shards/receipt.h"
#include "apps/shards/shard_files.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace soms::command {

namespace {

constexpr std::size_t kRowsOfAThread = 64;

/// What is wrong with a pose, where the message has named the pose already.
std::string_view without_subject(std::string_view place) {
  constexpr std::string_view kSubject = "pose: ";
  return place.starts_with(kSubject) ? place.substr(kSubject.size()) : place;
}

}  // namespace

PoseRun::PoseRun(const PairOptions& options, PoseQuestion question, Console& console)
    : RowRun({.verb = question.verb,
              .noun = "pose",
              .verify = options.verify,
              .fail_if_found = question.fail_if_found,
              .has_files = question.has_files},
             console),
      options_(options),
      question_(std::move(question)),
      poses_(poses_of(options, console)),
      a_(load(options.a, options.model_a)),
      tiles_(load_tiles()),
      b_(tiles_ ? Shape() : load(options.b, options.model_b)),
      report_{.a = a_.mesh(),
              .b = tiles_ ? MeshView(tiles_->manifest().statements) : b_.mesh(),
              // Whoever reads a program's answers needs no other form for a single row.
              .single = !options.files &&
                        (poses_.is_stated() || (!console.shared().json && poses_.is_single())),
              .verified = options.verify,
              .lists_rows = !options.files || console.shared().json,
              .read_a = stated_options(options.model_a, "--scale", "--up"),
              .read_b = stated_options(options.model_b, "--scale-b", "--up-b")} {
  const std::array<MeshView, 2> meshes{report_.a, report_.b};
  report_.notes = notes_of(meshes);
  std::vector<MeshView> unmoved;
  if (!options.pose_a) {
    unmoved.push_back(report_.a);
  }
  if (!options.pose_b) {
    unmoved.push_back(report_.b);
  }
  report_.georeference = georeference_of(unmoved);
  if (options.files) {
    begin_at(options.files->rows().begin);
  }
}

PosePairs PoseRun::poses_of(const PairOptions& options, const Console& console) {
  if (options.files) {
    return options.files->poses(options, console);
  }
  return {source("--pose", options.pose_a, console), source("--pose-b", options.pose_b, console)};
}

PoseSource PoseRun::source(const std::string& option, const std::optional<std::string>& text,
                           const Console& console) {
  return text ? PoseSource(option, *text, console, NoRows::no_poses) : PoseSource();
}

Shape PoseRun::load(const std::string& path, const ModelOptions& model) const {
  return load_shape(path, model, {.build = options_.build, .keep_tree = question_.keep_trees},
                    console());
}

std::optional<TileSet> PoseRun::load_tiles() const {
  if (!question_.refused_of_tiles || !is_tile_folder(options_.b)) {
    return std::nullopt;
  }
  refuse_of_tiles(options_.b, *question_.refused_of_tiles);
  refuse_of_tiles(options_.b, {refused_verify(options_.verify)});
  return open_tiles(options_.b, options_.model_b, options_.build, console(), "-b");
}

const Box& PoseRun::bounds_b() const {
  return tiles_ ? tiles_->bounds() : b_.bounds();
}

/// Models are compared by their numbers; where these may mean different things, the reader should
/// know.
void PoseRun::begin() {
  NamedFrame a = named_frame(report_.a, options_.model_a, "--scale", "--up");
  a.is_posed = options_.pose_a || options_.pose_b;
  report_.warnings =
      frame_warnings(a, named_frame(report_.b, options_.model_b, "--scale-b", "--up-b"));
  tell_warnings(report_.warnings, options_.model_a.strict, console());
}

bool PoseRun::read_row() {
  const std::optional<std::pair<Pose, Pose>> row = poses_.next();
  if (row) {
    check_row(*row);
    block_.push_back(*row);
  }
  return row.has_value();
}

/// A row that takes a body too far is named before its block is answered; a pose that was stated is
/// the query's to refuse.
void PoseRun::check_row(const std::pair<Pose, Pose>& row) const {
  if (poses_.is_stated()) {
    return;
  }
  check_pose(row.first, a_.bounds(), poses_.name_a());
  check_pose(row.second, bounds_b(), poses_.name_b());
}

void PoseRun::check_pose(const Pose& pose, const Box& bounds, const std::string& file) const {
  try {
    check_range(pose, bounds);
  } catch (const Error& error) {
    throw Error(error.kind(), place_of(block_.size(), file, error), error.remedy());
  }
}

/// The place of an error, in row `k` of the block.
std::string PoseRun::place_of(std::size_t k, const std::string& file, const Error& error) const {
  return fmt::format("{}: pose {}: {}", file, number() + k, without_subject(error.place()));
}

/// One pose uses the threads inside its query, several share them out. Answers of which several
/// would be right are those of one thread, so that they do not depend on what a block holds.
std::uint64_t PoseRun::answer_block() {
  reserve(block_.size());
  Parallel parallel = console().parallel();
  if (tiles_) {
    answer_of_tiles(parallel);
    return held();
  }
  if (block_.size() == 1 && (report_.single || !question_.is_free)) {
    parallel.progress = [this](double share) { show_progress(share); };
    Body a(a_);
    Body b(b_);
    answer_row(a, b, 0, parallel);
  } else {
    for_each_chunk(block_.size(), kRowsOfAThread, parallel,
                   [&](std::size_t begin, std::size_t end) {
                     while (begin < end) {
                       const std::size_t next = end_of_run(begin, end);
                       answer_rows(begin, next, {.stop = parallel.stop});
                       begin = next;
                     }
                   });
  }
  return held();
}

/// The end of the rows from `begin` on in which B stands still.
std::size_t PoseRun::end_of_run(std::size_t begin, std::size_t end) const {
  std::size_t next = begin + 1;
  while (next < end && block_[next].second.m == block_[begin].second.m) {
    ++next;
  }
  return next;
}

/// Tiles are opened once for all rows that meet them, so rows are not shared out here.
void PoseRun::answer_of_tiles(const Parallel& parallel) {
  for (std::size_t begin = 0; begin < block_.size();) {
    const std::size_t end = end_of_run(begin, block_.size());
    std::vector<Pose> poses;
    for (std::size_t k = begin; k < end; ++k) {
      poses.push_back(block_[k].first);
    }
    ask_tiles(begin, a_, poses, TiledBody{*tiles_, block_[begin].second}, parallel);
    begin = end;
  }
}

void PoseRun::answer_row(Body& a, Body& b, std::size_t k, const Parallel& parallel) {
  a.pose = block_[k].first;
  b.pose = block_[k].second;
  try {
    ask(k, a, b, parallel);
  } catch (const Error& error) {
    if (report_.single || error.kind() == ErrorKind::cancelled) {
      throw;
    }
    throw Error(error.kind(), place_of(k, poses_.name_a(), error), error.remedy());
  }
}

/// Answers rows in which b stands still together, which is faster. Where a pose is at fault, row by
/// row, so that the row is named.
void PoseRun::answer_rows(std::size_t begin, std::size_t end, const Parallel& parallel) {
  Body a(a_);
  Body b(b_, block_[begin].second);
  if (end - begin > 1) {
    std::vector<Pose> poses;
    for (std::size_t k = begin; k < end; ++k) {
      poses.push_back(block_[k].first);
    }
    try {
      ask(begin, a_, poses, b, parallel);
      return;
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled) {
        throw;
      }
    }
  }
  for (std::size_t k = begin; k < end; ++k) {
    answer_row(a, b, k, parallel);
  }
}

void PoseRun::print_row(std::size_t k, bool right, bool last) {
  look_at_boxes(k);
  report_.timed_out = last;
  print_answer(k, right);
}

/// Looks at the boxes of row `k`; with --strict those of a single row, far apart, are refused
/// before they are answered for.
void PoseRun::look_at_boxes(std::size_t k) {
  const Box a = report::moved(a_.bounds(), block_[k].first);
  const Box b = report::moved(bounds_b(), block_[k].second);
  boxes_.look(a, b);
  // Nothing tells what is inside of tiles.
  report_.one_box_in_other = !tiles_ && (a.contains(b) || b.contains(a));
  report_.gap = boxes_.gap();
  report_.boxes_apart =
      question_.doubts_gaps && boxes_.apart() && boxes_.gap() > question_.expected_gap;
  if (report_.single && report_.boxes_apart && options_.model_a.strict) {
    doubt_all_boxes();
  }
}

void PoseRun::doubt() {
  if (question_.doubts_gaps && boxes_.always_apart() &&
      boxes_.least_gap() > question_.expected_gap) {
    doubt_all_boxes();
  }
}

/// Of many poses some may be far off on purpose: only where all are, something may be wrong.
void PoseRun::doubt_all_boxes() {
  const FrameWarning warning =
      apart_warning(printable(report_.a.source), printable(report_.b.source), boxes_.least_gap(),
                    report_.single ? "" : "at every pose ");
  tell_warnings({warning}, options_.model_a.strict, console());
  report_.warnings.push_back(warning);
}

void PoseRun::finish(End end) {
  report_.interrupted = end == End::interrupted;
  report_.timed_out = end == End::out_of_time;
  if (options_.files && end == End::interrupted) {
    return;
  }
  if (options_.files && end == End::out_of_time) {
    throw Error(ErrorKind::timed_out, "the shard is not complete",
                "allow more time with --timeout");
  }
  finish_outputs();
  if (options_.files) {
    options_.files->finish(model_entry(report_.a),
                           tiles_ ? model_entry(*tiles_) : model_entry(report_.b), console());
  }
}

}  // namespace soms::command
