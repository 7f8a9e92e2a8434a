#include "graph/compare/pair_meter.h"

#include "gpu/objects/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace {
constexpr int block_side = 32;  // texels; also in blocks_text

constexpr const char* blocks_text = R"(
void main() {
    ivec2 low = ivec2(gl_FragCoord.xy) * 32;
    ivec2 end = min(low + 32, textureSize(ours, 0));
    vec4 sums = vec4(0.0);
    for (int y = low.y; y < end.y; ++y)
        for (int x = low.x; x < end.x; ++x)
            add(ours_at(ivec2(x, y)), other_at(ivec2(x, y)), sums);
    color = sums;
}
)";

// Sum of absolute differences, of squares, largest, pixels beyond the tolerance.
constexpr const char* distances_text = R"(
uniform float beyond;
void add(vec3 a, vec3 b, inout vec4 sums) {
    vec3 away = apart(a, b);
    float worst = max(away.r, max(away.g, away.b));
    sums.x += away.r + away.g + away.b;
    sums.y += dot(away, away);
    sums.z = max(sums.z, worst);
    sums.w += worst > beyond ? 1.0 : 0.0;
}
)";

// Sum of light of `ours` and of `other`, number of pixels.
constexpr const char* light_text = R"(
bool is_finite(vec3 c) { return !any(isnan(c)) && !any(isinf(c)); }
void add(vec3 a, vec3 b, inout vec4 sums) {
    if (!is_finite(a) || !is_finite(b)) return;
    sums.x += luminance(to_light(clamp(a, 0.0, 1.0)));
    sums.y += luminance(to_light(clamp(b, 0.0, 1.0)));
    sums.z += 1.0;
}
)";

// Sum of differences, largest, sum of levels: of all components.
constexpr const char* change_text = R"(
uniform bool as_shown;
void add(vec3 a, vec3 b, inout vec4 sums) {
    if (as_shown) {
        a = displayed(a);
        b = displayed(b);
    }
    vec3 away = apart(a, b);
    sums.x += away.r + away.g + away.b;
    sums.y = max(sums.y, max(away.r, max(away.g, away.b)));
    vec3 size = abs(a);
    float level = size.r + size.g + size.b;
    sums.z += isnan(level) || isinf(level) ? 0.0 : level;
}
)";

Extent blocks_of(Extent extent) {
    return {(extent.width + block_side - 1) / block_side,
            (extent.height + block_side - 1) / block_side};
}

Distances summed_distances(const std::vector<float>& blocks, Extent extent) {
    DifferenceSums sums;
    for (std::size_t i = 0; i < blocks.size(); i += 4) {
        sums.absolute += static_cast<double>(blocks[i]);
        sums.squares += static_cast<double>(blocks[i + 1]);
        sums.largest = std::max(sums.largest, static_cast<double>(blocks[i + 2]));
        sums.beyond += static_cast<double>(blocks[i + 3]);
    }
    return distances_of(sums, extent, 3);  // a single channel counts 3 times: same mean
}

Luminances summed_luminances(const std::vector<float>& blocks) {
    Luminances sums;
    double pixels = 0.0;
    for (std::size_t i = 0; i < blocks.size(); i += 4) {
        sums.ours += static_cast<double>(blocks[i]);
        sums.other += static_cast<double>(blocks[i + 1]);
        pixels += static_cast<double>(blocks[i + 2]);
    }
    return pixels > 0.0 ? Luminances{sums.ours / pixels, sums.other / pixels} : Luminances{};
}

PassChange summed_change(const std::vector<float>& blocks, Extent extent) {
    PassChange sums;
    for (std::size_t i = 0; i < blocks.size(); i += 4) {
        sums.mean += static_cast<double>(blocks[i]);
        sums.largest = std::max(sums.largest, static_cast<double>(blocks[i + 1]));
        sums.level += static_cast<double>(blocks[i + 2]);
    }
    const double numbers = 3.0 * extent.width * extent.height;
    return {sums.mean / numbers, sums.largest, sums.level / numbers};
}
}  // namespace

PairMeter::PairMeter(gpu::Program distances, gpu::Program light, gpu::Program change)
    : m_distances(std::move(distances)), m_light(std::move(light)), m_change(std::move(change)) {}

Result<PairMeter> PairMeter::make() {
    auto distances = build_pair_program(fmt::format("{}{}", distances_text, blocks_text));
    if (!distances)
        return fail(distances.error());
    auto light = build_pair_program(fmt::format("{}{}", light_text, blocks_text));
    if (!light)
        return fail(light.error());
    auto change = build_pair_program(fmt::format("{}{}", change_text, blocks_text));
    if (!change)
        return fail(change.error());
    return PairMeter(std::move(*distances), std::move(*light), std::move(*change));
}

// False without memory; then nothing is measured.
bool PairMeter::draw(const Pair& pair, const gpu::Program& program) {
    m_measured = pair.ours.extent();
    const Extent blocks = blocks_of(m_measured);
    if (blocks.is_empty())
        return false;
    if (!m_blocks || m_blocks->texture().extent() != blocks) {
        m_blocks.reset();
        auto made = gpu::Canvas::make(blocks, Format::rgba32f);
        if (!made)
            return false;
        m_blocks.emplace(std::move(*made));
    }
    const gpu::DrawScope scope;
    bind_pair(pair, program, m_samplers);
    m_vertices.bind();
    m_blocks->bind();
    gpu::draw_triangle();
    m_samplers.release();
    return true;
}

void PairMeter::start_distances(const Pair& pair, double tolerance) {
    stop();
    m_distances.write("beyond", std::array{tolerance});
    if (draw(pair, m_distances))
        m_sums_to_come.emplace(*m_blocks);
}

void PairMeter::start_luminances(const Pair& pair) {
    stop();
    if (draw(pair, m_light))
        m_light_to_come.emplace(*m_blocks);
}

void PairMeter::start_change(const Pair& pair, bool as_shown) {
    stop();
    m_change.write("as_shown", std::array{as_shown ? 1.0 : 0.0});
    if (draw(pair, m_change))
        m_change_to_come.emplace(*m_blocks);
}

std::optional<PairMeasured> PairMeter::take() {
    std::optional<PairMeasured> measured;
    if (m_sums_to_come && m_sums_to_come->is_available())
        measured = PairMeasured{.distances = summed_distances(m_sums_to_come->take(), m_measured)};
    else if (m_light_to_come && m_light_to_come->is_available())
        measured = PairMeasured{.luminances = summed_luminances(m_light_to_come->take())};
    else if (m_change_to_come && m_change_to_come->is_available())
        measured = PairMeasured{.change = summed_change(m_change_to_come->take(), m_measured)};
    if (measured)
        stop();
    return measured;
}

void PairMeter::stop() {
    m_sums_to_come.reset();
    m_light_to_come.reset();
    m_change_to_come.reset();
}
