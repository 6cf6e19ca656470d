#include "apps/soms/probes/ray.h"

#include "soms/base/error.h"

#include "apps/cli/parse.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/soms/probes/crossings_question.h"
#include "apps/soms/probes/ray_question.h"

#include <fmt/format.h>

#include <memory>

namespace soms::command {

namespace {

std::optional<std::string> unless(bool right, const std::string& found) {
  return right ? std::nullopt
               : std::optional("brute force finds " + found + ", and the answer is another");
}

std::string in_words(const ClosestHit& hit) {
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
}

}  // namespace

std::optional<std::string> difference_of(const ClosestHit& answer, const ClosestHit& truth) {
  return unless(agree(answer, truth), in_words(truth));
}

std::optional<std::string> difference_of(const AnyHit& answer, const ClosestHit& truth) {
  return unless(
      answer.hit == truth.triangle.has_value() || (answer.coverage == Coverage::cut && !answer.hit),
      in_words(truth));
}

std::optional<std::string> difference_of(const Crossings& answer, const Crossings& truth) {
  return unless(answer.coverage == Coverage::cut || answer.places == truth.places,
                fmt::format("{} of {}", counted(truth.places.size(), "crossing"),
                            counted(truth.count(), "triangle")));
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
    const bool rays = !options->rays.empty();
    check_probe_options(parser, *options, rays ? "--rays" : "--segments",
                        rays ? options->rays : options->segments);
    return run_ray(*options, console);
  };
}

namespace {

template <class Source>
int run_rays(const RayVerbOptions& options, const std::string& file, Console& console) {
  const ProbeTerms terms{.verb = "ray", .fail_if_found = options.fail_if_hit};
  if (options.all) {
    return run_probes<Source>(options, file, terms, console,
                              [&](const auto& rows, const Pose& pose) {
                                return CrossingsQuestion<Source>(options, rows, pose, console);
                              });
  }
  if (options.any) {
    return run_probes<Source>(options, file, terms, console,
                              [&](const auto& rows, const Pose& pose) {
                                return HitQuestion<AnyHit, Source>(options, rows, pose, console);
                              });
  }
  return run_probes<Source>(options, file, terms, console, [&](const auto& rows, const Pose& pose) {
    return HitQuestion<ClosestHit, Source>(options, rows, pose, console);
  });
}

}  // namespace

int run_ray(const RayVerbOptions& options, Console& console) {
  return options.rays.empty() ? run_rays<SegmentSource>(options, options.segments, console)
                              : run_rays<RaySource>(options, options.rays, console);
}

}  // namespace soms::command
