#include "apps/soms/overlap.h"

#include "soms/query/reference/overlap.h"

#include "apps/report/placing.h"
#include "apps/soms/block_size.h"
#include "apps/soms/overlap_output.h"
#include "apps/soms/overlap_report.h"
#include "apps/soms/overlap_verify.h"
#include "apps/support/console.h"
#include "apps/support/exit_status.h"
#include "apps/support/frame_warnings.h"
#include "apps/support/output.h"
#include "apps/support/parse.h"
#include "apps/support/pose_source.h"
#include "apps/support/stated_options.h"
#include "apps/support/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

using PosePair = std::pair<Pose, Pose>;

/// What is wrong with a pose, where the message has named the pose already.
std::string_view without_subject(std::string_view place) {
  constexpr std::string_view kSubject = "pose: ";
  return place.starts_with(kSubject) ? place.substr(kSubject.size()) : place;
}

/// Answers the rows of poses in blocks and prints each block's answers in order.
class OverlapRun {
 public:
  OverlapRun(const OverlapVerbOptions& options, Console& console)
      : options_(options),
        console_(console),
        output_(options),
        poses_(source("--pose", options.pose_a, console),
               source("--pose-b", options.pose_b, console)),
        a_(load(options.a, options.model_a)),
        b_(load(options.b, options.model_b)),
        report_{.a = a_.mesh(),
                .b = b_.mesh(),
                .mode = options.query.mode,
                .list_pairs = options.list_pairs,
                // Whoever reads a program's answers needs no other form for a single row.
                .single = poses_.is_stated() || (!console.shared().json && poses_.is_single()),
                .verified = options.verify,
                .traversal = options.query.traversal.traversal,
                .by_part = options.by_part,
                .read_a = stated_options(options.model_a, "--scale", "--up"),
                .read_b = stated_options(options.model_b, "--scale-b", "--up-b")},
        bar_(console.progress("overlap")) {
    options_.query.deadline = console.deadline();
    const std::array<const Mesh*, 2> meshes{&a_.mesh(), &b_.mesh()};
    report_.notes = notes_of(meshes);
    output_.begin(report_);
  }

  int run() {
    bool interrupted = false;
    try {
      answer_all();
    } catch (const Error& error) {
      interrupted = error.kind() == ErrorKind::cancelled;
      if (!interrupted) {
        throw;
      }
      error_ = nullptr;  // a faulty row was read ahead, but not reached
    }
    if ((!interrupted && !error_) || totals_.poses > 0) {
      print_totals(report_, totals_, console_);
    }
    console_.flush();
    if (error_) {
      std::rethrow_exception(error_);
    }
    if (boxes_.always_apart() && totals_.wrong == 0 && !interrupted) {
      doubt_all_boxes();
    }
    if (!interrupted || totals_.poses > 0) {
      report_.interrupted = interrupted;
      report_.timed_out = late_;
      output_.finish(totals_);
    }
    if (interrupted) {
      throw Error(ErrorKind::cancelled, "interrupted", answered() + " answered");
    }
    return status();
  }

 private:
  static PoseSource source(const std::string& option, const std::optional<std::string>& text,
                           const Console& console) {
    return text ? PoseSource(option, *text, console) : PoseSource();
  }

  Shape load(const std::string& path, const ModelOptions& model) {
    const bool named = options_.query.traversal.traversal != Traversal::fast;
    return build_shape(read_model(path, model, console_),
                       {.build = options_.build, .keep_tree = named}, console_);
  }

  /// Models are compared by their numbers; where these may mean different things, the reader
  /// should know.
  void doubt_frames() {
    report_.warnings =
        frame_warnings(named_frame(a_.mesh(), options_.model_a, "--scale", "--up"),
                       named_frame(b_.mesh(), options_.model_b, "--scale-b", "--up-b"));
    tell_warnings(report_.warnings, options_.model_a.strict, console_);
  }

  /// Looks at the boxes of row `k`; with --strict those of a single row, far apart, are refused
  /// before they are answered for.
  void doubt_boxes(std::size_t k) {
    boxes_.look(report::moved(a_.bounds(), block_[k].first),
                report::moved(b_.bounds(), block_[k].second));
    report_.gap = boxes_.gap();
    report_.boxes_apart = boxes_.apart();
    if (report_.single && report_.boxes_apart && options_.model_a.strict) {
      doubt_all_boxes();
    }
  }

