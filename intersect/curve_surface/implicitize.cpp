// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/implicitize.hpp>

#include <algorithm>
#include <array>
#include <chrono>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>
#include <eliminant/symbolic/elimination/implicit_equation.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/matrices/moving_lines.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>
#include <eliminant/symbolic/matrices/representation_rank.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::CurvePiece;
using symbolic::ImplicitDegree;
using symbolic::RationalSurface;
using symbolic::SurfacePiece;

class Stopwatch {
 public:
  explicit Stopwatch(ImplicitizeResult& result) : result_(result) {}

  template <class Compute>
  auto measure(const std::string& stage, Compute compute) {
    const auto start = Clock::now();
    struct Record {
      Stopwatch& watch;
      const std::string& stage;
      Clock::time_point start;
      ~Record() { watch.add(stage, start); }
    } const record{*this, stage, start};
    return compute();
  }

  void finish() {
    std::vector<std::pair<std::string, double>>& seconds = result_.seconds;
    seconds.insert(seconds.begin(), {"total", std::chrono::duration<double>(Clock::now() - begin_).count()});
  }

 private:
  using Clock = std::chrono::steady_clock;

  void add(const std::string& stage, Clock::time_point start) {
    const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    for (auto& [name, seconds] : result_.seconds)
      if (name == stage) {
        seconds += elapsed;
        return;
      }
    result_.seconds.emplace_back(stage, elapsed);
  }

  ImplicitizeResult& result_;
  Clock::time_point begin_ = Clock::now();
};

void set_ranks(PieceRepresentation& piece, long rank_off, long rank_on) {
  piece.rank_off = rank_off;
  piece.rank_on = rank_on;
  piece.represents = rank_off == piece.matrix.rows() && rank_on < rank_off;
}

class Implicitization {
 public:
  Implicitization(const ImplicitizeProblem& problem, const Options& options, const Context& context,
                  ImplicitizeResult& result)
      : problem_(problem),
        equation_(options.equation),
        seed_(options.seed),
        context_(context),
        result_(result),
        watch_(result) {
    result_.engine.method = "exact";
    result_.engine.seed = options.seed;
  }

  void run() {
    try {
      std::visit([&](const auto& geometry) { add_pieces(geometry); }, problem_.geometry);
      const bool proven =
          std::all_of(result_.pieces.begin(), result_.pieces.end(), [](const auto& piece) { return piece.proven; });
      result_.status = proven ? Status::certified : Status::numeric;
    } catch (const LimitReached& limit) {
      result_.limit = limit.what();
      result_.status = Status::incomplete;
    }
    watch_.finish();
  }

 private:
  void add_pieces(const symbolic::ParametricCurve& curve) {
    const bool plane = curve.pieces.front().map.dimension() == 2;
    result_.engine.matrix = plane ? "moving lines" : "moving planes";
    if (equation_ && !plane)
      throw InvalidInput("the implicit equation of a space curve was asked for, which has no single one",
                         "a plane curve or a surface, or no equation");
    for (const CurvePiece& piece : curve.pieces) add(piece);
  }

  void add_pieces(const symbolic::ParametricSurface& surface) {
    result_.engine.matrix = "moving planes";
    for (const SurfacePiece& piece : surface.pieces) add(piece);
  }

  void add(const CurvePiece& given) {
    const symbolic::RationalCurve& map = given.map;
    if (map.degree() < 1) throw InvalidInput("a curve to be represented is a point", "a curve that is not constant");
    context_.checkpoint("matrix");
    PieceRepresentation piece{.piece = given};
    piece.nu = {map.degree() - 1};
    watch_.measure("matrix", [&] { piece.matrix = symbolic::moving_line_matrix(map, piece.nu.front()); });
    watch_.measure("degree", [&] {
      set_ranks(piece, symbolic::generic_rank_modulo(piece.matrix, seed_),
                symbolic::rank_on_modulo(piece.matrix, map, seed_));
      piece.map_degree = piece.matrix.rows() - piece.rank_on;
      // Theorems: the degree of the map and of the curve multiply to that of the coordinates, which is that of the
      // minors of a plane curve.
      piece.product = map.degree();
      if (map.dimension() == 2) piece.minors = map.degree();
    });
    piece.proven = piece.map_degree == 1;
    PieceRepresentation& added = result_.pieces.emplace_back(std::move(piece));
    if (!equation_) return;
    watch_.measure("equation", [&] { added.equation = symbolic::implicit_equation(map, seed_, context_); });
    added.map_degree = map.degree() / added.equation->total_degree();
    added.proven = true;
  }

  void add(const SurfacePiece& given) {
    const RationalSurface& map = given.map;
    context_.checkpoint("matrix");
    PieceRepresentation piece{.piece = given};
    watch_.measure("matrix", [&] {
      if (map.kind() == RationalSurface::Kind::triangular) {
        piece.nu = {symbolic::representation_degree(map, seed_)};
        piece.matrix = symbolic::moving_plane_matrix(map, piece.nu.front());
      } else {
        const std::array<long, 2> nu = symbolic::representation_bidegree(map);
        piece.nu.assign(nu.begin(), nu.end());
        piece.matrix = symbolic::moving_plane_matrix(map, nu);
      }
    });
    ImplicitDegree degree;
    watch_.measure("degree", [&] {
      set_ranks(piece, symbolic::generic_rank_modulo(piece.matrix, seed_),
                symbolic::rank_on_modulo(piece.matrix, map, seed_));
      if (!piece.represents) return;
      degree = symbolic::implicit_degree(map, piece.matrix, seed_);
      piece.product = degree.product;
      piece.map_degree = degree.map_degree;
      piece.minors = degree.minors;
      piece.extraneous = degree.minors > degree.product;
    });
    piece.proven = degree.proven && degree.map_degree == 1;
    PieceRepresentation& added = result_.pieces.emplace_back(std::move(piece));
    if (!added.represents) {
      const std::string reason = "the base points of the surface leave no matrix representation by moving planes";
      if (equation_) throw LimitReached(reason);
      result_.warnings.push_back(reason);
      return;
    }
    if (added.extraneous)
      result_.warnings.emplace_back(
          "base points that are no local complete intersections add planes to the surface that the matrix represents");
    if (!equation_) return;
    watch_.measure("equation",
                   [&] { added.equation = symbolic::implicit_equation(map, added.matrix, degree, seed_, context_); });
    // The degree of the surface is now known; of the product it and the kernel at one point prove as much.
    const long degree_of_surface = added.equation->total_degree();
    if (degree.proven)
      added.map_degree = added.product / degree_of_surface;
    else
      added.product = degree_of_surface * added.map_degree;
    added.extraneous = degree.minors > added.product;
    added.proven = degree.proven || added.map_degree == 1;
  }

  const ImplicitizeProblem& problem_;
  bool equation_;
  std::uint64_t seed_;
  const Context& context_;
  ImplicitizeResult& result_;
  Stopwatch watch_;
};

}  // namespace

ImplicitizeResult implicitize(const ImplicitizeProblem& problem, const Options& options, const Context& context) {
  symbolic::install_flint_error_handler();
  ImplicitizeResult result;
  Implicitization(problem, options, context, result).run();
  return result;
}

}  // namespace eliminant::intersect
