#include "apps/soms/verbs.h"

#include "apps/soms/bench.h"
#include "apps/soms/completion.h"
#include "apps/soms/convert.h"
#include "apps/soms/generate.h"
#include "apps/soms/info.h"
#include "apps/soms/overlap.h"
#include "apps/soms/reproduce.h"
#include "apps/soms/simulate.h"

#include <array>

namespace soms::command {

namespace {

constexpr std::array kVerbs{
    Verb{"bench", "soms and the installed rivals on two models of yours", add_bench},
    Verb{"completion", "words for the shell to complete", add_completion},
    Verb{"convert", "read any model, write PLY, 3DS, STL, OFF or OBJ", add_convert},
    Verb{"generate", "make a model of an exact number of triangles", add_generate},
    Verb{"info", "triangles, bounds, parts, defects and trees of models", add_info},
    Verb{"overlap", "which triangles of two models share a point", add_overlap},
    Verb{"reproduce", "the experiments of the thesis: tables, figures and a page", add_reproduce},
    Verb{"simulate", "a city, movers on its streets, frame by frame: who touches what",
         add_simulate},
};

}  // namespace

std::span<const Verb> verbs() {
  return kVerbs;
}

ParsedVerb::ParsedVerb(const Verb& verb)
    : app_(std::string(verb.question), "soms " + std::string(verb.name)) {
  app_.allow_extras();   // told by program.cpp, with a suggestion
  app_.set_help_flag();  // none before the verb's own options
  app_.get_formatter()->column_width(30);
  app_.get_formatter()->label("Positionals", "Arguments");
  app_.get_formatter()->label("REQUIRED", "");
  action_ = verb.add(app_, shared_);
  app_.set_help_flag("-h,--help", "this text")->group(kSharedGroup);
  add_shared_options(app_, shared_);
}

std::string ParsedVerb::help() const {
  std::string text = app_.help();
  for (std::size_t at = text.find("\n\n\n"); at != std::string::npos; at = text.find("\n\n\n")) {
    text.erase(at, 1);
  }
  return text;
}

std::vector<std::string> ParsedVerb::option_names() const {
  std::vector<std::string> names;
  for (const CLI::Option* option : app_.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
    for (const std::string& name : option->get_snames()) {
      names.push_back("-" + name);
    }
  }
  return names;
}

}  // namespace soms::command
