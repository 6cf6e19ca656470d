#include "apps/soms/probes/ray.h"

#include "soms/base/error.h"

#include "apps/cli/parse.h"
#include "apps/rows/ray_source.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/soms/probes/ray_run.h"

#include <fmt/format.h>

#include <memory>
#include <variant>

namespace soms::command {

namespace {

std::string found_by_brute_force(const RayAnswer& truth) {
  if (const auto* all = std::get_if<Crossings>(&truth)) {
    return fmt::format("{} of {}", counted(all->places.size(), "crossing"),
                       counted(all->count(), "triangle"));
  }
  const auto& hit = std::get<ClosestHit>(truth);
  return hit.triangle ? fmt::format("triangle {} at t from {} to {}", *hit.triangle, hit.t.lower,
                                    hit.t.upper)
                      : "nothing";
}

bool agree(const ClosestHit& answer, const ClosestHit& truth) {
  if (answer.coverage == Coverage::cut) {
    return truth.t.upper <= answer.t.upper;  // a nearer one may be missing
  }
  return answer.t == truth.t && answer.triangle == truth.triangle && answer.point == truth.point &&
         answer.front == truth.front;
}

void check_ray_options(const RayVerbOptions& options) {
  if (options.rays.empty() == options.segments.empty()) {
    throw Error(ErrorKind::usage,
                options.rays.empty() ? "neither --rays nor --segments is given"
                                     : "--rays and --segments are both given",
                "give one of them");
  }
  if (options.any && options.all) {
    throw Error(ErrorKind::usage, "--any and --all exclude each other", "give one of them");
  }
  check_outputs({{"MODEL", options.model},
                 {"--rays", options.rays},
                 {"--segments", options.segments},
                 {"--pose", options.pose.value_or("")}},
                {{"--csv", options.csv}, {"--binary", options.binary}});
  check_extension("--csv", options.csv, {".csv"});
  check_extension("--binary", options.binary, {".npz"});
}

}  // namespace

std::optional<std::string> difference_of(const RayAnswer& answer, const RayAnswer& truth) {
  bool right = true;
  if (const auto* first = std::get_if<ClosestHit>(&answer)) {
    right = agree(*first, std::get<ClosestHit>(truth));
  } else if (const auto* all = std::get_if<Crossings>(&answer)) {
    right = is_cut(answer) || all->places == std::get<Crossings>(truth).places;
  } else {
    right = is_hit(answer) == is_hit(truth) || (is_cut(answer) && !is_hit(answer));
  }
  return right ? std::nullopt
               : std::optional("brute force finds " + found_by_brute_force(truth) +
                               ", and the answer is another");
}

Action add_ray(Parser& parser, Shared&) {
  const auto options = std::make_shared<RayVerbOptions>();
  add_probed_model(parser, *options, "model");
  add_rows(parser, "--rays", options->rays, "rays", "ox,oy,oz,dx,dy,dz[,length]");
  add_rows(parser, "--segments", options->segments, "segments", "x0,y0,z0,x1,y1,z1");
  add_model_pose(parser, *options);
  parser.add_flag("--any", options->any, "only say whether each ray hits anything")
      ->group(kQuestionGroup);
  parser.add_flag("--all", options->all, "list every place where each ray meets the model")
      ->group(kQuestionGroup);
  parser
      .add_option_function(
          "--skip",
          [options](const std::string& text) {
            options->skip = static_cast<TriangleId>(parse_count("--skip", text, 0, 0xffffffffU));
          },
          "leave this triangle out, as the one that the rays start on")
      ->option_text("N")
      ->group(kQuestionGroup);
  add_choice<bool>(parser, "--fail-if", options->fail_if_hit, {{"hit", true}},
                   "exit with status 1 if a ray hits anything")
      ->group(kQuestionGroup);
  add_output(parser, "--csv", options->csv, "write the answers as CSV")->group(kQuestionGroup);
  add_binary(parser, options->binary);
  add_probe_options(parser, *options);
  parser.footer(
      "The first point of the surface on each ray, decided exactly: none slips through an edge or\n"
      "a corner. A ray counts its t in units of its direction, a segment from 0 to 1.\n\n"
      "Example:\n"
      "  soms generate knot --triangles 2000 -o knot.ply\n"
      "  printf 'ox,oy,oz,dx,dy,dz\\n-3,0,0,1,0,0\\n3,0.25,0.125,-1,0,0\\n' | soms ray knot.ply "
      "--rays -");
  return [options, &parser](Console& console) {
    check_ray_options(*options);
    check_probe_options(parser, *options,
                        options->rays.empty() ? options->segments : options->rays);
    return run_ray(*options, console);
  };
}

int run_ray(const RayVerbOptions& options, Console& console) {
  RayFiles files(options);
  return options.rays.empty()
             ? RayRun<SegmentSource>(options, options.segments, files, console).run()
             : RayRun<RaySource>(options, options.rays, files, console).run();
}

}  // namespace soms::command
