// What E-Node might be: readings of its name, each run on every course, and what boxes of an
// earlier level get wrong where they stand for an answer.
#include "apps/draw/chart.h"
#include "apps/draw/grouped_bars.h"
#include "thesis/experiments/experiments.h"
#include "thesis/races/e_node_course.h"
#include "thesis/races/enode_racers.h"
#include "thesis/run/steps.h"
#include "thesis/run/traversal_tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::reproduce {

namespace {

std::string_view words_of(EnodeAnswer answer) {
  switch (answer) {
    case EnodeAnswer::first_leaves:
      return "yes or no, of boxes";
    case EnodeAnswer::first_contact:
      return "yes or no";
    case EnodeAnswer::boxes_only:
      return "all pairs and false ones";
    case EnodeAnswer::all_pairs:
      break;
  }
  return "all pairs";
}

Table counts_table(std::span<const CourseWork> courses) {
  Table table{
      .id = "readings_e_node",
      .caption = fmt::format(
          "What each reading of E-Node does on every course, trees by SOMS: work for its answer "
          "over all frames; work up to the first overlapping leaves, and up to the first triangles "
          "that touch, over the frames that have them. boxes_only: level {}, its pairs of nodes "
          "and the frames that it calls touching. From the last front all frames are traversed to "
          "their ends.{}",
          kEarlierLevel, kThesisOptions),
      .columns = {{"reading"},
                  {"model"},
                  {"course"},
                  {"answer"},
                  {"frames"},
                  {"box_tests"},
                  {"entered"},
                  {"pairs"},
                  {"triangle_pairs"},
                  {"leaf_frames"},
                  {"first_leaf_tests"},
                  {"first_leaf_entered"},
                  {"contact_frames"},
                  {"first_contact_tests"},
                  {"first_contact_entered"},
                  {"stands"}}};
  for (std::size_t i = 0; i < e_node_readings().size(); ++i) {
    const EnodeReading& reading = e_node_readings()[i];
    const bool boxes = reading.answer == EnodeAnswer::boxes_only;
    for (const CourseWork& course : courses) {
      const EarlierLevel& level = at_level(course.levels, kEarlierLevel);
      const EnodeTripWork& work = course.work[i];
      const EnodeWork own = work_of(reading, work, level);
      const bool contact = !boxes && reading.answer != EnodeAnswer::first_leaves;
      const auto if_contact = [&](std::uint64_t n) { return contact ? count_cell(n) : Cell{}; };
      const auto if_leaves = [&](std::uint64_t n) { return boxes ? Cell{} : count_cell(n); };
      table.rows.push_back({word_cell(reading.name), course.model, course.subject,
                            word_cell(words_of(reading.answer)), count_cell(course.frames),
                            count_cell(own.box_tests), count_cell(own.entered),
                            count_cell(own.leaf_pairs), count_cell(own.triangle_pairs),
                            count_cell(boxes ? level.called_frames : work.leaves.frames.size()),
                            count_cell(boxes ? level.first_tests : work.leaves.to_hit.box_tests),
                            if_leaves(work.leaves.to_hit.entered),
                            if_contact(work.contact.frames.size()),
                            if_contact(work.contact.to_hit.box_tests),
                            if_contact(work.contact.to_hit.entered), word_cell(reading.stands)});
    }
  }
  return table;
}

Table levels_table(std::span<const CourseWork> courses) {
  Table table{.id = "readings_e_node_levels",
              .caption =
                  "Boxes alone: trees by SOMS cut at a level, pairs of nodes whose boxes overlap, "
                  "and how many of them hold triangles that touch by the exact test; frames that "
                  "are called touching, and those in which nothing touches. A scene's tree ends at "
                  "level 13.",
              .columns = {{"model"},
                          {"course"},
                          {"level"},
                          {"frames"},
                          {"box_tests"},
                          {"entered"},
                          {"first_tests"},
                          {"pairs"},
                          {"touching_pairs"},
                          {"false_pairs"},
                          {"called_frames"},
                          {"touching_frames"},
                          {"false_frames"}}};
  for (const CourseWork& course : courses) {
    for (const int level : kShownLevels) {
      const EarlierLevel& found = at_level(course.levels, level);
      table.rows.push_back(
          {course.model, course.subject, count_cell(static_cast<std::uint64_t>(level)),
           count_cell(course.frames), count_cell(found.box_tests), count_cell(found.entered),
           count_cell(found.first_tests), count_cell(found.pairs), count_cell(found.touching_pairs),
           count_cell(found.pairs - found.touching_pairs), count_cell(found.called_frames),
           count_cell(course.contact_frames),
           count_cell(found.called_frames - course.contact_frames)});
    }
  }
  return table;
}

Table first_frames_table(std::span<const FirstFrames> trips) {
  const auto cell = [](std::size_t frame) {
    return frame == kNoFrame ? Cell{} : count_cell(frame);
  };
  Table table{
      .id = "readings_e_node_frames",
      .caption = fmt::format(
          "How early and how right: the first frame of each test in which the roots overlap, boxes "
          "of level {}, boxes of leaves, and the first in which triangles touch. Frames count from "
          "0; empty where there is none. Trees by SOMS.{}",
          kEarlierLevel, kThesisOptions),
      .columns = {{"model"},
                  {"still"},
                  {"test"},
                  {"frames"},
                  {"first_root_frame"},
                  {fmt::format("first_level_{}_frame", kEarlierLevel)},
                  {"first_leaf_frame"},
                  {"first_contact_frame"}}};
  for (const FirstFrames& trip : trips) {
    table.rows.push_back({trip.model, trip.still, trip.test, count_cell(trip.frames),
                          cell(trip.root), cell(trip.earlier), cell(trip.leaf),
                          cell(trip.contact)});
  }
  return table;
}

/// Work of all courses beside that of the reading taken, and what a reading gets wrong.
std::string why(std::size_t place, std::span<const CourseWork> courses) {
  const EnodeReading& reading = e_node_readings()[place];
  double least = 0;
  double most = 0;
  EarlierLevel boxes;
  std::size_t contact_frames = 0;
  bool any = false;
  for (const CourseWork& course : courses) {
    const EarlierLevel& level = at_level(course.levels, kEarlierLevel);
    add(boxes, level);
    contact_frames += course.contact_frames;
    const std::uint64_t base = course.work[0].whole.box_tests;
    const std::uint64_t own = work_of(reading, course.work[place], level).box_tests;
    const double percent = 100 * static_cast<double>(own) / static_cast<double>(base);
    least = any ? std::min(least, percent) : percent;
    most = any ? std::max(most, percent) : percent;
    any = true;
  }
  if (place == 0) {
    return "The other experiments take this reading, and those about E-Node set others beside it.";
  }
  std::string text =
      any ? fmt::format("By course, {:.3g} to {:.3g} % of the box tests of family_both.", least,
                        most)
          : std::string();
  if (reading.answer == EnodeAnswer::boxes_only) {
    text += fmt::format(
        " At level {} it calls {} frames touching, and in {} of them nothing touches; of its {} "
        "pairs {} hold no triangles that touch. It misses none.",
        kEarlierLevel, to_text(count_cell(boxes.called_frames)),
        to_text(count_cell(boxes.called_frames - contact_frames)), to_text(count_cell(boxes.pairs)),
        to_text(count_cell(boxes.pairs - boxes.touching_pairs)));
  }
  return text;
}

Table reasons_table(std::span<const CourseWork> courses) {
  Table table{
      .id = "readings_e_node_reasons",
      .caption =
          "What speaks for each reading of E-Node and against it, and how it "
          "stands: taken, open, against (something speaks against it, nothing "
          "excludes it), or excluded by words.",
      .columns = {{"reading"}, {"title"}, {"speaks_for"}, {"speaks_against"}, {"stands"}, {"why"}}};
  for (std::size_t i = 0; i < e_node_readings().size(); ++i) {
    const EnodeReading& reading = e_node_readings()[i];
    table.rows.push_back({word_cell(reading.name), word_cell(reading.title),
                          word_cell(reading.speaks_for), word_cell(reading.speaks_against),
                          word_cell(reading.stands), why(i, courses)});
  }
  return table;
}

bool is_four_sides(std::string_view subject) {
  return subject.ends_with("four sides");
}

/// Courses that fit in a picture: every object from four sides, and the drives of the first.
std::vector<const CourseWork*> pictured(std::span<const CourseWork> courses) {
  std::vector<const CourseWork*> chosen;
  for (const CourseWork& course : courses) {
    if (is_four_sides(course.subject) || course.model == courses.front().model) {
      chosen.push_back(&course);
    }
  }
  return chosen;
}

Figure work_figure(std::span<const CourseWork> courses) {
  std::vector<Datum> data;
  for (const CourseWork* const course : pictured(courses)) {
    const EarlierLevel& level = at_level(course->levels, kEarlierLevel);
    const auto base = static_cast<double>(course->work[0].whole.box_tests);
    for (std::size_t i = 1; i < e_node_readings().size(); ++i) {
      const EnodeReading& reading = e_node_readings()[i];
      if (reading.chain) {
        continue;  // the box tests of the reading taken, always, and one color more than there are
      }
      const EnodeWork own = work_of(reading, course->work[i], level);
      data.push_back({course->subject, std::string(reading.name),
                      100 * static_cast<double>(own.box_tests) / base});
    }
  }
  return {
      .id = "readings_e_node",
      .caption = fmt::format(
          "Box tests that each reading of E-Node makes for its answer, of "
          "those of the reading taken (family_both). first_leaves and "
          "first_contact stop there; boxes_only ends at level {}. chain makes the tests "
          "of family_both.",
          kEarlierLevel),
      .svg = draw(grouped_bars("Box tests of other readings of E-Node", "% of family_both", data))};
}

Figure levels_figure(std::span<const CourseWork> courses) {
  LineChart chart{.title = "Boxes alone: pairs called touching that do not touch",
                  .x_label = "level",
                  .y_label = "% of the pairs called touching"};
  for (const CourseWork* const course : pictured(courses)) {
    // As many as there are colors; golden drives touch in few frames or none.
    if (!is_four_sides(course->subject) && course->subject.find("touching") == std::string::npos) {
      continue;
    }
    Line line{.name = course->subject};
    for (const int level : kShownLevels) {
      const EarlierLevel& found = at_level(course->levels, level);
      if (found.pairs > 0) {
        const std::uint64_t wrong = found.pairs - found.touching_pairs;
        line.x.push_back(level);
        line.y.push_back(100 * static_cast<double>(wrong) / static_cast<double>(found.pairs));
      }
    }
    if (!line.x.empty()) {
      chart.lines.push_back(std::move(line));
    }
  }
  return {.id = "readings_e_node_levels",
          .caption =
              "Pairs of nodes whose boxes overlap but whose triangles do not touch, of all "
              "such pairs, by the level at which the trees are cut. At the last level the "
              "nodes are leaves.",
          .svg = draw(chart)};
}

}  // namespace

