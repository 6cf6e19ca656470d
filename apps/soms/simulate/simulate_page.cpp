#include "apps/soms/simulate/simulate_page.h"

#include "soms/query/overlap.h"

#include "apps/cli/text.h"
#include "apps/draw/chart.h"
#include "apps/report/page.h"
#include "apps/report/scene_words.h"
#include "apps/soms/answers/page_plots.h"
#include "apps/soms/simulate/simulate_near_report.h"
#include "apps/soms/simulate/simulate_passage_page.h"
#include "apps/soms/simulate/simulate_report.h"
#include "apps/soms/simulate/simulate_rows.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

Body mover_at(const World& world, MoverId mover, std::uint64_t frame) {
  return Body(world.models[world.routes[mover].model].shape, world.routes[mover].at(frame));
}

/// Pairs of triangles of a contact in its first frame, queried again: a log of all would be long.
std::vector<TrianglePair> pairs_of(const World& world, const Contact& contact) {
  const Body mover = mover_at(world, contact.mover, contact.begin);
  if (contact.part == Contact::kMover) {
    return overlap(mover, mover_at(world, contact.other, contact.begin)).pairs;
  }
  const Triangle t = world.city[contact.part].shape.mesh().triangle(contact.other);
  Mesh one;
  one.vertices = {t.a, t.b, t.c};
  one.triangles = {{0, 1, 2}};
  std::vector<TrianglePair> pairs = overlap(mover, Body(std::move(one))).pairs;
  for (TrianglePair& pair : pairs) {
    pair.b = contact.other;
  }
  return pairs;
}

/// The parts of movers that a page names, each once.
class MoverParts {
 public:
  MoverParts(const World& world, std::vector<report::ScenePart>& parts) : parts_(parts) {
    for (const Model& model : world.models) {
      parts_of_.emplace_back(model.shape.mesh());
    }
  }

  std::uint32_t number(const World& world, MoverId mover, TriangleId triangle) {
    const std::size_t model = world.routes[mover].model;
    const std::uint32_t part = parts_of_[model](triangle);
    if (part == Part::kNoParent) {
      return report::kNoPart;
    }
    const auto [at, added] =
        numbers_.try_emplace({model, part}, static_cast<std::uint32_t>(parts_.size()));
    if (added) {
      const MeshView& mesh = world.models[model].shape.mesh();
      parts_.push_back({part_label(mesh, part), part_path_label(mesh, part, report::kLongestText)});
    }
    return at->second;
  }

 private:
  std::vector<report::ScenePart>& parts_;
  std::vector<PartsOf> parts_of_;  ///< of each model
  std::map<std::pair<std::size_t, std::uint32_t>, std::uint32_t> numbers_;
};

report::SceneContact contact_of(const World& world, const Contact& contact, std::size_t number,
                                const report::SceneRow& row, MoverParts& parts) {
  const bool between = contact.part == Contact::kMover;
  report::SceneContact shown{.row = number,
                             .a = row.a,
                             .b = row.b,
                             .part_b = row.part_b,
                             .begin = contact.begin,
                             .end = contact.end,
                             .pairs = pairs_of(world, contact)};
  shown.pairs_in_all = shown.pairs.size();
  if (!shown.pairs.empty()) {
    const auto& [i, j] = shown.pairs.front();
    shown.part_a = parts.number(world, contact.mover, i);
    shown.part_b = between ? parts.number(world, contact.other, j) : row.part_b;
  }
  shown.pairs.resize(std::min(shown.pairs.size(), report::SceneLimits().pairs_of_contact));
  shown.pairs.shrink_to_fit();  // of two movers there may be very many
  return shown;
}

void add_bodies(report::Scene& scene, const World& world) {
  for (const Body& body : world.city) {
    scene.bodies.push_back({.model = scene.models.size(), .name = body.name, .moves = false});
    const FileNumbers& numbers = world.numbers[scene.models.size()];
    scene.models.push_back({body.shape.mesh(), body.name, numbers.list()});
  }
  const std::size_t first = scene.models.size();
  for (const Model& model : world.models) {
    scene.models.push_back({model.shape.mesh(), model.name});
  }
  for (std::size_t k = 0; k < world.routes.size(); ++k) {
    const std::size_t model = world.routes[k].model;
    scene.bodies.push_back({.model = first + model,
                            .name = fmt::format("{} {}", world.models[model].name, k),
                            .moves = true});
  }
}

