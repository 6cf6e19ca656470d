// The balanced level of SOMS on the urban scene is 7 (figure 5.5 by its caption).
//
// The thesis does not define the balanced level. Here it is the greatest level of which every node
// exists and holds a triangle. The root is level 1 and SOMS takes its axis from the inner box; the
// root as level 0 and the outer axis are shown beside it. What becomes of a node that cannot be
// divided has no part in it but through `next_axis`. The claim is about one scene: on others no row
// is judged.
#include "soms/tree/option_names.h"

#include "thesis/claims/thesis_claims.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/counts.h"
#include "thesis/trees/open_options.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr std::array kRootLevels{1, 0};

std::vector<ClaimRow> rows_of(std::span<const Model> scenes, const Limits& limits) {
  std::vector<ClaimRow> rows;
  for (const int root : kRootLevels) {
    for (const AxisFrom axis : kSomsAxes) {
      for (const Model& scene : scenes) {
        const auto level = static_cast<double>(
            counts_of(*scene.mesh, Rule::soms, kSceneLevel, {.soms_axis = axis}, limits)
                .balanced_level);
        rows.push_back(on_model(
            counted_row(fmt::format("{} axis, the root is level {}{}", name(axis), root,
                                    root == 1 ? "" : " (ours)"),
                        "balanced level (complete and filled, ours)", {}, "",
                        demand_of("balanced_level_7"), level - (1 - root)),
            scene, root == 1 ? axis_unjudged(axis) : "figure 4.30 has the root as level 1"));
      }
    }
  }
  return rows;
}

/// "u_mixed (stand-in) 10, u_boxes (stand-in) 10": as the text has it.
std::string levels_of(std::span<const ClaimRow> rows, std::size_t scenes) {
  std::string text;
  for (const ClaimRow& row : rows.first(scenes)) {
    text += fmt::format("{}{} {:.0f}", text.empty() ? "" : ", ", row.subject, row.value);
  }
  return text.empty() ? "no scene" : text;
}

}  // namespace

Result claim_level_7(const Context& context) {
  check_stop(context.limits);
  const std::span<const Model> scenes = context.models.scenes;
  Claim claim = judged(thesis_claim("balanced_level_7"),
                       rows_of(scenes, {.threads = 1, .stop = context.limits.stop}));
  claim.note =
      fmt::format("Inner axis, root at level 1: {}.", levels_of(claim.rows, scenes.size()));
  claim.why =
      "The balanced level is a property of the scene: it ends where the plane first leaves a "
      "single triangle, or none that can be parted, on one side. Figure 5.5 takes level 7 as "
      "given.";
  claim.revision = Revision{Verdict::cannot_be_checked,
                            "a scene of the thesis' size that you give is judged now"};
  return {.claims = {std::move(claim)}};
}

}  // namespace soms::reproduce
