#include "apps/soms/simulate/simulate.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/model/part_filter.h"
#include "apps/output/output.h"
#include "apps/soms/shell/viewer.h"
#include "apps/soms/simulate/map.h"
#include "apps/soms/simulate/simulate_events.h"
#include "apps/soms/simulate/simulate_page.h"
#include "apps/soms/simulate/simulate_picture.h"
#include "apps/soms/simulate/simulate_record.h"
#include "apps/soms/simulate/simulate_report.h"
#include "apps/soms/simulate/simulate_run.h"
#include "apps/world/route_notes.h"
#include "apps/world/world.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

/// Greater exit statuses are those of a shell, for programs that did not end by themselves.
constexpr int kMostOfAProgram = 125;

void check_files(const SimulateOptions& options) {
  NamedFiles taken;
  for (const std::string& path : options.world.cities) {
    taken.emplace_back("CITY", path);
  }
  for (const std::string& path : options.world.movers) {
    taken.emplace_back("--mover", path);
  }
  for (const std::string& path : options.world.routes) {
    taken.emplace_back("--route", path);
  }
  SimulateOptions named = options;
  check_outputs_by_extension(std::move(taken), simulate_files(named),
                             {{"--contacts", options.contacts}, {"--record", options.record}});
  check_extension("--contacts", options.contacts, {".csv"});
}

/// Throws ErrorKind::usage for a recording of parts of a city.
void check_parts(const SimulateOptions& options) {
  const PartFilter& parts = *options.world.city_model.parts;
  if (parts.is_given() && (!options.record.empty() || !options.picture.empty())) {
    throw Error(ErrorKind::usage,
                parts.options() +
                    " does not go with --record and -o FILE.png, which name "
                    "whole models",
                "write a city of these parts first: soms convert CITY PARTS.ply " + parts.text());
  }
}

/// Throws ErrorKind::usage for a recording of models that nobody could find again.
void check_recording(const SimulateOptions& options) {
  const WorldOptions& world = options.world;
  for (const auto* const files : {&world.cities, &world.movers}) {
    if ((!options.record.empty() || !options.picture.empty()) &&
        std::find(files->begin(), files->end(), "-") != files->end()) {
      throw Error(ErrorKind::usage,
                  "--record and -o FILE.png cannot name a model from standard input",
                  "give the model as a file, which can be read again later");
    }
  }
}

RecordingEnding ending_of(const Outcome& outcome) {
  switch (outcome.ending) {
    case Ending::whole:
      return RecordingEnding::complete;
    case Ending::timed_out:
      return RecordingEnding::timed_out;
    case Ending::interrupted:
      break;
  }
  return RecordingEnding::interrupted;
}

/// Files of a simulation. Places that cannot be written to are reported before the work, not after
/// it.
class SimulateFiles {
 public:
  SimulateFiles(const SimulateOptions& options, const std::string& recording) {
    open(events_, options.events);
    open(contacts_, options.contacts);
    open(map_, options.map);
    open(page_, options.report);
    open(answer_, options.answer);
    open(recording_, recording);
  }

  /// What the frames are written to while they run; nothing where they are not.
  [[nodiscard]] std::optional<OutputFile>& recording() { return recording_; }

  [[nodiscard]] bool has_answer() const { return answer_.has_value(); }

  /// All but the answer.
  void write(const World& world, const Outcome& outcome, const SimulateOptions& options) {
    std::vector<std::size_t> event_of;
    if (events_ || contacts_ || page_) {
      event_of = events_of_contacts(world, outcome.contacts.contacts(), outcome.events.spans());
    }
    if (events_) {
      write_events(events_->stream(), world, outcome, event_of, options);
      events_->commit();
    }
    if (contacts_) {
      write_contacts(contacts_->stream(), world, outcome, event_of);
      contacts_->commit();
    }
    if (map_) {
      draw_map(map_->stream(), world, outcome);
      map_->commit();
    }
    if (page_) {
      write_page(page_->stream(), world, outcome, std::move(event_of), options);
      page_->commit();
    }
  }

  /// \pre has_answer().
  void write_answer(const std::string& json) {
    answer_->stream() << json;
    answer_->commit();
  }

 private:
  static void open(std::optional<OutputFile>& file, const std::string& path) {
    if (!path.empty()) {
      file.emplace(path);
    }
  }

  std::optional<OutputFile> events_;
  std::optional<OutputFile> contacts_;
  std::optional<OutputFile> map_;
  std::optional<OutputFile> page_;
  std::optional<OutputFile> answer_;
  std::optional<OutputFile> recording_;
};

/// `drawn`: the exit status of who drew the picture.
int status_of(const Outcome& outcome, const SimulateOptions& options, int drawn) {
  if (outcome.is_wrong()) {
    return kDifference;
  }
  if (outcome.ending == Ending::interrupted) {
    return kInterrupted;
  }
  if (drawn != 0) {
    return drawn <= kMostOfAProgram ? drawn : exit_code(ErrorKind::cannot_write);
  }
  if (options.fail_if == FailIf::never) {
    return 0;
  }
  if (!outcome.contacts.contacts().empty() || !outcome.passages.events().empty() ||
      (options.fail_if == FailIf::near && !outcome.near.events().empty())) {
    return kConditionHolds;
  }
  // "Not found" is no proof of "free" when time ran out.
  return outcome.ending == Ending::timed_out ? kOutOfTime : 0;
}