/// Every so many of the pairs of triangles of an event, `most` at most, in the frame that has the
/// most of them: queried again, as those of contacts.
std::vector<TrianglePair> pairs_of(const World& world, const CityParts& parts,
                                   const ContactSpan& event, std::uint64_t most) {
  const bool between = event.b.body.kind == SceneBodyKind::mover;
  const Body mover = mover_at(world, event.a.body.id, event.most_step);
  const Body other =
      between ? mover_at(world, event.b.body.id, event.most_step) : world.city[event.b.body.id];
  std::vector<TrianglePair> pairs;
  std::uint64_t seen = 0;
  for (const TrianglePair& pair : overlap(mover, other).pairs) {
    if (between || parts.number(event.b.body.id, pair.b) == event.b.part) {
      if (seen * most / event.most_pairs < (seen + 1) * most / event.most_pairs) {
        pairs.push_back(pair);
      }
      ++seen;
    }
  }
  return pairs;
}

/// The curves of the first events, each with a fair share of the room.
void add_curves(report::Scene& scene, const World& world, const Outcome& outcome) {
  const report::SceneLimits limits;
  const CityParts parts(world);
  const std::vector<ContactSpan>& events = outcome.events.spans();
  std::vector<std::uint64_t> wanted;
  for (std::size_t r = 0; r < std::min(events.size(), limits.contacts); ++r) {
    wanted.push_back(std::min<std::uint64_t>(events[r].most_pairs, limits.pairs_of_row));
  }
  const std::vector<std::uint64_t> shares = report::fair_shares(wanted, limits.lines);
  for (std::size_t r = 0; r < shares.size(); ++r) {
    scene.rows[r].pairs = pairs_of(world, parts, events[r], shares[r]);
  }
}

report::Scene scene_of(const World& world, const Outcome& outcome,
                       std::vector<std::size_t> event_of) {
  report::Scene scene;
  add_bodies(scene, world);
  const std::vector<Contact>& contacts = outcome.contacts.contacts();
  ContactRows gathered = rows_of(world, outcome, std::move(event_of));
  scene.parts = std::move(gathered.parts);
  MoverParts parts(world, scene.parts);
  for (const std::size_t k : fair_sample(gathered, contacts, report::SceneLimits().contacts)) {
    const std::size_t row = gathered.row_of[k];
    scene.contacts.push_back(contact_of(world, contacts[k], row, gathered.rows[row], parts));
  }
  scene.rows = std::move(gathered.rows);
  scene.row = {"event", "events"};
  add_curves(scene, world, outcome);
  scene.complete = outcome.ending == Ending::whole;
  scene.contacts_in_all = contacts.size();
  add_passages(scene, world, outcome);
  scene.steps = {.count = std::max<std::uint64_t>(1, outcome.frames),
                 .noun = "frame",
                 .a_second = kFramesASecond};
  scene.pose = [&world](std::uint32_t body, std::uint64_t frame) {
    return body < world.city.size() ? world.city[body].pose
                                    : world.routes[body - world.city.size()].at(frame);
  };
  return scene;
}

/// How many contacts last in each frame.
report::Plot contacts_by_frame(const Outcome& outcome) {
  std::vector<std::int64_t> with_city(outcome.frames + 1, 0);
  std::vector<std::int64_t> between = with_city;
  for (const Contact& contact : outcome.contacts.contacts()) {
    std::vector<std::int64_t>& changes = contact.part == Contact::kMover ? between : with_city;
    ++changes[contact.begin];
    --changes[contact.end + 1];
  }
  reproduce::LineChart chart{.title = "Contacts in each frame",
                             .x_label = "frame",
                             .y_label = "contacts",
                             .markers = false};
  std::size_t width = 1;
  for (const auto& [name, of_kind, color] :
       {std::tuple("with the city", &with_city, reproduce::kStillColor),
        std::tuple("between movers", &between, reproduce::kMovesColor)}) {
    std::vector<std::int64_t>& changes = *of_kind;
    for (std::size_t k = 1; k < changes.size(); ++k) {
      changes[k] += changes[k - 1];
    }
    Binned bins =
        binned(outcome.frames, [&](std::uint64_t k) { return static_cast<double>(changes[k]); });
    width = bins.width;
    chart.lines.push_back(
        {.name = name, .x = std::move(bins.x), .y = std::move(bins.most), .color = color});
  }
  return plot(reproduce::draw(chart),
              width == 1 ? "Contacts that last in each frame."
                         : fmt::format("Contacts that last: the most in {} frames.", width));
}

report::Plot time_by_frame(const Outcome& outcome) {
  Binned bins = binned(outcome.frames, [&](std::uint64_t k) {
    return 1000 * static_cast<double>(outcome.frame_seconds[k]);
  });
  reproduce::LineChart chart{.title = "Time of each frame",
                             .x_label = "frame",
                             .y_label = "milliseconds",
                             .markers = false};
  if (bins.width > 1) {
    chart.lines.push_back({.name = "mean", .x = bins.x, .y = std::move(bins.mean)});
  }
  chart.lines.push_back({.name = bins.width > 1 ? "slowest" : "frame",
                         .x = std::move(bins.x),
                         .y = std::move(bins.most)});
  return plot(reproduce::draw(chart),
              fmt::format("Poses, broad phase, narrow phase and report{}. Times differ from run to "
                          "run.",
                          bins.width == 1 ? "" : fmt::format(", of {} frames each", bins.width)));
}

