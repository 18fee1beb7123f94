// Every way in which a host may keep its arrays leads to the same bits, and what cannot be told apart is refused.
//
//   c++ -std=c++17 arrays.cpp $(pkg-config --cflags --libs fmc_contact)
#include "expect.hpp"

#include <cmath>
#include <limits>
#if __has_include(<span>) && __cplusplus >= 202002L
#include <span>
#endif

namespace {

// The members by which a matrix of Eigen tells where its entries are; -1: known when it runs only.
template <int Rows, int Cols, bool RowMajor>
struct Matrix {
  static constexpr int RowsAtCompileTime = Rows, ColsAtCompileTime = Cols;
  std::vector<double> entries;
  std::ptrdiff_t r, c, gap = 0;

  Matrix(std::ptrdiff_t rows, std::ptrdiff_t cols) : entries(static_cast<std::size_t>(rows * cols)), r(rows), c(cols) {}
  double *data() { return entries.data(); }
  const double *data() const { return entries.data(); }
  std::ptrdiff_t rows() const { return r; }
  std::ptrdiff_t cols() const { return c; }
  std::ptrdiff_t size() const { return r * c; }
  std::ptrdiff_t innerSize() const { return RowMajor ? c : r; }
  std::ptrdiff_t outerSize() const { return RowMajor ? r : c; }
  std::ptrdiff_t innerStride() const { return 1; }
  std::ptrdiff_t outerStride() const { return innerSize() + gap; }
  std::ptrdiff_t rowStride() const { return RowMajor ? outerStride() : innerStride(); }
  std::ptrdiff_t colStride() const { return RowMajor ? innerStride() : outerStride(); }
  double &operator()(std::ptrdiff_t i, std::ptrdiff_t j) {
    return entries[static_cast<std::size_t>(i * rowStride() + j * colStride())];
  }
};

// A list of MFEM: its const vectors give pointers to what may be written.
template <class T>
struct Listed {
  std::vector<T> entries;
  T *GetData() const { return const_cast<T *>(entries.data()); }
  int Size() const { return static_cast<int>(entries.size()); }
};
// A matrix of MFEM, whose Size() is that of its side.
struct Square : Listed<double> {
  int Height() const { return 2; }
};

const std::vector<double> coords = {0, 0, 1, 0, 1, 1, 0, 1, 0.99, 0.1, 1.99, 0.1, 1.99, 0.9, 0.99, 0.9};
const std::vector<int32_t> quads = {0, 1, 2, 3, 4, 5, 6, 7};
const fmc::Options options(1e5);

// One matrix, n x 2 or 2 x n, filled, evaluated, and compared.
template <class M>
bool agrees(const std::vector<double> &expected, bool by_row) {
  M x = by_row ? M(8, 2) : M(2, 8), f = x;
  const auto at = [&](M &m, std::ptrdiff_t node, std::ptrdiff_t axis) -> double & {
    return by_row ? m(node, axis) : m(axis, node);
  };
  for (std::ptrdiff_t k = 0; k < 16; ++k) at(x, k / 2, k % 2) = coords[static_cast<std::size_t>(k)];
  fmc::Context contact(2, x, {{FMC_QUAD4, quads}}, options);
  contact.evaluate(x, f);
  bool same = fmc::contact_force(2, x, {{FMC_QUAD4, quads}}, options).forces == expected;
  for (std::ptrdiff_t k = 0; k < 16; ++k) same &= at(f, k / 2, k % 2) == expected[static_cast<std::size_t>(k)];
  return same;
}

}  // namespace

