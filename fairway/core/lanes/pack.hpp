// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "fairway/core/lanes/number.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

/// Several numbers side by side, in one register of the processor. Each comes to the bits that it would come
/// to alone: every operation is one of IEEE 754 on each lane, and none is fused with another. Operators are
/// those of the compilers' vectors (g++, clang++); what they lack is said for each kind of registers, of
/// which a file is compiled for one: eight lanes of AVX-512, four of AVX2, two of SSE2 or of any other
/// processor.
// NOLINTBEGIN(google-readability-casting, cppcoreguidelines-pro-type-cstyle-cast): between kinds of vectors
namespace fairway::lanes {

/// In an alias of its own g++ 12 forgets how long a vector is.
template <std::size_t N>
struct Registers {
  typedef double Numbers __attribute__((vector_size(N * sizeof(double))));  // NOLINT(modernize-use-using)
  typedef std::int64_t Integers
      __attribute__((vector_size(N * sizeof(double))));  // NOLINT(modernize-use-using)
};
template <std::size_t N>
using Numbers = typename Registers<N>::Numbers;
template <std::size_t N>
using Integers = typename Registers<N>::Integers;

template <std::size_t N>
struct MaskBits {
  using type = Integers<N>;  // all ones where true
};
#if defined(__AVX512DQ__)
template <>
struct MaskBits<8> {
  using type = std::uint8_t;
};
#endif

/// For each lane whether.
template <std::size_t N>
struct PackMask {
  using Bits = typename MaskBits<N>::type;

  Bits bits;

  friend PackMask operator&(PackMask a, PackMask b) { return {static_cast<Bits>(a.bits & b.bits)}; }
  friend PackMask operator|(PackMask a, PackMask b) { return {static_cast<Bits>(a.bits | b.bits)}; }
  friend PackMask operator!(PackMask a) { return {static_cast<Bits>(~a.bits)}; }
};

/// `N` numbers.
template <std::size_t N>
struct Pack {
  Numbers<N> numbers;

  Pack() = default;
  Pack(Numbers<N> n) : numbers{n} {}                   // NOLINT(google-explicit-constructor): it is the same
  Pack(double same) : numbers{same - Numbers<N>{}} {}  // NOLINT(google-explicit-constructor): as for one

  static Pack from(const double* lane) {
    Pack pack;
    __builtin_memcpy(&pack.numbers, lane, sizeof pack.numbers);
    return pack;
  }
  void to(double* lane) const { __builtin_memcpy(lane, &numbers, sizeof numbers); }

  /// 0, 1, 2...
  static Pack counting() {
    Pack pack;
    for (std::size_t i = 0; i < N; ++i) pack.numbers[i] = static_cast<double>(i);
    return pack;
  }

  friend Pack operator+(Pack a, Pack b) { return {a.numbers + b.numbers}; }
  friend Pack operator-(Pack a, Pack b) { return {a.numbers - b.numbers}; }
  friend Pack operator*(Pack a, Pack b) { return {a.numbers * b.numbers}; }
  friend Pack operator/(Pack a, Pack b) { return {a.numbers / b.numbers}; }
  friend Pack operator-(Pack a) { return {-a.numbers}; }