/// Movers that never come near the city cannot touch it: a shift, unit or axis may be missing. A
/// run that was interrupted may not have come to where they do; a wrong answer says enough.
std::vector<FrameWarning> doubt_boxes(const World& world, double clearance,
                                      const Outcome& outcome) {
  if (!outcome.boxes.always_apart() || outcome.boxes.least_gap() <= clearance ||
      outcome.ending == Ending::interrupted || outcome.is_wrong()) {
    return {};
  }
  return {apart_warning("the movers", world.title, outcome.boxes.least_gap(), "in every frame ")};
}

/// The pairs of --ignore-pair. \errors ErrorKind::usage for what is no pair, or changes nothing.
std::vector<NamedPair> parse_ignored(const SimulateOptions& options) {
  if (!options.ignored.empty() && !options.between_movers) {
    throw Error(ErrorKind::usage, "--ignore-pair has no effect with --no-between-movers",
                "leave out one of the two");
  }
  std::vector<NamedPair> pairs;
  for (const std::string& text : options.ignored) {
    pairs.push_back(parse_pair(text));
  }
  return pairs;
}

void check_fail_if(const SimulateOptions& options) {
  if (options.fail_if == FailIf::near && !(options.clearance > 0)) {
    throw Error(ErrorKind::usage, "--fail-if near has no effect without --clearance",
                "also give --clearance D");
  }
}

/// How many frames there are, once the routes are known; says what does not fit them.
void settle_frames(World& world, SimulateOptions& options, const Console& console) {
  const bool strict = options.world.city_model.strict;
  if (!options.frames_given) {
    options.frames = frames_of_routes(world, options.frames);
  }
  check_picture_frame(options);
  note_unused_rows(world, options.frames, strict, console);
  if (!options.swept) {
    note_long_steps(world, strict, console);
  }
}

/// Draws the picture, then tells and writes what was found, whatever became of the picture.
int finish(const World& world, const Outcome& outcome, const Picture& picture,
           const SimulateOptions& options, SimulateFiles& files, Console& console) {
  std::optional<int> drawn;
  std::exception_ptr fault;
  try {
    drawn = picture.draw(outcome, console);
  } catch (const Error&) {
    fault = std::current_exception();
  }
  SimulateOptions reported = options;
  if (drawn != 0) {
    reported.picture.clear();  // there is none
  }
  const std::string answer = files.has_answer() || console.shared().json
                                 ? json_of(world, outcome, reported)
                                 : std::string();
  if (files.has_answer()) {
    files.write_answer(answer);
  }
  console.print(console.shared().json ? answer
                                      : table_of(world, outcome, reported, console.terminal(),
                                                 console.talks_to_a_person()));
  console.flush();
  const int status = status_of(outcome, options, drawn.value_or(0));
  if (fault && status != kDifference) {
    std::rethrow_exception(fault);
  }
  return status;
}

/// A window instead of an answer.
int run_window(const SimulateOptions& options, const Console& console) {
  const bool answers = options.verify || options.fail_if != FailIf::never || console.shared().json;
  if (answers || !options.report.empty() || !options.map.empty() || !options.events.empty() ||
      !options.contacts.empty() || !options.record.empty() || !options.picture.empty() ||
      !options.answer.empty() || options.picture_frame || !options.between_movers ||
      !options.ignored.empty() || options.clearance > 0 || options.swept) {
    throw Error(ErrorKind::usage, "--view cannot be combined with an option of outputs or contacts",
                "leave out --view, or the other option");
  }
  std::vector<std::string> more;
  if (options.frames_given) {
    more = {"--frames", std::to_string(options.frames)};
  }
  more.insert(more.end(), options.tree_words.begin(), options.tree_words.end());
  return show_world(options.world, more, console);
}

}  // namespace

int run_simulate(const SimulateOptions& given, Console& console) {
  check_count(given.world);
  const std::vector<NamedPair> ignored = parse_ignored(given);
  check_parts(given);
  if (given.view) {
    return run_window(given, console);
  }
  check_files(given);
  check_recording(given);
  if (given.frames_given || given.world.routes.empty()) {
    check_picture_frame(given);
  }
  check_fail_if(given);
  // The answer is printed last: its reader is not waited for.
  console.go_on_without_reader();
  const Picture picture(given);
  SimulateOptions options = given;
  SimulateFiles files(options, picture.recording());
  World world = load_world(options.world, console);
  world.filter = {.between = options.between_movers, .ignored = ignored_pairs(world, ignored)};
  settle_frames(world, options, console);
  std::optional<Recorder> recorder;
  if (files.recording()) {
    recorder.emplace(*files.recording(), world, options.frames, options.clearance, options.swept);
  }
  const Outcome outcome = run_frames(world, options, console, recorder ? &*recorder : nullptr);
  if (recorder) {
    recorder->finish(ending_of(outcome));
  }
  const std::vector<FrameWarning> doubts = doubt_boxes(world, options.clearance, outcome);
  world.warnings.insert(world.warnings.end(), doubts.begin(), doubts.end());
  const bool strict = options.world.city_model.strict;
  if (!strict) {
    tell_warnings(doubts, strict, console);
  }
  files.write(world, outcome, options);
  const int status = finish(world, outcome, picture, options, files, console);
  if (strict) {
    tell_warnings(doubts, strict, console);  // an error, after all that was found is in its place
  }
  return status;
}

}  // namespace soms::command
