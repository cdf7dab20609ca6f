// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <string>

#include <eliminant/io/results/json_layout.hpp>

using eliminant::io::json_layout;
using eliminant::io::json_line;
using eliminant::io::json_on_one_line;
using Json = nlohmann::ordered_json;

TEST_CASE("JSON layout: joined into one line it is the line of the same value") {
  Json wide = Json::array();
  for (int i = 0; i < 100; ++i) wide.push_back({{"number", i}, {"text", std::string(30, 'x')}});
  for (const Json& value :
       {Json(), Json(1), Json("a,\n  b"), Json::array(), Json::object(), Json{{"a", Json::array()}}, wide,
        Json{{"list", wide}, {"quoted \" \\", "ends with a comma,"}, {"deep", Json::array({wide, wide})}}}) {
    for (const std::size_t width : {0U, 20U, 160U}) {
      CAPTURE(width);
      CHECK(json_on_one_line(json_layout(value, width)) == json_line(value));
    }
  }
}