  friend PackMask<N> operator<(Pack a, Pack b) {
#if defined(__AVX512DQ__)
    if constexpr (N == 8)
      return {_mm512_cmp_pd_mask((__m512d)a.numbers, (__m512d)b.numbers, _CMP_LT_OQ)};
    else  // NOLINT(readability-else-after-return): what is not compiled may not be looked at
#endif
      return {a.numbers < b.numbers};
  }
  friend PackMask<N> operator<=(Pack a, Pack b) {
#if defined(__AVX512DQ__)
    if constexpr (N == 8)
      return {_mm512_cmp_pd_mask((__m512d)a.numbers, (__m512d)b.numbers, _CMP_LE_OQ)};
    else  // NOLINT(readability-else-after-return): what is not compiled may not be looked at
#endif
      return {a.numbers <= b.numbers};
  }
  friend PackMask<N> operator>(Pack a, Pack b) { return b < a; }
  friend PackMask<N> operator>=(Pack a, Pack b) { return b <= a; }
};

template <std::size_t N>
Pack<N> select(const PackMask<N>& mask, const Pack<N>& yes, const Pack<N>& no) {
#if defined(__AVX512DQ__)
  if constexpr (N == 8)
    return {(Numbers<N>)_mm512_mask_blend_pd(mask.bits, (__m512d)no.numbers, (__m512d)yes.numbers)};
  else
#endif
#if defined(__AVX__)
      if constexpr (N == 4)
    return {(Numbers<N>)_mm256_blendv_pd((__m256d)no.numbers, (__m256d)yes.numbers, (__m256d)mask.bits)};
  else
#endif
    return {(Numbers<N>)((mask.bits & (Integers<N>)yes.numbers) | (~mask.bits & (Integers<N>)no.numbers))};
}

template <std::size_t N>
Pack<N> square_root(const Pack<N>& value) {
#if defined(__AVX512DQ__)
  if constexpr (N == 8)  // masked, since g++ 12 warns in the plain one
    return {(Numbers<N>)_mm512_maskz_sqrt_pd(0xFF, (__m512d)value.numbers)};
#endif
#if defined(__AVX__)
  if constexpr (N == 4) return {(Numbers<N>)_mm256_sqrt_pd((__m256d)value.numbers)};
#endif
#if defined(__SSE2__)
  if constexpr (N == 2) return {(Numbers<N>)_mm_sqrt_pd((__m128d)value.numbers)};
#endif
  Pack<N> root;
  for (std::size_t i = 0; i < N; ++i) root.numbers[i] = __builtin_sqrt(value.numbers[i]);
  return root;
}

/// One bit for each lane, the first lane's the lowest.
template <std::size_t N>
unsigned bits_of(const PackMask<N>& mask) {
#if defined(__AVX512DQ__)
  if constexpr (N == 8)
    return mask.bits;
  else
#endif
#if defined(__AVX__)
      if constexpr (N == 4)
    return static_cast<unsigned>(_mm256_movemask_pd((__m256d)mask.bits));
  else
#endif
#if defined(__SSE2__)
      if constexpr (N == 2)
    return static_cast<unsigned>(_mm_movemask_pd((__m128d)mask.bits));
  else
#endif
  {
    unsigned bits = 0;
    for (std::size_t i = 0; i < N; ++i) bits |= (mask.bits[i] != 0 ? 1U : 0U) << i;
    return bits;
  }
}

/// Writes to `at` the lanes that are in the mask, one after the other, and what means nothing up to `at` + N.
template <std::size_t N>
void write_those_in(const PackMask<N>& mask, const Pack<N>& pack, double* at) {
#if defined(__AVX512DQ__)
  if constexpr (N == 8)
    return _mm512_storeu_pd(at, _mm512_maskz_compress_pd(mask.bits, (__m512d)pack.numbers));
#endif
  const unsigned bits = bits_of(mask);
  for (std::size_t lane = 0, count = 0; lane < N; ++lane) {
    at[count] = pack.numbers[lane];
    count += bits >> lane & 1U;
  }
}

template <std::size_t N>
bool any(const PackMask<N>& mask) {
  return bits_of(mask) != 0;
}

template <std::size_t N>
Pack<N> magnitude(const Pack<N>& value) {
  return {(Numbers<N>)((Integers<N>)value.numbers & INT64_MAX)};
}

template <std::size_t N>
Pack<N> with_sign_of(const Pack<N>& size, const Pack<N>& sign) {
  const auto bits = (Integers<N>)magnitude(size).numbers;
  return {(Numbers<N>)(bits | ((Integers<N>)sign.numbers & INT64_MIN))};
}

/// Vectors whose numbers stand in three columns, `stride` apart.
template <std::size_t N>
VecOf<Pack<N>> vector_at(const double* at, std::size_t stride = N) {
  return {Pack<N>::from(at), Pack<N>::from(at + stride), Pack<N>::from(at + 2 * stride)};
}

template <std::size_t N>
void write_vector(const VecOf<Pack<N>>& v, double* at) {
  v.x().to(at);
  v.y().to(at + N);
  v.z().to(at + 2 * N);
}

}  // namespace fairway::lanes
// NOLINTEND(google-readability-casting, cppcoreguidelines-pro-type-cstyle-cast)
