#include "apps/soms/verbs.h"

#include "apps/soms/bench.h"
#include "apps/soms/completion.h"
#include "apps/soms/convert.h"
#include "apps/soms/generate.h"
#include "apps/soms/info.h"
#include "apps/soms/man.h"
#include "apps/soms/overlap.h"
#include "apps/soms/passed_on.h"
#include "apps/soms/simulate.h"
#include "apps/soms/version.h"

#include <array>

namespace soms::command {

namespace {

constexpr std::array kVerbs{
    Verb{"bench", "compare soms with the installed peers on your own two models", add_bench},
    Verb{"completion", "print a shell completion script", add_completion},
    Verb{"convert", "read any model, write PLY, 3DS, STL, OFF, OBJ or GLB", add_convert},
    Verb{"generate", "create a model with an exact number of triangles", add_generate},
    Verb{"info", "triangles, bounds, parts, defects and trees of models", add_info},
    Verb{"man", "print the man page of the command or of a verb", add_man},
    Verb{"overlap", "which triangles of two models share a point", add_overlap},
    Verb{"render", "draw a city, its movers and contacts as a picture, without a screen", nullptr,
         pass_to_viewer},
    Verb{"reproduce", "the experiments of the thesis: tables, figures and a page", nullptr,
         pass_to_reproduce},
    Verb{"simulate", "a city, movers on its streets, frame by frame: who touches what",
         add_simulate},
    Verb{"version", "the version, the instruction set and the formats of this soms", add_version},
    Verb{"view", "fly through a city and see what touches what, and why", nullptr, pass_to_viewer},
};

}  // namespace

std::span<const Verb> verbs() {
  return kVerbs;
}

Program program() {
  return {
      .name = "soms", .summary = "exact, fast answers to which triangles touch", .verbs = verbs()};
}

}  // namespace soms::command
