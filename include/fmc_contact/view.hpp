// Errors, and arrays of the host as the library sees them. Part of fmc_contact.hpp.
#ifndef FMC_CONTACT_VIEW_HPP
#define FMC_CONTACT_VIEW_HPP

#include "../fmc_contact.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace fmc {

// A call that failed. The text names the offending indices and values. After it outputs are untouched, and a context is as it
// was before the call.
class Error : public std::runtime_error {
 public:
  Error(fmc_status status, const std::string &text)
      : std::runtime_error(std::string(fmc_status_name(status)) + ": " + text), status_(status) {}

  // Value of `fmc_status`: every cause has its own.
  fmc_status status() const noexcept { return status_; }
  // Its name, such as "FMC_ERROR_INVERTED_CELL", with which `what()` begins.
  const char *name() const noexcept { return fmc_status_name(status_); }
  // Value of `fmc_status_class_value`: whether input, geometry, numbers, resources or the order of calls are to blame.
  int32_t status_class() const noexcept { return fmc_status_class(status_); }

 private:
  fmc_status status_;
};

// Throws the status of a function of the C interface, unless it is success.
inline void check(fmc_status status) {
  if (status != FMC_OK) throw Error(status, fmc_last_error());
}

namespace detail {

// Rows whose number the library knows: it is asked for that, then for them. `give` takes an array, its room and a number.
template <class T, class Give, class Done>
std::vector<T> rows(const Give &give, const Done &done) {
  std::size_t count = 0;
  done(give(static_cast<T *>(nullptr), std::size_t{0}, &count));
  std::vector<T> found(count);
  done(give(found.data(), count, &count));
  return found;
}
template <class T, class Give>
std::vector<T> rows(const Give &give) {
  return rows<T>(give, check);
}

struct Nothing {
  Nothing() = delete;
};

// Whether an E is read as a T: the same type, or an integer of the same size (long for long long, unsigned for signed).
template <class E, class T>
constexpr bool same_number = std::is_same_v<E, T> || (std::is_integral_v<E> && std::is_integral_v<T> && sizeof(E) == sizeof(T) &&
                                                      !std::is_same_v<E, bool>);

// Numbers in one element of a container: 0 for a number, N for an array of N, and the size in numbers for a fixed vector of
// Eigen.
template <class E, class T, class = void>
struct Row {
  static constexpr bool ok = same_number<E, T>;
  static constexpr std::size_t length = 0;
};
template <class E, class T, std::size_t N>
struct Row<std::array<E, N>, T> {
  static constexpr bool ok = N > 0 && same_number<E, T>;
  static constexpr std::size_t length = N;
};
template <class E, class T, std::size_t N>
struct Row<E[N], T> {
  static constexpr bool ok = same_number<E, T>;
  static constexpr std::size_t length = N;
};
template <class E, class T>
struct Row<E, T, std::enable_if_t<(E::SizeAtCompileTime > 0)>> {
  static constexpr bool ok = same_number<typename E::Scalar, T>;
  static constexpr std::size_t length = sizeof(E) / sizeof(T);
};

// Where the numbers of a container are, and how many: data() and size(), or an array. Else GetData() and Size(), as in MFEM; a matrix,
// which has a Height(), is not such a list.
template <class C>
constexpr auto data_of(C &container, int) -> decltype(std::data(container)) { return std::data(container); }
template <class C>
constexpr auto size_of(const C &container, int) -> decltype(std::size(container)) { return std::size(container); }

template <class C, class = void>
struct HasHeight : std::false_type {};
template <class C>
struct HasHeight<C, std::void_t<decltype(std::declval<const C &>().Height())>> : std::true_type {};

// Constant where the container is, though its GetData() may not be.
template <class C, class E = std::remove_pointer_t<decltype(std::declval<C &>().GetData())>,
          class = std::enable_if_t<!HasHeight<C>::value>>
constexpr auto data_of(C &container, long) -> std::conditional_t<std::is_const_v<C>, const E, E> * { return container.GetData(); }
template <class C>
constexpr auto size_of(const C &container, long) -> decltype(container.Size()) { return container.Size(); }

template <class C>
using pointer_of = decltype(data_of(std::declval<C &>(), 0));
template <class C>
using element_of = std::remove_cv_t<std::remove_pointer_t<pointer_of<C>>>;

// A container as it was passed: a temporary counts as constant, so that no output is written into it and lost.
template <class C>
using passed = std::conditional_t<std::is_lvalue_reference_v<C>, std::remove_reference_t<C>, const C>;

// Whether a container has T to view.
template <class C, class T, class = void>
struct IsViewable : std::false_type {};
template <class C, class T>
struct IsViewable<C, T, std::void_t<pointer_of<C>, decltype(size_of(std::declval<C &>(), 0))>>
    : std::bool_constant<Row<element_of<C>, std::remove_const_t<T>>::ok &&
                         (std::is_const_v<T> || !std::is_const_v<std::remove_pointer_t<pointer_of<C>>>)> {};

// Eigen's matrices, and other types with the same interface for strides.
template <class C, class = void>
struct IsMatrix : std::false_type {};
template <class C>
struct IsMatrix<C, std::void_t<decltype(std::declval<const C &>().rowStride()), decltype(std::declval<const C &>().colStride()),
                               decltype(C::RowsAtCompileTime)>> : std::true_type {};

template <class C>
constexpr bool is_vector = C::RowsAtCompileTime == 1 || C::ColsAtCompileTime == 1;

[[noreturn]] inline void refuse(fmc_status status, const std::string &text) { throw Error(status, text); }

}  // namespace detail

