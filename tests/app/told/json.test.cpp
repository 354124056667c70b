#include "app/told/json.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace snug::app::told {
namespace {

struct Small {
  int whole_number = 0;
  std::string short_;
  SNUG_FIELDS(whole_number, short_);
};
struct Large : Small {
  using Base = Small;
  std::optional<Small> other;
  IfAny<int> level;
  IfAny<std::string> tex;
  Word<"sub", "sup"> script;
  std::vector<bool> right;
  ByName<double> readout;
  SNUG_FIELDS(other, level, tex, script, right, readout);
};

TEST_CASE("a struct is told as an object, its fields in camelCase, those of its base before its own") {
  Large told{{3, "a"}};
  told.script = std::string_view("sup");
  CHECK(json_of(told) == R"({"wholeNumber":3,"short":"a","other":null,"script":"sup","right":[],"readout":{}})");
  told.other = Small{-1, ""};
  told.level = 2;
  told.tex = std::string("x");
  told.right = {true, false};
  told.readout = {{"after_broad", 0.5}, {"radius", 2}};
  CHECK(json_of(told) == R"({"wholeNumber":3,"short":"a","other":{"wholeNumber":-1,"short":""},"level":2,"tex":"x",)"
                         R"("script":"sup","right":[true,false],"readout":{"after_broad":0.5,"radius":2}})");
}

TEST_CASE("what is 0 is told where a field holds none or a number: none alone is left out") {
  CHECK_FALSE(IfAny<int>(0).any);
  CHECK(IfAny<int>(std::optional(0)).any);
  CHECK_FALSE(IfAny<int>(std::optional<int>()).any);
}

TEST_CASE("numbers keep every bit, the sign of zero among them; what is no number is null") {
  const double third = 1.0 / 3, least = std::numeric_limits<double>::denorm_min();
  const std::vector<double> values{0.0, -0.0, 1e15, -1e15, 0.1, third, least, 1e300, 123456789012345678.0};
  CHECK(json_of(values) == "[0,-0,1e+15,-1e+15,0.1,0.3333333333333333,4.94065645841247e-324,1e+300,"
                           "1.2345678901234568e+17]");
  for (const double value : values) CHECK(std::strtod(json_of(value).c_str(), nullptr) == value);
  CHECK(json_of(std::vector<double>{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::quiet_NaN()}) == "[null,null,null]");
  CHECK(json_of(std::numeric_limits<std::uint64_t>::max()) == "18446744073709551615");
  CHECK(json_of(std::numeric_limits<std::int64_t>::min()) == "-9223372036854775808");
  CHECK(json_of(0.1F) == "0.10000000149011612");  // as the page has it, whose numbers are all double
}

TEST_CASE("a text is told as it is, but for what JSON writes in another way") {
  CHECK(json_of(std::string("\"\\\n\x1f\x7fä−")) == "\"\\\"\\\\\\u000a\\u001f\x7fä−\"");
  CHECK(json_of(std::string("a\0b", 3)) == "\"a\\u0000b\"");
  CHECK(json_of(std::array<std::string_view, 3>{"[", "{:", ""}) == R"(["[","{:",""])");
}

}  // namespace
}  // namespace snug::app::told
