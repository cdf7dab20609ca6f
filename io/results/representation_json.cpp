// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/representation_json.hpp>

#include <algorithm>

#include <nlohmann/json.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/io/input/map_input.hpp>
#include <eliminant/io/input/named_errors.hpp>
#include <eliminant/io/results/json_fields.hpp>
#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>
#include <eliminant/symbolic/geometry/image_dimension.hpp>

namespace eliminant::io {

namespace {

using Json = nlohmann::ordered_json;
using symbolic::MatrixRepresentation;
using symbolic::Polynomial;
using symbolic::RationalSurface;
using Names = std::vector<std::string>;

const Names space_names{"x", "y", "z", "w"};
const Names plane_names{"x", "y", "w"};

constexpr long largest_degree = 1000;

const Names& names_of_parameters(const RationalSurface& surface) {
  static const Names forms{"s", "t", "u"};
  static const Names affine{"s", "t"};
  return surface.kind() == RationalSurface::Kind::triangular ? forms : affine;
}

class Reader {
 public:
  Reader(const JsonDocument& document, const symbolic::Limits& limits) : fields_(document, limits) {}

  intersect::SurfaceRepresentation read() const {
    const JsonValue& root = fields_.document().root();
    fields_.require_object(root, "the representation",
                           {"format", "representation", "parameters", "x", "y", "z", "w", "row_monomials", "matrix",
                            "product", "map_degree", "minors"});
    fields_.integer(fields_.member(root, "format"), "\"format\"", 1, 1);
    const JsonValue& kind = fields_.member(root, "representation");
    if (fields_.text(kind, "\"representation\"") != "surface")
      refuse(kind, "a representation of \"" + kind.text.substr(0, 40) + "\"", "\"surface\"");
    const Names parameters = read_parameters(fields_.member(root, "parameters"));
    RationalSurface surface = read_map(root, parameters);
    MatrixRepresentation matrix = read_matrix(root, parameters);
    symbolic::ImplicitDegree degree;
    const auto number = [&](const char* name) {
      return fields_.integer(fields_.member(root, name), "\"" + std::string(name) + "\"", 1, largest_degree);
    };
    degree.product = number("product");
    degree.map_degree = number("map_degree");
    degree.minors = number("minors");
    degree.proven = degree.product == degree.minors;
    return placed(fields_.document().place_of(root),
                  [&] { return intersect::SurfaceRepresentation(std::move(surface), std::move(matrix), degree); });
  }

 private:
  [[noreturn]] void refuse(const JsonValue& value, const std::string& message, const std::string& expected) const {
    throw InvalidInput(message, expected, fields_.document().place_of(value));
  }

  Names read_parameters(const JsonValue& list) const {
    Names parameters;
    for (const JsonValue& name : fields_.array(list, "\"parameters\""))
      parameters.push_back(parameter_name(fields_, name));
    if (parameters.size() != 2 && parameters.size() != 3)
      refuse(list, "\"parameters\" has " + std::to_string(parameters.size()) + " names",
             "two affine or three homogeneous parameters");
    return parameters;
  }

  RationalSurface read_map(const JsonValue& root, const Names& parameters) const {
    std::vector<Polynomial> coordinates;
    for (const std::string& name : space_names)
      coordinates.push_back(polynomial_from_json(fields_, fields_.member(root, name), name, parameters));
    return placed(fields_.document().place_of(root), [&] {
      RationalSurface surface(
          parameters.size() == 3 ? RationalSurface::Kind::triangular : RationalSurface::Kind::tensor_product,
          std::move(coordinates));
      if (!symbolic::is_two_dimensional(surface))
        throw InvalidInput("the image of the map is only a curve or a point", "a map with two independent parameters");
      return surface;
    });
  }

