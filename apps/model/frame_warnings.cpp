#include "apps/model/frame_warnings.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/model/models.h"
#include "apps/model/stated_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

namespace soms::command {

namespace {

constexpr const char* kAxes[] = {"", "x", "y", "z"};
constexpr const char* kLookFor =
    "if this is not intended, check for a missing translation, unit or up axis";

/// Names for a remedy, behind words that have whole paths: the last part alone, where that
/// distinguishes two files. Commands need the path.
std::string last_part(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

NamedFrame briefly(const NamedFrame& model, const NamedFrame& other) {
  NamedFrame brief = model;
  const std::string name = last_part(model.file);
  if (!name.empty() && name != last_part(other.file)) {
    brief.path = model.file;
    brief.file = name;
  }
  return brief;
}

const std::string& path_of(const NamedFrame& model) {
  return model.path.empty() ? model.file : model.path;
}

std::string up_words(const NamedFrame& model, UpAxis up) {
  return fmt::format("{} {}", model.up_option, kAxes[static_cast<std::size_t>(up)]);
}

/// What turns models of known axes to z: "--up y and --up-b x".
std::string turning_words(const NamedFrame& a, const NamedFrame& b) {
  std::string text;
  for (const NamedFrame* const model : {&a, &b}) {
    if (model->frame.up != UpAxis::z) {
      text += (text.empty() ? "" : " and ") + up_words(*model, model->frame.up);
    }
  }
  return text;
}

/// `known` declares its axis, `other` does not.
std::string axis_remedy(const NamedFrame& known, const NamedFrame& other) {
  if (other.is_shared) {
    return fmt::format("convert {} first: soms convert {} OUT.glb --up AXIS", other.file,
                       path_of(other));
  }
  if (known.frame.up == UpAxis::z) {
    return fmt::format("give {0} z if z is also up in {1}, or {0} y if y is", other.up_option,
                       other.file);
  }
  const UpAxis up = known.frame.up;
  return fmt::format("give {} if z is up in {}, and also {} if {} is", up_words(known, up),
                     other.file, up_words(other, up), kAxes[static_cast<std::size_t>(up)]);
}

/// The unit that the file itself declares.
double stored_unit(const NamedFrame& model) {
  return model.frame.unit * model.frame.scale;
}

/// What states that the numbers of two models mean the same as they are: --scale 1 of either, as
/// long as it is not scaled; empty where there is no such option.
std::string keeping_words(const NamedFrame& scaled, const NamedFrame& other) {
  for (const NamedFrame* const model : {&scaled, &other}) {
    if (!model->built_in && !model->is_shared && model->frame.scale == 1) {
      return fmt::format(", or give {} 1 to keep the numbers", model->scale_option);
    }
  }
  return {};
}

std::string scaling_words(const NamedFrame& model, double unit, std::string_view to) {
  const double factor = stored_unit(model) / unit;
  return same_unit(factor, 1) ? "leave out " + model.scale_option
                              : fmt::format("give {} {:.9g} to convert {}{}", model.scale_option,
                                            factor, model.file, to);
}

/// Two models of known units: one is brought to the unit of the other.
std::string units_remedy(const NamedFrame& a, const NamedFrame& b) {
  // A model that soms made is not scaled; otherwise the one that already is.
  const bool scales_b = a.built_in || (!b.built_in && a.frame.scale == 1 && b.frame.scale != 1);
  const NamedFrame& scaled = scales_b ? b : a;
  const NamedFrame& other = scales_b ? a : b;
  return scaling_words(scaled, other.frame.unit, "") + keeping_words(scaled, other);
}

/// The same in a world: what is not in meters is brought to them.
std::string meters_remedy(const NamedFrame& a, const NamedFrame& b) {
  std::vector<std::string> steps;
  std::string shared_scale;
  const NamedFrame* scaled = nullptr;
  for (const NamedFrame* const model : {&a, &b}) {
    if (model->built_in) {
      continue;
    }
    if (model->is_shared) {
      if (!same_unit(stored_unit(*model), 1)) {
        steps.push_back(
            fmt::format("convert {} to meters first (soms convert {} OUT.glb --scale {:.9g})",
                        model->file, path_of(*model), stored_unit(*model)));
      }
      shared_scale = model->frame.scale == 1 ? shared_scale : model->scale_option;
    } else if (!same_unit(model->frame.unit, 1)) {
      steps.push_back(scaling_words(*model, 1, " to meters"));
      scaled = scaled == nullptr ? model : scaled;
    }
  }
  if (!shared_scale.empty()) {
    steps.push_back("leave out " + shared_scale);
  }
  return fmt::format("{}", fmt::join(steps, " and ")) +
         (scaled == &b ? keeping_words(b, a) : keeping_words(a, b));
}

/// `known` declares its unit, `other` does not.
std::string unit_remedy(const NamedFrame& known, const NamedFrame& other) {
  if (other.is_shared) {
    return fmt::format(
        "give {0} 1 if {1} is in the same unit; otherwise convert it first (soms convert {2} "
        "OUT.glb --scale X), then give {0} 1",
        other.scale_option, other.file, path_of(other));
  }
  if (other.in_meters && !known.is_shared && !same_unit(known.frame.unit, 1)) {
    return fmt::format("{} if {} is in meters, or {} 1 if it is in the same unit",
                       scaling_words(known, 1, " to meters"), other.file, other.scale_option);
  }
  constexpr double kMillimeter = 0.001;
  const bool in_millimeters = same_unit(known.frame.unit, kMillimeter);
  return fmt::format(
      "give {0} 1 if {1} is in the same unit, or the {0} that converts it ({2:.9g} if it is in "
      "{3})",
      other.scale_option, other.file, (in_millimeters ? 1 : kMillimeter) / known.frame.unit,
      in_millimeters ? "meters" : "millimeters");
}

/// Where the origin of `b` lies in the map from that of `a`, if they differ in nothing else.
std::string offset_words(const NamedFrame& a, const NamedFrame& b) {
  const auto& from = a.frame.georeference.map_conversion;
  const auto& to = b.frame.georeference.map_conversion;
  if (!from || !to || !(from->unit > 0)) {
    return {};
  }
  MapConversion moved = *from;
  moved.eastings = to->eastings;
  moved.northings = to->northings;
  moved.height = to->height;
  Georeference other = a.frame.georeference;
  other.map_conversion = moved;
  if (other != b.frame.georeference) {
    return {};
  }
  return fmt::format(
      "the origin of {} lies {:.9g} m east, {:.9g} m north and {:.9g} m up from that "
      "of {}; ",
      b.file, (to->eastings - from->eastings) * from->unit,
      (to->northings - from->northings) * from->unit, (to->height - from->height) * from->unit,
      a.file);
}

/// Georeferences are compared as they are stated, and nothing is moved by them.
std::string georeference_remedy(const NamedFrame& a, const NamedFrame& b) {
  const NamedFrame& settled = a.frame.georeference.empty() ? a : b;
  const NamedFrame& known = a.frame.georeference.empty() ? b : a;
  std::string text = offset_words(a, b) +
                     "soms does not move models by it: bring both into one "
                     "frame first";
  if (!settled.crs_option.empty() && !settled.is_shared && settled.frame.georeference.empty() &&
      !known.frame.georeference.map_conversion) {
    text += fmt::format(", or give {} {} if {} is in it", settled.crs_option,
                        printable(known.frame.georeference.crs), settled.file);
  }
  return text;
}

std::string remedy_of(FrameDoubt doubt, const NamedFrame& a, const NamedFrame& b) {
  switch (doubt) {
    case FrameDoubt::axes_differ:
      return fmt::format("models are not rotated unless you give {}", turning_words(a, b));
    case FrameDoubt::axis_unknown:
      return a.frame.up == UpAxis::unknown ? axis_remedy(b, a) : axis_remedy(a, b);
    case FrameDoubt::units_differ:
      return a.in_meters ? meters_remedy(a, b) : units_remedy(a, b);
    case FrameDoubt::unit_unknown:
      return a.frame.unit > 0 ? unit_remedy(a, b) : unit_remedy(b, a);
    case FrameDoubt::georeferences_differ:
    case FrameDoubt::georeference_unknown:
      return georeference_remedy(a, b);
    case FrameDoubt::boxes_apart:
      break;
  }
  return kLookFor;
}

bool is_about_georeferences(FrameDoubt doubt) {
  return doubt == FrameDoubt::georeferences_differ || doubt == FrameDoubt::georeference_unknown;
}

/// What soms made has no unit and axis that a file could lack, nor one that the caller's word about
/// a file would contradict. What it made or a pose places lies where that says.
bool is_settled(FrameDoubt doubt, const NamedFrame& a, const NamedFrame& b) {
  if (is_about_georeferences(doubt)) {
    return a.built_in || b.built_in || a.is_posed || b.is_posed;
  }
  const bool stated = a.frame.unit_is_stated || b.frame.unit_is_stated;
  return (a.built_in || b.built_in) &&
         (doubt == FrameDoubt::axis_unknown || doubt == FrameDoubt::unit_unknown ||
          (doubt == FrameDoubt::units_differ && stated));
}

bool knows_unit(const NamedFrame& model) {
  return model.frame.unit > 0;
}

bool knows_axis(const NamedFrame& model) {
  return model.frame.up != UpAxis::unknown;
}

/// The first model of which `knows` holds, or else the first.
const NamedFrame& first_that(const std::vector<NamedFrame>& models,
                             bool (*knows)(const NamedFrame&)) {
  const auto found = std::find_if(models.begin(), models.end(), knows);
  return found == models.end() ? models.front() : *found;
}

/// Warnings of two files that one --scale goes to. It does not say how known units compare; 1 does
/// say that an unknown one is the other's.
std::vector<FrameWarning> shared_warnings(NamedFrame a, NamedFrame b) {
  const bool settles = (!knows_unit(a) || !knows_unit(b)) && a.frame.scale == 1;
  a.frame.unit_is_stated = a.frame.unit_is_stated && settles;
  b.frame.unit_is_stated = b.frame.unit_is_stated && settles;
  return frame_warnings(a, b);
}

bool is_about_axes(FrameDoubt doubt) {
  return doubt == FrameDoubt::axes_differ || doubt == FrameDoubt::axis_unknown;
}

bool is_about_units(FrameDoubt doubt) {
  return doubt == FrameDoubt::units_differ || doubt == FrameDoubt::unit_unknown;
}

void append_if(std::vector<FrameWarning>& all, const std::vector<FrameWarning>& found,
               bool (*is_about)(FrameDoubt)) {
  std::copy_if(found.begin(), found.end(), std::back_inserter(all),
               [is_about](const FrameWarning& warning) { return is_about(warning.doubt); });
}

/// Warnings about where on the Earth models lie that no pose places.
void append_georeferences(std::vector<FrameWarning>& all, std::vector<NamedFrame> models) {
  std::erase_if(models, [](const NamedFrame& model) { return model.is_posed || model.built_in; });
  if (models.empty()) {
    return;
  }
  const NamedFrame& known =
      first_that(models, [](const NamedFrame& model) { return !model.frame.georeference.empty(); });
  for (const NamedFrame& model : models) {
    if (&model != &known) {
      append_if(all, frame_warnings(known, model), is_about_georeferences);
    }
  }
}

}  // namespace

NamedFrame named_frame(const MeshView& mesh, const ModelOptions& options,
                       const std::string& scale_option, const std::string& up_option) {
  NamedFrame model{.file = printable(mesh.source),
                   .frame = frame_of(mesh),
                   .scale_option = scale_option,
                   .up_option = up_option,
                   .crs_option = crs_option(up_option)};
  model.frame.unit_is_stated = options.scale_is_given;
  model.frame.scale = options.scale;
  model.frame.up_is_stated = options.up != UpAxis::unknown;
  model.frame.georeference_is_stated = !options.crs.empty();
  return model;
}

std::vector<FrameWarning> frame_warnings(const NamedFrame& a, const NamedFrame& b) {
  std::vector<FrameWarning> warnings;
  for (const FrameDoubt doubt : compare_frames(a.frame, b.frame)) {
    if (!is_settled(doubt, a, b)) {
      warnings.push_back({doubt, explain(doubt, a.frame, a.file, b.frame, b.file),
                          remedy_of(doubt, briefly(a, b), briefly(b, a))});
    }
  }
  return warnings;
}

std::vector<FrameWarning> world_warnings(const std::vector<NamedFrame>& city,
                                         const std::vector<NamedFrame>& movers) {
  std::vector<FrameWarning> warnings;
  const NamedFrame& of_axis = first_that(city, knows_axis);
  const NamedFrame& of_unit = first_that(city, knows_unit);
  for (const NamedFrame& model : city) {
    if (&model != &of_axis) {
      append_if(warnings, shared_warnings(of_axis, model), is_about_axes);
    }
    if (&model != &of_unit) {
      append_if(warnings, shared_warnings(of_unit, model), is_about_units);
    }
  }
  for (const NamedFrame& model : movers) {
    append_if(warnings, frame_warnings(of_axis, model), is_about_axes);
    append_if(warnings, frame_warnings(of_unit, model), is_about_units);
  }
  if (!knows_unit(of_unit) && !movers.empty()) {
    const NamedFrame& of_movers = first_that(movers, knows_unit);
    for (const NamedFrame& model : movers) {
      if (knows_unit(of_movers) && knows_unit(model)) {
        append_if(warnings, shared_warnings(of_movers, model), is_about_units);
      }
    }
  }
  std::vector<NamedFrame> all = city;
  all.insert(all.end(), movers.begin(), movers.end());
  append_georeferences(warnings, std::move(all));
  return warnings;
}

FrameWarning apart_warning(const std::string& a, const std::string& b, double gap,
                           const std::string& where) {
  return {
      FrameDoubt::boxes_apart,
      fmt::format("{}the boxes of {} and {} are {:.4g} or more apart, farther than either is long",
                  where, a, b, gap),
      kLookFor};
}

void BoxWatch::look(const Box& a, const Box& b) {
  gap_ = soms::gap(a, b);
  apart_ = far_apart(a, b);
  least_gap_ = looked_ ? std::min(least_gap_, gap_) : gap_;
  always_apart_ = apart_ && (always_apart_ || !looked_);
  looked_ = true;
}

void tell_warnings(const std::vector<FrameWarning>& warnings, bool strict, const Console& console) {
  if (strict && !warnings.empty()) {
    std::vector<std::string> places;
    std::vector<std::string> remedies;
    for (const FrameWarning& warning : warnings) {
      places.push_back(warning.place);
      // One remedy may settle several.
      if (std::find(remedies.begin(), remedies.end(), warning.remedy) == remedies.end()) {
        remedies.push_back(warning.remedy);
      }
    }
    throw Error(ErrorKind::bad_file, fmt::format("--strict: {}", fmt::join(places, "; ")),
                fmt::format("{}", fmt::join(remedies, "; ")));
  }
  for (const FrameWarning& warning : warnings) {
    console.note("warning: " + warning.text());
  }
}

Json warnings_json(const std::vector<FrameWarning>& warnings) {
  Json list = Json::array();
  for (const FrameWarning& warning : warnings) {
    list.push_back({{"kind", name(warning.doubt)}, {"message", warning.text()}});
  }
  return list;
}

}  // namespace soms::command
