// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#ifdef ELIMINANT_PROGRAM

#include <cli/program.hpp>
#include <eliminant/io/input/json_text.hpp>

using eliminant::io::JsonDocument;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const char* const sphere =
    R"({"parameters": ["s", "t", "u"], "x": "s^2+t^2+u^2", "y": "2*s*u", "z": "2*s*t", "w": "s^2-t^2-u^2"})";

}  // namespace

TEST_CASE("program: implicitize a surface, and its equation where that is asked for") {
  const TemporaryFolder folder;
  const std::string path = folder.write("sphere.json", sphere);
  const Outcome without = run_program(folder, "implicitize '" + path + "'");
  CHECK(without.status == 0);
  CHECK(without.err.empty());
  CHECK(contains(without.out, "3 x 4"));
  CHECK_FALSE(contains(without.out, "Implicit equation"));
  const Outcome with = run_program(folder, "implicitize --equation '" + path + "'");
  CHECK(with.status == 0);
  CHECK(contains(with.out, "x^2 - y^2 - z^2 - w^2 = 0"));
  const Outcome json = run_program(folder, "implicitize --equation --format json '" + path + "'");
  CHECK(json.status == 0);
  const JsonDocument result(json.out);
  CHECK(result.root().find("problem")->text == "implicitize");
  CHECK(result.root().find("representations")->elements.front().find("equation")->text == "x^2 - y^2 - z^2 - w^2");
}

TEST_CASE("program: implicitize and solve answer the same problem alike") {
  const TemporaryFolder folder;
  const std::string path = folder.write(
      "problem.json",
      std::string("{\"problem\": \"implicitize\", \"options\": {\"equation\": true}, \"surface\": ") + sphere + "}");
  const auto without_seconds = [](const std::string& text) { return text.substr(0, text.find("seconds")); };
  const Outcome solved = run_program(folder, "solve '" + path + "'");
  const Outcome implicitized = run_program(folder, "implicitize '" + path + "'");
  CHECK(solved.status == 0);
  CHECK(without_seconds(solved.out) == without_seconds(implicitized.out));
  CHECK(run_program(folder, "implicitize --echo '" + path + "'").out ==
        run_program(folder, "solve --echo '" + path + "'").out);
}

TEST_CASE("program: what implicitize refuses") {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& text, const std::string& options, int status, const std::string& message) {
    const std::string path = folder.write("problem.json", text);
    const Outcome outcome = run_program(folder, "implicitize " + options + " '" + path + "'");
    CAPTURE(text);
    CAPTURE(outcome.err);
    CHECK(outcome.status == status);
    CHECK(contains(outcome.err, message));
  };
  check(sphere, "--format csv", 2, "implicitize cannot answer in the format csv");
  check(sphere, "--certificate c.json", 2, "--certificate does not go with implicitize");
  check(sphere, "--variables x,y", 2, "variables are given");
  check(R"({"problem": "plane_curves", "p": "x", "q": "y"})", "", 2, "the problem is of the kind plane_curves");
  check(R"({"parameter": "t", "x": "t", "y": "t^2", "z": "t^3"})", "--equation", 2, "which has no single one");
  check(R"({"parameter": "t", "x": "t^200", "y": "t"})", "--equation", 3, "more than the 5460 that are computed");
  check(R"({"parameter": "t", "x": "t^2", "y": "t"})", "--time-limit 1e-9", 3, "time limit");
  check("{", "", 2, "problem.json:1:2");
  const std::string path = folder.write("problem.json", R"({"parameter": "t", "x": "t"})");
  const Outcome outcome = run_program(folder, "implicitize --format json '" + path + "'");
  CHECK(outcome.status == 2);
  CHECK(JsonDocument(outcome.out).root().find("problem")->text == "implicitize");
  const std::string verified =
      folder.write("verified.json", std::string("{\"problem\": \"implicitize\", \"surface\": ") + sphere + "}");
  CHECK(contains(run_program(folder, "verify '" + verified + "' c.csv").err, "verify is for plane_curves"));
}

#endif
