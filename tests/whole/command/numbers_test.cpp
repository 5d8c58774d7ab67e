#include "program/output.h"

#include "catch.h"

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
