// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#ifdef ELIMINANT_PROGRAM

#include <cli/bad_input_table.hpp>
#include <cli/program.hpp>
#include <eliminant/io/input/json_text.hpp>

using eliminant::io::JsonDocument;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("program: every bad input of the table gives its exit status, message and error result") {
  const TemporaryFolder folder;
  for (const bad_input::Row& row : bad_input::rows()) {
    CAPTURE(row.what);
    const std::string path = folder.write("problem." + row.extension, row.text);
    const Outcome outcome = run_program(folder, "solve --format json '" + path + "'");
    CAPTURE(outcome.err);
    CHECK(outcome.status == (row.kind == "limit" ? 3 : 2));
    CHECK(contains(outcome.err, path + ":" + std::to_string(row.line) + ":" + std::to_string(row.column) + ": "));
    CHECK(contains(outcome.err, row.message));
    const JsonDocument result(outcome.out);
    CHECK(result.root().find("status")->text == "error");
    CHECK(result.root().find("error")->find("kind")->text == row.kind);
    CHECK(result.root().find("error")->find("column")->text == std::to_string(row.column));
  }
}

TEST_CASE("program: what is no text file is bad input") {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& path, const char* message) {
    const Outcome outcome = run_program(folder, "solve '" + path + "'");
    CAPTURE(path);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(contains(outcome.err, message));
  };
  check(folder.file("."), "is a directory");
  check(folder.file("missing.json"), "cannot be opened");
  check(folder.write("empty.json", ""), "is empty");
  check(folder.write("blank.json", " \n\t\n"), "is empty");
  check(folder.write("binary.json", std::string("\x7F"
                                                "ELF\0\0\1",
                                                7)),
        "is binary");
  check(folder.write("latin.json", "{\"problem\": \"\xE9\"}"), "no valid UTF-8");
  check(folder.write("utf16.json", "\xFF\xFE{ }"), "UTF-16");
  check("/dev/zero", "is binary");
}

TEST_CASE("program: a wrong command line is bad usage") {
  const TemporaryFolder folder;
  for (const char* arguments : {"",
                                "solve",
                                "sovle file",
                                "curves x",
                                "curves x y x",
                                "curves x y --fromat json",
                                "curves x y --digits",
                                "curves x y --digits 0",
                                "curves x y --digits many",
                                "curves x y --real --complex",
                                "curves x --y",
                                "batch",
                                "verify",
                                "verify p.json",
                                "verify p.json c.csv --certificate c.json",
                                "verify - -",
                                "implicitize",
                                "implicitize a.json b.json",
                                "curves x y --box '[[0,1]]'",
                                "curves x y --box '[[0,1],[1'",
                                "curves x y --variables x",
                                "curves x y --variables x,x",
                                "curves 'x+' y",
                                "curves x y --precision 54",
                                "curves x y --engine box",
                                "curves x y --time-limit 0",
                                "curves x y --threads 0",
                                "curves x y --seed -1",
                                "curves x y --epsilon nan",
                                "curves x y --tolerance 0",
                                "curves x y --tolerance 1",
                                "curves x y --tolerance -1e-9",
                                "report",
                                "report result.json",
                                "report result.json -o picture.pdf",
                                "report result.json -o picture",
                                "curves x y --memory-limit 1.5",
                                "solve a.json b.json"}) {
    CAPTURE(arguments);
    const Outcome outcome = run_program(folder, arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("eliminant: "));
  }
  const Outcome json = run_program(folder, "curves x --format json");
  CHECK(json.status == 2);
  CHECK(JsonDocument(json.out).root().find("error")->find("kind")->text == "usage");
}

TEST_CASE("program: an output that cannot be written is status 1") {
  const TemporaryFolder folder;
  CHECK(run_program(folder, "curves x y -o '" + folder.file("missing/result") + "'").status == 1);
  CHECK(run_program(folder, "curves x y -o '" + folder.file(".") + "'").status == 1);
  if (std::filesystem::exists("/dev/full")) {
    CHECK(run_program(folder, "curves x y -o /dev/full").status == 1);
    CHECK(run_program(folder, "curves x y >/dev/full").status == 1);
    CHECK(run_program(folder, "--help >/dev/full").status == 1);
  }
}

TEST_CASE("program: a polynomial may begin with a minus sign") {
  const TemporaryFolder folder;
  for (const char* arguments : {"curves -x+1 y --echo", "curves --echo -x+1 y", "curves --echo -- -x+1 y",
                                "--echo curves -x+1 y", "curves -x+1 --digits 20 -y --echo"}) {
    CAPTURE(arguments);
    const Outcome outcome = run_program(folder, arguments);
    CHECK(outcome.status == 0);
    CHECK(contains(outcome.out, "\"p\": \"-x + 1\""));
  }
}

