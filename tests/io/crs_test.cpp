#include "soms/io/crs.h"

#include "soms/io/detail/cityjson/epsg_units.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace soms::test {
namespace {

TEST(Crs, HasOneNameInEveryFormOfTheRegistry) {
  for (const char* const text :
       {"EPSG:7415", "epsg:7415", " EPSG: 7415 ", "urn:ogc:def:crs:EPSG::7415",
        "urn:ogc:def:crs:EPSG:7415", "urn:ogc:def:crs:EPSG:9.8.15:7415",
        "urn:x-ogc:def:crs:EPSG:6.11:7415", "http://www.opengis.net/def/crs/EPSG/0/7415",
        "http://www.opengis.net/def/crs/EPSG/0/7415/",
        "https://www.opengis.net/def/crs/EPSG/9.9/7415",
        "http://www.opengis.net/gml/srs/epsg.xml#7415"}) {
    EXPECT_EQ(crs_name(text), "EPSG:7415") << text;
  }
  for (const char* const text :
       {"EPSG:28992+5709", "EPSG:28992+EPSG:5709", "urn:ogc:def:crs,crs:EPSG::28992,crs:EPSG::5709",
        "http://www.opengis.net/def/crs-compound?1=http://www.opengis.net/def/crs/EPSG/0/28992&"
        "2=http://www.opengis.net/def/crs/EPSG/0/5709"}) {
    EXPECT_EQ(crs_name(text), "EPSG:28992+5709") << text;
  }
}

TEST(Crs, KeepsOtherNames) {
  for (const char* const text :
       {"", "EPSG", "EPSG:", "EPSG:x", "EPSG:1x", "EPSG:99999999999", "7415", "ESRI:102100",
        "EPSG:28992+", "ETRS89 / UTM 33N", "https://www.opengis.net/def/crs/OGC/0/CRS84", "local/",
        "PROJCS[\"a, b\"]", "+proj=utm +zone=33"}) {
    EXPECT_EQ(crs_name(text), text);
    EXPECT_EQ(crs_axes(crs_name(text)), CrsAxes{}) << text;
  }
}

TEST(Crs, KnowsTheUnitsOfTheRegistry) {
  const double survey_foot = 1200.0 / 3937;
  EXPECT_EQ(crs_axes("EPSG:25833"), (CrsAxes{.unit = 1}));
  EXPECT_EQ(crs_axes("EPSG:7415"), (CrsAxes{.unit = 1})) << "compound";
  EXPECT_EQ(crs_axes("EPSG:28992+5709"), (CrsAxes{.unit = 1}));
  EXPECT_EQ(crs_axes("EPSG:4978"), (CrsAxes{.unit = 1})) << "geocentric";
  EXPECT_DOUBLE_EQ(crs_axes("EPSG:2263").unit, survey_foot) << "New York Long Island";
  EXPECT_EQ(crs_axes("EPSG:2222"), (CrsAxes{.unit = 0.3048})) << "Arizona East";
  EXPECT_EQ(crs_axes("EPSG:2263+5703"), CrsAxes{}) << "feet, and meters of height";
  EXPECT_EQ(crs_axes("EPSG:4326"), (CrsAxes{.angles = true}));
  EXPECT_EQ(crs_axes("EPSG:4979"), (CrsAxes{.angles = true}));
  EXPECT_EQ(crs_axes("EPSG:4326+5703"), (CrsAxes{.angles = true}));
  EXPECT_EQ(crs_axes("EPSG:1"), CrsAxes{}) << "no system";
  EXPECT_EQ(crs_axes("EPSG:2181"), CrsAxes{}) << "none, behind one";
  EXPECT_EQ(crs_axes("EPSG:25833+1"), CrsAxes{});
}

TEST(Crs, HasSortedRunsOfCodes) {
  std::uint32_t end = 0;
  std::size_t codes = 0;
  for (const detail::EpsgRun& run : detail::epsg_runs()) {
    EXPECT_GE(run.first, end);
    EXPECT_GT(run.count, 0U);
    EXPECT_GE(detail::epsg_meters(run), 0);
    end = run.first + run.count;
    codes += run.count;
  }
  EXPECT_GT(codes, 6000U);
}

}  // namespace
}  // namespace soms::test
