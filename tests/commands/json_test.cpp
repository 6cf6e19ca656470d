#include "apps/output/json.h"

#include "tests/support/support.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace soms::test {
namespace {

using CommandJson = command::Json;
using OtherJson = nlohmann::ordered_json;

std::string text_of(const OtherJson& value) {
  return value.dump(-1, ' ', false, OtherJson::error_handler_t::replace);
}

/// The same value in both, by members and by braces.
template <class Value>
Value made_of(double number, const std::string& text) {
  Value value{{"text", text}, {"pair", {text, number}}, {"two", {"a", "b"}}, {"none", nullptr}};
  value["list"] = Value::array({number, -3, 7U, true, {{"x", number}, {"x", 2}}});
  value["list"].push_back(Value::array());
  value["empty"] = Value::object();
  value["text"] = value["pair"];
  value.erase("two");
  return value;
}

TEST(Json, IsWrittenAsNlohmannWritesIt) {
  for (const double number :
       {0.0, -0.0, 1.0, 0.1, 1e-5, 1e15, 1e16, 123456789.125, 5e-324, 1.7976931348623157e308,
        std::nextafter(0.3, 1.0), std::numeric_limits<double>::infinity(), std::nan("")}) {
    for (const std::string text : {"", "plain", "\"\\\n\x01", "\xc3\xa9", "\xff\xc3", "\xe2\x82"}) {
      EXPECT_EQ(command::json_text(made_of<CommandJson>(number, text)),
                text_of(made_of<OtherJson>(number, text)));
    }
  }
  EXPECT_EQ(command::json_text("\x7f\xc2\x85"), "\"\\u007f\\u0085\"");
}

TEST(Json, IsReadAsNlohmannReadsIt) {
  for (const std::string text :
       {"{\"a\":1,\"b\":[-2,3.5,null,true,{\"c\":\"\xc3\xa9\"}],\"a\":\"again\"}", "[]",
        "18446744073709551615", " \"x\" "}) {
    const command::ParsedJson parsed = command::parse_json(text, 8);
    EXPECT_EQ(parsed.fault, 0U) << text;
    EXPECT_EQ(command::json_text(parsed.value), text_of(OtherJson::parse(text)));
  }
  for (const std::string text : {"", "[1,", "{\"a\" 1}", "[1] 2", "nul", "[\"\x01\"]"}) {
    std::size_t byte = 0;
    try {
      EXPECT_TRUE(OtherJson::parse(text).is_discarded()) << text;
    } catch (const OtherJson::parse_error& error) {
      byte = error.byte;
    }
    EXPECT_EQ(command::parse_json(text, 8).fault, std::max<std::size_t>(byte, 1)) << text;
  }
}

/// The line on which the byte of a fault stands.
std::size_t line_of(const std::string& text, int deepest) {
  const std::size_t fault = command::parse_json(text, deepest).fault;
  EXPECT_GT(fault, 0U);
  return 1 + static_cast<std::size_t>(std::count(
                 text.begin(), text.begin() + static_cast<std::ptrdiff_t>(fault - 1), '\n'));
}

TEST(Json, SaysOnWhichLineEachFaultStands) {
  // What is wrong on line 3, with and without something behind it.
  for (const std::string behind : {"", "\n", "\n,\n2", " ]\n}\n"}) {
    for (const std::string fault :
         {"1e999", "-1e999", "nul", "[[[1", "[[[\"a\"", "[[[{", "[[[[", "{\"a\":[[2"}) {
      const std::string text = "{\"a\":\n[\n" + fault + behind;
      EXPECT_EQ(line_of(text, 4), 3U) << text;
    }
  }
}

TEST(Json, OfManyMembersIsReadInTimeThatGrowsWithTheirNumber) {
  const auto object = [](int members, int names) {
    std::string text = "{";
    for (int k = 0; k < members; ++k) {
      text +=
          (k == 0 ? "\"name" : ",\"name") + std::to_string(k % names) + "\":" + std::to_string(k);
    }
    return text + "}";
  };
  // Sought among all before it, each of so many members would take minutes.
  for (const int names : {400'000, 200'000}) {
    const command::ParsedJson parsed = command::parse_json(object(400'000, names), 4);
    ASSERT_EQ(parsed.fault, 0U);
    ASSERT_EQ(parsed.value.size(), static_cast<std::size_t>(names));
    EXPECT_EQ(parsed.value.items().back().second.get<int>(), 399'999);
    EXPECT_EQ(parsed.value.items().back().first, "name" + std::to_string(names - 1));
  }
}

TEST(Json, IsRefusedWhereItIsTooDeep) {
  EXPECT_FALSE(command::parse_json("[[[1]]]", 3).too_deep);
  EXPECT_FALSE(command::parse_json("[[[[]]]]", 3).too_deep);
  EXPECT_TRUE(command::parse_json("[[[[1]]]]", 3).too_deep);
}

TEST(Json, OfAnotherTypeIsAnError) {
  const CommandJson value{{"a", 1}};
  EXPECT_THROW((void)value.at("b"), CommandJson::exception);
  EXPECT_THROW((void)value.at("a").get<std::string>(), CommandJson::exception);
  EXPECT_THROW((void)value.at(std::size_t{0}), CommandJson::exception);
  EXPECT_EQ(value.at("a").get<double>(), 1);
}

TEST(Json, WholeNumbersAreNotMadeOfOthers) {
  const auto read = [](const char* text) { return command::parse_json(text, 8).value; };
  for (const char* const text : {"0.5", "1e300", "-1e300", "18446744073709551616", "-1"}) {
    EXPECT_THROW((void)read(text).get<std::uint64_t>(), CommandJson::exception) << text;
  }
  EXPECT_EQ(read("1e3").get<std::uint64_t>(), 1000U);
  EXPECT_EQ(read("18446744073709551615").get<std::uint64_t>(), ~std::uint64_t{0});
  EXPECT_THROW((void)read("2147483648").get<int>(), CommandJson::exception);
  EXPECT_EQ(read("-2147483648").get<int>(), std::numeric_limits<int>::min());
  EXPECT_EQ(read("-9223372036854775808").get<std::int64_t>(),
            std::numeric_limits<std::int64_t>::min());
}

}  // namespace
}  // namespace soms::test
