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
    Verb{"bench", "soms and the installed rivals on two models of yours", add_bench},
    Verb{"completion", "words for the shell to complete", add_completion},
    Verb{"convert", "read any model, write PLY, 3DS, STL, OFF, OBJ or GLB", add_convert},
    Verb{"generate", "make a model of an exact number of triangles", add_generate},
    Verb{"info", "triangles, bounds, parts, defects and trees of models", add_info},
    Verb{"man", "the manual: a page for the command and each verb", add_man},
    Verb{"overlap", "which triangles of two models share a point", add_overlap},
    Verb{"render", "draw a city, movers and contacts into a picture, without a screen", nullptr,
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
