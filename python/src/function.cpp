#include "python/src/function.h"

#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

namespace soms::python {

namespace {

/// A function of the module.
struct Function {
  std::string name;
  std::string doc;
  Parameters parameters;
  std::vector<PyObject*> names;  ///< interned, of the parameters
  std::size_t by_place = 0;      ///< how many may be passed by their place
  std::function<py::object(const Passed&)> body;
  PyMethodDef method = {};
};

/// What a function of C gets as its self: a module of its own that holds a pointer. CPython pickles
/// a function whose self is a module by its name, and one that has a capsule not at all.
py::object self_with(void* pointer) {
  static PyModuleDef definition = {PyModuleDef_HEAD_INIT,
                                   "soms",
                                   nullptr,
                                   sizeof(void*),
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr};
  py::object self = py::reinterpret_steal<py::object>(PyModule_Create(&definition));
  if (!self) {
    throw py::error_already_set();
  }
  *static_cast<void**>(PyModule_GetState(self.ptr())) = pointer;
  return self;
}

template <class T>
T& in_self(PyObject* self) {
  return *static_cast<T*>(*static_cast<void**>(PyModule_GetState(self)));
}

/// The call with names has four arguments; CPython casts it back, as the flags say.
template <class Call>
PyMethodDef method_of(const std::string& name, Call* call, const std::string& doc) {
  return {name.c_str(), reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(call)),
          METH_FASTCALL | METH_KEYWORDS, doc.c_str()};
}

void set_function(const py::module_& module, PyMethodDef& method, const py::object& self) {
  module.attr(method.ml_name) = py::reinterpret_steal<py::object>(
      PyCFunction_NewEx(&method, self.ptr(), module.attr("__name__").ptr()));
}

/// A function of pybind11, by its name.
struct Named {
  std::string name;
  std::string doc;
  py::object function;
  PyMethodDef method = {};
};

PyObject* pass_on(PyObject* self, PyObject* const* arguments, Py_ssize_t count, PyObject* names) {
  return PyObject_Vectorcall(in_self<Named>(self).function.ptr(), arguments,
                             static_cast<std::size_t>(count), names);
}

/// All of them, never given back, as modules are not unloaded.
Function& keep(Function function) {
  static auto* const all = new std::vector<std::unique_ptr<Function>>;
  return *all->emplace_back(std::make_unique<Function>(std::move(function)));
}

[[noreturn]] void refuse_call(const Function& function, const std::string& why) {
  throw py::type_error(function.name + "(): " + why);
}

std::size_t place_of(const Function& function, PyObject* name) {
  for (std::size_t i = 0; i < function.names.size(); ++i) {
    if (function.names[i] == name) {
      return i;
    }
  }
  for (std::size_t i = 0; i < function.names.size(); ++i) {  // names that are not interned
    if (PyUnicode_Compare(function.names[i], name) == 0) {
      return i;
    }
  }
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const Parameter& parameter = function.parameters[i];
    if (parameter.old_name != nullptr &&
        PyUnicode_CompareWithASCIIString(name, parameter.old_name) == 0) {
      warn_of_old_name(function.name + "()", parameter.old_name, parameter.name);
      return i;
    }
  }
  refuse_call(function, "no argument is named " + py::repr(name).cast<std::string>());
}

Passed passed_to(const Function& function, PyObject* const* arguments, std::size_t count,
                 PyObject* names) {
  if (count > function.by_place) {
    refuse_call(function, std::to_string(count) + " arguments by place, of at most " +
                              std::to_string(function.by_place));
  }
  Passed passed{};
  std::copy_n(arguments, count, passed.begin());
  const Py_ssize_t named = names == nullptr ? 0 : PyTuple_GET_SIZE(names);
  for (Py_ssize_t i = 0; i < named; ++i) {
    PyObject*& place = passed.at(place_of(function, PyTuple_GET_ITEM(names, i)));
    if (place != nullptr) {
      refuse_call(function, "an argument is given twice");
    }
    place = arguments[static_cast<Py_ssize_t>(count) + i];
  }
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    if (passed[i] == nullptr) {
      passed[i] = function.parameters[i].fallback.ptr();
      if (passed[i] == nullptr) {
        refuse_call(function,
                    std::string("the argument ") + function.parameters[i].name + " is missing");
      }
    }
  }
  return passed;
}

PyObject* enter(PyObject* self, PyObject* const* arguments, Py_ssize_t count, PyObject* names) {
  const auto& function = in_self<const Function>(self);
  try {
    const Passed passed = passed_to(function, arguments, static_cast<std::size_t>(count), names);
    return function.body(passed).release().ptr();
  } catch (py::error_already_set& error) {
    error.restore();
  } catch (const py::builtin_exception& error) {
    error.set_error();
  } catch (const Error& error) {
    set_error(error);
  } catch (const std::bad_alloc&) {
    PyErr_NoMemory();
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
  }
  return nullptr;
}

}  // namespace

void warn_of_old_name(const std::string& function, const char* old_name, const char* name) {
  const std::string text = function + ": " + old_name + " is named " + name + " now";
  if (PyErr_WarnEx(PyExc_DeprecationWarning, text.c_str(), 1) != 0) {
    throw py::error_already_set();
  }
}

Parameters with_limits(Parameters parameters) {
  parameters.push_back({"timeout", py::none(), true, "seconds"});
  parameters.push_back({"threads", py::int_(1), true});
  parameters.push_back({"progress", py::none(), true});
  return parameters;
}

void add_function(py::module_& module, const char* name, std::string doc, Parameters parameters,
                  std::function<py::object(const Passed&)> body) {
  auto* const function =
      &keep({name, std::move(doc), std::move(parameters), {}, 0, std::move(body), {}});
  for (const Parameter& parameter : function->parameters) {
    function->names.push_back(PyUnicode_InternFromString(parameter.name));
    function->by_place += parameter.is_named_only ? 0U : 1U;
  }
  function->method = method_of(function->name, &enter, function->doc);
  set_function(module, function->method, self_with(function));
}

void name_functions(const py::module_& module) {
  static auto* const all = new std::vector<std::unique_ptr<Named>>;
  const py::dict there = module.attr("__dict__").attr("copy")();
  for (const auto& [name, value] : there) {
    if (PyCFunction_Check(value.ptr()) != 0 &&
        PyCapsule_CheckExact(PyCFunction_GetSelf(value.ptr())) != 0) {
      Named& named = *all->emplace_back(std::make_unique<Named>());
      named.name = name.cast<std::string>();
      named.doc = value.attr("__doc__").is_none() ? "" : py::str(value.attr("__doc__"));
      named.function = py::reinterpret_borrow<py::object>(value);
      named.method = method_of(named.name, &pass_on, named.doc);
      set_function(module, named.method, self_with(&named));
    }
  }
}

void refuse_argument(const char* function, const char* parameter, PyObject* given) {
  PyErr_Clear();
  throw py::type_error(std::string(function) + "(): " + parameter + ": " +
                       py::repr(given).cast<std::string>() + " is of type " +
                       Py_TYPE(given)->tp_name);
}

}  // namespace soms::python
