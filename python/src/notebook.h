/// \file
/// Objects that a notebook shows as a page.
#pragma once

#include <pybind11/pybind11.h>

namespace soms::python {

namespace py = pybind11;

/// Gives a class its page in a notebook. \pre soms._page is there when it is shown.
template <class Class>
void def_notebook_page(Class& of_class) {
  of_class.def(
      "_repr_html_",
      [](const py::object& self) {
        return py::module_::import("soms._page").attr("notebook_html")(self);
      },
      "_repr_html_() -> str\n\nA Page of it, as a notebook shows it.");
}

}  // namespace soms::python
