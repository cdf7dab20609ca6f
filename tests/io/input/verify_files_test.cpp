// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/plane_curves/certificate_check.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/io/input/candidates_file.hpp>
#include <eliminant/io/input/problem_file.hpp>
#include <eliminant/io/results/certificate_json.hpp>

using namespace eliminant;
using namespace eliminant::io;
using symbolic::Rational;

namespace {

struct Refused {
  std::string message;
  SourcePlace place;
};

template <class Read>
Refused refused(Read read) {
  try {
    read();
  } catch (const InvalidInput& error) {
    return {error.what(), error.place()};
  }
  return {"accepted", {}};
}

Refused refused_candidates(const std::string& text) {
  return refused([&] { return read_candidates(text); });
}

}  // namespace

TEST_CASE("certificate file: reading gives back what was written") {
  for (const auto& [p, q] :
       {std::pair{"(x-1)^2+y^2-1", "x*(y-2)"}, {"(x-y)*(x+2*y)-1/3", "(x-y)*(x+3*y)-1"}, {"x*(x-y)", "x*(y-3)^2"}}) {
    CAPTURE(p);
    const auto problem = std::get<intersect::PlaneCurvesProblem>(problem_from_arguments(p, q, std::nullopt).problem);
    intersect::Options options;
    options.certificate = true;
    const intersect::Result result = intersect::intersect_plane_curves(problem, options, Context());
    REQUIRE(result.certificate.has_value());
    const std::string text = certificate_json(*result.certificate);
    const intersect::Certificate again = read_certificate(text);
    CHECK(certificate_json(again) == text);
    CHECK(again.balls.size() == result.certificate->balls.size());
    CHECK(intersect::check_certificate(problem, again, Context()).empty());
  }
}

TEST_CASE("certificate file: bad ones are refused with their place") {
  const std::string good =
      "{\"format\": 1, \"certificate\": \"plane_curves\", \"variables\": [\"x\", \"y\"],\n"
      "\"p\": \"x\", \"q\": \"y\", \"at_infinity\": 0, \"shears\": [],\n"
      "\"balls\": [{\"x\": [\"0\", \"0\"], \"y\": [\"0\", \"0\"], \"radius\": \"1e-9\", \"multiplicity\": 1, \"real\": "
      "true}]}";
  CHECK(read_certificate(good).balls.size() == 1);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return refused([&] { return read_certificate(text); });
  };
  CHECK(with("\"format\": 1", "\"format\": 2").place.line == 1);
  CHECK(with("plane_curves", "cylinders").message.find("cylinders") != std::string::npos);
  CHECK(with("\"p\": \"x\"", "\"p\": \"x+\"").place.line == 2);
  CHECK(with("\"p\": \"x\", ", "").message == "the field \"p\" is missing");
  CHECK(with("\"1e-9\"", "\"0.1\"").place.line == 3);
  CHECK(with("\"1e-9\"", "\"1e-999999999\"").place.line == 3);
  CHECK(with("\"1e-9\"", "1e-9").message.find("\"radius\"") == 0);
  CHECK(with("\"multiplicity\": 1", "\"multiplicity\": 0").place.line == 3);
  CHECK(with("\"multiplicity\": 1", "\"multiplicity\": 1.5").place.line == 3);
  CHECK(with("\"real\": true", "\"real\": 1").place.line == 3);
  CHECK(with("[\"0\", \"0\"]", "[\"0\"]").place.line == 3);
  CHECK(with("[\"0\", \"0\"]", "[\"0\", \"zero\"]").place.line == 3);
  CHECK(with("\"shears\": []", "\"shears\": [1e9]").place.line == 2);
  CHECK(with("\"shears\": []", "\"shears\": {}").place.line == 2);
  CHECK(with("\"balls\"", "\"bells\"").message.find("unknown field") == 0);
  CHECK(with("[{", "[3, {").message.find("a ball is") == 0);
  CHECK(with("\"variables\": [\"x\", \"y\"]", "\"variables\": [\"x\", \"x\"]").place.line == 1);
}

TEST_CASE("candidates: CSV with and without header, JSON results and bare lists") {
  const CandidatesFile plain = read_candidates("0.5, -1/3\n2,0x1p-1\n");
  CHECK(plain.real_only);
  REQUIRE(plain.candidates.size() == 2);
  CHECK(plain.candidates[0].y_real == Rational(-1) / Rational(3));
  CHECK(plain.candidates[1].y_real == Rational(1) / Rational(2));
  CHECK_FALSE(plain.candidates[0].multiplicity.has_value());
  CHECK(read_candidates("1,2,3\n").candidates[0].multiplicity == 3UL);
  const CandidatesFile complex = read_candidates("# mine\r\n\r\n1,2,3,4,5\r\n");
  CHECK_FALSE(complex.real_only);
  CHECK(complex.candidates[0].x_imaginary == Rational(2));
  CHECK(complex.candidates[0].multiplicity == 5UL);
  const CandidatesFile result =
      read_candidates("x_re,x_im,y_re,y_im,radius,real,multiplicity,certified\n1e-3,0,1,-2,1e-15,true,4,true\n");
  CHECK(result.candidates[0].x_real == Rational(1) / Rational(1000));
  CHECK(result.candidates[0].y_imaginary == Rational(-2));
  CHECK(result.candidates[0].multiplicity == 4UL);
  const CandidatesFile named = read_candidates("y,x\n1,2\n");
  CHECK(named.candidates[0].x_real == Rational(2));
  const CandidatesFile json = read_candidates(
      R"({"status": "numeric", "solutions": [{"x": ["1", 2], "y": 0.25, "multiplicity": 2, "radius": "1e-3"}]})");
  CHECK_FALSE(json.real_only);
  CHECK(json.candidates[0].x_imaginary == Rational(2));
  CHECK(json.candidates[0].y_real == Rational(1) / Rational(4));
  CHECK(read_candidates("[]").candidates.empty());
  CHECK(read_candidates("x,y\n").candidates.empty());
}

TEST_CASE("candidates: bad files are refused with their place") {
  CHECK(refused_candidates("1,2\n1,nan\n").place.line == 2);
  CHECK(refused_candidates("1,2\n1,nan\n").place.column == 3);
  CHECK(refused_candidates("1,2\n1\n").place.line == 2);
  CHECK(refused_candidates("1\n").place.line == 1);
  CHECK(refused_candidates("1,2,3,4,5,6\n").place.line == 1);
  CHECK(refused_candidates("1,2,0\n").place.column == 5);
  CHECK(refused_candidates("1,2,1.5\n").place.column == 5);
  CHECK(refused_candidates("x,y,x\n1,2,3\n").message.find("twice") != std::string::npos);
  CHECK(refused_candidates("x,z\n1,2\n").place.line == 1);
  CHECK(refused_candidates("# nothing\n").message == "the table of candidates is empty");
  CHECK(refused_candidates("{\"solution\": []}").message == "the field \"solutions\" is missing");
  CHECK(refused_candidates("[{\"x\": 1}]").message == "the field \"y\" is missing");
  CHECK(refused_candidates("[{\"x\": [1,2,3], \"y\": 0}]").place.column == 8);
  CHECK(refused_candidates("[{\"x\": NaN, \"y\": 0}]").place.column == 8);
  CHECK(refused_candidates("[{\"x\": 1, \"y\": 0, \"multiplicity\": -1}]").message.find("-1") != std::string::npos);
  CHECK(refused_candidates("[1]").place.column == 2);
}