  /// Of many poses some may be far off on purpose: only where all are, something may be wrong.
  void doubt_all_boxes() {
    const FrameWarning warning =
        apart_warning(printable(a_.mesh().source), printable(b_.mesh().source), boxes_.least_gap(),
                      report_.single ? "" : "at every pose ");
    tell_warnings({warning}, options_.model_a.strict, console_);
    report_.warnings.push_back(warning);
  }

  void answer_all() {
    doubt_frames();
    BlockSize size;
    while (!over_) {
      const auto begin = std::chrono::steady_clock::now();
      read_block(size.value());
      const std::uint64_t pairs = answer_block();
      print_block();
      size.learn(std::chrono::steady_clock::now() - begin, pairs);
    }
  }

  [[nodiscard]] std::string answered() const {
    return fmt::format("{} {}", counted(totals_.poses, "pose"), totals_.poses == 1 ? "is" : "are");
  }

  /// A faulty row ends the reading, as the end of time does; the rows before it are answered first,
  /// and also before a row that is not there yet: its writer may wait for the answers.
  void read_block(std::size_t size) {
    block_.clear();
    try {
      while (block_.size() < size && (block_.empty() || poses_.ready())) {
        const std::optional<PosePair> row = poses_.next();
        if (!row) {
          over_ = true;
          return;
        }
        check_row(*row);
        block_.push_back(*row);
      }
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled) {
        throw;
      }
      over_ = true;
      starved_ = error.kind() == ErrorKind::timed_out && totals_.poses + block_.size() > 0;
      error_ = starved_ ? nullptr : std::current_exception();
    }
  }

  /// Of many rows one that takes a body too far is named before its block is answered; a single one
  /// is the query's to refuse.
  void check_row(const PosePair& row) const {
    if (report_.single) {
      return;
    }
    check_pose(row.first, a_, poses_.name_a());
    check_pose(row.second, b_, poses_.name_b());
  }

  void check_pose(const Pose& pose, const Shape& shape, const std::string& file) const {
    try {
      check_range(pose, shape.bounds());
    } catch (const Error& error) {
      throw Error(error.kind(), place_of(block_.size(), file, error), error.remedy());
    }
  }

  /// The place of an error, in row `k` of the block.
  [[nodiscard]] std::string place_of(std::size_t k, const std::string& file,
                                     const Error& error) const {
    return fmt::format("{}: pose {}: {}", file, totals_.poses + k, without_subject(error.place()));
  }

  Overlap answer_row(Body& a, Body& b, std::size_t k, const Parallel& parallel) const {
    a.pose = block_[k].first;
    b.pose = block_[k].second;
    try {
      return overlap(a, b, options_.query, parallel);
    } catch (const Error& error) {
      if (report_.single || error.kind() == ErrorKind::cancelled) {
        throw;
      }
      throw Error(error.kind(), place_of(k, poses_.name_a(), error), error.remedy());
    }
  }

  /// Answers rows in which b stands still together, which is faster. Where a pose is at fault, row
  /// by row, so that the row is named.
  void answer_rows(std::size_t begin, std::size_t end, const Parallel& parallel) {
    Body a(a_);
    Body b(b_, block_[begin].second);
    if (end - begin > 1) {
      std::vector<Pose> poses;
      for (std::size_t k = begin; k < end; ++k) {
        poses.push_back(block_[k].first);
      }
      try {
        const OverlapBatch batch = overlap(a_, poses, b, options_.query, parallel);
        for (std::size_t k = begin; k < end; ++k) {
          answers_[k] = answer_of(batch, k - begin);
        }
        return;
      } catch (const Error& error) {
        if (error.kind() == ErrorKind::cancelled) {
          throw;
        }
      }
    }
    for (std::size_t k = begin; k < end; ++k) {
      answers_[k] = answer_row(a, b, k, parallel);
    }
  }

  static Overlap answer_of(const OverlapBatch& batch, std::size_t k) {
    const auto pairs = batch.pairs_of(k);
    return {.any = batch.any[k] != 0,
            .pairs = {pairs.begin(), pairs.end()},
            .coverage = batch.coverage[k],
            .cost = batch.costs[k],
            .traversal = batch.traversals.empty() ? TraversalCounts{} : batch.traversals[k]};
  }

  /// One pose uses the threads inside its query, several share them out.
  std::uint64_t answer_block() {
    answers_.assign(block_.size(), {});
    Parallel parallel = console_.parallel();
    if (block_.size() == 1) {
      parallel.progress = [this](double share) { show_progress(share); };
      Body a(a_);
      Body b(b_);
      answers_[0] = answer_row(a, b, 0, parallel);
    } else {
      for_each_chunk(block_.size(), kChunk, parallel, [&](std::size_t begin, std::size_t end) {
        while (begin < end) {
          std::size_t next = begin + 1;
          while (next < end && block_[next].second.m == block_[begin].second.m) {
            ++next;
          }
          answer_rows(begin, next, {.stop = parallel.stop});
          begin = next;
        }
      });
    }
    std::uint64_t pairs = 0;
    for (const Overlap& answer : answers_) {
      pairs += answer.pairs.size();
    }
    return pairs;
  }

  void show_progress(double share) {
    const bool perhaps_alone = totals_.poses == 0 && answers_.size() == 1;
    if (report_.single || perhaps_alone) {
      bar_.show(share);
    } else {
      bar_.show(counted(totals_.poses, "pose"));
    }
  }

  void print_block() {
    for (std::size_t k = 0; k < answers_.size(); ++k) {
      bool right = true;
      try {
        right = !options_.verify || verify(k);
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::timed_out || totals_.poses == 0) {
          throw;
        }
        end_by_time();
        break;
      }
      doubt_boxes(k);
      report_.timed_out = ended_by_time(answers_[k]);
      output_.add(totals_.poses, block_[k].first, block_[k].second, answers_[k], right, console_);
      totals_.add(answers_[k]);
      if (report_.timed_out) {
        end_by_time();
        break;
      }
    }
    if (starved_ && !late_) {
      end_by_time();
    }
    console_.flush();
    show_progress(0);
  }

  void end_by_time() {
    late_ = true;  // rows may be left
    console_.note(fmt::format("out of time after {}", counted(totals_.poses, "pose")));
    over_ = true;
    error_ = nullptr;  // a faulty row was read ahead, but not reached
  }

  [[nodiscard]] bool ended_by_time(const Overlap& answer) const {
    return answer.coverage == Coverage::cut && answer.pairs.size() < options_.query.limit &&
           console_.out_of_time();
  }

  /// True if brute force agrees.
  bool verify(std::size_t k) {
    const Overlap truth = console_.run("verifying", [&](const Parallel& parallel) {
      return reference::overlap(a_.mesh(), block_[k].first, b_.mesh(), block_[k].second, parallel);
    });
    const bool right = agrees(answers_[k], truth, options_.query.mode);
    if (!right) {
      ++totals_.wrong;
      print_error("soms overlap",
                  fmt::format("pose {}: brute force finds {}, but the answer has {}", totals_.poses,
                              counted(truth.pairs.size(), "pair"), answers_[k].pairs.size()));
    }
    return right;
  }

  [[nodiscard]] int status() const {
    if (totals_.wrong != 0) {
      return kDifference;
    }
    if (options_.fail_if_overlap && totals_.overlapping != 0) {
      return kConditionHolds;
    }
    // "Not found" is no proof of "free" when time ran out.
    return options_.fail_if_overlap && (totals_.undecided != 0 || late_) ? kOutOfTime : 0;
  }

  static constexpr std::size_t kChunk = 64;

  OverlapVerbOptions options_;
  Console& console_;
  OverlapOutput output_;
  PosePairs poses_;
  Shape a_;
  Shape b_;
  OverlapReport report_;
  Progress bar_;
  std::vector<PosePair> block_;
  std::vector<Overlap> answers_;
  OverlapTotals totals_;
  std::exception_ptr error_;
  BoxWatch boxes_;
  bool over_ = false;
  bool starved_ = false;  ///< time ended while a row was waited for
  bool late_ = false;
};

