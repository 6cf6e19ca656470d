#include "apps/soms/pairs/pose_rows.h"

#include "soms/base/error.h"
#include "soms/base/parallel.h"

#include "apps/cli/console.h"
#include "apps/model/part_filter.h"
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

RefusedOfTiles refused_page(const AnswerOutputs& outputs) {
  return {!outputs.page.empty(), "-o " + outputs.page, "a page shows the whole model"};
}

PoseRows::PoseRows(const PairOptions& options, PoseTerms terms, Console& console)
    : options_(options),
      terms_(std::move(terms)),
      console_(console),
      poses_(poses_of(options, console)),
      a_(load(options.a, options.model_a)),
      tiles_(load_tiles()),
      b_(tiles_ ? ModelShape() : load(options.b, options.model_b)),
      report_{.a = a_.file_mesh(),
              .b = tiles_ ? MeshView(tiles_->manifest().statements) : b_.file_mesh(),
              .left_a = a_,
              .left_b = b_,
              // Whoever reads a program's answers needs no other form for a single row.
              .single = !options.files &&
                        (poses_.is_stated() || (!console.shared().json && poses_.is_single())),
              .verified = options.verify,
              .lists_rows = !options.files || console.shared().json,
              .read_a = stated_options(options.model_a, "--scale", "--up"),
              .read_b = stated_options(options.model_b, "--scale-b", "--up-b")},
      before_(options.files ? options.files->rows().begin : 0) {
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
  if (options.model_a.parts) {
    options.model_a.parts->finish(console);
  }
}

RowRunOptions PoseRows::run_options() const {
  return {.verb = terms_.verb,
          .noun = "pose",
          .verify = options_.verify,
          .fail_if_found = terms_.fail_if_found,
          .first = before_};
}

PosePairs PoseRows::poses_of(const PairOptions& options, const Console& console) {
  if (options.files) {
    return options.files->poses(options, console);
  }
  return {source("--pose", options.pose_a, console), source("--pose-b", options.pose_b, console)};
}

PoseSource PoseRows::source(const std::string& option, const std::optional<std::string>& text,
                            const Console& console) {
  return text ? PoseSource(option, *text, console, NoRows::no_poses) : PoseSource();
}

ModelShape PoseRows::load(const std::string& path, const ModelOptions& model) const {
  return load_model_shape(path, model, {.build = options_.build, .keep_tree = terms_.keep_trees},
                          console_);
}

std::optional<TileSet> PoseRows::load_tiles() const {
  if (!terms_.refused_of_tiles || !is_tile_folder(options_.b)) {
    return std::nullopt;
  }
  refuse_of_tiles(options_.b, *terms_.refused_of_tiles);
  refuse_of_tiles(options_.b, {refused_verify(options_.verify)});
  return open_tiles(options_.b, options_.model_b, options_.build, console_, "-b");
}

const Box& PoseRows::bounds_b() const {
  return tiles_ ? tiles_->bounds() : b_.shape.bounds();
}

/// Models are compared by their numbers; where these may mean different things, the reader should
/// know.
void PoseRows::begin() {
  NamedFrame a = named_frame(report_.a, options_.model_a, "--scale", "--up");
  a.is_posed = options_.pose_a || options_.pose_b;
  report_.warnings =
      frame_warnings(a, named_frame(report_.b, options_.model_b, "--scale-b", "--up-b"));
  tell_warnings(report_.warnings, options_.model_a.strict, console_);
}

void PoseRows::clear() {
  before_ += block_.size();
  block_.clear();
}

bool PoseRows::read() {
  const std::optional<std::pair<Pose, Pose>> row = poses_.next();
  if (row) {
    check_row(*row);
    block_.push_back(*row);
  }
  return row.has_value();
}

/// A row that takes a body too far is named before its block is answered; a pose that was stated is
/// the query's to refuse.
void PoseRows::check_row(const std::pair<Pose, Pose>& row) const {
  if (poses_.is_stated()) {
    return;
  }
  check_pose(row.first, a_.shape.bounds(), poses_.name_a());
  check_pose(row.second, bounds_b(), poses_.name_b());
}

void PoseRows::check_pose(const Pose& pose, const Box& bounds, const std::string& file) const {
  try {
    check_range(pose, bounds);
  } catch (const Error& error) {
    throw Error(error.kind(), place_of(block_.size(), file, error), error.remedy());
  }
}

/// The place of an error, in row `k` of the block.
std::string PoseRows::place_of(std::size_t k, const std::string& file, const Error& error) const {
  return fmt::format("{}: pose {}: {}", file, before_ + k, without_subject(error.place()));
}

