#include "apps/soms/thesis/thesis_picture.h"

#include "soms/base/error.h"
#include "soms/io/write_mesh.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"

#include "apps/cli/child.h"
#include "apps/cli/console.h"
#include "apps/cli/kebab.h"
#include "apps/cli/temporary_folder.h"
#include "apps/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace soms::command {

namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

/// The trees and the traversal, as soms-view takes them.
Words words_of_trees(const ThesisOptions& options) {
  const BuildOptions& build = options.build;
  std::string keys;
  const auto add = [&](bool differs, std::string_view key, const std::string& value) {
    if (differs) {
      keys += fmt::format("{}{}={}", keys.empty() ? "" : ",", key, value);
    }
  };
  add(true, "rule", std::string(entry(build.rule).kebab));
  add(true, "levels", std::to_string(build.level));
  add(true, "leaf", std::to_string(build.per_leaf));
  const BuildOptions thesis = without_idle(thesis_options(build.rule, build.level));
  add(build.midpoint != thesis.midpoint, "midpoint", kebab(name(build.midpoint)));
  add(build.empty_side != thesis.empty_side, "empty-side", kebab(name(build.empty_side)));
  if (build.axis_from) {
    add(build.axis_from != thesis.axis_from, "axis-from", kebab(name(*build.axis_from)));
  }
  add(build.root_level != thesis.root_level, "root-level", std::to_string(build.root_level));
  add(build.c_vertex != thesis.c_vertex, "c-vertex", std::to_string(build.c_vertex));
  const Traversal traversal = options.traversal.traversal;
  add(true, "traversal", std::string(entry(traversal).kebab));
  add(has_descent(traversal), "descent", std::string(entry(options.traversal.descent).kebab));
  return {"--thesis", "--tree", keys};
}

/// The two models of trips as soms-view reads them: their files, or those that are written for
/// models which have none.
class ViewedModels {
 public:
  ViewedModels() : folder_("models") {}

  /// The models and the test.
  [[nodiscard]] Words words(const ThesisTrip& what) {
    Words words{as_argument(file(what.still_file, what.trip.still, what.trip.a)), "--mover",
                file(what.moving_file, what.trip.moving, what.trip.b)};
    add_reading(words, what.still_file, what.up, "--scale", "--up");
    add_reading(words, what.moving_file, what.up, "--mover-scale", "--mover-up");
    return words;
  }

 private:
  std::string file(const ThesisFile& file, const std::string& name, const Shape& shape) {
    if (!file.path.empty()) {
      return file.path;
    }
    const fs::path path = folder_.path() / (name + ".ply");
    if (written_.insert(path).second) {
      write_mesh(path, shape.mesh(), MeshFormat::ply);
    }
    return path.string();
  }

  static void add_reading(Words& words, const ThesisFile& file, std::size_t up,
                          const std::string& scale_option, const std::string& up_option) {
    constexpr const char* kAxes[] = {"", "x", "y", "z"};
    if (file.scale_is_given) {
      words.insert(words.end(), {scale_option, fmt::format("{}", file.scale)});
    }
    const char* const own = up == 1 ? "y" : "z";
    words.insert(
        words.end(),
        {up_option, file.up == UpAxis::unknown ? own : kAxes[static_cast<std::size_t>(file.up)]});
  }

  TemporaryFolder folder_;
  std::set<fs::path> written_;
};

/// Frames that are drawn: the first with roots, the first with a contact, and the last.
std::set<std::size_t> drawn_frames(const ThesisResult& result) {
  std::set<std::size_t> frames{result.frames.size() - 1};
  for (const auto& first : {result.summary.first_root, result.summary.first_contact}) {
    if (first) {
      frames.insert(*first);
    }
  }
  return frames;
}

/// The test and its frame; the drive of the thesis has a path of its own.
void add_frame(Words& words, const ThesisTrip& what, std::size_t frame) {
  if (what.still_file.path.empty() && what.trip.test == kDriveTest) {
    const Vec3& at = what.trip.offsets[frame];
    words.insert(words.end(), {"--pose", fmt::format("{} {} {}", at.x, at.y, at.z)});
  } else {
    words.insert(words.end(), {"--test", what.trip.test, "--frame", std::to_string(frame)});
  }
}

std::string title_of(const ThesisResult& result, std::size_t frame) {
  return fmt::format("{}, {}: frame {} of 0 to {}, contacts: {}", result.what.trip.moving,
                     result.what.trip.test, frame, result.frames.size() - 1,
                     with_commas(result.frames[frame].contacts.size()));
}

/// Says how what soms-view shows of a drive differs from the table.
void note_on_drive(const ThesisTrip& what, const ThesisOptions& options, const Console& console) {
  if (what.trip.test == kDriveTest && what.still_levels.last != options.build.level) {
    console.note(
        fmt::format("drive: soms-view builds both trees with {} levels; the table has {} levels of "
                    "the still model (--level {} shows the same)",
                    options.build.level, what.still_levels.last, what.still_levels.last));
  }
}

}  // namespace

int show_trip(const ThesisTrip& what, const ThesisOptions& options, const Console& console) {
  const fs::path program = viewer_program();
  ViewedModels models;
  Words words{"view"};
  for (const Words& more : {models.words(what), words_of_trees(options)}) {
    words.insert(words.end(), more.begin(), more.end());
  }
  words.insert(words.end(), {"--test", what.trip.test, "--run"});
  note_on_drive(what, options, console);
  if (what.trip.test == kDriveTest && what.still_file.path.empty()) {
    console.note("drive: the window has a path of its own, and the table that of the thesis");
  }
  if (console.shared().quiet) {
    words.emplace_back("--quiet");
  }
  return run_child(program, words, console, {.called = "soms"});
}

ThesisPictures::ThesisPictures(const ThesisOptions& options) : options_(options) {
  if (options.picture.empty()) {
    return;
  }
  (void)viewer_program();
  std::error_code error;
  fs::create_directories(options.picture, error);
  if (error) {
    throw Error(ErrorKind::cannot_write, fmt::format("{}: {}", options.picture, error.message()),
                "name a folder that can be written to");
  }
}

int ThesisPictures::draw(const std::vector<ThesisResult>& results, const Console& console) const {
  if (options_.picture.empty()) {
    return 0;
  }
  const fs::path program = viewer_program();
  ViewedModels models;
  const Words trees = words_of_trees(options_);
  for (const ThesisResult& result : results) {
    note_on_drive(result.what, options_, console);
    const Words files = models.words(result.what);
    for (const std::size_t frame : drawn_frames(result)) {
      const fs::path picture =
          fs::path(options_.picture) /
          fmt::format("{}_{}_{}.png", result.what.trip.moving, result.what.trip.test, frame);
      Words words{"render", "--quiet", "--trace", "--title=" + title_of(result, frame)};
      words.insert(words.end(), files.begin(), files.end());
      words.insert(words.end(), trees.begin(), trees.end());
      add_frame(words, result.what, frame);
      words.insert(words.end(), {"--output", as_argument(picture.string())});
      if (const int status = run_child(program, words, console, {.called = "soms"}); status != 0) {
        return status;
      }
      console.note(fmt::format("wrote {}", picture.string()));
    }
  }
  return 0;
}

}  // namespace soms::command
