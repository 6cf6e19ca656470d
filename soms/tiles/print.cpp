// Tiles, and how they are cut and opened, printed by `<<`.

#include "soms/base/print.h"

#include "soms/base/print_fields.h"
#include "soms/tiles/cut_tiles.h"
#include "soms/tiles/tile_set.h"
#include "soms/tree/print.h"

namespace soms {

std::ostream& operator<<(std::ostream& out, const TileSource& value) {
  return out << PrintedFields("TileSource")
                    .add("file", value.file)
                    .add("first", value.first)
                    .add("triangles", value.triangles)
                    .add("hash", value.hash);
}

std::ostream& operator<<(std::ostream& out, const Tile& value) {
  return out << PrintedFields("Tile")
                    .add("file", value.file)
                    .add("ids", value.ids)
                    .add("hash", value.hash)
                    .add("ids_hash", value.ids_hash)
                    .add("bytes", value.bytes)
                    .add("triangles", value.triangles)
                    .add("source", value.source)
                    .add("splits_part", value.splits_part)
                    .add("bounds", value.bounds);
}

std::ostream& operator<<(std::ostream& out, const TileManifest& value) {
  return out << PrintedFields("TileManifest")
                    .item(printed_count(value.sources.size(), "source", "sources"))
                    .item(printed_count(value.tiles.size(), "tile", "tiles"));
}

std::ostream& operator<<(std::ostream& out, const TileOptions& value) {
  return out << PrintedFields("TileOptions")
                    .add("max_memory", value.max_memory)
                    .add("check", value.check);
}

std::ostream& operator<<(std::ostream& out, const OpenTile& value) {
  return out << PrintedFields("OpenTile").add("shape", value.shape);
}

std::ostream& operator<<(std::ostream& out, const TileSet& value) {
  return out << PrintedFields("TileSet")
                    .add("folder", value.folder().string())
                    .item(printed_count(value.triangles(), "triangle", "triangles"))
                    .item(printed_count(value.tiles().size(), "tile", "tiles"));
}

std::ostream& operator<<(std::ostream& out, const TiledBody& value) {
  return out << PrintedFields("TiledBody").add("tiles", value.tiles).add("pose", value.pose);
}

std::ostream& operator<<(std::ostream& out, const CutOptions& value) {
  return out << PrintedFields("CutOptions").add("most", value.most).add("shape", value.shape);
}

std::ostream& operator<<(std::ostream& out, const TileCut& value) {
  return out << PrintedFields("TileCut")
                    .item(printed_count(value.triangles.size(), "triangle", "triangles"))
                    .add("splits_part", value.splits_part);
}

}  // namespace soms
