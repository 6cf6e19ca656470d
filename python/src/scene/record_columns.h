/// \file
/// One field of many records of C++ as an array of numpy, where the records lie: a view without a
/// copy.
#pragma once

#include "python/src/arrays.h"

#include <cstddef>
#include <vector>

namespace soms::python {

/// Numbers, enumerations (as integers) and structures. \shape (n,).
template <class Record, class Value>
[[nodiscard]] py::array field_column(const std::vector<Record>& records, Value Record::*place,
                                     py::handle owner) {
  const void* const first = records.empty() ? nullptr : &(records.front().*place);
  return view(RowType<Value>::get(), {static_cast<py::ssize_t>(records.size())}, {sizeof(Record)},
              first, owner);
}

/// Points. \shape (n, 3).
template <class Record>
[[nodiscard]] py::array field_column(const std::vector<Record>& records, Vec3 Record::*place,
                                     py::handle owner) {
  const void* const first = records.empty() ? nullptr : &(records.front().*place);
  return view(py::dtype::of<double>(), {static_cast<py::ssize_t>(records.size()), 3},
              {sizeof(Record), sizeof(double)}, first, owner);
}

/// Their least and greatest corners. \shape (n, 2, 3).
template <class Record>
[[nodiscard]] py::array field_column(const std::vector<Record>& records, Box Record::*place,
                                     py::handle owner) {
  static_assert(sizeof(Box) == 2 * sizeof(Vec3));
  const void* const first = records.empty() ? nullptr : &(records.front().*place);
  return view(py::dtype::of<double>(), {static_cast<py::ssize_t>(records.size()), 2, 3},
              {sizeof(Record), sizeof(Vec3), sizeof(double)}, first, owner);
}

/// What a function says of each record, a copy. \shape (n,).
template <class Value, class Record, class Function>
[[nodiscard]] py::array computed_column(const std::vector<Record>& records,
                                        const Function& function) {
  py::array_t<Value> array(static_cast<py::ssize_t>(records.size()));
  Value* to = array.mutable_data();
  for (const Record& record : records) {
    *to++ = function(record);
  }
  return array;
}

}  // namespace soms::python
