#include "program/output.h"

#include "catch.h"
#include "support/error_of.h"

#include <limits>

using namespace raysteps;

TEST_CASE("numbers are written as JSON in the order in which they were given", "[command]") {
    Numbers numbers{{"scene", "a \"b\""}, {"rays", std::size_t{3}}, {"seconds", 0.1}};
    numbers["done"] = true;
    numbers["rays"] = -4;
    numbers["facts"]["whole"] = 2.0;
    numbers["facts"]["unknown"] = std::numeric_limits<double>::quiet_NaN();
    CHECK(numbers.to_json() == R"({
  "scene": "a \"b\"",
  "rays": -4,
  "seconds": 0.1,
  "done": true,
  "facts": {
    "whole": 2.0,
    "unknown": null
  }
})");
}

TEST_CASE("lists of numbers and objects are written as JSON", "[command]") {
    Numbers numbers = empty_list();
    CHECK(numbers.to_json() == "[]");
    CHECK(empty_object().to_json() == "{}");
    CHECK(Numbers().to_json() == "null");
    numbers.push_back(std::vector<std::string>{"a", "b"});
    numbers.push_back({{"x", 1}});
    CHECK(numbers.to_json() == R"([
  [
    "a",
    "b"
  ],
  {
    "x": 1
  }
])");
}

TEST_CASE("what was written as JSON is read again", "[command]") {
    Numbers numbers{{"text", "a \"b\""},  {"whole", -3},           {"count", 12345678901234567890U},
                    {"part", 0.1},        {"yes", true},           {"nothing", Numbers()},
                    {"list", {{"x", 1}}}, {"empty", empty_list()}, {"none", empty_object()}};
    numbers["values"] = std::vector<double>{1.5, 2.0};
    const Numbers again = parse_json(numbers.to_json(), "some.json");
    CHECK(again.to_json() == numbers.to_json());
    CHECK(again.at("part").number() == 0.1);
    CHECK(again.at("whole").number() == -3.0);
    CHECK(again.at("values").values().size() == 2);
    CHECK(again.find("lost") == nullptr);
}

TEST_CASE("what is missing in a JSON file is named", "[command][refusal]") {
    const Numbers numbers = parse_json(R"({"a": "text"})", "some.json");
    CHECK_THAT(error_of([&] { numbers.at("b"); }), contains_text("`b` is missing"));
    CHECK_THAT(error_of([&] { numbers.at("a").number(); }), contains_text("`\"text\"` stands"));
    CHECK_THAT(error_of([] { parse_json("{", "some.json"); }),
               contains_text("some.json: this is no JSON file"));
}
