// Owen-scrambled Sobol points: numbers that fill space far more evenly than random ones, and are
// unbiased. sobol_digits() computes the points once. Each pixel scrambles them differently.
#ifndef AFTERGLOW_SOBOL
#define AFTERGLOW_SOBOL

#include "noise.glsl"

const int sobol_dimensions = 20;
const int sobol_bits = 14;  // of an index: after 2^14 points, they are scrambled again

// For the dimensions after the first: degree of the primitive polynomial, its inner coefficients,
// and the first direction numbers. Source: S. Joe and F. Y. Kuo, "Constructing Sobol sequences with
// better two-dimensional projections", SIAM J. Sci. Comput. 30, 2008.
const int sobol_degree[19] = int[](1, 2, 3, 3, 4, 4, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 7);
const int sobol_polynomial[19] =
    int[](0, 1, 1, 2, 1, 4, 2, 4, 7, 11, 13, 14, 1, 13, 16, 19, 22, 25, 1);
const int sobol_start[19 * 7] = int[](
    1, 0, 0, 0, 0, 0, 0,      1, 3, 0, 0, 0, 0, 0,      1, 3, 1, 0, 0, 0, 0,
    1, 1, 1, 0, 0, 0, 0,      1, 1, 3, 3, 0, 0, 0,      1, 3, 5, 13, 0, 0, 0,
    1, 1, 5, 5, 17, 0, 0,     1, 1, 5, 5, 5, 0, 0,      1, 1, 7, 11, 19, 0, 0,
    1, 1, 5, 1, 1, 0, 0,      1, 1, 1, 3, 11, 0, 0,     1, 3, 5, 5, 31, 0, 0,
    1, 3, 3, 9, 7, 49, 0,     1, 1, 1, 15, 21, 21, 0,   1, 3, 1, 13, 27, 49, 0,
    1, 1, 1, 15, 7, 5, 0,     1, 3, 1, 15, 13, 25, 0,   1, 1, 5, 5, 19, 61, 0,
    1, 3, 7, 11, 23, 15, 103);

// The next direction number, from the `degree` numbers before it (I. M. Sobol, 1967; P. Bratley and
// B. L. Fox, "Algorithm 659", ACM TOMS 14, 1988).
uint next_direction(uint before[sobol_bits], int k, int degree, int polynomial) {
    uint oldest = before[k - degree];
    uint next = oldest ^ (oldest << degree);
    for (int i = 1; i < degree; ++i)
        if (((polynomial >> (degree - 1 - i)) & 1) != 0)
            next ^= before[k - i] << i;
    return next;
}

// The binary digits of point `index` in a dimension, counted from 0. The first digit after the
// binary point is the highest bit.
uint sobol_digits(uint index, int dimension) {
    if (dimension == 0)
        return bitfieldReverse(index);
    int row = dimension - 1;
    uint directions[sobol_bits];
    uint digits = 0u;
    for (int k = 0; k < sobol_bits; ++k) {
        directions[k] = k < sobol_degree[row]
                            ? uint(sobol_start[row * 7 + k])
                            : next_direction(directions, k, sobol_degree[row], sobol_polynomial[row]);
        if (((index >> k) & 1u) != 0u)
            digits ^= directions[k] << (31 - k);
    }
    return digits;
}

// A random Owen scrambling: the digits above a digit and `seed` decide whether it is inverted. In
// the permutation of S. Laine and T. Karras ("Stratified Sampling for Stochastic Transparency",
// EGSR 2011), each bit changes only the bits above it. So the digits are reversed before and after
// it (B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020).
uvec4 owen_scrambled(uvec4 digits, uvec4 seed) {
    uvec4 x = bitfieldReverse(digits) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return bitfieldReverse(x);
}

// Shuffles the order of the points in the same way. Each run of 2^k points that starts at a
// multiple of 2^k stays together, so it is as uniform as before. Two orders are combined at random.
uint shuffled_index(uint index, uint seed) {
    uint digits = index << (32 - sobol_bits);
    return owen_scrambled(uvec4(digits), uvec4(seed)).x >> (32 - sobol_bits);
}

// Four seeds from a key.
uvec4 seeds_of(uvec3 key) {
    uvec3 three = hash(key);
    return uvec4(three, hash(three).x);
}

// Digits as numbers, 0 <= n < 1.
vec4 fractions(uvec4 digits) {
    return vec4(digits >> 8u) / 16777216.0;
}

#endif
