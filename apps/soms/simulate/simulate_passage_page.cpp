#include "apps/soms/simulate/simulate_passage_page.h"

#include "soms/scene/passages.h"

#include "apps/soms/simulate/simulate_rows.h"

#include <algorithm>
#include <array>
#include <utility>

namespace soms::command {

namespace {

/// A passage as a row of its own: where the two are at its moment, and the triangles that meet.
void add_passage(report::Scene& scene, const World& world, const PassageEvent& event) {
  const EnvironmentPassage& passage = event.passage;
  const double after = moment_of(passage.t);
  const std::uint64_t before = event.frame - 1;
  const auto there = [&](MoverId mover) {
    const MoverRoute& route = world.routes[mover];
    return way_of_step(world.models[route.model].shape, route.at(before), route.at(event.frame))
        .pose_at(after);
  };
  const std::uint32_t a = body_of(world, passage.mover);
  const std::uint32_t b = event.between_movers() ? body_of(world, event.other) : passage.part;
  report::SceneRow row{.a = a,
                       .b = b,
                       .count = 1,
                       .steps = 1,
                       .begin = before,
                       .end = before,
                       .first = {passage.i, passage.j},
                       .box = {passage.point, passage.point},
                       .place = passage.point,
                       .meeting = passage.verdict == ContactVerdict::contact
                                      ? report::Meeting::passage
                                      : report::Meeting::may_be_passage,
                       .after = after};
  scene.contacts.push_back(
      {.row = scene.rows.size(),
       .a = a,
       .b = b,
       .begin = before,
       .end = before,
       .pairs = {row.first},
       .pairs_in_all = 1,
       .poses = std::array{there(passage.mover),
                           event.between_movers() ? there(event.other) : world.city[b].pose}});
  scene.rows.push_back(std::move(row));
}

}  // namespace

void add_passages(report::Scene& scene, const World& world, const Outcome& outcome) {
  const std::size_t events = scene.rows.size();
  for (const PassageEvent& event : outcome.passages.events()) {
    if (event.unseen) {
      add_passage(scene, world, event);
    }
  }
  const std::size_t added = scene.rows.size() - events;
  if (added == 0) {
    return;
  }
  std::stable_sort(scene.contacts.begin(), scene.contacts.end(),
                   [](const auto& x, const auto& y) { return x.begin < y.begin; });
  scene.contacts_in_all += added;
  scene.row = {"event or passage", "events and passages"};
  scene.contact = {"contact or passage", "contacts and passages"};
}

}  // namespace soms::command
