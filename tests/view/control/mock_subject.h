/// \file
/// A thing to show that is not there: a box-like city, one object, 100 frames. It remembers what it
/// was queried.
#pragma once

#include "soms/base/error.h"

#include "apps/view/control/subject.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::view {

/// The city fills [-100, 100] x [-100, 100] x [0, 50], the object is a cube of side 4 about its
/// pose. A ray that looks down meets the ground z = 0.
class MockSubject final : public Subject {
 public:
  void choose(const ViewState& state) override {
    ++chosen;
    last_choice = choice(state);
  }

  [[nodiscard]] Facts facts(const ViewState& state) const override {
    Facts facts;
    facts.name = "mock city";
    facts.note = note;
    facts.left_out = left_out;
    facts.triangles = 1'234'567;
    facts.movers = 3;
    facts.frame = frame;
    facts.contacts = 42;
    facts.clearance = clearance;
    facts.gaps = 7;
    facts.least_gap = least_gap;
    facts.orientation_test = last_choice.orientation_test;
    facts.traversed = true;
    facts.gap = gap;
    if (state.learn && learn_tests > 0) {
      facts.learn.emplace();
      facts.learn->tests = learn_tests;
      facts.learn->test = std::min(state.learn_step, learn_tests - 1);
      facts.learn->sentences = {"Their boxes overlap."};
      facts.learn->a = {"city", {}, {{0, 1, 0, TreeBars::Look::now}}, 1};
      facts.learn->b = {"car", {}, {{0, 1, 0, TreeBars::Look::visited}}, 1};
    }
    facts.limits = {7, 5, frames, 3, moves, can_seek, has_object, 4, 200};
    facts.bounds = {{-100, -100, 0}, {100, 100, 50}};
    if (has_object) {
      facts.object = object;
      const Vec3 at = object.shift();
      facts.object_bounds = {at - Vec3{2, 2, 2}, at + Vec3{2, 2, 2}};
    }
    const Vec3 at{static_cast<double>(frame), 10.0 * static_cast<double>(state.followed), 1};
    facts.followed = Pose::translation(at.x, at.y, at.z);
    facts.followed_bounds = {at - Vec3{2, 1, 1}, at + Vec3{2, 1, 1}};
    return facts;
  }

  void advance(int count) override {
    advanced += count;
    const auto next = static_cast<std::int64_t>(frame) + count;
    frame = static_cast<std::uint64_t>(std::max<std::int64_t>(next, 0));
  }

  void seek(std::uint64_t to) override { frame = to; }

  void restart() override {
    frame = 0;
    ++restarts;
  }

  void place_object(const Pose& pose) override {
    object = pose;
    last_choice.orientation_test.reset();
    ++placed;
  }

  void object_home() override { object = Pose::translation(0, 0, 10); }

  [[nodiscard]] std::optional<PickedFacts> pick(const Ray& ray) override {
    if (refuse_to_pick) {
      throw Error(ErrorKind::out_of_range, "a ray beyond 2^300", "come nearer");
    }
    if (ray.direction.z > -1e-3) {
      return std::nullopt;
    }
    const Vec3 at = ray.origin + ray.direction * (-ray.origin.z / ray.direction.z);
    if (std::max(std::abs(at.x), std::abs(at.y)) > 100) {
      return std::nullopt;
    }
    PickedFacts picked;
    picked.title = "triangle 4711 of mock city";
    picked.numbers = {{"part", "ground"}, {"vertices", "1, 2, 3"}};
    picked.why = {"Its plane is crossed by two edges of the other."};
    picked.point = at;
    picked.bounds = {at - Vec3{1, 1, 0}, at + Vec3{1, 1, 0}};
    last_pick = picked.title;
    return picked;
  }

  void select() override { selected = last_pick; }

  [[nodiscard]] std::optional<PickedFacts> selection() const override {
    if (frame > touch_until) {
      return std::nullopt;
    }
    PickedFacts facts;
    facts.title = "in frame " + std::to_string(frame);
    return facts;
  }

  void deselect() override { selected.clear(); }

  [[nodiscard]] const EventList& events() const override { return found; }

  void search_events() override {
    ++searches;
    found.searched = std::min(found.searched + 10, found.frames);
    if (found.searched == found.frames || rows_at_once) {
      found.rows = rows;
    }
  }

  [[nodiscard]] Sight show_event(std::size_t row, const FitCamera& fit) override {
    frame = found.rows.at(row).most_frame;
    Sight sight;
    sight.facts.title = found.rows.at(row).title;
    sight.camera = fit({{10, 10, 0}, {14, 14, 4}}, {0, -1, 1});
    return sight;
  }

  void open(const std::string& path) override {
    if (path == "broken.ply") {
      throw Error(ErrorKind::bad_file, "broken.ply, line 3: no vertices", "repair the file");
    }
    opened.push_back(path);
  }

  [[nodiscard]] DrawList draw_list(const ViewState&) override {
    ++lists;
    if (refuse_to_draw) {
      throw Error(ErrorKind::usage, "no front without pruning", "switch pruning on");
    }
    DrawList list;
    list.lines.push_back({{0, 0, 0}, {1, 0, 0}});
    return list;
  }

  std::uint64_t frame = 0;
  std::uint64_t frames = 100;
  bool moves = true;
  bool can_seek = true;
  bool has_object = true;
  Pose object = Pose::translation(0, 0, 10);
  std::string note;
  std::string clearance;  ///< empty: no gaps
  std::string least_gap;
  std::vector<std::string> left_out;
  EventList found{{}, 0, 0, 20};
  std::vector<ContactEvent> rows{{"car (mover 1) touches house", 3, 9, 12, 5},
                                 {"person (mover 2) touches tree", 7, 7, 1, 7}};
  bool rows_at_once = false;  ///< else when all is searched
  int searches = 0;
  std::uint64_t learn_tests = 12;
  std::optional<GapFacts> gap;

  int chosen = 0;
  Choice last_choice;
  int advanced = 0;
  int restarts = 0;
  int placed = 0;
  int lists = 0;
  bool refuse_to_draw = false;
  bool refuse_to_pick = false;
  std::uint64_t touch_until = 1'000'000;  ///< the last frame in which what is selected is there
  std::string last_pick;
  std::string selected;
  std::vector<std::string> opened;
};

}  // namespace soms::view
