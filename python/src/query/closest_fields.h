/// \file
/// The fields of nearest points and of hits of rays, which queries of a body and of a scene share.
#pragma once

#include "soms/query/closest.h"
#include "soms/query/ray.h"

#include "python/src/answer.h"

namespace soms::python {

/// T is a Closest.
template <class T>
void closest_fields(AnswerClass<T>& one) {
  one.derived(
         "lower", [](const T& c) { return c.distance.lower; },
         "The largest double that is not above the distance.")
      .derived(
          "upper", [](const T& c) { return c.distance.upper; },
          "The least double that is not below it.")
      .field("triangle", &T::triangle, "The least triangle at this distance; None if farther.")
      .field("point", &T::point, "(3,): the nearest point, in world.")
      .field("feature", &T::feature, "TriangleFeature: where on the triangle that lies.")
      .field("farther", &T::farther, "The distance exceeds at_most.")
      .field("coverage", &T::coverage, "Coverage.")
      .field("cost", &T::cost, "Cost.");
}

/// T is a ClosestBatch.
template <class T>
void closest_columns(AnswerClass<T>& batch) {
  batch.column("lower", &T::lower, "(n,) float64.")
      .column("upper", &T::upper, "(n,) float64.")
      .column("triangle", &T::triangle, "(n,) int64, -1 where there is none.")
      .column("point", &T::point, "(n, 3) float64; 0 where there is no triangle.")
      .column("feature", &T::feature, "(n,) integers of TriangleFeature.")
      .column("farther", &T::farther, "(n,) bool.")
      .column("coverage", &T::coverage, "(n,) integers of Coverage.")
      .column("costs", &T::costs, "(n,) node_tests, triangle_tests, exact_tests.")
      .field("cost", &T::cost, "Cost of all points together.")
      .entries();
}

/// T is a ClosestHit.
template <class T>
void hit_fields(AnswerClass<T>& one) {
  one.derived(
         "lower", [](const T& h) { return h.t.lower; },
         "The largest double that is not above t; infinity where nothing is hit.")
      .derived(
          "upper", [](const T& h) { return h.t.upper; }, "The least double that is not below t.")
      .field("triangle", &T::triangle, "The least triangle met at this t, or None.")
      .field("point", &T::point, "(3,): where, in world.")
      .field("front", &T::front, "The ray meets the front of the triangle.")
      .field("coverage", &T::coverage, "Coverage.")
      .field("cost", &T::cost, "Cost.");
}

/// T is a ClosestHitBatch.
template <class T>
void hit_columns(AnswerClass<T>& batch) {
  batch.column("lower", &T::lower, "(n,) float64: t, infinity where nothing is hit.")
      .column("upper", &T::upper, "(n,) float64.")
      .column("triangle", &T::triangle, "(n,) int64, -1 where nothing is hit.")
      .column("point", &T::point, "(n, 3) float64; 0 where nothing is hit.")
      .column("front", &T::front, "(n,) bool.")
      .column("coverage", &T::coverage, "(n,) integers of Coverage.")
      .column("costs", &T::costs, "(n,) node_tests, triangle_tests, exact_tests.")
      .field("cost", &T::cost, "Cost of all rays together.")
      .entries();
}

/// T is an AllHits.
template <class T>
void all_hits_columns(AnswerClass<T>& all) {
  all.column("lower", &T::lower, "(m,) float64: t of each crossing.")
      .column("upper", &T::upper, "(m,) float64.")
      .column("kind", &T::kind, "(m,) integers of CrossingKind.")
      .column("offsets", &T::offsets,
              "(n + 1,) uint64: ray i has the crossings offsets[i] to offsets[i + 1].")
      .column("triangle", &T::triangle, "(k,) uint32: triangles of all crossings.")
      .column(
          "triangle_offsets", &T::triangle_offsets,
          "(m + 1,) uint64: crossing j has triangle[triangle_offsets[j]:triangle_offsets[j + 1]].")
      .column("coverage", &T::coverage, "(n,) integers of Coverage.")
      .column("costs", &T::costs, "(n,) node_tests, triangle_tests, exact_tests.")
      .field("cost", &T::cost, "Cost of all rays together.")
      .entries();
}

}  // namespace soms::python
