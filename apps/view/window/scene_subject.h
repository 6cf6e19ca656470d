/// \file
/// A scene as the controls see it.
#pragma once

#include "apps/view/control/subject.h"
#include "apps/view/scene/counted_step.h"
#include "apps/view/scene/event_finder.h"
#include "apps/view/scene/fast_lesson.h"
#include "apps/view/scene/lesson.h"
#include "apps/view/scene/scene_content.h"
#include "apps/view/scene/view_options.h"
#include "apps/view/scene/view_scene.h"
#include "apps/view/sight/dense_place.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace soms::view {

/// Brings the words of `Subject` to a `ViewScene`. The object that is moved by hand is the second
/// body of the scene's pair; picking a mover makes it that.
class SceneSubject final : public Subject {
 public:
  explicit SceneSubject(SceneContent content, const Limits& limits = {});

  /// As `ViewScene::set_gap_patience`.
  void set_gap_patience(GapStore::Patience patience);

  /// Meters of a unit, for the scale and the length of the gap; 0: not known.
  void set_meters(double meters) { meters_ = meters; }

  /// As `StepCounter::set_patience`.
  void set_step_patience(std::chrono::steady_clock::duration patience);

  void choose(const ViewState& state) override;
  [[nodiscard]] Facts facts(const ViewState& state) const override;
  void advance(int count) override;
  void seek(std::uint64_t frame) override;
  void restart() override;
  void place_object(const Pose& pose) override;
  void object_home() override;
  [[nodiscard]] std::optional<PickedFacts> pick(const Ray& ray) override;
  void select() override;
  [[nodiscard]] std::optional<PickedFacts> selection() const override;
  void deselect() override;

  [[nodiscard]] const EventList& events() const override { return events_; }

  void search_events() override;
  [[nodiscard]] Sight show_event(std::size_t row, const FitCamera& fit) override;
  void open(const std::string& path) override;
  [[nodiscard]] DrawList draw_list(const ViewState& state) override;

 private:
  /// What a click chose: a triangle, and with it or alone a contact.
  struct Chosen {
    BodyRef body;
    TriangleId triangle = 0;
    std::optional<Touch> touch;
  };

  [[nodiscard]] PickedFacts triangle_facts(const Picked& picked) const;
  [[nodiscard]] std::string gap_in_text(const Gap& gap) const;
  [[nodiscard]] PickedFacts contact_facts(const Touch& touch) const;
  [[nodiscard]] std::optional<GapFacts> gap_facts() const;
  void add_costs(Facts& facts) const;
  [[nodiscard]] std::optional<std::uint32_t> object() const;
  [[nodiscard]] std::optional<BodyRef> tree_body(TreeOf tree) const;
  [[nodiscard]] int levels_of(TreeOf tree) const;
  [[nodiscard]] bool moves() const;
  void list_events();
  [[nodiscard]] Sight show_passage(const FoundPassage& passage, const FitCamera& fit);
  [[nodiscard]] Sight aimed_at(const Touch& touch, std::uint32_t part, const FitCamera& fit);
  void place_at_moment(BodyRef body, const Pose& before, const FoundPassage& passage);
  void leave_moment();
  void let_go();
  void prepare_lesson(const ViewState& state);
  void prepare_fast_lesson(const ViewState& state);
  void add_lesson(DrawList& list);
  void add_fast_lesson(DrawList& list) const;
  [[nodiscard]] ViewLimits limits() const;
  [[nodiscard]] const SceneStatistics& statistics() const;

  /// True while the contact still is one.
  [[nodiscard]] bool touching(const std::optional<Touch>& touch) const;

  void changed() { statistics_.reset(); }

  void start_test(const std::optional<std::size_t>& row);

  std::vector<bool> has_motion_;  ///< of each mover
  Limits limits_;
  EventFinder finder_;
  EventList events_;
  ViewScene scene_;
  Lesson lesson_;
  FastLesson fast_lesson_;                  ///< of Traversal::fast
  std::optional<LearnFacts> lesson_facts_;  ///< of the last choice or picture
  std::optional<std::size_t> test_;
  bool through_ = false;                  ///< contacts are seen, and picked, through everything
  bool movers_shown_ = true;              ///< else they are not picked
  std::optional<int> single_levels_;      ///< of the city's tree, where there is no pair
  std::vector<std::string> left_out_;     ///< of the last picture
  std::optional<DensePlace> place_;       ///< at the beginning, of a sparse scene
  std::optional<Chosen> seen_;            ///< by the last `pick`
  std::optional<Chosen> selected_;        ///< drawn brighter
  std::optional<Box> focus_;              ///< of an event, while its contact is selected
  std::map<std::uint32_t, Pose> home_;    ///< where movers were that the hand moved
  std::vector<std::uint32_t> at_moment_;  ///< movers that stand between two frames, at a passage
  double meters_ = 0;                     ///< of a unit
  mutable StepCounter counter_;           ///< of named traversals
  mutable std::optional<SceneStatistics> statistics_;  ///< counts whole trees: kept till a change
};

/// What the controls' choices mean for a picture of the scene.
[[nodiscard]] ViewOptions options_of(const ViewState& state);

/// The trees and the traversal of the controls' choices.
[[nodiscard]] TreeChoice trees_of(const ViewState& state);

}  // namespace soms::view
