#include "apps/soms/shell/verbs.h"

#include "apps/soms/clash/clash.h"
#include "apps/soms/clearance/clearance.h"
#include "apps/soms/models/convert.h"
#include "apps/soms/models/generate.h"
#include "apps/soms/models/info.h"
#include "apps/soms/models/self.h"
#include "apps/soms/pairs/distance.h"
#include "apps/soms/pairs/motion.h"
#include "apps/soms/pairs/overlap.h"
#include "apps/soms/pairs/within.h"
#include "apps/soms/probes/closest.h"
#include "apps/soms/probes/contains.h"
#include "apps/soms/probes/ray.h"
#include "apps/soms/robot/robot.h"
#include "apps/soms/shards/join.h"
#include "apps/soms/shell/bench.h"
#include "apps/soms/shell/completion.h"
#include "apps/soms/shell/man.h"
#include "apps/soms/shell/passed_on.h"
#include "apps/soms/shell/version.h"
#include "apps/soms/simulate/simulate.h"
#include "apps/soms/solid/solid.h"
#include "apps/soms/thesis/thesis_verb.h"
#include "apps/store/build_verb.h"
#include "apps/store/tile_verb.h"

#include <array>

namespace soms::command {

namespace {

const std::array kVerbs{
    Verb{"bench", "compare soms with the installed peers on your own two models", add_bench},
    Verb{"build", "save a model with its tree, to be opened without being read or built again",
         add_build},
    Verb{"clash", "list the parts of models that cross, contain, touch or come near each other",
         add_clash},
    Verb{"clearance", "find how near a model comes to others along a path, between stations, too",
         add_clearance},
    Verb{"closest",
         "find the points of a model nearest to given points, and the triangles near them",
         add_closest},
    Verb{"completion", "print a shell completion script", add_completion},
    Verb{"contains", "decide which points are inside a closed model", add_contains},
    Verb{"convert", "convert a model to PLY, 3DS, STL, OFF, OBJ or GLB", add_convert},
    Verb{"distance", "find how far apart two models are, and where they are nearest", add_distance},
    Verb{"generate", "create a model with an exact number of triangles", add_generate},
    Verb{"info", "report triangles, bounds, parts, defects and trees of models", add_info},
    Verb{"join", "put the answers of all shards together, as one run would have written them",
         add_join},
    Verb{"man", "print the man page of the command or of a verb", add_man},
    Verb{"motion", "find when a model on its way from one pose to another first touches a second",
         add_motion},
    Verb{"overlap", "find the triangles of two models that touch or intersect", add_overlap},
    Verb{"ray", "find what rays, or segments between two points, hit in a model", add_ray},
    Verb{"render", "draw a city, its movers and contacts to a PNG file, without a screen", nullptr,
         pass_to_viewer},
    Verb{"reproduce", "rerun the experiments of the thesis: tables, figures and a page", nullptr,
         pass_to_reproduce},
    Verb{"robot", "decide in which states a robot touches itself or its cell, and how near it is",
         add_robot},
    Verb{"self", "find the triangles of a model that cross or touch each other", add_self},
    Verb{"simulate", "move objects through a city and report what touches what, frame by frame",
         add_simulate},
    Verb{"solid", "decide whether two closed models are clear, touch, cross or contain each other",
         add_solid},
    thesis_verb(),
    Verb{"tile", "cut models into tiles, for questions about more triangles than memory holds",
         add_tile},
    Verb{"version", "print the version, the instruction set and the file formats", add_version},
    Verb{"view", "fly through a city and see what touches what, and why", nullptr, pass_to_viewer},
    Verb{"within", "decide whether two models are within a clearance of each other", add_within},
};

}  // namespace

std::span<const Verb> verbs() {
  return kVerbs;
}

Program program() {
  return {
      .name = "soms", .summary = "find exactly, and fast, which triangles touch", .verbs = verbs()};
}

}  // namespace soms::command
