// The drives as a program draws them: frames a second with drawing and without.
#include "apps/draw/chart.h"
#include "thesis/experiments/experiments.h"
#include "thesis/races/drive_contenders.h"
#include "thesis/races/touching_drive.h"
#include "thesis/run/steps.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trips/drawn_frames.h"
#include "thesis/trips/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace soms::reproduce {

namespace {

/// In a quick run every so many frames are drawn.
constexpr std::size_t kQuickStep = 40;

/// Frames that are drawn of both drives through a scene, one after the other.
struct DrivenCourse {
  const Model* scene;
  std::vector<Vec3> offsets;
  std::size_t touching_from;  ///< the first frame of the touching drive
};

/// A rule and a traversal on a course.
struct Showing {
  const DrivenCourse* course;
  Contender build;  ///< of the scene
  std::size_t traversal;
  std::vector<Frame> frames = {};  ///< empty where there are too many pairs of triangles
  DrawnFrames drawn = {};

  /// Frames of a drive with contacts or without.
  [[nodiscard]] std::vector<std::size_t> frames_of(bool touching, bool contact) const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < frames.size(); ++k) {
      if ((k >= course->touching_from) == touching && frames[k].contacts.empty() != contact) {
        found.push_back(k);
      }
    }
    return found;
  }
};

/// Mean times of some frames, in milliseconds; 0 of none.
struct MeanTimes {
  double alone = 0;  ///< collision in a pass that draws nothing
  double drawn = 0;  ///< collision in a pass that draws
  double draw = 0;
};

MeanTimes mean_times(const Showing& showing, bool touching, bool contact) {
  std::vector<double> alone;
  std::vector<double> drawn;
  std::vector<double> draw;
  if (!showing.drawn.frames.empty()) {
    for (const std::size_t k : showing.frames_of(touching, contact)) {
      const DrawnFrame& frame = showing.drawn.frames[k];
      alone.push_back(frame.alone.sum());
      drawn.push_back(frame.drawn.sum());
      draw.push_back(frame.draw);
    }
  }
  return {mean_of(alone), mean_of(drawn), mean_of(draw)};
}

DrivenCourse course_of(const Model& scene, const Model& object, const Context& context) {
  DrivenCourse course{&scene, {}, 0};
  const std::size_t step = context.quick ? kQuickStep : 1;
  const auto add = [&](const std::vector<Vec3>& offsets) {
    for (std::size_t k = 0; k < offsets.size(); k += step) {
      course.offsets.push_back(offsets[k]);
    }
  };
  add(city_drive());
  course.touching_from = course.offsets.size();
  add(touching_drive(context, scene, object).offsets);
  return course;
}

void run_showing(Showing& showing, const Model& object, const Contender& build_of_object,
                 const Context& context) {
  Trip trip = drive_trip(*showing.course->scene, object, showing.build, build_of_object);
  trip.offsets = showing.course->offsets;
  const NamedTraversal traversal = drive_traversals()[showing.traversal];
  if (has_too_many_pairs(totals(traverse_frames(trip, traversal, context.limits)))) {
    return;
  }
  showing.frames = answer_frames(trip, traversal, context.limits);
  if (!context.draw) {
    showing.drawn.trouble = "this run has no program that draws";
    return;
  }
  showing.drawn = context.draw({.still = trip.a.shared_mesh(),
                                .moving = trip.b.shared_mesh(),
                                .offsets = trip.offsets,
                                .build = showing.build.options,
                                .moving_level = build_of_object.options.level,
                                .traversal = traversal.options});
  const std::vector<DrawnFrame>& drawn = showing.drawn.frames;
  require(drawn.empty() || drawn.size() == showing.frames.size(),
          fmt::format("drive through {}: frames drawn and frames requested", trip.still));
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    require(drawn[k].contacts == showing.frames[k].contacts.size(),
            fmt::format("drive through {}, frame {}: contacts by {} drawn and not drawn",
                        trip.still, k, traversal.name));
  }
}