TEST_CASE("program: the echo of a problem is a problem with the same echo") {
  const TemporaryFolder folder;
  const Outcome first = run_program(
      folder, "curves '2e-3 ab - 1/3' '(a-b)^2' --variables b,a --box '[[-1, \"1/2\"], [0, 1e2]]' --digits 30 --echo");
  CHECK(first.status == 0);
  CHECK(contains(first.out, "\"digits\": \"30\""));
  const Outcome second = run_program(folder, "solve --echo '" + folder.write("echo.json", first.out) + "'");
  CHECK(second.out == first.out);
  const Outcome third = run_program(folder, "solve --echo --digits 31 - <'" + folder.file("echo.json") + "'");
  CHECK(contains(third.out, "\"digits\": \"31\""));
}

TEST_CASE("program: help and version are answers") {
  const TemporaryFolder folder;
  CHECK(contains(run_program(folder, "--version").out, "eliminant "));
  const Outcome help = run_program(folder, "curves --help");
  CHECK(help.status == 0);
  for (const char* option :
       {"--format",   "--digits",     "--engine",      "--matrix",       "--precision", "--epsilon",
        "--real",     "--complex",    "--certify",     "--no-certify",   "--box",       "--variables",
        "--threads",  "--time-limit", "--certificate", "--memory-limit", "--output",    "--echo",
        "--progress", "--quiet",      "--seed",        "--tolerance",    "--equation",  "--bspline"})
    CHECK(contains(help.out, option));
}

TEST_CASE("program: an answer goes to standard output alone, or to the file") {
  const TemporaryFolder folder;
  const Outcome json = run_program(folder, "curves 'x^2+y^2-5' 'x*y-2' --format json --quiet");
  CHECK(json.status == 0);
  CHECK(json.err.empty());
  CHECK(JsonDocument(json.out).root().find("format")->text == "1");
  const Outcome filed =
      run_program(folder, "curves 'x^2+y^2-5' 'x*y-2' --format csv --quiet -o '" + folder.file("r") + "'");
  CHECK(filed.status == 0);
  CHECK(filed.out.empty());
  CHECK(folder.read("r").starts_with("x_re,x_im,y_re,y_im,radius,real,multiplicity,certified\n"));
}

TEST_CASE("program: a certificate is written, and verify accepts it, but no corrupted one") {
  const TemporaryFolder folder;
  const std::string problem = folder.write(
      "p.json", R"json({"problem": "plane_curves", "p": "(x-1)^2 + y^2 - 1", "q": "x*(y-2)", "id": 7})json");
  const std::string certificate = folder.file("c.json");
  CHECK(run_program(folder, "solve '" + problem + "' --certificate '" + certificate + "'").status == 0);
  const std::string verify = "verify '" + problem + "' --format json --certificate '";
  const Outcome accepted = run_program(folder, verify + certificate + "'");
  CHECK(accepted.status == 0);
  CHECK(contains(accepted.out, "\"verdict\": \"accepted\""));
  CHECK(contains(accepted.out, "\"id\": 7"));
  std::string text = folder.read("c.json");
  text.replace(text.find("\"real\": true"), 12, "\"real\": false");
  const Outcome refused = run_program(folder, verify + folder.write("corrupted.json", text) + "'");
  CHECK(refused.status == 0);
  CHECK(contains(refused.out, "\"verdict\": \"refused\""));
  CHECK(run_program(folder, verify + folder.write("none.json", "{}") + "'").status == 2);
  CHECK(run_program(folder, verify + folder.file("missing.json") + "'").status == 2);
  CHECK(contains(run_program(folder, verify + folder.write("empty.json", "") + "'").err, "empty.json"));
  CHECK(run_program(folder, "solve '" + problem + "' --certificate same -o same").status == 2);
  CHECK(run_program(folder, "solve '" + problem + "' --certificate /nowhere/c.json").status == 1);
}

TEST_CASE("program: verify compares its own results and somebody's floats") {
  const TemporaryFolder folder;
  const std::string problem =
      folder.write("p.json", R"json({"problem": "plane_curves", "p": "(x-1)^2 + y^2 - 1", "q": "x*(y-2)"})json");
  for (const char* format : {"csv", "json"}) {
    const Outcome result = run_program(folder, "solve '" + problem + "' --format " + format);
    const Outcome verdict = run_program(folder, "verify '" + problem + "' '" + folder.write("r", result.out) + "'");
    CHECK(verdict.status == 0);
    CHECK(contains(verdict.out, "Verdict: accepted"));
  }
  const Outcome verdict = run_program(
      folder, "verify --tolerance 1e-3 '" + problem + "' '" + folder.write("f.csv", "x,y\n0.0001,0\n1,1\n") + "'");
  CHECK(verdict.status == 0);
  CHECK(contains(verdict.out, "Verdict: refused"));
  CHECK(contains(verdict.out, "candidate 1 is within 1.1e-04 of (0, 0)"));
  CHECK(contains(verdict.out, "candidate 2: the nearest solution"));
  const Outcome bad = run_program(folder, "verify '" + problem + "' '" + folder.write("b.csv", "x,y\n0,inf\n") + "'");
  CHECK(bad.status == 2);
  CHECK(contains(bad.err, "b.csv:2:3: "));
  CHECK(run_program(folder, "verify '" + problem + "' '" + folder.file("f.csv") + "' --format csv").status == 2);
  CHECK(run_program(folder, "verify '" + problem + "' '" + folder.file("f.csv") + "' --tolerance 2").status == 2);
}

