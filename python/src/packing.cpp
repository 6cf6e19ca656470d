#include "python/src/packing.h"

namespace soms::python {

void refuse_pickle() {
  throw Error(ErrorKind::bad_file, "pickle: its bytes are damaged", "make the answer again");
}

py::tuple pickle_state(const std::string& bytes) {
  return py::make_tuple(SOMS_PYTHON_VERSION, py::bytes(bytes));
}

std::string_view pickled_bytes(const py::tuple& state) {
  if (state.size() < 2 || !py::isinstance<py::bytes>(state[1])) {
    refuse_pickle();
  }
  const std::string version = py::str(state[0]).cast<std::string>();
  if (version != SOMS_PYTHON_VERSION) {
    throw Error(ErrorKind::bad_file,
                "pickle: of soms " + version + ", this is " SOMS_PYTHON_VERSION,
                "make the answer again");
  }
  char* data = nullptr;
  py::ssize_t size = 0;
  if (PyBytes_AsStringAndSize(py::object(state[1]).ptr(), &data, &size) != 0) {
    throw py::error_already_set();
  }
  return {data, static_cast<std::size_t>(size)};
}

}  // namespace soms::python
