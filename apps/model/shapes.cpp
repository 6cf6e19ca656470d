#include "apps/model/shapes.h"

#include "soms/base/error.h"
#include "soms/store/tree_file.h"
#include "soms/tree/rule/rules.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/part_filter.h"

#include <fmt/format.h>

#include <utility>

namespace soms::command {

namespace {

/// What of the command line changes the mesh of a tree file, or its tree; empty if nothing does.
std::string reason_to_build(const Shape& shape, const ModelOptions& model, bool keep_tree) {
  const bool same_axis =
      model.up == UpAxis::unknown || (model.up == UpAxis::z && shape.mesh().up == UpAxis::z);
  if (model.scale != 1 || !same_axis) {
    return "the scale or the up axis changes the mesh";
  }
  if (!model.crs.empty()) {
    return "the stated coordinate reference system changes the mesh";
  }
  return keep_tree ? "a traversal by name needs the binary tree" : "";
}

/// The tree that was built is the tree that is wanted.
void check_same_tree(const std::string& path, const Shape& shape, const BuildOptions& wanted) {
  if (wanted != BuildOptions{} && wanted != shape.build_options()) {
    throw Error(
        ErrorKind::usage,
        fmt::format("{}: its tree was built already, with rule={},leaf={}", printable(path),
                    entry(shape.build_options().rule).kebab, shape.build_options().per_leaf),
        "leave the options of trees out, or build the file again with them: soms build");
  }
}

}  // namespace

Shape open_tree_file(const std::string& path, TreeCheck check, const Console& console) {
  return console.run("opening " + printable(path), [&](const Limits& limits) {
    return open_shape(path, {.check = check}, limits);
  });
}

Shape load_shape(const std::string& path, const ModelOptions& model, const ShapeOptions& shape,
                 const Console& console) {
  if (!is_tree_file(path)) {
    return build_shape(read_model(path, model, console), shape, console);
  }
  Shape opened = open_tree_file(path, TreeCheck::sound, console);
  if (const std::string reason = reason_to_build(opened, model, shape.keep_tree); !reason.empty()) {
    console.note(fmt::format("{}: its tree is built again: {}", printable(path), reason));
    return build_shape(read_model(path, model, console), shape, console);
  }
  check_same_tree(path, opened, shape.build);
  check_statements(opened.mesh(), model, path, console);
  return opened;
}

ModelShape load_model_shape(const std::string& path, const ModelOptions& model,
                            const ShapeOptions& shape, const Console& console) {
  if (!model.parts || !model.parts->is_given()) {
    return {load_shape(path, model, shape, console)};
  }
  Mesh mesh = read_model(path, model, console);
  std::optional<PartsLeft> rest = model.parts->left_of(mesh);
  const bool is_tree = is_tree_file(path);
  if (!rest) {
    return {is_tree ? load_shape(path, model, shape, console)
                    : build_shape(std::move(mesh), shape, console)};
  }
  if (rest->mesh.triangles.empty()) {
    throw Error(
        ErrorKind::usage,
        fmt::format("{}: no part of it is left by {}", printable(path), model.parts->options()),
        "give other patterns; soms info lists the parts");
  }
  if (is_tree) {
    console.note(fmt::format("{}: its tree is built again: parts are left out", printable(path)));
  }
  return {build_shape(std::move(rest->mesh), shape, console),
          std::make_shared<const Mesh>(std::move(mesh)), FileNumbers(std::move(rest->numbers))};
}

ModelShape load_only_model(const std::string& path, const ModelOptions& model,
                           const ShapeOptions& shape, const Console& console) {
  ModelShape loaded = load_model_shape(path, model, shape, console);
  if (model.parts) {
    model.parts->finish(console);
  }
  return loaded;
}

}  // namespace soms::command
