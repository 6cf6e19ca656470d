/// \file
/// What a simulation tells of who came near whom: for people, for programs, and as rows.
#pragma once

#include "apps/output/json.h"
#include "apps/report/page.h"
#include "apps/soms/simulate/simulate.h"
#include "apps/soms/simulate/simulate_report.h"
#include "apps/soms/simulate/simulate_run.h"
#include "apps/world/world.h"

#include <ostream>
#include <string>
#include <string_view>

namespace soms::command {

/// Columns of the events that follow those of a contact, where there is a clearance.
inline constexpr std::string_view kNearColumns =
    ",lower,upper,nearest,mover_triangle,triangle,ax,ay,az,bx,by,bz";

/// Their fields in the row of a contact.
inline constexpr std::string_view kNearFieldsOfContact = ",,,,,,,,,,,";

/// "0.0123 m": what people compare; programs get all digits.
[[nodiscard]] std::string meters_in_text(double meters);

/// Lines on how many came within the clearance, and on the nearest of them.
void add_near_figures(Figures& figures, const World& world, const Outcome& outcome,
                      const SimulateOptions& options);

/// What brute force said to gaps.
[[nodiscard]] std::string gaps_verified(const VerifiedGaps& verified);

/// The figures as members of the answer.
void add_near_json(Json& json, const World& world, const Outcome& outcome,
                   const SimulateOptions& options);

/// A mover and what it comes to: triangle `j` of a body of the city, or mover `other`, as of
/// NearEvent.
struct NamedBodies {
  MoverId mover = 0;
  EnvironmentId part = 0;
  MoverId other = 0;
  TriangleId j = 0;
};

/// What JSON says of them: mover, model, and other_mover, other_model or city, part.
[[nodiscard]] Json bodies_json(const World& world, const NamedBodies& bodies);

[[nodiscard]] Json point_json(const Vec3& point);

/// The fields mover, model, touched and part of an event.
void write_bodies(std::ostream& out, const World& world, const CityParts& parts,
                  const NamedBodies& bodies);

/// Rows of events, after those of contacts; `nearest` is the frame of the least distance, and
/// there are no points where the two touch in it. `behind` are the fields of further columns.
void write_near_events(std::ostream& out, const World& world, const Outcome& outcome,
                       std::string_view behind);

/// Adds to a page the events without a touch, the nearest first, as many as it has room for: as a
/// table, and as gaps of the scene. \pre `page.scene.bodies` are those of the city, then the
/// movers.
void add_near(report::Page& page, const World& world, const Outcome& outcome,
              const SimulateOptions& options);

}  // namespace soms::command
