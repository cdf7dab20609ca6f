// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace bad_input {

/// One bad input and what is said of it, by the library and by the program.
struct Row {
  std::string what;
  /// The extension of the problem file.
  std::string extension;
  std::string text;
  std::string kind;  ///< `parse_error`, `invalid_input` (both exit 2) or `limit` (exit 3)
  std::size_t line;
  std::size_t column;
  std::string message;   ///< a part of the message
  std::string expected;  ///< a part of what was expected
};

// A plane_curves problem with this p; its first character stands in column 35.
inline std::string with_p(const std::string& p) {
  return "{\"problem\": \"plane_curves\", \"p\": \"" + p + "\", \"q\": \"y\"}";
}

// A complete problem with one more field, which begins in column 49.
inline std::string with_field(const std::string& field) {
  return "{\"problem\": \"plane_curves\", \"p\": \"x\", \"q\": \"y\", " + field + "}";
}

inline std::vector<Row> rows() {
  const std::string parse = "parse_error";
  const std::string invalid = "invalid_input";
  const std::string limit = "limit";
  const auto many = [](std::size_t count, char c) { return std::string(count, c); };
  return {
      // The polynomial grammar.
      {"empty polynomial", "json", with_p(""), parse, 1, 35, "p: the polynomial is empty", "a polynomial"},
      {"missing operand", "json", with_p("x +"), parse, 1, 38, "unexpected end of the polynomial", "a number"},
      {"two operators", "json", with_p("x+*y"), parse, 1, 37, "unexpected '*'", "a variable (x, y)"},
      {"missing parenthesis", "json", with_p("(x+1"), parse, 1, 39, "unexpected end", "')'"},
      {"surplus parenthesis", "json", with_p("x+1)"), parse, 1, 38, "unexpected ')'", "the end"},
      {"empty parentheses", "json", with_p("2*()"), parse, 1, 38, "unexpected ')'", "a number"},
      {"square brackets", "json", with_p("[x]"), parse, 1, 35, "unexpected '['", "round parentheses"},
      {"two numbers", "json", with_p("2 3"), parse, 1, 37, "unexpected '3'", "an operator"},
      {"number behind a variable", "json", with_p("x 2"), parse, 1, 37, "unexpected '2'", "an operator"},
      {"two decimal points", "json", with_p("1.2.3"), parse, 1, 38, "unexpected '.3'", "an operator"},
      {"decimal comma", "json", with_p("1,5*x"), parse, 1, 36, "unexpected ','", "the decimal sign is a point"},
      {"equation", "json", with_p("x = 1"), parse, 1, 37, "unexpected '='", "left side minus right side"},
      {"typographic minus", "json", with_p("x \xE2\x88\x92 1"), parse, 1, 37, "unexpected", "ASCII minus"},
      {"superscript", "json", with_p("x\xC2\xB2"), parse, 1, 36, "unexpected", "x^2"},
      {"question mark", "json", with_p("x?"), parse, 1, 36, "unexpected '?'", "one of + - * / ^ ( )"},
      {"division by a variable", "json", with_p("1/x"), parse, 1, 37, "division by an expression", "a number"},
      {"division by zero", "json", with_p("x/0"), parse, 1, 37, "division by zero", "non-zero"},
      {"negative exponent", "json", with_p("x^-1"), parse, 1, 38, "exponent is negative", "whole number >= 0"},
      {"fractional exponent", "json", with_p("x^0.5"), parse, 1, 37, "not a whole number", "whole number >= 0"},
      {"variable as exponent", "json", with_p("x^y"), parse, 1, 37, "exponent has variables", "whole number >= 0"},
      {"function", "json", with_p("sin(x)"), parse, 1, 35, "'sin' looks like a function", "a polynomial"},
      {"second line", "json", with_p("x\\n+ *y"), parse, 1, 40, "unexpected '*'", "a number"},
      // Variables.
      {"three variables", "json", with_p("x*z"), invalid, 1, 47, "q: a third variable 'y'", "two variables"},
      {"undeclared variable", "json",
       "{\"problem\": \"plane_curves\", \"variables\": [\"x\", \"y\"],\n \"p\": \"x + z\", \"q\": \"y\"}", parse, 2, 12,
       "unknown variable 'z'", "x, y or a product"},
      {"one declared variable", "json", with_field("\"variables\": [\"x\"]"), invalid, 1, 62, "1 variables",
       "two names"},
      {"three declared variables", "json", with_field("\"variables\": [\"x\", \"y\", \"z\"]"), invalid, 1, 62,
       "3 variables", "two names"},
      {"variable declared twice", "json", with_field("\"variables\": [\"x\", \"x\"]"), invalid, 1, 62, "twice",
       "two different"},
      {"variable that is no name", "json", with_field("\"variables\": [\"x\", \"2\"]"), invalid, 1, 62, "no name",
       "letters"},
      {"variables as text", "json", with_field("\"variables\": \"x,y\""), invalid, 1, 62, "is a text", "an array"},
      {"variable as number", "json", with_field("\"variables\": [\"x\", 1]"), invalid, 1, 68, "is a number", "a name"},
      // The fields of a problem.
      {"array as problem", "json", "[1]", invalid, 1, 1, "the problem is an array", "an object"},
      {"text as problem", "json", "\"x\"", invalid, 1, 1, "the problem is a text", "an object"},
      {"no kind", "json", "{\"p\": \"x\", \"q\": \"y\"}", invalid, 1, 1, "\"problem\" is missing", "plane_curves"},
      {"kind as number", "json", "{\"problem\": 3}", invalid, 1, 13, "is a number", "plane_curves"},
      {"unknown kind", "json", "{\"problem\": \"curves\"}", invalid, 1, 13, "unknown problem kind", "plane_curves"},
      {"surface with itself", "json", "{\"problem\": \"self_intersection\", \"surface\": {}}", invalid, 1, 45,
       "\"parameters\" is missing", "\"parameters\": [\"s\", \"t\"]"},
      {"equation with itself", "json", "{\"problem\": \"self_intersection\", \"surface\": {\"implicit\": \"x*y*z\"}}",
       invalid, 1, 45, "\"surface\" is given by an equation", "a surface with parameters"},
      {"nothing with itself", "json", "{\"problem\": \"self_intersection\"}", invalid, 1, 1,
       "\"curve\" or \"surface\" is missing", "one curve or one surface"},
      {"curve and surface with themselves", "json",
       "{\"problem\": \"self_intersection\", \"curve\": {}, \"surface\": {}}", invalid, 1, 1,
       "\"curve\" and \"surface\" are both there", "one curve or one surface"},
      {"no first surface", "json", "{\"problem\": \"surface_surface\"}", invalid, 1, 1, "\"first\" is missing",
       "a surface"},
      {"no second surface", "json", "{\"problem\": \"surface_surface\", \"first\": {\"implicit\": \"x\"}}", invalid, 1,
       1, "\"second\" is missing", "a surface"},
      {"two equations of surfaces", "json",
       "{\"problem\": \"surface_surface\", \"first\": {\"implicit\": \"x\"},\n\"second\": {\"implicit\": \"y\"}}",
       invalid, 2, 11, "both given by equations", "at least one surface with parameters"},
      {"surfaces with a curve", "json", "{\"problem\": \"surface_surface\", \"curve\": {}}", invalid, 1, 32,
       "unknown field \"curve\"", "first, second"},
      {"extraction without a cloud", "json", "{\"problem\": \"cylinder_extraction\"}", invalid, 1, 1,
       "the field \"cloud\" is missing", "the path of a point cloud"},
      {"cloud that is not there", "json",
       "{\"problem\": \"cylinder_extraction\", \"cloud\": \"/nowhere/scan.ply\", \"distance\": 1}", invalid, 1, 45,
       "the cloud '/nowhere/scan.ply' cannot be opened", "a point cloud"},
      {"no points", "json", "{\"problem\": \"cylinders\"}", invalid, 1, 1, "\"points\" is missing", "five points"},
      {"four points", "json", "{\"problem\": \"cylinders\", \"points\": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]}", invalid, 1,
       36, "holds 4 points", "five points"},
      {"six points", "json", "{\"problem\": \"cylinders\",\n\"points\": [[0],[1],[2],[3],[4],[5]]}", invalid, 2, 11,
       "holds 6 points", "five points"},
      {"points as object", "json", "{\"problem\": \"cylinders\", \"points\": {}}", invalid, 1, 36,
       "\"points\" is an object", "five points"},
      {"plane point", "json", "{\"problem\": \"cylinders\",\n\"points\": [[0,0,0],[1,0],[0,1,0],[0,0,1],[1,1,1]]}",
       invalid, 2, 20, "point 2 has 2 numbers", "[x, y, z]"},
      {"point as number", "json", "{\"problem\": \"cylinders\",\n\"points\": [[0,0,0],[1,0,0],7,[0,0,1],[1,1,1]]}",
       invalid, 2, 28, "point 3 is a number", "[x, y, z]"},
      {"point with a word", "json",
       "{\"problem\": \"cylinders\",\n\"points\": [[0,0,0],[1,0,0],[0,\"y\",0],[0,0,1],[1,1,1]]}", parse, 2, 32,
       "y of point 3", "a number"},
      {"point with null", "json",
       "{\"problem\": \"cylinders\",\n\"points\": [[0,0,0],[1,0,0],[0,null,0],[0,0,1],[1,1,1]]}", invalid, 2, 31,
       "y of point 3 is null", "a number"},
      {"no p", "json", "{\"problem\": \"plane_curves\", \"q\": \"y\"}", invalid, 1, 1, "\"p\" is missing",
       "a polynomial"},
      {"no q", "json", "{\"problem\": \"plane_curves\", \"p\": \"y\"}", invalid, 1, 1, "\"q\" is missing",
       "a polynomial"},
      {"p is null", "json", "{\"problem\": \"plane_curves\", \"p\": null, \"q\": \"y\"}", invalid, 1, 34,
       "\"p\" is null", "a polynomial"},
      {"p is an array", "json", "{\"problem\": \"plane_curves\", \"p\": [1], \"q\": \"y\"}", invalid, 1, 34,
       "\"p\" is an array", "a polynomial"},
      {"q is true", "json", "{\"problem\": \"plane_curves\", \"p\": \"x\",\n\"q\": true}", invalid, 2, 6,
       "\"q\" is true", "a polynomial"},
      {"unknown field", "json", with_field("\"boks\": 1"), invalid, 1, 49, "unknown field \"boks\"", "variables, box"},
      {"id as object", "json", with_field("\"id\": {}"), invalid, 1, 55, "\"id\" is an object", "a text or a whole"},
      {"id beyond 64 bits", "json", with_field("\"id\": 9223372036854775808"), invalid, 1, 55, "more than 64 bits",
       "a whole number from -2^63"},
      {"id as fraction", "json", with_field("\"id\": 1.5"), invalid, 1, 55, "\"id\" is a number", "a text or a whole"},
      // The box.
      {"box as number", "json", with_field("\"box\": 1"), invalid, 1, 56, "\"box\" is a number", "[[x lower"},
      {"flat box", "json", with_field("\"box\": [0, 1]"), invalid, 1, 57, "a side of \"box\"", "[lower, upper]"},
      {"box of three sides", "json", with_field("\"box\": [[0,1],[0,1],[0,1]]"), invalid, 1, 56, "of 3 values",
       "[[x lower"},
      {"reversed box", "json", with_field("\"box\": [[0, 1], [1, 0]]"), invalid, 1, 65, "empty", "lower <= upper"},
      {"infinite box", "json", with_field("\"box\": [[0, \"inf\"], [0, 1]]"), parse, 1, 62, "box: unexpected 'inf'",
       "a number"},
      {"box with null", "json", with_field("\"box\": [[0, null], [0, 1]]"), invalid, 1, 61, "is null", "a number"},
      {"box with zero denominator", "json", with_field("\"box\": [[0, \"1/0\"], [0, 1]]"), parse, 1, 64,
       "denominator of a number is zero", "non-zero"},
      // Options.
      {"options as array", "json", with_field("\"options\": []"), invalid, 1, 60, "\"options\" is an array",
       "an object"},
      {"unknown option", "json", with_field("\"options\": {\"digit\": 3}"), invalid, 1, 61, "unknown option 'digit'",
       "digits"},
      {"no digits", "json", with_field("\"options\": {\"digits\": 0}"), invalid, 1, 71, "digits is '0'", "from 1 to"},
      {"fractional digits", "json", with_field("\"options\": {\"digits\": 1.5}"), invalid, 1, 71, "digits is '1.5'",
       "whole number"},
      {"unknown engine", "json", with_field("\"options\": {\"engine\": \"magic\"}"), invalid, 1, 71,
       "engine is 'magic'", "auto, pencil, exact"},
      {"precision between", "json", with_field("\"options\": {\"precision\": 100}"), invalid, 1, 74,
       "precision is '100'", "128"},
      {"switch as text", "json", with_field("\"options\": {\"real\": \"yes\"}"), invalid, 1, 69, "real is a text",
       "true or false"},
      {"negative time", "json", with_field("\"options\": {\"time-limit\": -1}"), invalid, 1, 75, "time-limit is '-1'",
       "a positive number"},
      {"no tolerance", "json", with_field("\"options\": {\"tolerance\": 0}"), invalid, 1, 74, "tolerance is '0'",
       "a positive number"},
      {"tolerance of everything", "json", with_field("\"options\": {\"tolerance\": 1}"), invalid, 1, 74,
       "tolerance is '1'", "between 0 and 1"},
      {"tolerance as array", "json", with_field("\"options\": {\"tolerance\": []}"), invalid, 1, 74,
       "tolerance is an array", "a number or a text"},
      {"splines as number", "json", with_field("\"options\": {\"bspline\": 1}"), invalid, 1, 72, "bspline is a number",
       "true or false"},
      {"real and complex", "json", with_field("\"options\": {\"real\": true, \"complex\": true}"), invalid, 1, 69,
       "both given", "one of the two"},
      // JSON itself.
      {"duplicate name", "json", with_field("\"p\": \"x\""), parse, 1, 49, "\"p\" occurs twice", "once"},
      {"NaN", "json", with_field("\"box\": [[NaN, 1], [0, 1]]"), parse, 1, 58, "'NaN' is no number", "finite"},
      {"Infinity", "json", with_field("\"box\": [[-Infinity, 1], [0, 1]]"), parse, 1, 58, "'-Infinity'", "finite"},
      {"leading zero", "json", with_field("\"id\": 01"), parse, 1, 55, "'01' is no JSON number", "a number"},
      {"bare fraction", "json", with_field("\"box\": [[0, 1/2], [0, 1]]"), parse, 1, 61, "'1/2' is no JSON number",
       "double quotes"},
      {"bare hexadecimal", "json", with_field("\"id\": 0x10"), parse, 1, 55, "'0x10' is no JSON number",
       "double quotes"},
      {"comment", "json", "{ // a problem\n}", parse, 1, 3, "JSON has no comments", "a JSON value"},
      {"single quotes", "json", "{'problem': 1}", parse, 1, 2, "single quote", "double quotes"},
      {"bare name", "json", "{problem: 1}", parse, 1, 2, "unexpected 'problem'", "double quotes"},
      {"comma at the end", "json", "{\"p\": \"x\",\n}", parse, 2, 1, "unexpected '}'", "a name"},
      {"no comma", "json", "{\"p\": \"x\"\n \"q\": \"y\"}", parse, 2, 2, "unexpected '\"q\"'", "','"},
      {"no colon", "json", "{\"p\" \"x\"}", parse, 1, 6, "unexpected '\"x\"'", "':'"},
      {"no end", "json", "{\"p\": \"x\"", parse, 1, 10, "unexpected end", "'}'"},
      {"text without end", "json", "{\"p\": \"x}", parse, 1, 7, "a text has no end", "double quote"},
      {"line break in a text", "json", "{\"p\": \"x\ny\"}", parse, 1, 9, "end of the line", "double quote"},
      {"unknown escape", "json", "{\"p\": \"x\\q\"}", parse, 1, 9, "escape", "\\u"},
      {"half a surrogate pair", "json", "{\"p\": \"\\ud800\"}", parse, 1, 7, "unexpected", "escape"},
      {"second value", "json", "{} {}", parse, 1, 4, "unexpected '{'", "nothing behind"},
      {"text behind the value", "json", "{} end", parse, 1, 4, "unexpected 'end'", "a JSON value"},
      {"deep arrays", "json", many(100'000, '['), parse, 1, 101, "nested more than 100", "a problem"},
      // msolve's format.
      {"three polynomials", "ms", "x,y\n0\nx,\ny,\nx", invalid, 4, 3, "third polynomial", "two polynomials"},
      {"one polynomial", "ms", "x,y\n0\nx", invalid, 3, 2, "fewer than two", "two polynomials"},
      {"prime characteristic", "ms", "x,y\n65521\nx,\ny", invalid, 2, 1, "'65521'", "0 (the rational numbers)"},
      {"three variables of msolve", "ms", "x,y,z\n0\nx,\ny", invalid, 1, 1, "3 variables", "two names"},
      {"unknown variable of msolve", "ms", "x,y\n0\nx,\ny + z", parse, 4, 5, "q: unknown variable 'z'", "x, y"},
      {"empty polynomial of msolve", "ms", "x,y\n0\n,\ny", invalid, 4, 2, "fewer than two", "two polynomials"},
      // Too large.
      {"number of 1000001 digits", "json", with_p(many(1'000'001, '7')), limit, 1, 35, "1000001 digits", ""},
      {"bare number of 1000001 digits", "json", with_field("\"box\": [[" + many(1'000'001, '7') + ", 1], [0, 1]]"),
       limit, 1, 58, "1000001 digits", ""},
      {"exponent 10^9", "json", with_p("x^1000000000"), limit, 1, 37, "degree 1000000000", ""},
      {"exponent beyond a word", "json", with_p("x^" + many(30, '9')), limit, 1, 37, "exponent is too large", ""},
      {"power of a number", "json", with_p("2^(10^9)"), limit, 1, 37, "more than 2000000 digits", ""},
      {"decimal exponent", "json", with_p("1e1000001*x"), limit, 1, 35, "exponent beyond the limit", ""},
      {"nested powers", "json", with_p("((x^999)^999)^999"), limit, 1, 44, "degree 998001", ""},
      {"degree of a product", "json", with_p("(x+y+1)^1000*(x+1)"), limit, 1, 35, "degree 1001", ""},
      {"long coefficients", "json", with_p("(10^500*x+3*y+7)^1000"), limit, 1, 52, "digits together", ""},
      {"nested parentheses", "json", with_p(many(100'000, '(')), limit, 1, 535, "nested more than 500", ""},
  };
}

}  // namespace bad_input