void add_questions(CLI::App& app, OverlapVerbOptions& options) {
  const char* const group = "Question";
  app.add_option(
         "--pose", options.pose_a,
         "pose of A: \"x y z [qw qx qy qz]\", or a CSV file, one row per pose; - is standard input")
      ->option_text("POSE")
      ->group(group);
  app.add_option("--pose-b", options.pose_b, "pose of B, in the same form")
      ->option_text("POSE")
      ->group(group);
  OverlapMode& mode = options.query.mode;
  const auto asks = [&](const std::string& name, OverlapMode value, const std::string& text) {
    return app
        .add_flag_callback(
            name, [&mode, value] { mode = value; }, text)
        ->group(group);
  };
  CLI::Option* all = asks("--all", OverlapMode::all, "find every pair (default)");
  CLI::Option* any =
      asks("--any", OverlapMode::any, "stop at the first pair found, whichever it is");
  CLI::Option* first =
      asks("--first", OverlapMode::first, "find the lowest pair by triangle numbers");
  any->excludes(all)->excludes(first);
  first->excludes(all);
  add_count(app, "--limit", options.query.limit, 1, std::numeric_limits<std::uint64_t>::max(),
            "stop after N pairs per pose")
      ->excludes(any)
      ->excludes(first)
      ->group(group);
  CLI::Option* no_pairs = app.add_flag_callback(
                                 "--no-pairs", [&options] { options.list_pairs = false; },
                                 "count the pairs without listing them")
                              ->group(group);
  add_choice<bool>(app, "--by", options.by_part, {{"triangle", false}, {"part", true}},
                   "what to list pairs of")
      ->excludes(any)
      ->excludes(first)
      ->excludes(no_pairs)
      ->group(group);
  add_choice<bool>(app, "--fail-if", options.fail_if_overlap, {{"overlap", true}},
                   "exit with status 1 if this is found")
      ->group(group);
  add_output(app, "--report", options.report,
             "write an HTML report with figures, plots and a 3-D view of the overlap")
      ->group(group);
  add_output(app, "--csv", options.csv, "write the pairs as CSV, one row per pair")
      ->excludes(no_pairs)
      ->group(group);
  app.add_flag("--verify", options.verify,
               "compare with brute force; exit with status 6 if they differ")
      ->group(group);
}

}  // namespace

