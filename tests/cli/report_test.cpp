// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#ifdef ELIMINANT_PROGRAM

#include <cli/program.hpp>

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const char* const loop_in_patches = R"({"format": 1, "problem": "surface_surface", "status": "certified",
  "counts": {"curves": 0, "loops": 1}, "domains": {"u": ["0", "1"], "v": ["0", "1"], "s": ["0", "1"], "t": ["0", "1"]},
  "components": [{"kind": "loop", "error": "1e-9", "certified": true, "points": [
   {"u": "0.25", "v": "0.25", "s": "0.5", "t": "0.5", "x": "0", "y": "0", "z": "0"},
   {"u": "0.75", "v": "0.25", "s": "0.5", "t": "0.75", "x": "1", "y": "0", "z": "0"},
   {"u": "0.5", "v": "0.75", "s": "0.75", "t": "0.5", "x": "0", "y": "1", "z": "0"},
   {"u": "0.25", "v": "0.25", "s": "0.5", "t": "0.5", "x": "0", "y": "0", "z": "0"}]}],
  "singular_points": []})";

}  // namespace

TEST_CASE("report: a picture as SVG and as HTML, by the name of the file") {
  const TemporaryFolder folder;
  const std::string result = folder.write("result.json", loop_in_patches);
  const Outcome svg = run_program(folder, "report '" + result + "' -o '" + folder.file("picture.svg") + "'");
  CHECK(svg.status == 0);
  CHECK(svg.out.empty());
  CHECK(svg.err.empty());
  const std::string picture = folder.read("picture.svg");
  CHECK(picture.starts_with("<svg"));
  CHECK(contains(picture, "On the first surface"));
  CHECK(contains(picture, "On the second surface"));
  CHECK(run_program(folder, "report -o '" + folder.file("page.html") + "' - <'" + result + "'").status == 0);
  const std::string page = folder.read("page.html");
  CHECK(page.starts_with("<!DOCTYPE html>"));
  CHECK(contains(page, picture));
  // The same bytes each time.
  CHECK(run_program(folder, "report '" + result + "' -o '" + folder.file("again.svg") + "'").status == 0);
  CHECK(folder.read("again.svg") == picture);
}

TEST_CASE("report: results of the program itself") {
  const TemporaryFolder folder;
  const std::string curve = folder.write("curve.json", R"({"problem": "curve_topology", "p": "x^2 + y^2 - 1"})");
  for (const std::string& command : {"solve '" + curve + "'", std::string("curves 'x^2+y^2-5' 'x*y-2'")}) {
    CAPTURE(command);
    const Outcome solved = run_program(folder, command + " --format json -o '" + folder.file("result.json") + "'");
    CHECK(solved.status == 0);
    const Outcome outcome =
        run_program(folder, "report '" + folder.file("result.json") + "' -o '" + folder.file("picture.svg") + "'");
    CHECK(outcome.status == 0);
    CHECK(contains(folder.read("picture.svg"), "<circle"));
  }
}

TEST_CASE("report: what is no result is bad input, and nothing is written") {
  const TemporaryFolder folder;
  const std::string picture = folder.file("picture.svg");
  const auto check = [&](const std::string& path, const char* message) {
    const Outcome outcome = run_program(folder, "report '" + path + "' -o '" + picture + "'");
    CAPTURE(path);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(contains(outcome.err, message));
    CHECK_FALSE(std::filesystem::exists(picture));
  };
  check(folder.file("missing.json"), "cannot be opened");
  check(folder.write("empty.json", ""), "is empty");
  check(folder.write("text.json", "Status: certified"), "text.json:1:1: unexpected 'Status'");
  check(folder.write("problem.json", R"({"problem": "surface_surface", "first": {}, "second": {}})"),
        "problem.json:1:1: this is no result");
  check(folder.write("error.json", "{\"format\": 1, \"problem\": \"plane_curves\",\n\"status\": \"error\"}"),
        "error.json:2:11: this result is an error");
  check(folder.write("curves.json", R"({"format": 1, "problem": "curve_curve", "status": "certified"})"),
        "no picture of results of the kind \"curve_curve\"");
}

TEST_CASE("report: a picture that cannot be written is status 1, another format bad usage") {
  const TemporaryFolder folder;
  const std::string result = folder.write("result.json", loop_in_patches);
  CHECK(run_program(folder, "report '" + result + "' -o '" + folder.file("missing/picture.svg") + "'").status == 1);
  std::filesystem::create_directory(folder.file("folder.html"));
  CHECK(run_program(folder, "report '" + result + "' -o '" + folder.file("folder.html") + "'").status == 1);
  const Outcome usage = run_program(folder, "report '" + result + "' -o picture.png");
  CHECK(usage.status == 2);
  CHECK(contains(usage.err, "-o FILE.svg or -o FILE.html"));
  CHECK(run_program(folder, "report '" + result + "'").status == 2);
}

#endif
