#include "soms/geometry/frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>

namespace soms {

namespace {

double longest_side(const Box& box) {
  const Vec3 extent = box.extent();
  return std::max({extent.x, extent.y, extent.z});
}

std::string_view axis_word(UpAxis up) {
  constexpr std::array<std::string_view, 4> kWords{"unknown", "x", "y", "z"};
  return kWords.at(static_cast<std::size_t>(up));
}

std::string unit_words(const CoordinateFrame& frame) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(9);
  out << frame.unit << " m";
  if (frame.scale != 1) {
    out << " (after scaling by " << frame.scale << ")";
  }
  return out.str();
}

/// The caller says that the numbers mean what those of the other model mean, as they are.
bool keeps_unit(const CoordinateFrame& frame) {
  return frame.unit_is_stated && frame.scale == 1;
}

bool units_are_in_doubt(const CoordinateFrame& a, const CoordinateFrame& b) {
  return a.unit > 0 && b.unit > 0 ? !keeps_unit(a) && !keeps_unit(b) && !same_unit(a.unit, b.unit)
                                  : !a.unit_is_stated && !b.unit_is_stated && a.unit != b.unit;
}

bool georeference_is_in_doubt(const CoordinateFrame& a, const CoordinateFrame& b) {
  const bool stated = a.georeference_is_stated || b.georeference_is_stated;
  const bool both = !a.georeference.empty() && !b.georeference.empty();
  return a.georeference != b.georeference && (both || !stated);
}

/// What differs of two georeferences, or all that one states.
struct GeoreferenceWords {
  std::string what;
  std::string a;
  std::string b;
};

GeoreferenceWords georeference_words(const Georeference& a, const Georeference& b) {
  const auto name = [](const std::string& text) { return text.empty() ? "unknown" : text; };
  const auto place = [](const Georeference& whole) {
    return whole.map_conversion ? describe({.map_conversion = whole.map_conversion}) : "none";
  };
  if (a.empty() || b.empty()) {
    return {"the georeference", a.empty() ? "unknown" : describe(a),
            b.empty() ? "unknown" : describe(b)};
  }
  if (a.crs != b.crs) {
    return {"the coordinate reference system", name(a.crs), name(b.crs)};
  }
  if (a.vertical_datum != b.vertical_datum) {
    return {"the vertical datum", name(a.vertical_datum), name(b.vertical_datum)};
  }
  return {"the map conversion", place(a), place(b)};
}

}  // namespace

CoordinateFrame frame_of(const MeshView& mesh) {
  return {.unit = mesh.unit, .up = mesh.up, .georeference = mesh.georeference};
}

bool same_unit(double a, double b) {
  constexpr double kRounding = 1e-6;  // of a float: 6e-8
  return std::abs(a - b) <= kRounding * std::max(a, b);
}

std::vector<FrameDoubt> compare_frames(const CoordinateFrame& a, const CoordinateFrame& b) {
  std::vector<FrameDoubt> doubts;
  const bool knows_up_a = a.up != UpAxis::unknown;
  const bool knows_up_b = b.up != UpAxis::unknown;
  if (knows_up_a && knows_up_b && a.up != b.up) {
    doubts.push_back(FrameDoubt::axes_differ);
  }
  if (knows_up_a != knows_up_b && !a.up_is_stated && !b.up_is_stated) {
    doubts.push_back(FrameDoubt::axis_unknown);
  }
  if (units_are_in_doubt(a, b)) {
    const bool both = a.unit > 0 && b.unit > 0;
    doubts.push_back(both ? FrameDoubt::units_differ : FrameDoubt::unit_unknown);
  }
  if (georeference_is_in_doubt(a, b)) {
    const bool both = !a.georeference.empty() && !b.georeference.empty();
    doubts.push_back(both ? FrameDoubt::georeferences_differ : FrameDoubt::georeference_unknown);
  }
  return doubts;
}

std::string explain(FrameDoubt doubt, const CoordinateFrame& a, const std::string& name_a,
                    const CoordinateFrame& b, const std::string& name_b) {
  if (doubt == FrameDoubt::georeferences_differ || doubt == FrameDoubt::georeference_unknown) {
    // What is known comes first.
    if (a.georeference.empty()) {
      return explain(doubt, b, name_b, a, name_a);
    }
    const GeoreferenceWords words = georeference_words(a.georeference, b.georeference);
    return words.what + " is " + words.a + " in " + name_a + ", and " + words.b + " in " + name_b;
  }
  const bool axes = doubt == FrameDoubt::axes_differ || doubt == FrameDoubt::axis_unknown;
  const auto known = [&](const CoordinateFrame& frame) {
    return axes ? frame.up != UpAxis::unknown : frame.unit > 0;
  };
  const auto word = [&](const CoordinateFrame& frame) {
    return !known(frame) ? "unknown" : axes ? std::string(axis_word(frame.up)) : unit_words(frame);
  };
  // What is known comes first.
  const bool swapped = known(b) && !known(a);
  const CoordinateFrame& first = swapped ? b : a;
  const CoordinateFrame& second = swapped ? a : b;
  return std::string(axes ? "the up axis" : "the unit") + " is " + word(first) + " in " +
         (swapped ? name_b : name_a) + ", and " + word(second) + " in " +
         (swapped ? name_a : name_b);
}

double gap(const Box& a, const Box& b) {
  double widest = 0;
  if (!a.empty() && !b.empty()) {
    for (std::size_t k = 0; k < 3; ++k) {
      widest = std::max({widest, a.lower[k] - b.upper[k], b.lower[k] - a.upper[k]});
    }
  }
  return widest;
}

bool far_apart(const Box& a, const Box& b) {
  const double widest = gap(a, b);
  return widest > 0 && widest > longest_side(a) && widest > longest_side(b);
}

}  // namespace soms
