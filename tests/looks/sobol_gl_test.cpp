// The points of shaders/include/sobol.glsl compared with published ones, and their uniformity.
#include "looks/glsl_function.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <utility>

namespace {
/// x: the index of a point; y: its dimension; z: the seed of scrambling, 0: none.
std::vector<double> points(const std::vector<Vec4>& inputs) {
    std::vector<double> numbers;
    for (const Vec4& drawn : run_glsl("#include \"sobol.glsl\"\nvec4 f(vec4 x) {\n"
                                      "uvec4 digits = uvec4(sobol_digits(uint(x.x), int(x.y)));\n"
                                      "return fractions(x.z == 0.0 ? digits : "
                                      "owen_scrambled(digits, uvec4(uint(x.z)))); }\n",
                                      inputs))
        numbers.push_back(drawn[0]);
    return numbers;
}
}  // namespace

TEST_CASE("the first points match those printed by Joe and Kuo") {
    // In three dimensions, in Gray code order.
    constexpr double printed[8][3] = {{0, 0, 0},          {.5, .5, .5},       {.75, .25, .25},
                                      {.25, .75, .75},    {.375, .375, .625}, {.875, .875, .125},
                                      {.625, .125, .875}, {.125, .625, .375}};
    std::vector<Vec4> inputs;
    for (unsigned i = 0; i < 8; ++i)
        for (unsigned dimension = 0; dimension < 3; ++dimension)
            inputs.push_back({static_cast<double>(i ^ (i >> 1u)), static_cast<double>(dimension)});
    const auto drawn = points(inputs);
    for (std::size_t i = 0; i < 24; ++i)
        CHECK(drawn[i] == printed[i / 3][i % 3]);
}

TEST_CASE("scrambled or not, 256 points are stratified in each dimension and in 16 x 16 squares") {
    for (const double seed : {0.0, 77.0}) {
        CAPTURE(seed);
        std::vector<Vec4> inputs;
        for (int dimension = 0; dimension < 20; ++dimension)
            for (int i = 0; i < 256; ++i)
                inputs.push_back({static_cast<double>(i), static_cast<double>(dimension),
                                  seed == 0.0 ? 0.0 : seed + dimension});
        const auto drawn = points(inputs);
        for (std::size_t dimension = 0; dimension < 20; ++dimension) {
            std::set<int> places;
            for (std::size_t i = 0; i < 256; ++i)
                places.insert(static_cast<int>(drawn[256 * dimension + i] * 256.0));
            CHECK(places.size() == 256);
        }
        std::set<std::pair<int, int>> squares;
        for (std::size_t i = 0; i < 256; ++i)
            squares.insert(
                {static_cast<int>(drawn[i] * 16.0), static_cast<int>(drawn[256 + i] * 16.0)});
        CHECK(squares.size() == 256);
    }
}
