// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/io/input/json_text.hpp>
#include <random>
#include <string>

using namespace eliminant;
using namespace eliminant::io;

TEST_CASE("JsonDocument: bare numbers keep their digits") {
  const std::string long_integer(400, '7');
  const JsonDocument document("{\"a\": 1e400, \"b\": [-0.10, " + long_integer + ", 1E-400], \"c\": \"1e5 \\\" 2\"}");
  CHECK(document.root().find("a")->text == "1e400");
  CHECK(document.root().find("b")->elements[0].text == "-0.10");
  CHECK(document.root().find("b")->elements[1].text == long_integer);
  CHECK(document.root().find("b")->elements[2].text == "1E-400");
  CHECK(document.root().find("c")->text == "1e5 \" 2");
  CHECK(document.root().find("c")->kind == JsonValue::Kind::text);
  CHECK(document.root().find("d") == nullptr);
}

TEST_CASE("JsonDocument: every value and name knows its place") {
  const JsonDocument document("{\n  \"a\": [1,\n    {\"b\": null}],\n  \"c\": true\n}");
  const JsonValue& array = *document.root().find("a");
  CHECK(document.place_of(array).line == 2);
  CHECK(document.place_of(array).column == 8);
  CHECK(document.place_of(array.elements[0]).column == 9);
  CHECK(document.place_of(array.elements[1]).line == 3);
  CHECK(document.place_of(*array.elements[1].find("b")).column == 11);
  CHECK(document.place_of(document.root().members[1].offset).line == 4);
}

TEST_CASE("JsonDocument: places inside a text count its escapes as they stand") {
  const JsonDocument document(R"({"p": "\u0061\tx\ud83d\ude00y"})");
  const JsonValue& text = *document.root().find("p");
  CHECK(text.text == "a\tx\xF0\x9F\x98\x80y");
  const Locate locate = document.locate_inside(text);
  CHECK(locate(0).column == 8);
  CHECK(locate(1).column == 14);
  CHECK(locate(2).column == 16);
  CHECK(locate(7).column == 29);
}

TEST_CASE("JsonDocument: random changes of a document never crash") {
  const std::string original =
      R"({"problem": "plane_curves", "p": "x^2\u00e9 - y", "box": [[-1, 2.5e3], ["1/3", null]], "t": true})";
  std::mt19937_64 random(5);
  for (int round = 0; round < 20'000; ++round) {
    std::string text = original;
    for (std::size_t change = 0; change <= random() % 3; ++change) {
      const std::size_t at = random() % text.size();
      const char c = "\"\\{}[],:0-.eutn \n\x01"[random() % 18];
      if (random() % 3 == 0)
        text.erase(at, 1 + random() % 5);
      else
        text.insert(at, 1, c);
      if (text.empty()) text = " ";
    }
    CAPTURE(text);
    try {
      const JsonDocument document(text);
    } catch (const ParseError& error) {
      CHECK(error.place().line > 0);
      CHECK_FALSE(error.expected().empty());
    }
  }
}
