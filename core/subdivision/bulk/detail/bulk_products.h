// SPDX-License-Identifier: LGPL-2.1-or-later
// Small matrix products over vectors of one width.
//
// `V` is a vector width (see simd_plain.cpp): its `type`, `kWidth` lanes, and load, store, all
// (one value in every lane), fma(a, b, c) = a b + c. It has to be a type of its own in each source
// file, so that no instance leaves the file whose instructions it was made for.

#pragma once

#include <cstddef>
#include <type_traits>

/// A part of a kernel: takes the instructions and the constant sizes of its caller.
#define BLOSSOM_PART [[gnu::always_inline]] inline

namespace blossom::detail {

/// Operand A: its entries are single values that count for every lane, or vectors.
enum class Entries { Single, Vectors };

/// A distance that the compiler knows, so that it becomes part of the instruction.
template <std::ptrdiff_t kDistance>
using Fixed = std::integral_constant<std::ptrdiff_t, kDistance>;

/// size * kFactor, fixed where the size is the constant kSize.
template <int kSize, int kFactor>
BLOSSOM_PART constexpr auto distance_of([[maybe_unused]] int size) {
  if constexpr (kSize > 0)
    return Fixed<kSize * kFactor>{};
  else
    return static_cast<std::ptrdiff_t>(size) * kFactor;
}

/// Places of a matrix: entry (x, z) at from + x * row + z * column.
template <class Value, class Row, class Column>
struct Places {
  Value* from;
  Row row;
  Column column;

  BLOSSOM_PART Value* at(std::ptrdiff_t x, std::ptrdiff_t z) const {
    return from + x * row + z * column;
  }
};
template <class Value, class Row, class Column>
Places(Value*, Row, Column) -> Places<Value, Row, Column>;  // clang before 17 asks for it

template <class Value>
using FreePlaces = Places<Value, std::ptrdiff_t, std::ptrdiff_t>;

template <class V, Entries A>
BLOSSOM_PART typename V::type entry(const double* place) {
  if constexpr (A == Entries::Single)
    return V::all(*place);
  else
    return V::load(place);
}

/// Longer sums stay loops: unrolled, the tiles of one product would leave the cache of decoded
/// instructions.
inline constexpr int kUnrolled = 6;

/// X x Y entries of out = A B; the sums run from z = 0 upwards, first product unfused. Z is the
/// inner length, or 0 if only `inner` knows it.
template <class V, Entries A, int Z, int X, int Y, class InA, class InB, class Out>
BLOSSOM_PART void product_tile(int inner, const InA& a, const InB& b, const Out& out) {
  typename V::type sum[X][Y], row[Y];
  const int count = Z > 0 ? Z : inner;
#pragma GCC unroll 8
  for (int y = 0; y < Y; ++y) row[y] = V::load(b.at(0, y));
#pragma GCC unroll 8
  for (int x = 0; x < X; ++x) {
    const typename V::type factor = entry<V, A>(a.at(x, 0));
#pragma GCC unroll 8
    for (int y = 0; y < Y; ++y) sum[x][y] = factor * row[y];
  }
  const auto add_products = [&](int z) [[gnu::always_inline]] {
#pragma GCC unroll 8
    for (int y = 0; y < Y; ++y) row[y] = V::load(b.at(z, y));
#pragma GCC unroll 8
    for (int x = 0; x < X; ++x) {
      const typename V::type factor = entry<V, A>(a.at(x, z));
#pragma GCC unroll 8
      for (int y = 0; y < Y; ++y) sum[x][y] = V::fma(factor, row[y], sum[x][y]);
    }
  };
  if constexpr (0 < Z && Z <= kUnrolled) {
#pragma GCC unroll 8
    for (int z = 1; z < Z; ++z) add_products(z);
  } else {
#pragma GCC unroll 1
    for (int z = 1; z < count; ++z) add_products(z);
  }
#pragma GCC unroll 8
  for (int x = 0; x < X; ++x)
#pragma GCC unroll 8
    for (int y = 0; y < Y; ++y) V::store(out.at(x, y), sum[x][y]);
}

/// X rows of the product, all columns.
template <class V, Entries A, int Z, int X, class InA, class InB, class Out>
BLOSSOM_PART void product_rows(int columns, int inner, const InA& a, InB b, Out out) {
  constexpr int kTileColumns = V::kTileColumns;
  for (; columns >= kTileColumns; columns -= kTileColumns) {
    product_tile<V, A, Z, X, kTileColumns>(inner, a, b, out);
    b.from += kTileColumns * b.column;
    out.from += kTileColumns * out.column;
  }
  if (kTileColumns > 2 && columns >= 2) {
    product_tile<V, A, Z, X, 2>(inner, a, b, out);
    b.from += 2 * b.column;
    out.from += 2 * out.column;
    columns -= 2;
  }
  if (columns == 1) product_tile<V, A, Z, X, 1>(inner, a, b, out);
}

/// out = A B for `rows` x `columns` results, columns counted in vectors. Rows go outside, so that
/// wide results are written in long runs.
template <class V, Entries A, int Z, class InA, class InB, class Out>
BLOSSOM_PART void product(int rows, int columns, int inner, InA a, const InB& b, Out out) {
  constexpr int kTileRows = 4;
  for (; rows >= kTileRows; rows -= kTileRows) {
    product_rows<V, A, Z, kTileRows>(columns, inner, a, b, out);
    a.from += kTileRows * a.row;
    out.from += kTileRows * out.row;
  }
  if (rows == 3) product_rows<V, A, Z, 3>(columns, inner, a, b, out);
  if (rows == 2) product_rows<V, A, Z, 2>(columns, inner, a, b, out);
  if (rows == 1) product_rows<V, A, Z, 1>(columns, inner, a, b, out);
}

/// The product with a version of its own for the inner lengths of degrees 1 to 5.
template <class V, Entries A, class InA, class InB, class Out>
[[gnu::noinline]] void product_of_size(int rows, int columns, int inner, const InA& a, const InB& b,
                                       const Out& out) {
  switch (inner) {
    case 2: return product<V, A, 2>(rows, columns, inner, a, b, out);
    case 3: return product<V, A, 3>(rows, columns, inner, a, b, out);
    case 4: return product<V, A, 4>(rows, columns, inner, a, b, out);
    case 5: return product<V, A, 5>(rows, columns, inner, a, b, out);
    case 6: return product<V, A, 6>(rows, columns, inner, a, b, out);
    default: return product<V, A, 0>(rows, columns, inner, a, b, out);
  }
}

/// The product in line where the inner length Z is a constant, else by the choice above.
template <class V, Entries A, int Z, class InA, class InB, class Out>
BLOSSOM_PART void product_in_line(int rows, int columns, int inner, const InA& a, const InB& b,
                                  const Out& out) {
  if constexpr (Z > 0)
    product<V, A, Z>(rows, columns, Z, a, b, out);
  else
    product_of_size<V, A>(rows, columns, inner, FreePlaces<const double>{a.from, a.row, a.column},
                          FreePlaces<const double>{b.from, b.row, b.column},
                          FreePlaces<double>{out.from, out.row, out.column});
}

}  // namespace blossom::detail
