// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>

#include <algorithm>
#include <optional>
#include <unordered_set>

#include <eliminant/symbolic/arithmetic/expression.hpp>
#include <eliminant/symbolic/arithmetic/parse_number.hpp>
#include <eliminant/symbolic/arithmetic/polynomial_tokens.hpp>
#include <eliminant/symbolic/arithmetic/variable_names.hpp>

namespace eliminant::symbolic {

namespace {

using Kind = PolynomialToken::Kind;
using Node = Expression::Node;

std::string in_quotes(std::string_view token) {
  // Cut at a character boundary: the message must stay valid UTF-8.
  std::size_t end = std::min<std::size_t>(token.size(), 30);
  while (end < token.size() && (static_cast<unsigned char>(token[end]) & 0xC0U) == 0x80U) ++end;
  return "'" + std::string(token.substr(0, end)) + (end < token.size() ? "...'" : "'");
}

std::string list_of(std::span<const std::string> names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

// Recursive descent; only "(" recurses, so that `nesting` bounds the stack.
class Parser {
 public:
  Parser(std::string_view text, std::span<const std::string> names, const Limits& limits, const Locate& locate)
      : names_(names), limits_(limits), tokens_(text, locate), expression_(names.size(), limits) {}

  Polynomial parse() {
    if (is(Kind::end)) throw ParseError("the polynomial is empty", "a polynomial such as x^2 - 2*y", tokens_.place());
    const Node root = sum();
    if (!is(Kind::end)) refuse(after_operand());
    return expression_.expand(root);
  }

 private:
  bool is(Kind kind) const { return tokens_.current().kind == kind; }

  [[noreturn]] void refuse(const std::string& expected) const {
    const PolynomialToken& token = tokens_.current();
    throw ParseError("unexpected " + (is(Kind::end) ? "end of the polynomial" : in_quotes(token.text)), expected,
                     tokens_.place());
  }

  std::string at_operand() const {
    return "a number, " + (names_.empty() ? std::string() : "a variable (" + list_of(names_) + ") ") + "or '('";
  }
  std::string after_operand() const { return depth_ > 0 ? "an operator or ')'" : "an operator or the end"; }

  // Places are computed only for errors: each costs a walk through the text.
  template <class Build>
  Node bounded(std::size_t offset, Build build) const {
    return with_place([this](std::size_t at) { return tokens_.place_of(at); }, offset, build);
  }

  Node sum() {
    const std::size_t begin = tokens_.current().offset;
    std::vector<Node> addends{product()};
    while (is(Kind::plus) || is(Kind::minus)) {
      const bool negative = is(Kind::minus);
      tokens_.advance();
      const Node addend = product();
      addends.push_back(negative ? expression_.negated(addend) : addend);
    }
    return bounded(begin, [&] { return expression_.sum(std::move(addends)); });
  }

  Node product() {
    const std::size_t begin = tokens_.current().offset;
    std::vector<Node> factors;
    factor(factors);
    while (true) {
      if (is(Kind::divide)) {
        tokens_.advance();
        divide(factors);
      } else if (is(Kind::times)) {
        tokens_.advance();
        factor(factors);
      } else if (is(Kind::name) || is(Kind::open)) {
        factor(factors);
      } else {
        return bounded(begin, [&] { return expression_.product(factors); });
      }
    }
  }

  void divide(std::vector<Node>& factors) {
    const std::size_t begin = tokens_.current().offset;
    std::vector<Node> divisors;
    factor(divisors);
    const Node divisor = bounded(begin, [&] { return expression_.product(divisors); });
    if (!expression_.is_constant(divisor))
      throw ParseError("division by an expression with variables", "a number as divisor", tokens_.place_of(begin));
    if (expression_.value(divisor).is_zero())
      throw ParseError("division by zero", "a non-zero divisor", tokens_.place_of(begin));
    factors.push_back(expression_.constant(Rational(1) / expression_.value(divisor)));
  }

  // Appends a signed power. An identifier that stands for a product appends several factors: the exponent belongs to
  // the last one, as in xy^2 = x*y^2.
  void factor(std::vector<Node>& factors) {
    if (signs()) factors.push_back(expression_.constant(-1));
    // Right to left, without recursion: 2^3^2 = 2^(3^2).
    struct Level {
      Node node;
      bool negative;
      std::size_t offset;
    };
    std::vector<Level> tower;
    const std::size_t begin = tokens_.current().offset;
    tower.push_back({operand(factors), false, begin});
    while (is(Kind::power)) {
      tokens_.advance();
      const bool negative = signs();
      const std::size_t offset = tokens_.current().offset;
      std::vector<Node> exponent;
      exponent.push_back(operand(exponent));
      tower.push_back({bounded(offset, [&] { return expression_.product(exponent); }), negative, offset});
    }
    while (tower.size() > 1) {
      const Level exponent = tower.back();
      tower.pop_back();
      tower.back().node = power(tower.back().node, exponent.node, exponent.negative, exponent.offset);
    }
    factors.push_back(tower.front().node);
  }

  // Whether the signs here multiply to -1.
  bool signs() {
    bool negative = false;
    for (; is(Kind::plus) || is(Kind::minus); tokens_.advance())
      if (is(Kind::minus)) negative = !negative;
    return negative;
  }

  Node power(Node base, Node exponent, bool negative, std::size_t offset) {
    const auto refuse_exponent = [&](const char* problem, const char* expected) {
      throw ParseError(problem, expected, tokens_.place_of(offset));
    };
    const char* const expected = "a whole number >= 0 as exponent";
    if (!expression_.is_constant(exponent)) refuse_exponent("an exponent has variables", expected);
    const Rational value = negative ? -expression_.value(exponent) : expression_.value(exponent);
    if (!value.is_integer()) refuse_exponent("an exponent is not a whole number", expected);
    if (value.sign() < 0) {
      if (!expression_.is_constant(base)) refuse_exponent("an exponent is negative", expected);
      if (expression_.value(base).is_zero()) refuse_exponent("zero has a negative exponent", "a non-zero base");
      base = expression_.constant(Rational(1) / expression_.value(base));
    }
    const Integer size = value.sign() < 0 ? -value.numerator() : value.numerator();
    // Nothing but 0, 1 and -1 has a power this high within the limits.
    if (size.bit_length() > 62) throw LimitReached("an exponent is too large", tokens_.place_of(offset));
    return bounded(offset, [&] { return expression_.power(base, fmpz_get_ui(size.get())); });
  }

  Node operand(std::vector<Node>& factors) {
    const PolynomialToken token = tokens_.current();
    if (token.kind == Kind::number) {
      tokens_.advance();
      return bounded(token.offset, [&] { return expression_.constant(number_literal_value(token.text, limits_)); });
    }
    if (token.kind == Kind::name) {
      const std::vector<std::size_t> variables = resolve(token.text);
      tokens_.advance();
      for (std::size_t i = 0; i + 1 < variables.size(); ++i) factors.push_back(expression_.variable(variables[i]));
      return expression_.variable(variables.back());
    }
    if (token.kind != Kind::open) refuse(at_operand());
    if (++depth_ > limits_.nesting)
      throw LimitReached("parentheses are nested more than " + std::to_string(limits_.nesting) + " deep",
                         tokens_.place());
    tokens_.advance();
    const Node inside = sum();
    if (!is(Kind::close)) refuse(after_operand());
    --depth_;
    tokens_.advance();
    return inside;
  }

  std::vector<std::size_t> resolve(std::string_view name) const {
    VariableSplit split = split_into_variables(name, names_);
    if (split.outcome == VariableSplit::Outcome::ambiguous)
      throw ParseError(in_quotes(name) + " is a product of variables in more than one way", "'*' between the variables",
                       tokens_.place());
    if (split.outcome == VariableSplit::Outcome::none)
      throw ParseError("unknown variable " + in_quotes(name),
                       names_.empty() ? "a number" : list_of(names_) + " or a product of them", tokens_.place());
    return std::move(split.variables);
  }

  std::span<const std::string> names_;
  const Limits& limits_;
  PolynomialTokens tokens_;
  Expression expression_;
  std::size_t depth_ = 0;
};

}  // namespace

Polynomial parse_polynomial(std::string_view text, std::span<const std::string> names, const Limits& limits,
                            const Locate& locate) {
  return Parser(text, names, limits, locate ? locate : locate_in(text)).parse();
}

std::vector<NameOccurrence> names_in(std::string_view text, const Locate& locate) {
  PolynomialTokens tokens(text, locate ? locate : locate_in(text));
  std::vector<NameOccurrence> names;
  std::unordered_set<std::string> known;
  while (tokens.current().kind != Kind::end) {
    const PolynomialToken token = tokens.current();
    tokens.advance();
    if (token.kind != Kind::name) continue;
    if (token.text.size() > 1 && tokens.current().kind == Kind::open &&
        tokens.current().offset == token.offset + token.text.size())
      throw ParseError(in_quotes(token.text) + " looks like a function", "a polynomial; '*' before a parenthesis",
                       tokens.place_of(token.offset));
    if (known.emplace(token.text).second) names.push_back({std::string(token.text), token.offset});
  }
  return names;
}

}  // namespace eliminant::symbolic