int main() try {
  const fmc::ContactForces first_force = fmc::contact_force(2, coords, {{FMC_QUAD4, quads}}, options);
  const std::vector<double> &expected = first_force.forces;
  EXPECT(first_force.volume > 0.0079 && first_force.volume < 0.0081 && expected[8] > 0);

  // 1. Rows in containers of several kinds, and an array of the language.
  std::vector<std::array<double, 2>> pairs(8), pair_forces(8);
  std::vector<std::array<double, 3>> triples(8), triple_forces(8, {7, 7, 7});
  double plain[8][2], plain_forces[8][2];
  for (std::size_t n = 0; n < 8; ++n)
    for (std::size_t axis = 0; axis < 2; ++axis) pairs[n][axis] = triples[n][axis] = plain[n][axis] = coords[2 * n + axis];
  fmc::Context contact(2, pairs, {{FMC_QUAD4, quads}}, options);
  std::vector<double> forces(16);
  const auto same = [&] { return std::exchange(forces, std::vector<double>(16)) == expected; };
  contact.evaluate(coords, forces);
  EXPECT(same());
  contact.evaluate(pairs, pair_forces);
  contact.evaluate(plain, plain_forces);
  contact.evaluate(triples, triple_forces);
  for (std::size_t k = 0; k < 16; ++k) {
    EXPECT(pair_forces[k / 2][k % 2] == expected[k] && plain_forces[k / 2][k % 2] == expected[k]);
    EXPECT(triple_forces[k / 2][k % 2] == expected[k] && triple_forces[k / 2][2] == 7);
  }
  contact.evaluate({coords.data(), 16}, {forces.data(), 16});
  EXPECT(same());
#if defined(__cpp_lib_span)
  contact.evaluate(std::span<const double>(coords), std::span(forces));
  EXPECT(same());
#endif

  const Listed<double> listed{coords};
  Listed<double> listed_forces{std::vector<double>(16)};
  fmc::Context(2, listed, {{FMC_QUAD4, Listed<int>{quads}}}, options).evaluate(listed, listed_forces);
  EXPECT(listed_forces.entries == expected);

  // 2. All x, then all y.
  std::vector<double> apart(16), apart_forces(16);
  for (std::size_t k = 0; k < 16; ++k) apart[k % 2 * 8 + k / 2] = coords[k];
  contact.evaluate(fmc::Coords::strided(apart.data(), 8, 1, 8), fmc::Forces::strided(apart_forces.data(), 8, 1, 8));
  for (std::size_t k = 0; k < 16; ++k) EXPECT(apart_forces[k % 2 * 8 + k / 2] == expected[k]);
  EXPECT(fmc::contact_force(2, fmc::Coords::strided(apart.data(), 8, 1, 8), {{FMC_QUAD4, quads}}, options).forces == expected);

  // 3. Matrices, nodes in rows or in columns, in either storage order.
  EXPECT(agrees<Matrix<-1, -1, false>>(expected, true) && agrees<Matrix<-1, -1, false>>(expected, false));
  EXPECT(agrees<Matrix<-1, -1, true>>(expected, true) && agrees<Matrix<-1, -1, true>>(expected, false));
  EXPECT(agrees<Matrix<-1, 2, false>>(expected, true) && agrees<Matrix<2, -1, false>>(expected, false));
  const Matrix<-1, -1, false> square(2, 2);
  EXPECT(refused(FMC_ERROR_LENGTH, "rows or columns", [&] { contact.evaluate(square); }));
  EXPECT(fmc::Coords(Matrix<2, -1, false>(2, 2)).as_c(2).axis_stride == 1);
  EXPECT(fmc::Coords(Matrix<-1, 2, false>(2, 2)).as_c(2).node_stride == 1);
  EXPECT(refused(FMC_ERROR_LENGTH, "3 x 8", [&] { contact.evaluate(Matrix<-1, -1, false>(3, 8)); }));
  Matrix<-1, -1, false> gaps(4, 2);
  gaps.gap = 1;
  EXPECT(refused(FMC_ERROR_STRIDE, "gaps", [&] { contact.set_slip(gaps); }));

  // 4. Node numbers of 32 and 64 bits, signed or not, in rows or not, of several blocks; bodies by id.
  const std::vector<int64_t> wide(quads.begin(), quads.end());
  const std::vector<unsigned long long> natural(quads.begin(), quads.end());
  const std::vector<std::array<int32_t, 4>> rows = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  EXPECT(fmc::contact_force(2, coords, {{FMC_QUAD4, wide}}, options).forces == expected);
  EXPECT(fmc::contact_force(2, coords, {{FMC_QUAD4, natural}}, options).forces == expected);
  EXPECT(fmc::contact_force(2, coords, {{FMC_QUAD4, rows}}, options).forces == expected);
  const std::vector<int32_t> first = {0, 1, 2, 3}, second = {4, 5, 6, 7};
  fmc::Context blocks(2, coords, {{FMC_QUAD4, first}, {FMC_QUAD4, second}}, options, {3, 9});
  blocks.evaluate(coords, forces);
  EXPECT(same() && blocks.body(1).id == 9);
  fmc::Context wide_blocks(2, coords, {{FMC_QUAD4, wide}}, options, std::vector<int64_t>{3, 3});
  EXPECT(wide_blocks.evaluate(coords).pair_count == 0);
  std::vector<fmc::Cells<int32_t>> list = {{FMC_QUAD4, first}, {FMC_QUAD4, second}};
  fmc::Context(2, coords, list, options).evaluate(coords, forces);
  EXPECT(same());
  const std::vector<int32_t> edges = {0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6, 6, 7, 7, 4};
  fmc::Options volume_law(1e5);
  volume_law.set("law", "volume").set("exponent", "2");
  auto surface = fmc::Context::from_facets(2, coords, {{FMC_FACET_LINE2, edges}}, volume_law);
  surface.evaluate(coords, forces);
  EXPECT(std::exchange(forces, std::vector<double>(16)) == fmc::contact_force(2, coords, {{FMC_QUAD4, quads}}, volume_law).forces);
  const std::vector<int64_t> wide_edges(edges.begin(), edges.end());
  EXPECT(fmc::Context::from_facets(2, coords, {{FMC_FACET_LINE2, wide_edges}}, volume_law, {1, 1, 1, 1, 2, 2, 2, 2}).counts().facets == 8);
  // A disc of four parabolas, their middles on the circle: a square and segments of 2/3 of chord times rise.
  const double half = std::sqrt(0.5);
  const std::vector<double> ring = {1, 0, 0, 1, -1, 0, 0, -1, half, half, -half, half, -half, -half, half, -half};
  const std::vector<int64_t> quarters = {0, 1, 4, 1, 2, 5, 2, 3, 6, 3, 0, 7};
  auto disc = fmc::Context::from_facets(2, ring, {{FMC_FACET_LINE3, quarters}}, volume_law);
  disc.add_half_space(fmc::Pose::along({0, 10}, {0, 1}));
  EXPECT(std::fabs(disc.evaluate(ring).volume - (2 + 8.0 / 3 * std::sqrt(2.0) * (1 - half))) < 1e-12);
  EXPECT(refused(FMC_ERROR_LENGTH, "rows of 3", [&] {
    fmc::Context::from_facets(2, ring, {{FMC_FACET_LINE3, edges}}, volume_law);
  }));

  // 5. What does not fit is refused by name, and changes nothing.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto broken = coords;
  broken[9] = nan;
  EXPECT(refused(FMC_ERROR_NON_FINITE_COORDINATE, "4", [&] { contact.evaluate(broken, forces); }));
  EXPECT(std::string(fmc_last_error()).find("4") != std::string::npos && forces == std::vector<double>(16));
  EXPECT(refused(FMC_ERROR_LENGTH, "15 numbers", [&] { contact.evaluate({coords.data(), 15}); }));
  EXPECT(refused(FMC_ERROR_LENGTH, "", [&] { contact.evaluate({coords.data(), 14}); }));
  EXPECT(refused(FMC_ERROR_BUFFER_TOO_SMALL, "", [&] { contact.evaluate(coords, {forces.data(), 14}); }));
  const std::vector<std::array<double, 2>> flat(8);
  EXPECT(refused(FMC_ERROR_LENGTH, "rows of 2", [&] { fmc::Coords(flat).as_c(3); }));
  EXPECT(refused(FMC_ERROR_DIMENSION, "4", [&] { fmc::Context(4, coords, {{FMC_QUAD4, quads}}, options); }));
  const std::vector<std::array<int32_t, 4>> three(3);
  EXPECT(refused(FMC_ERROR_LENGTH, "rows of 4", [&] { fmc::Context(2, coords, {{FMC_TRI3, three}}, options); }));
  EXPECT(refused(FMC_ERROR_LENGTH, "8 node numbers", [&] { fmc::Context(2, coords, {{FMC_TRI3, quads}}, options); }));
  EXPECT(refused(FMC_ERROR_LENGTH, "body_ids", [&] { fmc::Context(2, coords, {{FMC_QUAD4, quads}}, options, {1, 2, 3}); }));
  EXPECT(refused(FMC_ERROR_NODE_OUT_OF_RANGE, "9",
                 [&] { fmc::contact_force(2, coords, {{FMC_QUAD4, std::vector<int64_t>{0, 1, 2, 3, 4, 5, 6, 9}}}, options); }));
  EXPECT(refused(FMC_ERROR_UNKNOWN_CELL_TYPE, "31",
                 [&] { fmc::contact_force(2, coords, {{static_cast<fmc_cell_type>(31), quads}}, options); }));
  EXPECT(refused(FMC_ERROR_UNKNOWN_OPTION, "colour", [] { fmc::Options(1.0).set("colour", "red"); }));
  EXPECT(refused(FMC_ERROR_NOT_POSITIVE, "", [&] { fmc::contact_force(2, coords, {{FMC_QUAD4, quads}}, fmc::Options(-1)); }));

  // 6. What must not be written is not taken to be written, and a context is moved, not copied.
  static_assert(!std::is_convertible_v<const std::vector<double> &, fmc::Forces>);
  static_assert(!std::is_convertible_v<std::vector<double>, fmc::Forces>);
  static_assert(!std::is_convertible_v<std::vector<float> &, fmc::Coords>);
  static_assert(!std::is_convertible_v<const Listed<double> &, fmc::Forces> && !std::is_convertible_v<Listed<double>, fmc::Forces>);
  static_assert(!std::is_convertible_v<Listed<float> &, fmc::Coords> && !std::is_convertible_v<Square &, fmc::Coords>);
  static_assert(!std::is_convertible_v<std::vector<int32_t> &, fmc::View<const int64_t>>);
  static_assert(!std::is_convertible_v<std::vector<std::vector<double>> &, fmc::Coords>);
  static_assert(!std::is_copy_constructible_v<fmc::Context> && std::is_nothrow_move_constructible_v<fmc::Context>);
  fmc::Context moved = std::move(contact);
  moved.evaluate(coords, forces);
  EXPECT(same());
  EXPECT(refused(FMC_ERROR_NULL_POINTER, "context", [&] { contact.evaluate(coords); }));
  contact = std::move(moved);
  contact.evaluate(coords, forces);
  EXPECT(same());
  return report();
} catch (const std::exception &error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
