#include "graph/compare/signed_difference.h"

#include "gpu/objects/draw.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
constexpr const char* signed_text = R"(
uniform float gain;
void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec3 added = displayed(other_at(texel)) - displayed(ours_at(texel));
    color = vec4(0.5 + gain * added, 1.0);
}
)";
}  // namespace

Result<SignedDifference> SignedDifference::make() {
    auto program = build_pair_program(signed_text);
    if (!program)
        return fail(program.error());
    return SignedDifference(std::move(*program));
}

void SignedDifference::draw(const Pair& pair, double gain, const gpu::Canvas& to) {
    m_program.write("gain", std::array{gain});
    const gpu::DrawScope scope;
    bind_pair(pair, m_program, m_samplers);
    to.bind();
    m_vertices.bind();
    gpu::draw_triangle();
    m_samplers.release();
}

double gain_for(double largest) {
    constexpr double max_stops = 8.0;
    if (!(largest > 0.0) || !std::isfinite(largest))
        return 1.0;
    return std::exp2(std::clamp(std::floor(std::log2(0.5 / largest)), 0.0, max_stops));
}
