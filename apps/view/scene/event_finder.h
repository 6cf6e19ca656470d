/// \file
/// Finds who touches whom over time, apart from what is shown: as if no hand moved anything.
#pragma once

#include "soms/base/parallel.h"
#include "soms/scene/contact_spans.h"

#include "apps/view/scene/scene_content.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace soms::view {

/// A passage of a recording that none of its frames shows (soms/scene/passages.h).
struct FoundPassage {
  ContactSide a = {};  ///< a mover
  ContactSide b = {};
  std::uint64_t before = 0;  ///< the frame in which the way begins; it ends in the next
  TrianglePair pair = {};
  ContactVerdict verdict = ContactVerdict::contact;
  Bracket t = {};   ///< of the first contact, in parts of the way
  Vec3 point = {};  ///< where that is
};

/// A row of the list of events: a span, or a passage.
struct FoundEvent {
  bool is_passage = false;
  std::size_t index = 0;  ///< in `EventFinder::spans` or `EventFinder::passages`
};

/// Frames in which contacts are searched for: of a recording all, else those that `simulate` would
/// run; one where nothing moves.
[[nodiscard]] std::uint64_t frames_to_search(const SceneContent& content);

/// Steps through the frames of a content once, from the first, and gathers contacts in spans. What
/// a step finds is what `soms simulate` finds in that frame; of a recording, what it holds.
/// \threads One caller at a time; uses the threads of `Limits`.
class EventFinder {
 public:
  explicit EventFinder(SceneContent content, const Limits& limits = {});
  ~EventFinder();
  EventFinder(EventFinder&&) noexcept;
  EventFinder& operator=(EventFinder&&) noexcept;

  /// Adds a body that stands still, as the viewer does: the first one is the city, others are
  /// movers. The search starts over.
  void add(Body body);

  /// Frames that there are to search: of a recording all, else those that `simulate` would run; one
  /// where nothing moves.
  [[nodiscard]] std::uint64_t frames() const;

  /// Frames searched.
  [[nodiscard]] std::uint64_t searched() const;

  /// Searches frames until `milliseconds` are over, one at least if any is left.
  /// \errors As `Scene::step` and `Replay::frame`.
  void search(double milliseconds);

  /// Spans of the frames searched: of whole movers, and of the parts of the city's meshes.
  [[nodiscard]] const std::vector<ContactSpan>& spans() const;

  /// Passages of the frames searched.
  [[nodiscard]] const std::vector<FoundPassage>& passages() const;

  /// Spans and passages in order of time. Grows at its end.
  [[nodiscard]] const std::vector<FoundEvent>& events() const;

  /// "car (mover 12) passed through house 5 of town"
  [[nodiscard]] std::string title(const FoundPassage& passage) const;

  /// The two of a span in words: "car (mover 12) touches house 5 of town".
  [[nodiscard]] std::string title(const ContactSpan& span) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace soms::view
