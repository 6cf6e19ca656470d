#include "apps/view/scene/event_finder.h"

#include "soms/geometry/parts_of.h"
#include "soms/scene/passages.h"
#include "soms/scene/scene.h"

#include "apps/view/scene/frame_report.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace soms::view {

/// The scene is made when the search begins: a window where nothing moves never searches.
struct EventFinder::State {
  SceneContent content;
  Limits limits;
  std::optional<Scene> scene;
  std::vector<PartsOf> parts;  ///< of each body of the city
  ContactSpans spans;
  std::vector<FoundPassage> passages;
  std::vector<FoundEvent> events;
  std::uint64_t searched = 0;

  void start_over() {
    scene.reset();
    parts.clear();
    spans = {};
    passages.clear();
    events.clear();
    searched = 0;
  }

  void make_scene() {
    scene.emplace();
    for (const Body& body : content.city) {
      scene->add_environment(body);
      parts.emplace_back(body.shape.mesh());
    }
    for (const MovingBody& mover : content.movers) {
      scene->add_mover(mover.body);
    }
  }

  [[nodiscard]] Replay* recording() const { return content.recording.get(); }

  /// The bodies are those that were recorded.
  [[nodiscard]] bool as_recorded() const {
    return recording() != nullptr && recording()->frames() > 0 &&
           recording()->head().environment.size() == content.city.size() &&
           recording()->head().movers.size() == content.movers.size();
  }

  void place_movers() {
    for (std::uint32_t k = 0; k < content.movers.size(); ++k) {
      const Motion& motion = content.movers[k].motion;
      if (const Pose* const recorded = recorded_pose(recording(), searched, k)) {
        scene->set_pose(k, *recorded);
      } else if (motion) {
        scene->set_pose(k, motion(searched));
      }
    }
  }

  void search_frame() {
    if (!scene) {
      make_scene();
    }
    place_movers();
    const StepReport report =
        as_recorded() ? report_of(recording()->frame(searched)) : scene->step({}, limits);
    ContactBodies bodies = contact_bodies(*scene);
    bodies.part = [this](const SceneBody& body, TriangleId triangle) {
      return body.kind == SceneBodyKind::environment ? parts[body.id](triangle) : Part::kNoParent;
    };
    if (as_recorded()) {
      add_passages(report);
    }
    const std::size_t known = spans.spans().size();
    spans.follow(searched, report, bodies);
    for (std::size_t k = known; k < spans.spans().size(); ++k) {
      events.push_back({.is_passage = false, .index = k});
    }
    ++searched;
  }

  [[nodiscard]] static ContactSide mover_side(MoverId mover) {
    return {{SceneBodyKind::mover, mover}, Part::kNoParent};
  }

  void add(const ContactSide& b, const EnvironmentPassage& passage) {
    events.push_back({.is_passage = true, .index = passages.size()});
    passages.push_back({.a = mover_side(passage.mover),
                        .b = b,
                        .before = searched - 1,
                        .pair = {passage.i, passage.j},
                        .verdict = passage.verdict,
                        .t = passage.t,
                        .point = passage.point});
  }

  /// Those that no frame shows. No way leads to the first frame.
  void add_passages(const StepReport& report) {
    if (searched == 0) {
      return;
    }
    for (const EnvironmentPassage& passage : report.environment_passages) {
      if (is_between_steps(passage, report.environment)) {
        add({{SceneBodyKind::environment, passage.part}, parts[passage.part](passage.j)}, passage);
      }
    }
    for (const MoverPassage& passage : report.mover_passages) {
      if (is_between_steps(passage, report.movers)) {
        add(mover_side(passage.b),
            {passage.a, 0, passage.i, passage.j, passage.verdict, passage.t, passage.point});
      }
    }
  }

  [[nodiscard]] std::string name_of(const ContactSide& side) const {
    if (side.body.kind == SceneBodyKind::mover) {
      return fmt::format("{} (mover {})", content.movers[side.body.id].body.name, side.body.id);
    }
    const Body& body = content.city[side.body.id];
    return side.part == Part::kNoParent
               ? body.name
               : command::part_in_text(body.shape.mesh(), side.part) + " of " + body.name;
  }
};

std::uint64_t frames_to_search(const SceneContent& content) {
  if (content.recording != nullptr && content.recording->frames() > 0) {
    return content.recording->frames();
  }
  const bool moves = std::any_of(content.movers.begin(), content.movers.end(),
                                 [](const MovingBody& m) { return bool(m.motion); });
  return moves ? content.frames : 1;
}

EventFinder::EventFinder(SceneContent content, const Limits& limits)
    : state_(std::make_unique<State>()) {
  state_->content = std::move(content);
  state_->limits.threads = limits.threads;
  state_->limits.stop = limits.stop;
}

EventFinder::~EventFinder() = default;
EventFinder::EventFinder(EventFinder&&) noexcept = default;
EventFinder& EventFinder::operator=(EventFinder&&) noexcept = default;

void EventFinder::add(Body body) {
  SceneContent& content = state_->content;
  if (content.city.empty() && content.movers.empty()) {
    content.city.push_back(std::move(body));
  } else {
    content.movers.push_back({std::move(body), {}});
  }
  state_->start_over();
}

std::uint64_t EventFinder::frames() const {
  return frames_to_search(state_->content);
}

std::uint64_t EventFinder::searched() const {
  return state_->searched;
}

void EventFinder::search(double milliseconds) {
  const auto begin = std::chrono::steady_clock::now();
  const std::chrono::duration<double, std::milli> patience(milliseconds);
  while (state_->searched < frames()) {
    state_->search_frame();
    if (std::chrono::steady_clock::now() - begin >= patience) {
      return;
    }
  }
}

const std::vector<ContactSpan>& EventFinder::spans() const {
  return state_->spans.spans();
}

const std::vector<FoundPassage>& EventFinder::passages() const {
  return state_->passages;
}

const std::vector<FoundEvent>& EventFinder::events() const {
  return state_->events;
}

std::string EventFinder::title(const FoundPassage& passage) const {
  return state_->name_of(passage.a) +
         (passage.verdict == ContactVerdict::contact ? " passed through "
                                                     : " may have passed through ") +
         state_->name_of(passage.b);
}

std::string EventFinder::title(const ContactSpan& span) const {
  return state_->name_of(span.a) + " touches " + state_->name_of(span.b);
}

}  // namespace soms::view
