#include "soms/query/body.h"
#include "soms/query/print.h"
#include "soms/store/tree_file.h"
#include "soms/tree/print.h"
#include "soms/tree/refit.h"
#include "soms/tree/shape.h"

#include "python/src/answer.h"
#include "python/src/call.h"
#include "python/src/enums.h"
#include "python/src/notebook.h"
#include "python/src/paths.h"
#include "python/src/poses.h"
#include "python/src/scene/bodies.h"
#include "python/src/text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace soms::python {

namespace {

constexpr const char* kShapeDoc =
    R"(Shape(mesh, *, rule='fast', layout='wide', per_leaf=8, level=0, threads=1, progress=None)

A mesh and the tree that queries traverse. Build it once, query it often. It does not change.

mesh: a Mesh, or an object with vertices and faces. rule: a name of Rule; answers are the same with
each. layout: 'wide' for speed (70 to 80 bytes a triangle) or 'compact' (about 12). per_leaf, level:
triangles of a leaf, levels of the tree (0: without limit). threads: 0 for all processors.
progress: called with the share done, 0 to 1.

Raises Error of kind usage. Half a second a million triangles; pickling keeps the mesh alone and
builds again, but a shape that open_shape opened is pickled as its path and hash.)";

constexpr const char* kOpenDoc =
    R"(open_shape(file, *, check='sound', load=False, threads=1) -> Shape

Opens a tree file, which Shape.save or `soms build` wrote: nothing is parsed or built. The
file is mapped, and processes share its memory. Answers are those of the shape that was saved.

file: a path, or bytes, which are copied. check: a name of TreeCheck: 'trusted' looks at the head
alone; 'safe' makes sure that queries end and touch no other memory; 'sound' finds all damage;
'full' compares every box with the triangles, so that answers are exact whoever wrote the file.
load: copy the file into memory of the process, which no other shares; the file may change.

Raises Error of kind cannot_open, bad_file (names section and record), unsupported (another version
of the format: build it again).)";

constexpr const char* kBodyDoc = R"(Body(shape, pose=None, name='')

A shape at a place, as queries take it. It does not change: at(pose) gives another.

shape: a Shape or Mesh, or an object with vertices and faces (a tree is built then). pose: as Pose
takes it.)";

Shape make_shape(const py::object& given, const ShapeOptions& options, int threads,
                 const py::object& progress) {
  auto mesh = mesh_of(given, "mesh");
  return run(Work::many, threads, progress,
             [&](const Limits& limits) { return Shape(std::move(mesh), options, limits); });
}

Shape refitted(const Shape& shape, const py::object& vertices, int threads) {
  std::vector<Vec3> moved = points_of(vertices, "vertices").copied();
  return run(Work::many, threads, py::none(),
             [&](const Limits& limits) { return refit(shape, std::move(moved), limits); });
}

void save_shape(const Shape& shape, const py::object& place) {
  const std::filesystem::path path = path_of(place);
  run(Work::many, 1, py::none(), [&](const Limits&) {
    save(path, shape);
    return true;
  });
}

Shape opened_shape(const py::object& file, const py::object& check, bool load, int threads) {
  const OpenOptions options{.check = enum_of<TreeCheck>(check, "check"), .load = load};
  if (PyObject_CheckBuffer(file.ptr()) != 0) {
    const std::vector<std::byte> bytes = bytes_of(file);
    return run(Work::many, threads, py::none(),
               [&](const Limits& limits) { return open_shape(bytes, "bytes", options, limits); });
  }
  const std::filesystem::path path = path_of(file);
  return run(Work::many, threads, py::none(),
             [&](const Limits& limits) { return open_shape(path, options, limits); });
}

/// Shapes of tree files that were unpickled last: the tasks of one process name the same few.
class OpenedFiles {
 public:
  /// \errors ErrorKind::bad_file where the file is another one since it was pickled.
  [[nodiscard]] Shape get(const std::filesystem::path& path, std::uint64_t hash) {
    const std::lock_guard lock(mutex_);
    const auto known = std::find_if(shapes_.begin(), shapes_.end(), [&](const Shape& shape) {
      return shape.tree_file()->hash == hash && shape.tree_file()->path == path.string();
    });
    if (known != shapes_.end()) {
      return *known;
    }
    Shape shape = open_shape(path);
    if (shape.tree_file()->hash != hash) {
      throw Error(ErrorKind::bad_file,
                  path.string() + ": not the tree file that the shape was opened from",
                  "open it again, and pickle that shape");
    }
    if (shapes_.size() == kMost) {
      shapes_.erase(shapes_.begin());
    }
    shapes_.push_back(shape);
    return shape;
  }

 private:
  static constexpr std::size_t kMost = 4;

  std::mutex mutex_;
  std::vector<Shape> shapes_;
};

Shape shape_of_file(const Text& path, std::uint64_t hash) {
  static OpenedFiles files;
  return run(Work::many, 1, py::none(), [&](const Limits&) { return files.get(path.bytes, hash); });
}

/// Of a shape from a file its path and hash; of others the mesh and how the tree is built.
py::tuple shape_state(const Shape& shape) {
  if (const TreeFileName* const file = shape.tree_file();
      file != nullptr && is_tree_file(std::filesystem::path(file->path))) {
    return py::make_tuple(Text{std::filesystem::absolute(file->path).string()}, file->hash);
  }
  const BuildOptions& options = shape.build_options();
  return py::make_tuple(std::const_pointer_cast<Mesh>(shape.shared_mesh()),
                        member(options.rule).attr("name"), member(shape.layout_kind()).attr("name"),
                        options.per_leaf, options.level);
}