/// One pose uses the threads inside its query, several share them out. Answers of which several
/// would be right are those of one thread, so that they do not depend on what a block holds. Tiles
/// are opened once for all rows that meet them, so their rows are not shared out here.
void PoseRows::answer(PoseAnswers& answers, const ShowProgress& show) const {
  Limits limits = console_.limits();
  if (tiles_) {
    for (std::size_t begin = 0; begin < block_.size();) {
      const std::size_t end = end_of_run(begin, block_.size());
      answers.answer_some(begin, a_.shape, poses_a(begin, end), TiledBody{*tiles_, pose_b(begin)},
                          limits);
      begin = end;
    }
  } else if (block_.size() == 1 && (report_.single || !terms_.is_free)) {
    limits.progress = show;
    Body a(a_.shape);
    Body b(b_.shape);
    answer_row(answers, a, b, 0, limits);
  } else {
    for_each_chunk(block_.size(), kRowsOfAThread, limits.without_deadline(),
                   [&](std::size_t begin, std::size_t end) {
                     while (begin < end) {
                       const std::size_t next = end_of_run(begin, end);
                       answer_rows(answers, begin, next, limits.alone());
                       begin = next;
                     }
                   });
  }
}

/// The end of the rows from `begin` on in which B stands still.
std::size_t PoseRows::end_of_run(std::size_t begin, std::size_t end) const {
  std::size_t next = begin + 1;
  while (next < end && block_[next].second.m == block_[begin].second.m) {
    ++next;
  }
  return next;
}

std::vector<Pose> PoseRows::poses_a(std::size_t begin, std::size_t end) const {
  std::vector<Pose> poses;
  for (std::size_t k = begin; k < end; ++k) {
    poses.push_back(pose_a(k));
  }
  return poses;
}

void PoseRows::answer_row(PoseAnswers& answers, Body& a, Body& b, std::size_t k,
                          const Limits& limits) const {
  a.pose = pose_a(k);
  b.pose = pose_b(k);
  try {
    answers.answer_one(k, a, b, limits);
  } catch (const Error& error) {
    if (report_.single || error.kind() == ErrorKind::cancelled) {
      throw;
    }
    throw Error(error.kind(), place_of(k, poses_.name_a(), error), error.remedy());
  }
}

/// Answers rows in which b stands still together, which is faster. Where a pose is at fault, row by
/// row, so that the row is named.
void PoseRows::answer_rows(PoseAnswers& answers, std::size_t begin, std::size_t end,
                           const Limits& limits) const {
  Body a(a_.shape);
  Body b(b_.shape, pose_b(begin));
  if (end - begin > 1) {
    try {
      answers.answer_some(begin, a_.shape, poses_a(begin, end), b, limits);
      return;
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled) {
        throw;
      }
    }
  }
  for (std::size_t k = begin; k < end; ++k) {
    answer_row(answers, a, b, k, limits);
  }
}

/// Looks at the boxes of the row; with --strict those of a single row, far apart, are refused
/// before they are answered for.
void PoseRows::report(const AnsweredRow& row) {
  report_.timed_out = row.last;
  const Box a = report::moved(a_.shape.bounds(), pose_a(row.k));
  const Box b = report::moved(bounds_b(), pose_b(row.k));
  boxes_.look(a, b);
  // Nothing tells what is inside of tiles.
  report_.one_box_in_other = !tiles_ && (a.contains(b) || b.contains(a));
  report_.gap = boxes_.gap();
  report_.boxes_apart = terms_.doubts_gaps && boxes_.apart() && boxes_.gap() > terms_.expected_gap;
  if (report_.single && report_.boxes_apart && options_.model_a.strict) {
    doubt_all_boxes();
  }
}

void PoseRows::doubt() {
  if (terms_.doubts_gaps && boxes_.always_apart() && boxes_.least_gap() > terms_.expected_gap) {
    doubt_all_boxes();
  }
}

/// Of many poses some may be far off on purpose: only where all are, something may be wrong.
void PoseRows::doubt_all_boxes() {
  const FrameWarning warning =
      apart_warning(printable(report_.a.source), printable(report_.b.source), boxes_.least_gap(),
                    report_.single ? "" : "at every pose ");
  tell_warnings({warning}, options_.model_a.strict, console_);
  report_.warnings.push_back(warning);
}

bool PoseRows::end(RunEnd end) {
  report_.interrupted = end == RunEnd::interrupted;
  report_.timed_out = end == RunEnd::out_of_time;
  if (options_.files && report_.timed_out) {
    throw Error(ErrorKind::timed_out, "the shard is not complete",
                "allow more time with --timeout");
  }
  return !options_.files || !report_.interrupted;
}

void PoseRows::finish() {
  if (options_.files) {
    options_.files->finish(model_entry(report_.a),
                           tiles_ ? model_entry(*tiles_) : model_entry(report_.b), console_);
  }
}

}  // namespace soms::command