TEST_CASE("program: certificates and verify are for plane curves, and say so") {
  const TemporaryFolder folder;
  const std::string curve = R"({"parameter": "t", "x": "t", "y": "t^2"})";
  const std::string problem = folder.write(
      "p.json", R"({"problem": "curve_curve", "id": 7, "first": )" + curve + R"(, "second": {"implicit": "x - y"}})");
  const std::string certificate = folder.file("c.json");
  for (const std::string& arguments :
       {"solve '" + problem + "' --certificate '" + certificate + "'",
        "verify '" + problem + "' --certificate '" + certificate + "'", "verify '" + problem + "' candidates.csv"}) {
    CAPTURE(arguments);
    const Outcome outcome = run_program(folder, arguments + " --format json");
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.err, "p.json: "));
    CHECK(contains(outcome.err, "plane_curves"));
    const JsonDocument result(outcome.out);
    CHECK(result.root().find("problem")->text == "curve_curve");
    CHECK(result.root().find("id")->text == "7");
    CHECK(result.root().find("error")->find("kind")->text == "invalid_input");
  }
  CHECK_FALSE(std::filesystem::exists(certificate));
}

TEST_CASE("program: an error names the kind of its problem, null where it is unknown") {
  const TemporaryFolder folder;
  const auto problem_of = [&](const std::string& arguments) {
    const Outcome outcome = run_program(folder, arguments + " --format json");
    CHECK(outcome.status == 2);
    const JsonDocument result(outcome.out);
    const eliminant::io::JsonValue* const problem = result.root().find("problem");
    return problem->kind == eliminant::io::JsonValue::Kind::null ? "null" : problem->text;
  };
  const auto kind_in = [&](const std::string& text) {
    return problem_of("solve '" + folder.write("p.json", text) + "'");
  };
  CHECK(kind_in(R"({"problem": "curve_surface", "curve": 1})") == "curve_surface");
  CHECK(kind_in(R"({"first": 1, "problem": "curve_curve"})") == "curve_curve");
  CHECK(kind_in(R"({"problem": "plane_curves", "p": "x +", "q": "y"})") == "plane_curves");
  CHECK(kind_in(R"({"problem": "plane_curves", )") == "null");
  CHECK(problem_of("solve '" + folder.write("p.ms", "x, y\n0\nx +, y\n") + "'") == "plane_curves");
  CHECK(problem_of("curves x+ y") == "plane_curves");
  CHECK(problem_of("solve") == "null");
}

TEST_CASE("program: the topology of a plane curve in every format, and what does not go with it") {
  const TemporaryFolder folder;
  const std::string path = folder.write("curve.json", R"({"problem": "curve_topology", "p": "x^2 + y^2 - 1"})");
  const Outcome json = run_program(folder, "solve --format json '" + path + "'");
  CHECK(json.status == 0);
  const JsonDocument result(json.out);
  CHECK(result.root().find("status")->text == "certified");
  CHECK(result.root().find("counts")->find("loops")->text == "1");
  CHECK(result.root().find("vertices")->elements.size() == 2);
  CHECK(result.root().find("edges")->elements.size() == 2);
  const Outcome csv = run_program(folder, "solve --format csv '" + path + "'");
  CHECK(csv.status == 0);
  CHECK(csv.out ==
        "kind,type,x,y,radius,left,right,vertical,milnor_number,on_border,certified\n"
        "critical,,-1,0,1e-14,0,2,0,0,false,true\n"
        "critical,,1,0,1e-14,2,0,0,0,false,true\n");
  const Outcome text = run_program(folder, "solve '" + path + "'");
  CHECK(text.status == 0);
  CHECK(contains(text.out, "every vertex and every arc proven"));
  const Outcome echo = run_program(folder, "solve --echo '" + path + "'");
  CHECK(contains(echo.out, "\"problem\": \"curve_topology\""));
  CHECK(run_program(folder, "solve --certificate c.json '" + path + "'").status == 2);
  CHECK(run_program(folder, "solve --engine box '" + path + "'").status == 2);
  CHECK(run_program(folder, "verify '" + path + "' '" + path + "'").status == 2);
  const std::string constant = folder.write("constant.json", R"({"problem": "curve_topology", "p": "1"})");
  const Outcome refused = run_program(folder, "solve --format json '" + constant + "'");
  CHECK(refused.status == 2);
  CHECK(contains(refused.out, "the equation of a curve is constant"));
}

#endif
