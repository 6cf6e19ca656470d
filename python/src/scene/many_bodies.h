/// \file
/// Queries of points and rays over many bodies, as methods: those of a scene and of an index differ
/// in how they say which bodies take part.
#pragma once

#include "soms/scene/of_bodies.h"

#include "python/src/call.h"
#include "python/src/packing.h"
#include "python/src/query/point_query.h"
#include "python/src/query/ray_arguments.h"

#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace soms::python {

template <class Answer, class Name>
struct Packing<OfBodies<Answer, Name>>
    : ExtendedPacking<OfBodies<Answer, Name>, Answer, &OfBodies<Answer, Name>::body> {};

/// The arguments of a filter in a signature, and what they are.
struct FilterText {
  std::string arguments;  ///< "ignore=None, "
  std::string meaning;
};

/// Binds methods of `Bound`. `use(held)` gives what keeps a held object in use, whose `queried()`
/// answers; `filter_of` makes its filter of what was passed.
template <class Bound, class Filter, class... Types>
class ManyBodies {
 public:
  using Names = std::array<py::arg_v, sizeof...(Types)>;

  ManyBodies(py::class_<Bound>& bound, Filter (*filter_of)(Types...), Names names, FilterText text)
      : bound_(bound), filter_of_(filter_of), names_(std::move(names)), text_(std::move(text)) {}

  /// `closest`, whose answers are of these classes.
  void bind_closest(const std::string& one, const std::string& batch) {
    const std::string doc = signature("closest(points, *, at_most=inf, ") +
                            "The nearest point of all bodies. Returns " + one + ", or " + batch +
                            " for n points." + text_.meaning;
    def_closest(doc, std::index_sequence_for<Types...>());
  }

  /// `query(object, one or more lines, options, filter...)` by a name.
  template <class Query>
  void bind_rays(const char* name, const Query& query, const std::string& what) {
    const std::string doc =
        signature(std::string(name) +
                  "(origins, directions=None, *, ends=None, lengths=inf, skip=None, ") +
        what + text_.meaning;
    def_rays(name, query, doc, std::index_sequence_for<Types...>());
  }

  /// All queries of rays; answers of `closest_hit` and `all_hits` are of these classes.
  void bind_all_rays(const std::string& hit, const std::string& hits, const std::string& all) {
    bind_rays(
        "closest_hit",
        [](const auto& many, const auto&... given) { return many.closest_hit(given...); },
        "The first point of all bodies on a ray. Returns " + hit + ", or " + hits + " for n rays.");
    bind_rays(
        "any_hit", [](const auto& many, const auto&... given) { return many.any_hit(given...); },
        "Does a ray hit any body? Returns AnyHit, or AnyHitBatch for n rays.");
    bind_rays(
        "all_hits",
        [](const auto& many, const auto& lines, const auto&... given) {
          return many.all_hits(rays_in(lines), given...);
        },
        "All places where rays meet bodies. Returns " + all + ".");
  }

 private:
  [[nodiscard]] std::string signature(const std::string& begin) const {
    return begin + text_.arguments + "timeout=None, threads=1, progress=None)\n\n";
  }

  template <std::size_t... I>
  void def_closest(const std::string& doc, std::index_sequence<I...>) {
    bound_.def(
        "closest",
        [filter_of = filter_of_](Bound& held, const py::object& points, double at_most,
                                 Types... filtering, const std::optional<double>& timeout,
                                 int threads, const py::object& progress,
                                 const py::kwargs& old_names) {
          const auto& in_use = use(held);
          const ClosestOptions options{.at_most = at_most};
          const Filter filter = filter_of(filtering...);
          return answer_points(points, {threads, timeout_of(timeout, old_names)}, progress,
                               [&](const Limits& limits, const auto& places) {
                                 return in_use.queried().closest(places, options, filter, limits);
                               });
        },
        py::arg("points"), py::kw_only(), py::arg("at_most") = ClosestOptions{}.at_most,
        names_[I]..., py::arg("timeout") = py::none(), py::arg("threads") = 1,
        py::arg("progress") = py::none(), doc.c_str());
  }

  template <class Query, std::size_t... I>
  void def_rays(const char* name, const Query& query, const std::string& doc,
                std::index_sequence<I...>) {
    bound_.def(
        name,
        [query, filter_of = filter_of_](
            Bound& held, const py::object& origins, const py::object& directions,
            const py::object& ends, const py::object& lengths, const py::object& skip,
            Types... filtering, const std::optional<double>& timeout, int threads,
            const py::object& progress, const py::kwargs& old_names) {
          const auto& in_use = use(held);
          const RayOptions options = ray_options(skip);
          const Filter filter = filter_of(filtering...);
          return answer_rays(rays_of(origins, directions, ends, lengths),
                             {threads, timeout_of(timeout, old_names)}, progress,
                             [&](const auto& lines, const Limits& limits) {
                               return query(in_use.queried(), lines, options, filter, limits);
                             });
        },
        py::arg("origins"), py::arg("directions") = py::none(), py::kw_only(),
        py::arg("ends") = py::none(), py::arg("lengths") = Ray{}.length,
        py::arg("skip") = py::none(), names_[I]..., py::arg("timeout") = py::none(),
        py::arg("threads") = 1, py::arg("progress") = py::none(), doc.c_str());
  }

  py::class_<Bound>& bound_;
  Filter (*filter_of_)(Types...);
  Names names_;
  FilterText text_;
};

}  // namespace soms::python