// Numbers of the host, one after the other: not owned, not copied, and read or written during the call only. Made from an array,
// or from any type with data() and size(): std::vector, std::array, std::span, Eigen's. Rows may be arrays themselves, such as
// std::vector<std::array<double, 3>>. MFEM's vectors and arrays work by GetData() and Size(). An output must not be a temporary
// container.
//
// Integers are taken from any type of the same size. Throws `FMC_ERROR_STRIDE` for a matrix with gaps between its entries.
template <class T>
class View {
  using Value = std::remove_const_t<T>;
  using Listed = std::conditional_t<std::is_const_v<T>, Value, detail::Nothing>;

 public:
  View() = default;
  View(T *data, std::size_t size) : data_(data), size_(size) {}
  template <class C, class = std::enable_if_t<!std::is_same_v<std::decay_t<C>, View> &&
                                              detail::IsViewable<detail::passed<C>, T>::value>>
  View(C &&container) {
    using Row = detail::Row<detail::element_of<std::remove_reference_t<C>>, Value>;
    using Container = std::decay_t<C>;
    if constexpr (detail::IsMatrix<Container>::value) {
      const bool gaps = container.innerStride() != 1 ||
                        (container.outerSize() > 1 && container.outerStride() != container.innerSize());
      if (gaps && container.size() > 1) detail::refuse(FMC_ERROR_STRIDE, "a matrix with gaps between its entries");
      if constexpr (!detail::is_vector<Container>) row_ = static_cast<std::size_t>(container.innerSize());
    } else {
      row_ = Row::length;
    }
    data_ = reinterpret_cast<T *>(detail::data_of(container, 0));
    size_ = static_cast<std::size_t>(detail::size_of(container, 0)) * (Row::length > 0 ? Row::length : 1);
  }
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winit-list-lifetime"  // a view in an argument ends before the list does
#endif
  // Numbers written where the call is: `{0.0, 1.0}`.
  View(std::initializer_list<Listed> list) : data_(list.begin()), size_(list.size()) {}
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

  T *data() const noexcept { return data_; }
  std::size_t size() const noexcept { return size_; }
  bool empty() const noexcept { return size_ == 0; }
  T *begin() const noexcept { return data_; }
  T *end() const noexcept { return data_ + size_; }
  T &operator[](std::size_t index) const { return data_[index]; }
  // Length of the host's rows, 0 for plain numbers: so that rows of another length are found out.
  std::size_t row() const noexcept { return row_; }

 private:
  T *data_ = nullptr;
  std::size_t size_ = 0, row_ = 0;
};