Action add_overlap(CLI::App& app, Shared&) {
  const auto options = std::make_shared<OverlapVerbOptions>();
  app.add_option("A", options->a, "first model; - is standard input")->required()->type_name("");
  app.add_option("B", options->b, "second model")->required()->type_name("");
  add_questions(app, *options);
  add_model_options(app, options->model_a, "--scale", "--up", "A");
  add_model_options(app, options->model_b, "--scale-b", "--up-b", "B");
  app.add_flag("--allow-empty", options->model_a.allow_empty, "accept models without triangles")
      ->group("Models");
  add_strict(app, options->model_a.strict);
  add_build_options(app, options->build);
  add_traversal_options(app, options->query.traversal);
  app.footer(
      "Touching counts as overlap: corners and edges belong to their triangles. Only surfaces are\n"
      "tested: a body entirely inside another one does not overlap it.\n\nExample:\n"
      "  soms generate knot --triangles 2000 -o knot.ply\n"
      "  soms generate sphere --triangles 800 -o ball.off\n"
      "  soms overlap knot.ply ball.off --pose \"0.5 0 0\"");
  return [options, &app](Console& console) {
    options->model_a.offers_empty = true;
    options->model_b.offers_empty = true;
    options->model_b.allow_empty = options->model_a.allow_empty;
    options->model_b.strict = options->model_a.strict;
    check_build(app, options->build);
    check_traversal(app, options->query.traversal);
    if (!options->list_pairs && options->query.mode != OverlapMode::all && !console.shared().json) {
      throw Error(ErrorKind::usage,
                  "--no-pairs has no effect: --any and --first list no pairs without --json",
                  "leave it out, or also give --json");
    }
    return run_overlap(*options, console);
  };
}

int run_overlap(const OverlapVerbOptions& options, Console& console) {
  const std::array<std::optional<std::string>, 4> inputs{options.a, options.b, options.pose_a,
                                                         options.pose_b};
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    throw Error(ErrorKind::usage, "standard input is given twice", "give one of them as a file");
  }
  check_outputs({{"A", options.a},
                 {"B", options.b},
                 {"--pose", options.pose_a.value_or("")},
                 {"--pose-b", options.pose_b.value_or("")}},
                {{"--report", options.report}, {"--csv", options.csv}});
  check_extension("--report", options.report, {".html", ".htm"});
  check_extension("--csv", options.csv, {".csv"});
  return OverlapRun(options, console).run();
}

}  // namespace soms::command
