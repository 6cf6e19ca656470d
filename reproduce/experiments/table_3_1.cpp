#include "reproduce/experiments/experiments.h"

namespace soms::reproduce {

Result table_3_1(const Context& context) {
  Table table{.id = "table_3_1",
              .caption = "The objects: one row for each PLY model.",
              .columns = {{"object"}, {"file"}, {"vertices"}, {"faces"}}};
  for (const Model& model : context.models.objects) {
    table.rows.push_back({model.name, model.file,
                          static_cast<std::int64_t>(model.mesh->vertices.size()),
                          static_cast<std::int64_t>(model.mesh->triangles.size())});
  }
  return {.tables = {std::move(table)}};
}

}  // namespace soms::reproduce
