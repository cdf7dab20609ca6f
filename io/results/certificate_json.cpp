// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/certificate_json.hpp>

#include <nlohmann/json.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/enclosures/decimal.hpp>
#include <eliminant/io/input/plane_curves_input.hpp>
#include <eliminant/io/results/json_fields.hpp>
#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>

namespace eliminant::io {

namespace {

using intersect::CertifiedBall;
using Json = nlohmann::ordered_json;

constexpr long largest_shear = 1000000;
constexpr long largest_radius_exponent = 100000;

Json ball_json(const CertifiedBall& ball) {
  Json out;
  out["x"] = Json::array({bridge::exact_text(ball.x_real), bridge::exact_text(ball.x_imaginary)});
  out["y"] = Json::array({bridge::exact_text(ball.y_real), bridge::exact_text(ball.y_imaginary)});
  out["radius"] = "1e" + std::to_string(ball.radius_exponent);
  out["multiplicity"] = ball.multiplicity;
  out["real"] = ball.real;
  return out;
}

class Reader {
 public:
  Reader(const JsonDocument& document, const symbolic::Limits& limits) : fields_(document, limits) {}

  intersect::Certificate read() const {
    const JsonValue& root = fields_.document().root();
    fields_.require_object(
        root, "the certificate",
        {"format", "certificate", "variables", "p", "q", "common_component", "at_infinity", "shears", "balls"});
    fields_.integer(fields_.member(root, "format"), "\"format\"", 1, 1);
    const JsonValue& kind = fields_.member(root, "certificate");
    if (fields_.text(kind, "\"certificate\"") != "plane_curves")
      throw InvalidInput("a certificate of \"" + kind.text.substr(0, 40) + "\"", "\"plane_curves\"",
                         fields_.document().place_of(kind));
    intersect::Certificate certificate;
    certificate.variables.clear();
    const JsonValue& variables = fields_.member(root, "variables");
    for (const JsonValue& name : fields_.array(variables, "\"variables\""))
      certificate.variables.push_back(fields_.text(name, "a variable"));
    require_two_variables(certificate.variables, fields_.document().place_of(variables));
    certificate.p = polynomial(root, "p", certificate.variables);
    certificate.q = polynomial(root, "q", certificate.variables);
    if (root.find("common_component") != nullptr)
      certificate.common_component = polynomial(root, "common_component", certificate.variables);
    certificate.at_infinity = static_cast<unsigned long>(
        fields_.integer(fields_.member(root, "at_infinity"), "\"at_infinity\"", 0, 1L << 40));
    for (const JsonValue& shear : fields_.array(fields_.member(root, "shears"), "\"shears\""))
      certificate.shears.push_back(fields_.integer(shear, "a shear", -largest_shear, largest_shear));
    for (const JsonValue& value : fields_.array(fields_.member(root, "balls"), "\"balls\""))
      certificate.balls.push_back(ball(value));
    return certificate;
  }

 private:
  symbolic::Polynomial polynomial(const JsonValue& root, const char* name,
                                  const std::vector<std::string>& variables) const {
    const JsonValue& value = fields_.member(root, name);
    fields_.text(value, "\"" + std::string(name) + "\"");
    return symbolic::parse_polynomial(value.text, variables, fields_.limits(), fields_.document().locate_inside(value));
  }

  CertifiedBall ball(const JsonValue& value) const {
    fields_.require_object(value, "a ball", {"x", "y", "radius", "multiplicity", "real"});
    CertifiedBall ball;
    const auto coordinate = [&](const char* name, symbolic::Rational& real, symbolic::Rational& imaginary) {
      const JsonValue& pair = fields_.member(value, name);
      const std::string what = "\"" + std::string(name) + "\" of a ball";
      if (fields_.array(pair, what).size() != 2)
        throw InvalidInput(what + " has " + std::to_string(pair.elements.size()) + " parts", "[real, imaginary]",
                           fields_.document().place_of(pair));
      real = fields_.number(pair.elements[0], what);
      imaginary = fields_.number(pair.elements[1], what);
    };
    coordinate("x", ball.x_real, ball.x_imaginary);
    coordinate("y", ball.y_real, ball.y_imaginary);
    const JsonValue& radius = fields_.member(value, "radius");
    if (fields_.text(radius, "\"radius\"").rfind("1e", 0) != 0)
      throw InvalidInput("\"radius\" is " + radius.text.substr(0, 40), "a power of ten as text, like \"1e-30\"",
                         fields_.document().place_of(radius));
    JsonValue exponent = radius;
    exponent.text = radius.text.substr(2);
    ball.radius_exponent =
        fields_.integer(exponent, "the exponent of a radius", -largest_radius_exponent, largest_radius_exponent);
    ball.multiplicity = static_cast<unsigned long>(
        fields_.integer(fields_.member(value, "multiplicity"), "\"multiplicity\"", 1, 1L << 40));
    ball.real = fields_.boolean(fields_.member(value, "real"), "\"real\"");
    return ball;
  }

  JsonFields fields_;
};

}  // namespace

std::string certificate_json(const intersect::Certificate& certificate) {
  Json out;
  out["format"] = 1;
  out["certificate"] = "plane_curves";
  out["variables"] = certificate.variables;
  out["p"] = symbolic::to_string(certificate.p, certificate.variables);
  out["q"] = symbolic::to_string(certificate.q, certificate.variables);
  if (certificate.common_component)
    out["common_component"] = symbolic::to_string(*certificate.common_component, certificate.variables);
  out["at_infinity"] = certificate.at_infinity;
  out["shears"] = certificate.shears;
  out["balls"] = Json::array();
  for (const CertifiedBall& ball : certificate.balls) out["balls"].push_back(ball_json(ball));
  return json_layout(out);
}

intersect::Certificate read_certificate(const std::string& text, const symbolic::Limits& limits) {
  const JsonDocument document(text);
  return Reader(document, limits).read();
}

}  // namespace eliminant::io
