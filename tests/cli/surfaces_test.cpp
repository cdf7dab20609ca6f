// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#ifdef ELIMINANT_PROGRAM

#include <cli/program.hpp>
#include <eliminant/io/input/json_text.hpp>

using eliminant::io::JsonDocument;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string two_patches = R"({"problem": "surface_surface", "id": 7,
  "first": {"parameters": ["a", "b"], "x": "a", "y": "b", "z": "0", "domain": [[0, 1], [0, 1]]},
  "second": {"parameters": ["a", "b"], "x": "a", "y": "1/2", "z": "b - 1/2", "domain": [[0, 1], [0, 1]]}})";

const std::string itself = R"({"problem": "self_intersection",
  "surface": {"parameters": ["s", "t"], "x": "s^2", "y": "s*t", "z": "t", "domain": [[-1, 1], [-1, 1]]}})";

}  // namespace

TEST_CASE("program: the options of traced curves are echoed") {
  const TemporaryFolder folder;
  const std::string path = folder.write("p.json", two_patches);
  const Outcome first = run_program(folder, "solve '" + path + "' --tolerance 1e-6 --bspline --equation --echo");
  CHECK(first.status == 0);
  CHECK(contains(first.out, "\"problem\": \"surface_surface\""));
  CHECK(contains(first.out, R"("options": {"equation": true, "bspline": true, "tolerance": "1e-06"})"));
  const Outcome second = run_program(folder, "solve --echo '" + folder.write("echo.json", first.out) + "'");
  CHECK(second.out == first.out);
  const Outcome third = run_program(folder, "solve --echo --tolerance 1e-9 '" + folder.file("echo.json") + "'");
  CHECK_FALSE(contains(third.out, "tolerance"));
  const Outcome surface = run_program(folder, "solve --echo '" + folder.write("i.json", itself) + "'");
  CHECK(surface.status == 0);
  CHECK(contains(surface.out, "\"surface\": {\"parameters\""));
}

TEST_CASE("program: certificates and verify do not go with surfaces") {
  const TemporaryFolder folder;
  for (const auto& [kind, text] : {std::pair("surface_surface", two_patches), std::pair("self_intersection", itself)}) {
    const std::string path = folder.write("p.json", text);
    for (const std::string& arguments : {"solve '" + path + "' --certificate '" + folder.file("c.json") + "'",
                                         "verify '" + path + "' candidates.csv"}) {
      CAPTURE(arguments);
      const Outcome outcome = run_program(folder, arguments + " --format json");
      CHECK(outcome.status == 2);
      CHECK(JsonDocument(outcome.out).root().find("problem")->text == kind);
      CHECK(contains(outcome.err, "plane_curves"));
    }
  }
}

TEST_CASE("program: patches with a part in common are an answer, in every format and as a picture") {
  const TemporaryFolder folder;
  const std::string path = folder.write("p.json", R"({"problem": "surface_surface",
  "first": {"parameters": ["a", "b"], "x": "a", "y": "b", "z": "a*b", "domain": [[0, 1], [0, 1]]},
  "second": {"parameters": ["a", "b"], "x": "b", "y": "a", "z": "a*b", "domain": [["1/2", 2], ["-1", "1/4"]]}})");
  const Outcome json = run_program(folder, "solve '" + path + "' --tolerance 1e-3 --bspline --format json");
  CHECK(json.status == 0);
  const JsonDocument document(json.out);
  CHECK(document.root().find("status")->text == "infinite");
  CHECK(document.root().find("rest_status")->text == "certified");
  CHECK(document.root().find("counts")->find("overlaps")->text == "1");
  const auto& overlap = document.root().find("components")->elements.at(0);
  CHECK(overlap.find("kind")->text == "overlap");
  // x from 0 to 1/4, y from 1/2 to 1: a hyperbolic paraboloid with straight borders.
  CHECK(overlap.find("points")->elements.size() == 5);
  CHECK(overlap.find("points")->elements.at(2).find("z")->text == "0.25");
  const Outcome text = run_program(folder, "solve '" + path + "'");
  CHECK(text.status == 0);
  CHECK(contains(text.out, "Rest:   certified"));
  CHECK(contains(text.out, "1  common part of both surfaces"));
  const Outcome csv = run_program(folder, "solve '" + path + "' --format csv");
  CHECK(contains(csv.out, "0,overlap,0.25,1,1,0.25,0.25,1,0.25"));
  folder.write("r.json", json.out);
  CHECK(run_program(folder, "report '" + folder.file("r.json") + "' -o '" + folder.file("r.svg") + "'").status == 0);
}

TEST_CASE("program: --tolerance is checked wherever it stands") {
  const TemporaryFolder folder;
  const std::string path = folder.write("p.json", two_patches);
  for (const char* value : {"0", "-1", "1", "nan", "1e-9x", "''"}) {
    CAPTURE(value);
    const Outcome outcome = run_program(folder, "solve '" + path + "' --tolerance " + value);
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.err, "option tolerance"));
  }
  const std::string bad = two_patches.substr(0, two_patches.size() - 1) + ",\n\"options\": {\"tolerance\": \"0\"}}";
  const Outcome outcome = run_program(folder, "solve '" + folder.write("bad.json", bad) + "'");
  CHECK(outcome.status == 2);
  CHECK(contains(outcome.err, "bad.json:4:26: option tolerance is '0'; expected a positive number"));
}

#endif