ShapeOptions shape_options(const py::object& rule, const py::object& layout, int per_leaf,
                           int level) {
  ShapeOptions options;
  options.build.rule = enum_of<Rule>(rule, "rule");
  options.build.per_leaf = per_leaf;
  options.build.level = level;
  options.layout = enum_of<Layout>(layout, "layout");
  return options;
}

Shape shape_from(const py::tuple& state) {
  if (state.size() == 2) {
    return shape_of_file(state[0].cast<Text>(), state[1].cast<std::uint64_t>());
  }
  return make_shape(state[0],
                    shape_options(state[1], state[2], state[3].cast<int>(), state[4].cast<int>()),
                    1, py::none());
}

void bind_shape(py::module_& module) {
  py::class_<Shape> shape(module, "Shape", kShapeDoc);
  shape.def(py::init([](const py::object& mesh, const py::object& rule, const py::object& layout,
                        int per_leaf, int level, int threads, const py::object& progress) {
              return make_shape(mesh, shape_options(rule, layout, per_leaf, level), threads,
                                progress);
            }),
            py::arg("mesh"), py::kw_only(), py::arg("rule") = "fast", py::arg("layout") = "wide",
            py::arg("per_leaf") = 8, py::arg("level") = 0, py::arg("threads") = 1,
            py::arg("progress") = py::none());
  shape.def_property_readonly(
      "mesh", [](const Shape& s) { return std::const_pointer_cast<Mesh>(s.shared_mesh()); },
      "The mesh.");
  shape.def_property_readonly(
      "rule", [](const Shape& s) { return member(s.build_options().rule); },
      "Rule that it was built by.");
  shape.def_property_readonly(
      "layout", [](const Shape& s) { return member(s.layout_kind()); }, "Layout of its tree.");
  shape.def_property_readonly("memory", &Shape::memory, "Bytes of mesh and tree.");
  shape.def_property_readonly("sah_degradation", &Shape::sah_degradation,
                              "How far the tree has fallen behind by refit: 1 as built.");
  shape.def_property_readonly("build_is_due", &build_is_due,
                              "True if a new build pays after refits.");
  shape.def("refit", &refitted, py::arg("vertices"), py::kw_only(), py::arg("threads") = 1,
            "refit(vertices, *, threads=1) -> Shape\n\nThe same triangles with moved vertices, "
            "(n, 3): half the time of a build. This shape stays.");
  shape.def("save", &save_shape, py::arg("path"),
            "save(path)\n\nWrites a tree file (.somst), which open_shape opens; it appears whole "
            "or not at all.\n\nRaises Error of kind cannot_write.");
  shape.def_property_readonly(
      "tree_file",
      [](const Shape& s) -> py::object {
        const TreeFileName* const file = s.tree_file();
        return file == nullptr ? py::object(py::none()) : py::cast(Text{file->path});
      },
      "Path of the tree file that it was opened from, or None.");
  shape.def("__len__", [](const Shape& s) { return s.mesh().triangles.size(); });
  shape.def(
      "__eq__", [](const Shape& a, const Shape& b) { return a == b; }, py::is_operator());
  module.def("open_shape", &opened_shape, py::arg("file"), py::kw_only(),
             py::arg("check") = "sound", py::arg("load") = false, py::arg("threads") = 1, kOpenDoc);
  shape.attr("__hash__") = py::none();
  def_notebook_page(shape);
  shape.def("__repr__", &printed<Shape>);
  shape.def(py::pickle(&shape_state, &shape_from));
}

void bind_body(py::module_& module) {
  py::class_<Body> body(module, "Body", kBodyDoc);
  body.def(py::init([](const py::object& shape, const py::object& pose, Text name) {
             return Body(shape_of(shape, "shape"), pose.is_none() ? Pose() : pose_of(pose),
                         std::move(name.bytes));
           }),
           py::arg("shape"), py::arg("pose") = py::none(), py::arg("name") = "");
  body.def_readonly("shape", &Body::shape, "The Shape.");
  body.def_readonly("pose", &Body::pose, "The Pose.");
  body.def_property_readonly(
      "name", [](const Body& b) { return Text{b.name}; }, "The name.");
  body.def(
      "at",
      [](const Body& b, const py::object& pose) { return Body(b.shape, pose_of(pose), b.name); },
      py::arg("pose"), "at(pose) -> Body\n\nThe same shape at another pose; nothing is built.");
  body.def(
      "__eq__", [](const Body& a, const Body& b) { return a == b; }, py::is_operator());
  body.attr("__hash__") = py::none();
  def_notebook_page(body);
  body.def("__repr__", &printed<Body>);
  body.def(py::pickle([](const Body& b) { return py::make_tuple(b.shape, b.pose, Text{b.name}); },
                      [](const py::tuple& s) {
                        return Body(s[0].cast<Shape>(), s[1].cast<Pose>(), s[2].cast<Text>().bytes);
                      }));
}

}  // namespace

void bind_shapes(py::module_& module) {
  bind_shape(module);
  bind_body(module);
}

}  // namespace soms::python
