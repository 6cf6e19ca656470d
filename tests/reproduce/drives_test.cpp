// The experiment of the drives: contact frames apart from free ones, and rates of mean frames.
#include "soms/generate/shapes.h"
#include "soms/query/reference/overlap.h"

#include "tests/reproduce/trips.h"
#include "thesis/races/touching_drive.h"
#include "thesis/run/traversal_tables.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {
namespace {

using trips::cell;
using trips::run_quick;
using trips::table_of;

/// The generated scenes, and a knot about as large as the bunny in its place.
Models knot_and_scenes() {
  Models models = find_models({}, {.scenes = true});
  Model knot;
  knot.name = "knot";
  knot.title = "knot";
  knot.stand_in = true;
  knot.mesh = std::make_shared<const Mesh>(transformed(generate_knot(300), 0.06, UpAxis::z));
  models.objects.push_back(knot);
  return models;
}

TEST(Drives, HaveGoldenCounts) {
  const Models models = knot_and_scenes();
  const Result result = run_quick("drives", models);
  const Table& table = table_of(result, "drives");
  ASSERT_EQ(table.rows.size(), 3U * 2 * 2 * 2);
  std::map<std::string, std::string> found;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (cell(table, i, "algorithm") == "enode_larger") {
      found[cell(table, i, "static") + " " + cell(table, i, "rule") + " " +
            cell(table, i, "test")] =
          cell(table, i, "contact_frames") + " " + cell(table, i, "contacts") + " " +
          cell(table, i, "box_tests") + " " + cell(table, i, "triangle_tests");
    }
  }
  // Spatial median stops at the large triangles of u_mixed and u_boxes: no triangles are tested.
  EXPECT_EQ(found, (std::map<std::string, std::string>{
                       {"u_mixed soms drive", "203 13090 328557 97309"},
                       {"u_mixed soms touching_drive", "67 2336 122165 5324"},
                       {"u_mixed spatial_median drive", "  113787 "},
                       {"u_mixed spatial_median touching_drive", "  126191 "},
                       {"u_boxes soms drive", "202 7216 90505 16076"},
                       {"u_boxes soms touching_drive", "76 1844 64487 4052"},
                       {"u_boxes spatial_median drive", "  48735 "},
                       {"u_boxes spatial_median touching_drive", "  127495 "},
                       {"u_plain soms drive", "41 848 17975 2400"},
                       {"u_plain soms touching_drive", "119 5666 80889 12170"},
                       {"u_plain spatial_median drive", "41 848 9057 2400"},
                       {"u_plain spatial_median touching_drive", "119 5666 49023 12170"}}));
}

TEST(Drives, TimeFramesOfEachKindOnlyWhereThereAreSome) {
  const Models models = trips::small_models();
  const Result result = run_quick("drives", models);
  const Table& table = table_of(result, "drives");
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto value = [&](std::string_view column) {
      for (std::size_t k = 0; k < table.columns.size(); ++k) {
        if (table.columns[k].name == column) {
          return table.rows[i][k];
        }
      }
      return Cell{};
    };
    const std::string contact = cell(table, i, "contact_frames");
    const bool all_free = contact == "0";
    EXPECT_EQ(std::holds_alternative<double>(value("contact_fps")), !all_free);
    EXPECT_EQ(std::holds_alternative<double>(value("free_fps")),
              contact != cell(table, i, "frames"));
    if (!all_free) {
      EXPECT_DOUBLE_EQ(std::get<double>(value("contact_fps")),
                       1000 / std::get<double>(value("contact_frame_time")));
    }
  }
}

/// Draws nothing, finds the contacts by brute force, and takes 1 ms without drawing, 2 and 6 with.
DrawnFrames pretend_to_draw(const DrawRequest& request) {
  DrawnFrames drawn{.device = "none", .width = 640, .height = 480, .passes = 1};
  for (const Vec3& by : request.offsets) {
    drawn.frames.push_back(
        {.alone = {.move = 0.25, .query = 0.75},
         .drawn = {.move = 1, .query = 1},
         .draw = 6,
         .contacts = reference::overlap(*request.still, Pose::identity(), *request.moving,
                                        Pose::translation(by.x, by.y, by.z))
                         .pairs.size()});
  }
  return drawn;
}

Result run_drawn(const DrawFrames& draw) {
  const Models models = trips::small_models();
  const std::string_view item = "drives-drawn";
  return experiments_named(std::span(&item, 1))
      .front()
      ->run({.models = models, .quick = true, .draw = draw});
}

TEST(DrivesDrawn, HaveRatesWithDrawingAndWithout) {
  const Result result = run_drawn(pretend_to_draw);
  const Table& table = table_of(result, "drives_drawn");
  ASSERT_EQ(table.rows.size(), 2U * 2 * 2);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    EXPECT_EQ(cell(table, i, "frames"), "6");
    EXPECT_NE(cell(table, i, "contact_frames"), "0");
  }
  const std::string csv = to_csv(table);
  EXPECT_NE(csv.find(",1,2,6,1000,125,1,2,6,1000,125,none\n"), std::string::npos) << csv;
  ASSERT_EQ(result.figures.size(), 1U);
  EXPECT_TRUE(result.figures[0].timed);
  EXPECT_NE(result.figures[0].caption.find("Drawing takes 75.0 to 75.0 % of a drawn frame"),
            std::string::npos)
      << result.figures[0].caption;
}

TEST(DrivesDrawn, SayWhyNothingWasDrawn) {
  for (const DrawFrames& draw : {DrawFrames{}, DrawFrames{[](const DrawRequest&) {
                                   return DrawnFrames{.trouble = "dark"};
                                 }}}) {
    const Result result = run_drawn(draw);
    const Table& table = table_of(result, "drives_drawn");
    EXPECT_NE(table.caption.find(draw ? "nothing was drawn (dark)"
                                      : "nothing was drawn (this run has no program that draws)"),
              std::string::npos)
        << table.caption;
    EXPECT_TRUE(result.figures.empty());
    for (const auto& row : table.rows) {
      EXPECT_EQ(row.back(), Cell{});
    }
  }
}

TEST(DrivesDrawn, EndTheRunWhereADrawnFrameHasOtherContacts) {
  EXPECT_THROW((void)run_drawn([](const DrawRequest& request) {
                 DrawnFrames drawn = pretend_to_draw(request);
                 ++drawn.frames.front().contacts;
                 return drawn;
               }),
               std::logic_error);
}

TEST(FrameRates, AreThoseOfTheMeanFrameNotTheMeanOfRates) {
  std::vector<Cell> row;
  add_rate_cells(row, {1, 1, 4});
  ASSERT_EQ(row.size(), 4U);
  EXPECT_EQ(row, (std::vector<Cell>{500.0, 1000.0, 250.0, 1000.0}));
  add_rate_cells(row, {});
  EXPECT_EQ(row.size(), 8U);
  EXPECT_EQ(rate_cell(0), Cell{});
}

}  // namespace
}  // namespace soms::reproduce