// `dim` numbers for every node, to be read (`Coords`) or written (`Forces`); as `View` neither owned nor copied. Made from
//
// - numbers in rows, node after node: any `View`;
// - rows longer than `dim`, whose first entries count: std::vector<std::array<double, 3>> in 2D;
// - a matrix of Eigen, n x dim or dim x n, in either storage order. A square one is refused, `FMC_ERROR_LENGTH`, unless its
//   type fixes which of the two is `dim`;
// - anything else by `strided`, with strides as in `fmc_coords`: strided(x, n, 1, n) for all x, then all y, then all z.
template <class T>
class Nodal {
 public:
  Nodal() = default;
  Nodal(T *data, std::size_t size) : data_(data), rows_(size) {}
  template <class C, class = std::enable_if_t<!std::is_same_v<std::decay_t<C>, Nodal> && std::is_convertible_v<C, View<T>>>>
  Nodal(C &&container) {
    using Container = std::decay_t<C>;
    if constexpr (detail::IsMatrix<Container>::value) {
      if constexpr (!detail::is_vector<Container>) {
        data_ = container.data();
        rows_ = static_cast<std::size_t>(container.rows()), cols_ = static_cast<std::size_t>(container.cols());
        row_stride_ = container.rowStride(), col_stride_ = container.colStride();
        fixed_rows_ = Container::RowsAtCompileTime, fixed_cols_ = Container::ColsAtCompileTime;
        kind_ = Kind::matrix;
        return;
      }
    }
    const View<T> view(std::forward<C>(container));
    data_ = view.data(), rows_ = view.size(), cols_ = view.row();
  }
  Nodal(std::initializer_list<std::conditional_t<std::is_const_v<T>, double, detail::Nothing>> list)
      : Nodal(View<T>(list)) {}

  // Component `axis` of node `node` is `data[node * node_stride + axis * axis_stride]`.
  static Nodal strided(T *data, std::size_t node_count, std::ptrdiff_t node_stride, std::ptrdiff_t axis_stride) {
    Nodal nodal(data, node_count);
    nodal.row_stride_ = node_stride, nodal.col_stride_ = axis_stride, nodal.kind_ = Kind::strided;
    return nodal;
  }

  // As the C interface takes it. Throws `FMC_ERROR_LENGTH` where the array does not have `dim` numbers for every node.
  auto as_c(int dim) const {
    using C = std::conditional_t<std::is_const_v<T>, fmc_coords, fmc_forces>;
    const auto axes = static_cast<std::size_t>(dim);
    if (dim != 2 && dim != 3) detail::refuse(FMC_ERROR_DIMENSION, "dim is " + std::to_string(dim) + ", not 2 or 3");
    if (kind_ == Kind::strided) return C{data_, rows_, row_stride_, col_stride_};
    if (kind_ == Kind::matrix) {
      const bool by_row = cols_ == axes && fixed_rows_ != dim, by_col = rows_ == axes && fixed_cols_ != dim;
      if (by_row == by_col)
        detail::refuse(FMC_ERROR_LENGTH, "a matrix of " + std::to_string(rows_) + " x " + std::to_string(cols_) +
                                             (by_row ? ": its nodes may be rows or columns, say which by `strided`"
                                                     : ", neither n x " + std::to_string(dim) + " nor the transpose"));
      return by_row ? C{data_, rows_, row_stride_, col_stride_} : C{data_, cols_, col_stride_, row_stride_};
    }
    const std::size_t row = cols_ > 0 ? cols_ : axes;
    if (row < axes || rows_ % row != 0)
      detail::refuse(FMC_ERROR_LENGTH, std::to_string(rows_) + " numbers" +
                                           (cols_ > 0 ? " in rows of " + std::to_string(cols_) : std::string()) + ", not " +
                                           std::to_string(dim) + " for every node");
    return C{data_, rows_ / row, static_cast<std::ptrdiff_t>(row), 1};
  }

 private:
  enum class Kind { rows, strided, matrix };
  T *data_ = nullptr;
  std::size_t rows_ = 0, cols_ = 0;
  std::ptrdiff_t row_stride_ = 0, col_stride_ = 0;
  int fixed_rows_ = -1, fixed_cols_ = -1;
  Kind kind_ = Kind::rows;
};

using Coords = Nodal<const double>;
using Forces = Nodal<double>;

namespace detail {

// Dense rows, in place where the host has them, else copied.
class DenseRows {
 public:
  DenseRows(const Coords &coords, int dim) : view_(coords.as_c(dim)) {
    if (view_.node_stride == dim && view_.axis_stride == 1) return;
    copy_.reserve(view_.node_count * static_cast<std::size_t>(dim));
    for (std::size_t node = 0; node < view_.node_count; ++node)
      for (std::ptrdiff_t axis = 0; axis < dim; ++axis)
        copy_.push_back(view_.data[static_cast<std::ptrdiff_t>(node) * view_.node_stride + axis * view_.axis_stride]);
    view_.data = copy_.data();
  }
  DenseRows(const DenseRows &) = delete;
  DenseRows &operator=(const DenseRows &) = delete;
  const double *data() const noexcept { return view_.data; }
  std::size_t node_count() const noexcept { return view_.node_count; }

 private:
  fmc_coords view_;
  std::vector<double> copy_;
};

}  // namespace detail
}  // namespace fmc

#endif  // FMC_CONTACT_VIEW_HPP