Result readings_e_node(const Context& context) {
  const BuildPairing soms =
      pairing(thesis_rules(kSceneLevel), thesis_rules(kObjectLevel), kEnodeRule);
  std::vector<RideCourse> courses = thesis_courses(context);
  if (context.quick) {
    const std::string first_model = courses.empty() ? std::string() : courses.front().model;
    std::erase_if(courses, [&](const RideCourse& course) {
      return course.model != first_model && !is_four_sides(course.subject);
    });
  }
  Steps steps(context.limits, courses.size());
  std::vector<CourseWork> works;
  std::vector<FirstFrames> first;
  for (const RideCourse& course : courses) {
    works.push_back({course.model, course.subject});
    for (const auto& trip : course.trips) {
      run_trip(trip(soms), works.back(), first, steps.quiet());
    }
    steps.done_one();
  }
  Result result{.tables = {reasons_table(works), counts_table(works), levels_table(works),
                           first_frames_table(first)},
                .remarks = object_remarks(context.models.objects)};
  const std::vector<std::string> scenes = scene_remarks(context.models.scenes);
  result.remarks.insert(result.remarks.end(), scenes.begin(), scenes.end());
  if (context.quick && context.models.objects.size() > 1) {
    result.remarks.push_back(
        fmt::format("Quick run: drives of {} alone.", context.models.objects.front().name));
  }
  if (!works.empty()) {
    result.figures = {work_figure(works), levels_figure(works)};
  }
  return result;
}

}  // namespace soms::reproduce