  MatrixRepresentation read_matrix(const JsonValue& root, const Names& parameters) const {
    MatrixRepresentation m;
    for (const JsonValue& row : fields_.array(fields_.member(root, "row_monomials"), "\"row_monomials\"")) {
      const Polynomial monomial = polynomial_from_json(fields_, row, "a row monomial", parameters);
      if (monomial.term_count() != 1 || !(monomial.terms().front().coefficient == symbolic::Rational(1)))
        refuse(row, "a row monomial is none", "a product of parameters");
      m.row_monomials.push_back(monomial.terms().front().exponents);
    }
    const JsonValue& list = fields_.member(root, "matrix");
    const std::vector<JsonValue>& rows = fields_.array(list, "\"matrix\"");
    if (rows.empty() || rows.size() != m.row_monomials.size())
      refuse(list, "\"matrix\" has " + std::to_string(rows.size()) + " rows", "one for each row monomial");
    const std::size_t columns = fields_.array(rows.front(), "a row of the matrix").size();
    for (std::size_t k = 0; k < 4; ++k)
      m.coefficients.emplace_back(static_cast<long>(rows.size()), static_cast<long>(columns));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (fields_.array(rows[i], "a row of the matrix").size() != columns)
        refuse(rows[i], "a row of the matrix has " + std::to_string(rows[i].elements.size()) + " entries",
               std::to_string(columns) + " entries");
      for (std::size_t j = 0; j < columns; ++j)
        set_entry(m, static_cast<long>(i), static_cast<long>(j), rows[i].elements[j]);
    }
    return m;
  }

  void set_entry(MatrixRepresentation& m, long i, long j, const JsonValue& value) const {
    const std::string what = "an entry of the matrix";
    const Polynomial form = polynomial_from_json(fields_, value, what, space_names);
    for (const Polynomial::Term& term : form.terms()) {
      const auto variable = std::find(term.exponents.begin(), term.exponents.end(), 1UL);
      if (!symbolic::is_form(form) || form.total_degree() != 1 || !term.coefficient.is_integer())
        refuse(value, what + " is no linear form", "integers times x, y, z, w");
      fmpz_set(m.coefficients[static_cast<std::size_t>(variable - term.exponents.begin())].entry(i, j),
               term.coefficient.numerator().get());
    }
  }

  JsonFields fields_;
};

}  // namespace

std::vector<std::vector<std::string>> linear_forms(const MatrixRepresentation& m) {
  const Names& names = coordinate_names(m.coefficients.size());
  std::vector<std::vector<std::string>> result;
  for (long i = 0; i < m.rows(); ++i) {
    std::vector<std::string>& row = result.emplace_back();
    for (long j = 0; j < m.columns(); ++j) {
      Polynomial form(names.size());
      for (std::size_t k = 0; k < names.size(); ++k)
        form = form + symbolic::Rational(symbolic::Integer(m.coefficients[k].entry(i, j))) *
                          Polynomial::variable(names.size(), k);
      row.push_back(symbolic::to_string(form, names));
    }
  }
  return result;
}

std::vector<std::string> monomial_texts(const MatrixRepresentation& m, const Names& parameters) {
  Names result;
  for (const auto& exponents : m.row_monomials) {
    const std::vector<Polynomial::Term> terms{{symbolic::Rational(1), exponents}};
    result.push_back(symbolic::to_string(Polynomial::from_terms(parameters.size(), terms), parameters));
  }
  return result;
}

const Names& coordinate_names(std::size_t count) { return count == 3 ? plane_names : space_names; }

void add_map(Json& out, const RationalSurface& surface) {
  const Names& parameters = names_of_parameters(surface);
  for (std::size_t k = 0; k < 4; ++k) out[space_names[k]] = symbolic::to_string(surface.coordinates()[k], parameters);
}

Json matrix_json(const MatrixRepresentation& m) { return linear_forms(m); }

std::string representation_json(const intersect::SurfaceRepresentation& representation) {
  const RationalSurface& surface = representation.surface();
  const Names& parameters = names_of_parameters(surface);
  Json out;
  out["format"] = 1;
  out["representation"] = "surface";
  out["parameters"] = parameters;
  add_map(out, surface);
  out["row_monomials"] = monomial_texts(representation.matrix(), parameters);
  out["matrix"] = matrix_json(representation.matrix());
  out["product"] = representation.degree().product;
  out["map_degree"] = representation.degree().map_degree;
  out["minors"] = representation.degree().minors;
  return json_layout(out);
}

intersect::SurfaceRepresentation read_representation(const std::string& text, const symbolic::Limits& limits) {
  symbolic::install_flint_error_handler();
  const JsonDocument document(text);
  return Reader(document, limits).read();
}

}  // namespace eliminant::io
