#include "apps/support/frame_warnings.h"

#include "soms/base/error.h"

#include "apps/support/console.h"
#include "apps/support/models.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::command {

namespace {

constexpr const char* kAxes[] = {"", "x", "y", "z"};
constexpr const char* kLookFor =
    "if this is not intended, check for a missing translation, unit or up axis";

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
  if (known.frame.up == UpAxis::z) {
    return fmt::format("give {0} z if z is also up in {1}, or {0} y if y is", other.up_option,
                       other.file);
  }
  const UpAxis up = known.frame.up;
  return fmt::format("give {} if z is up in {}, and also {} if {} is", up_words(known, up),
                     other.file, up_words(other, up), kAxes[static_cast<std::size_t>(up)]);
}

std::string remedy_of(FrameDoubt doubt, const NamedFrame& a, const NamedFrame& b) {
  switch (doubt) {
    case FrameDoubt::axes_differ:
      return fmt::format("models are not rotated unless you give {}", turning_words(a, b));
    case FrameDoubt::axis_unknown:
      return a.frame.up == UpAxis::unknown ? axis_remedy(b, a) : axis_remedy(a, b);
    case FrameDoubt::units_differ:
      // A model that soms made is not scaled.
      return a.built_in ? fmt::format("give {} {} to convert, or {} 1 to keep it", b.scale_option,
                                      b.frame.unit / a.frame.unit, b.scale_option)
                        : fmt::format("give {} {} to convert, or {} 1 to keep it", a.scale_option,
                                      a.frame.unit / b.frame.unit, a.scale_option);
    case FrameDoubt::unit_unknown: {
      const NamedFrame& other = a.frame.unit > 0 ? b : a;
      return fmt::format("give {0} 1 if {1} is in the same unit, or the {0} that converts it",
                         other.scale_option, other.file);
    }
    case FrameDoubt::boxes_apart:
      break;
  }
  return kLookFor;
}

}  // namespace

NamedFrame named_frame(const Mesh& mesh, const ModelOptions& options,
                       const std::string& scale_option, const std::string& up_option) {
  NamedFrame model{.file = printable(mesh.source),
                   .frame = frame_of(mesh),
                   .scale_option = scale_option,
                   .up_option = up_option};
  model.frame.unit_is_stated = options.scale_is_given;
  model.frame.up_is_stated = options.up != UpAxis::unknown;
  return model;
}

std::vector<FrameWarning> frame_warnings(const NamedFrame& a, const NamedFrame& b) {
  std::vector<FrameWarning> warnings;
  for (const FrameDoubt doubt : compare_frames(a.frame, b.frame)) {
    const bool unknown = doubt == FrameDoubt::axis_unknown || doubt == FrameDoubt::unit_unknown;
    if (unknown && (a.built_in || b.built_in)) {
      continue;
    }
    warnings.push_back(
        {doubt, explain(doubt, a.frame, a.file, b.frame, b.file), remedy_of(doubt, a, b)});
  }
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
    std::string places;
    std::string remedies;
    for (const FrameWarning& warning : warnings) {
      places += (places.empty() ? "--strict: " : "; ") + warning.place;
      remedies += (remedies.empty() ? "" : "; ") + warning.remedy;
    }
    throw Error(ErrorKind::bad_file, places, remedies);
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