std::vector<report::Plot> plots_of(const World& world, const Outcome& outcome) {
  std::vector<report::Plot> plots;
  if (outcome.frames > 1) {
    plots.push_back(contacts_by_frame(outcome));
    plots.push_back(time_by_frame(outcome));
  }
  const CityParts names(world);
  std::map<std::string, double> parts;
  std::map<std::string, double> models;
  const auto count_model = [&](MoverId mover) {
    ++models[world.models[world.routes[mover].model].name];
  };
  for (const Contact& contact : outcome.contacts.contacts()) {
    count_model(contact.mover);
    if (contact.part == Contact::kMover) {
      count_model(contact.other);
    } else {
      ++parts[names.name(contact.part, contact.other)];
    }
  }
  for (const auto& [counts, title, caption, color] :
       {std::tuple(&parts, "Parts of the city by contacts",
                   "The parts with the most contacts; a contact is a mover and a triangle.",
                   reproduce::kStillColor),
        std::tuple(&models, "Models by contacts",
                   "Contacts by moving model; a contact of two movers counts for each of them.",
                   reproduce::kMovesColor)}) {
    for (report::Plot& bars :
         bars_of({counts->begin(), counts->end()}, title, "contacts", caption, color)) {
      plots.push_back(std::move(bars));
    }
  }
  return plots;
}

/// What touches what, in a sentence; the worst event first.
std::string lead_of(const World& world, const Outcome& outcome, const report::Scene& scene) {
  const std::string tested = fmt::format(
      "{} in {} ({:.4g} s)", counted(world.routes.size(), "mover"),
      counted(outcome.frames, "frame"), static_cast<double>(outcome.frames) / kFramesASecond);
  const std::optional<std::size_t> worst = report::worst_row(scene);
  if (!worst) {
    return fmt::format("Nothing touches: {}.", tested);
  }
  const report::SceneRow& row = scene.rows[*worst];
  if (row.meeting != report::Meeting::touch) {  // there is nothing else
    return fmt::format("{} between two frames: {} in all, among {}.",
                       report::who_touches(scene, row), counted(scene.rows.size(), "passage"),
                       tested);
  }
  return fmt::format("{} most: {} of triangles in frame {}. In all {} by {} of {}.",
                     report::who_touches(scene, row), counted(row.most_pairs, "pair"),
                     with_commas(row.most_step), counted(scene.rows.size(), "event"),
                     with_commas(outcome.contacts.movers()), tested);
}

}  // namespace

void write_page(std::ostream& out, const World& world, const Outcome& outcome,
                std::vector<std::size_t> event_of, const SimulateOptions& options) {
  report::Page page{
      .title = fmt::format("{} and {}", world.title, counted(world.routes.size(), "mover")),
      .lead = {},
      .facts = {},
      .plots = {},
      .notes = {}};
  for (const auto& [name, value] : figures_of(world, outcome, options)) {
    if (name.empty()) {
      page.facts.back().value += "; " + value;
    } else {
      page.facts.push_back({name, value});
    }
  }
  for (const std::string& note : world.notes) {
    page.facts.push_back({"note", note});
  }
  for (const FrameWarning& warning : world.warnings) {
    page.warnings.push_back(warning.text());
  }
  if (outcome.ending != Ending::whole) {
    page.notes.emplace_back("This run ended early; the page shows the frames that were done.");
  }
  page.notes.emplace_back(
      "An event is one mover and one part of the city, or two movers, over consecutive frames in "
      "which they touch. Its contacts are the triangles of the city that the mover touches, each "
      "with its own first and last frame. Only surfaces are tested: a mover entirely inside a "
      "closed building touches nothing. The picture may be simplified; the answers never are.");
  if (options.swept) {
    page.notes.emplace_back(
        "A passage is what a mover touches between two frames, in neither of them. It is proved "
        "for "
        "every moment of the way. \"frame 12 + 0.41\" is the part 0.41 of the way from frame 12 to "
        "the next one, and the view shows the mover there.");
  }
  page.plots = plots_of(world, outcome);
  page.scene = scene_of(world, outcome, std::move(event_of));
  page.lead = lead_of(world, outcome, page.scene);
  if (options.clearance > 0) {
    add_near(page, world, outcome, options);
  }
  report::write_page(out, page);
}

}  // namespace soms::command
