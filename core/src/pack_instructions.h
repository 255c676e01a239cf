#pragma once

// Included by pack.h: what the compiler's vector types make long code of, in the words of the
// instruction set. Least, greatest, roots and choices are one instruction each (GCC 12 takes two to
// four for the first two), and comparisons of 512 bits stay in mask registers.
//
// The results are those of pack.h's own functions, to the last bit and for every input: the
// operands of min and max stand so that a number that is not one is treated alike.

namespace dbd {

#ifdef __SSE2__
inline Pack<float, 4> Min(const Pack<float, 4>& a, const Pack<float, 4>& b) {
  return Pack<float, 4>(_mm_min_ps(a.v, b.v));
}
inline Pack<float, 4> Max(const Pack<float, 4>& a, const Pack<float, 4>& b) {
  return Pack<float, 4>(_mm_max_ps(b.v, a.v));
}
inline Pack<float, 4> Sqrt(const Pack<float, 4>& a) { return Pack<float, 4>(_mm_sqrt_ps(a.v)); }
inline bool AnyOf(const PackMask<float, 4>& mask) {
  return _mm_movemask_ps(__builtin_bit_cast(Pack<float, 4>::Vector, mask.v)) != 0;
}

inline Pack<double, 2> Min(const Pack<double, 2>& a, const Pack<double, 2>& b) {
  return Pack<double, 2>(_mm_min_pd(a.v, b.v));
}
inline Pack<double, 2> Max(const Pack<double, 2>& a, const Pack<double, 2>& b) {
  return Pack<double, 2>(_mm_max_pd(b.v, a.v));
}
inline Pack<double, 2> Sqrt(const Pack<double, 2>& a) { return Pack<double, 2>(_mm_sqrt_pd(a.v)); }
inline bool AnyOf(const PackMask<double, 2>& mask) {
  return _mm_movemask_pd(__builtin_bit_cast(Pack<double, 2>::Vector, mask.v)) != 0;
}

#endif

#if DBD_PACK_TARGET >= 2
[[gnu::always_inline]] inline Pack<float, 4> MultiplyAdd(const Pack<float, 4>& a,
                                                         const Pack<float, 4>& b,
                                                         const Pack<float, 4>& c) {
  return Pack<float, 4>(_mm_fmadd_ps(a.v, b.v, c.v));
}
[[gnu::always_inline]] inline Pack<float, 8> MultiplyAdd(const Pack<float, 8>& a,
                                                         const Pack<float, 8>& b,
                                                         const Pack<float, 8>& c) {
  return Pack<float, 8>(_mm256_fmadd_ps(a.v, b.v, c.v));
}
[[gnu::always_inline]] inline Pack<double, 4> MultiplyAdd(const Pack<double, 4>& a,
                                                          const Pack<double, 4>& b,
                                                          const Pack<double, 4>& c) {
  return Pack<double, 4>(_mm256_fmadd_pd(a.v, b.v, c.v));
}
inline Pack<float, 8> Min(const Pack<float, 8>& a, const Pack<float, 8>& b) {
  return Pack<float, 8>(_mm256_min_ps(a.v, b.v));
}
inline Pack<float, 8> Max(const Pack<float, 8>& a, const Pack<float, 8>& b) {
  return Pack<float, 8>(_mm256_max_ps(b.v, a.v));
}
inline Pack<float, 8> Sqrt(const Pack<float, 8>& a) { return Pack<float, 8>(_mm256_sqrt_ps(a.v)); }
inline Pack<double, 4> Min(const Pack<double, 4>& a, const Pack<double, 4>& b) {
  return Pack<double, 4>(_mm256_min_pd(a.v, b.v));
}
inline Pack<double, 4> Max(const Pack<double, 4>& a, const Pack<double, 4>& b) {
  return Pack<double, 4>(_mm256_max_pd(b.v, a.v));
}
inline Pack<double, 4> Sqrt(const Pack<double, 4>& a) {
  return Pack<double, 4>(_mm256_sqrt_pd(a.v));
}
#endif

#if DBD_PACK_TARGET == 2
inline Pack<float, 4> Select(const PackMask<float, 4>& mask, const Pack<float, 4>& yes,
                             const Pack<float, 4>& no) {
  return Pack<float, 4>(
      _mm_blendv_ps(no.v, yes.v, __builtin_bit_cast(Pack<float, 4>::Vector, mask.v)));
}
inline Pack<float, 8> Select(const PackMask<float, 8>& mask, const Pack<float, 8>& yes,
                             const Pack<float, 8>& no) {
  return Pack<float, 8>(
      _mm256_blendv_ps(no.v, yes.v, __builtin_bit_cast(Pack<float, 8>::Vector, mask.v)));
}
inline bool AnyOf(const PackMask<float, 8>& mask) {
  return _mm256_movemask_ps(__builtin_bit_cast(Pack<float, 8>::Vector, mask.v)) != 0;
}
inline Pack<double, 4> Select(const PackMask<double, 4>& mask, const Pack<double, 4>& yes,
                              const Pack<double, 4>& no) {
  return Pack<double, 4>(
      _mm256_blendv_pd(no.v, yes.v, __builtin_bit_cast(Pack<double, 4>::Vector, mask.v)));
}
inline bool AnyOf(const PackMask<double, 4>& mask) {
  return _mm256_movemask_pd(__builtin_bit_cast(Pack<double, 4>::Vector, mask.v)) != 0;
}
#endif

#if DBD_PACK_TARGET >= 512
// With all lanes in the mask the compiler drops it; without one GCC 12 warns of its own headers
// (bug 105593).
inline constexpr __mmask16 kAllOfSixteen = 0xffff;
inline constexpr __mmask8 kAllOfEight = 0xff;

[[gnu::always_inline]] inline Pack<float, 16> MultiplyAdd(const Pack<float, 16>& a,
                                                          const Pack<float, 16>& b,
                                                          const Pack<float, 16>& c) {
  return Pack<float, 16>(_mm512_fmadd_ps(a.v, b.v, c.v));
}
[[gnu::always_inline]] inline Pack<double, 8> MultiplyAdd(const Pack<double, 8>& a,
                                                          const Pack<double, 8>& b,
                                                          const Pack<double, 8>& c) {
  return Pack<double, 8>(_mm512_fmadd_pd(a.v, b.v, c.v));
}
inline Pack<float, 16> Min(const Pack<float, 16>& a, const Pack<float, 16>& b) {
  return Pack<float, 16>(_mm512_mask_min_ps(a.v, kAllOfSixteen, a.v, b.v));
}
inline Pack<float, 16> Max(const Pack<float, 16>& a, const Pack<float, 16>& b) {
  return Pack<float, 16>(_mm512_mask_max_ps(a.v, kAllOfSixteen, b.v, a.v));
}
inline Pack<float, 16> Sqrt(const Pack<float, 16>& a) {
  return Pack<float, 16>(_mm512_mask_sqrt_ps(a.v, kAllOfSixteen, a.v));
}
inline PackMask<float, 16> operator<(const Pack<float, 16>& a, const Pack<float, 16>& b) {
  return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)};
}
inline PackMask<float, 16> operator>(const Pack<float, 16>& a, const Pack<float, 16>& b) {
  return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ)};
}
inline Pack<float, 16> Select(const PackMask<float, 16>& mask, const Pack<float, 16>& yes,
                              const Pack<float, 16>& no) {
  return Pack<float, 16>(_mm512_mask_blend_ps(mask.bits, no.v, yes.v));
}
inline bool AnyOf(const PackMask<float, 16>& mask) { return mask.bits != 0; }
inline Pack<double, 8> Min(const Pack<double, 8>& a, const Pack<double, 8>& b) {
  return Pack<double, 8>(_mm512_mask_min_pd(a.v, kAllOfEight, a.v, b.v));
}
inline Pack<double, 8> Max(const Pack<double, 8>& a, const Pack<double, 8>& b) {
  return Pack<double, 8>(_mm512_mask_max_pd(a.v, kAllOfEight, b.v, a.v));
}
inline Pack<double, 8> Sqrt(const Pack<double, 8>& a) {
  return Pack<double, 8>(_mm512_mask_sqrt_pd(a.v, kAllOfEight, a.v));
}
inline PackMask<double, 8> operator<(const Pack<double, 8>& a, const Pack<double, 8>& b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)};
}
inline PackMask<double, 8> operator>(const Pack<double, 8>& a, const Pack<double, 8>& b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)};
}
inline Pack<double, 8> Select(const PackMask<double, 8>& mask, const Pack<double, 8>& yes,
                              const Pack<double, 8>& no) {
  return Pack<double, 8>(_mm512_mask_blend_pd(mask.bits, no.v, yes.v));
}
inline bool AnyOf(const PackMask<double, 8>& mask) { return mask.bits != 0; }
inline PackMask<float, 8> operator<(const Pack<float, 8>& a, const Pack<float, 8>& b) {
  return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)};
}
inline PackMask<float, 8> operator>(const Pack<float, 8>& a, const Pack<float, 8>& b) {
  return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ)};
}
inline Pack<float, 8> Select(const PackMask<float, 8>& mask, const Pack<float, 8>& yes,
                             const Pack<float, 8>& no) {
  return Pack<float, 8>(_mm256_mask_blend_ps(mask.bits, no.v, yes.v));
}
inline bool AnyOf(const PackMask<float, 8>& mask) { return mask.bits != 0; }
inline PackMask<double, 4> operator<(const Pack<double, 4>& a, const Pack<double, 4>& b) {
  return {_mm256_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)};
}
inline PackMask<double, 4> operator>(const Pack<double, 4>& a, const Pack<double, 4>& b) {
  return {_mm256_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)};
}
inline Pack<double, 4> Select(const PackMask<double, 4>& mask, const Pack<double, 4>& yes,
                              const Pack<double, 4>& no) {
  return Pack<double, 4>(_mm256_mask_blend_pd(mask.bits, no.v, yes.v));
}
inline bool AnyOf(const PackMask<double, 4>& mask) { return mask.bits != 0; }
#endif

}  // namespace dbd