Table drawn_table(const std::vector<Showing>& showings, const std::string& outcome) {
  Table table{
      .id = "drives_drawn",
      .caption = fmt::format(
          "The drives as soms-view draws them, without a screen: {} Milliseconds are means "
          "over the frames with contact and over those without; collision is moving the "
          "boxes, traversing the trees and testing the triangles, in passes without drawing and in "
          "passes with it "
          "(collision_drawn); drawing ends when the driver has finished, and is the "
          "median over rules and traversals, whose pictures are the same; fps are 1000 / ms. Trees "
          "of level {}, scenes {}.{}",
          outcome, kObjectLevel, kSceneLevel, kThesisOptions),
      .columns = {{"static"}, {"rule"}, {"test"}, {"algorithm"}, {"frames"}, {"contact_frames"}}};
  for (const char* const kind : {"contact", "free"}) {
    for (const char* const part : {"collision", "collision_drawn", "drawing"}) {
      table.columns.push_back({fmt::format("{}_{}", kind, part), "ms", ColumnKind::timed});
    }
    for (const char* const part : {"fps", "fps_drawn"}) {
      table.columns.push_back({fmt::format("{}_{}", kind, part), "", ColumnKind::timed});
    }
  }
  table.columns.push_back({"renderer", "", ColumnKind::timed});
  for (const Showing& showing : showings) {
    for (const bool touching : {false, true}) {
      const std::size_t contact = showing.frames_of(touching, true).size();
      const std::size_t free = showing.frames_of(touching, false).size();
      std::vector<Cell> row{showing.course->scene->name,
                            showing.build.name,
                            word_cell(touching ? "touching_drive" : "drive"),
                            drive_traversals()[showing.traversal].name,
                            count_cell(contact + free),
                            count_cell(contact)};
      for (const bool with_contact : {true, false}) {
        const MeanTimes ms = mean_times(showing, touching, with_contact);
        for (const double part : {ms.alone, ms.drawn, ms.draw}) {
          row.push_back(part > 0 ? number_cell(part) : Cell{});
        }
        row.push_back(rate_cell(ms.alone));
        row.push_back(rate_cell(ms.drawn + ms.draw));
      }
      row.push_back(showing.drawn.device.empty() ? Cell{} : word_cell(showing.drawn.device));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

/// Least and greatest share of drawing in a frame, and how far rules and traversals are apart with
/// drawing and without: a sentence about the contact frames of the touching drives.
std::string effect_of_drawing(const std::vector<Showing>& showings) {
  double least_share = 1;
  double most_share = 0;
  double apart = 1;
  double apart_drawn = 1;
  for (const Showing& one : showings) {
    const MeanTimes a = mean_times(one, true, true);
    if (a.draw <= 0) {
      continue;
    }
    const double share = a.draw / (a.drawn + a.draw);
    least_share = std::min(least_share, share);
    most_share = std::max(most_share, share);
    for (const Showing& other : showings) {
      const MeanTimes b = mean_times(other, true, true);
      if (other.course == one.course && b.draw > 0) {
        apart = std::max(apart, a.alone / b.alone);
        apart_drawn = std::max(apart_drawn, (a.drawn + a.draw) / (b.drawn + b.draw));
      }
    }
  }
  if (most_share == 0) {
    return "No frame was drawn.";
  }
  return fmt::format(
      "Drawing takes {:.1f} to {:.1f} % of a drawn frame. The slowest rule and traversal takes up "
      "to {:.2f} times as long as the fastest in the same scene without drawing, and up to {:.2f} "
      "times with it.",
      100 * least_share, 100 * most_share, apart, apart_drawn);
}

Figure drawn_figure(const std::vector<Showing>& showings) {
  BarChart chart{.title = "Frames a second with contact, touching drives",
                 .y_label = "frames a second",
                 .y_scale = Scale::log,
                 .bars = {{.name = "without drawing"}, {.name = "with drawing"}}};
  for (const Showing& showing : showings) {
    const MeanTimes ms = mean_times(showing, true, true);
    if (ms.draw > 0) {
      chart.groups.push_back(fmt::format("{}, {}, {}", showing.course->scene->name,
                                         showing.build.title,
                                         showing.traversal == larsson ? "Larsson" : "E-Node"));
      chart.bars[0].values.push_back(1000 / ms.alone);
      chart.bars[1].values.push_back(1000 / (ms.drawn + ms.draw));
    }
  }
  return {.id = "drives_drawn",
          .caption = fmt::format("Frames a second over the contact frames of the touching drives "
                                 "(1000 / mean ms), drawn by {}. {}{}",
                                 showings.front().drawn.device, effect_of_drawing(showings),
                                 kThesisOptions),
          .svg = draw(chart),
          .timed = true};
}

/// The pictures are the same for all rules and traversals on a course: each frame's drawing time
/// becomes the median over them, so that what a busy machine added does not look like a rule's.
void share_drawing(std::vector<Showing>& showings, const DrivenCourse& course) {
  for (std::size_t k = 0; k < course.offsets.size(); ++k) {
    std::vector<double> times;
    for (const Showing& showing : showings) {
      if (showing.course == &course && !showing.drawn.frames.empty()) {
        times.push_back(showing.drawn.frames[k].draw);
      }
    }
    if (times.empty()) {
      return;
    }
    const double shared = summarize(std::move(times)).median;
    for (Showing& showing : showings) {
      if (showing.course == &course && !showing.drawn.frames.empty()) {
        showing.drawn.frames[k].draw = shared;
      }
    }
  }
}

/// What was drawn, or why nothing was, for the caption.
std::string outcome_of(const std::vector<Showing>& showings) {
  for (const Showing& showing : showings) {
    if (!showing.drawn.trouble.empty()) {
      return fmt::format("nothing was drawn ({}), so the times are empty.", showing.drawn.trouble);
    }
  }
  for (const Showing& showing : showings) {
    if (!showing.drawn.frames.empty()) {
      return fmt::format(
          "{}x{} pixels, a usual size when the thesis was written, one sample a pixel, "
          "each time the median of {} passes.",
          showing.drawn.width, showing.drawn.height, showing.drawn.passes);
    }
  }
  return "there was nothing to draw, so the times are empty.";
}

std::vector<Showing> showings_on(const std::vector<DrivenCourse>& courses) {
  std::vector<Showing> showings;
  const std::vector<Contender> builds = thesis_rules(kSceneLevel);
  for (const DrivenCourse& course : courses) {
    for (const std::string_view rule : kDriveRules) {
      for (std::size_t i = 0; i < drive_traversal_count; ++i) {
        showings.push_back({&course, build_named(builds, rule), i});
      }
    }
  }
  return showings;
}

}  // namespace

Result drives_drawn(const Context& context) {
  const Model& object = context.models.objects.front();
  const std::vector<Contender> of_object = thesis_rules(kObjectLevel);
  std::vector<DrivenCourse> courses;
  Result result{.remarks = {object_remark(object)}};
  for (const Model& scene : context.models.scenes) {
    courses.push_back(course_of(scene, object, context));
  }
  std::vector<Showing> showings = showings_on(courses);
  Steps steps(context.limits, showings.size());
  for (Showing& showing : showings) {
    run_showing(showing, object, build_named(of_object, showing.build.name), context);
    if (showing.frames.empty() && showing.traversal == larsson) {
      result.remarks.push_back(fmt::format(
          "Left out: {} trees of {}, whose overlapping leaves hold too many pairs of triangles.",
          showing.build.title, showing.course->scene->name));
    }
    steps.done_one();
  }
  std::erase_if(showings, [](const Showing& showing) { return showing.frames.empty(); });
  result.remarks.emplace_back(
      "The marks of contacts in the pictures come from the viewer's own query, which is not timed. "
      "The numbers of contacts in the drawn frames are those of the frames that are not drawn.");
  if (context.quick) {
    result.remarks.push_back(
        fmt::format("Quick run: every {}th frame of a drive is drawn.", kQuickStep));
  }
  for (const DrivenCourse& course : courses) {
    share_drawing(showings, course);
  }
  result.tables = {drawn_table(showings, outcome_of(showings))};
  const bool any = std::any_of(showings.begin(), showings.end(), [](const Showing& showing) {
    return mean_times(showing, true, true).draw > 0;
  });
  if (any) {
    result.figures = {drawn_figure(showings)};
  }
  return result;
}

}  // namespace soms::reproduce
