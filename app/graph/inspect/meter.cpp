#include "graph/inspect/meter.h"

#include "gpu/objects/draw.h"
#include "graph/inspect/texel_programs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {
// The counts of a block are packed into one float. They are exact below 2^24, so a block has less
// than 2^12 texels.
constexpr int max_block_side = 63;
constexpr int min_block_side = 8;
constexpr int max_blocks = 261;  // per side; 16384 / 63
constexpr int max_samples = 256;
constexpr double packing = 4096.0;

constexpr const char* meter_start = R"(#version 410 core
out vec4 color;
uniform int block_side;  // texels; 0: samples are taken
uniform vec2 cell;       // texels a sample
uniform bool counts_clipped;
uniform float ceiling;
)";

constexpr const char* meter_end = R"(
vec4 block_sums(ivec2 low) {
    ivec2 end = min(low + block_side, textureSize(shown, 0));
    float least = 3.4e38, most = -3.4e38, sum = 0.0, nans = 0.0, infinities = 0.0;
    for (int y = low.y; y < end.y; ++y)
        for (int x = low.x; x < end.x; ++x) {
            vec3 numbers = chosen(texel_at(ivec2(x, y)));
            if (any(isnan(numbers))) {
                nans += 1.0;
            } else if (any(isinf(numbers))) {
                infinities += 1.0;
            } else {
                least = min(least, min(numbers.r, min(numbers.g, numbers.b)));
                most = max(most, max(numbers.r, max(numbers.g, numbers.b)));
                sum += (numbers.r + numbers.g + numbers.b) / 3.0;
            }
        }
    return vec4(least, most, sum, nans + 4096.0 * infinities);
}

// Somewhere in the cell, or a mask that repeats with the cells would show one of its colours alone.
ivec2 texel_of(ivec2 cell_at) {
    uint noise = uint(cell_at.x) * 0x9E3779B1u ^ uint(cell_at.y) * 0x85EBCA77u;
    noise = (noise ^ (noise >> 15)) * 0x2C1B3C6Du;
    noise = (noise ^ (noise >> 12)) * 0x297A2D39u;
    noise ^= noise >> 15;
    vec2 part = vec2(noise & 0xFFFFu, noise >> 16) / 65536.0;
    return min(ivec2((vec2(cell_at) + part) * cell), textureSize(shown, 0) - 1);
}

// Texels of a sample's cell that reach the ceiling. The cells cover every texel once.
float clipped_in(ivec2 cell_at) {
    ivec2 low = ivec2(vec2(cell_at) * cell + 0.5);
    ivec2 end = min(ivec2(vec2(cell_at + 1) * cell + 0.5), textureSize(shown, 0));
    float clipped = 0.0;
    for (int y = low.y; y < end.y; ++y)
        for (int x = low.x; x < end.x; ++x) {
            vec3 numbers = chosen(texel_at(ivec2(x, y)));
            bool is_finite = !any(isnan(numbers)) && !any(isinf(numbers));
            if (is_finite && max(numbers.r, max(numbers.g, numbers.b)) >= ceiling)
                clipped += 1.0;
        }
    return clipped;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (block_side > 0)
        color = block_sums(at * block_side);
    else
        color = vec4(chosen(texel_at(texel_of(at))), counts_clipped ? clipped_in(at) : 0.0);
}
)";

int block_side_for(Extent extent) {
    const int longest = std::max(extent.width, extent.height);
    return std::clamp((longest + max_blocks - 1) / max_blocks, min_block_side, max_block_side);
}

Extent blocks_of(Extent extent, int side) {
    return {(extent.width + side - 1) / side, (extent.height + side - 1) / side};
}

Statistics combined(const std::vector<float>& blocks, Extent extent) {
    const int side = block_side_for(extent);
    const Extent count = blocks_of(extent, side);
    Statistics all;
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -minimum;
    double sum = 0.0;
    const float* block = blocks.data();
    for (int y = 0; y < count.height; ++y)
        for (int x = 0; x < count.width; ++x, block += 4) {
            const int texels =
                std::min(side, extent.width - x * side) * std::min(side, extent.height - y * side);
            const auto packed = static_cast<double>(block[3]);
            const auto infinite = static_cast<std::size_t>(packed / packing);
            const auto not_a_number =
                static_cast<std::size_t>(packed - static_cast<double>(infinite) * packing);
            const std::size_t finite = static_cast<std::size_t>(texels) - infinite - not_a_number;
            all.infinite += infinite;
            all.not_a_number += not_a_number;
            all.finite += finite;
            if (finite == 0)
                continue;
            minimum = std::min(minimum, static_cast<double>(block[0]));
            maximum = std::max(maximum, static_cast<double>(block[1]));
            sum += static_cast<double>(block[2]);
        }
    if (all.finite > 0) {
        all.minimum = minimum;
        all.maximum = maximum;
        all.mean = sum / static_cast<double>(all.finite);
    }
    return all;
}

Picture picture_of(const std::vector<float>& texels, Extent extent, bool is_color) {
    Picture picture{extent, is_color ? 3 : 1, Encoding::linear, {}};
    picture.pixels.reserve(texels.size() / 4 * static_cast<std::size_t>(picture.channels));
    for (std::size_t i = 0; i < texels.size(); i += 4)
        picture.pixels.insert(picture.pixels.end(), &texels[i], &texels[i] + picture.channels);
    return picture;
}
std::size_t clipped_in(const std::vector<float>& texels) {
    double clipped = 0.0;
    for (std::size_t i = 3; i < texels.size(); i += 4)
        clipped += static_cast<double>(texels[i]);
    return static_cast<std::size_t>(clipped);
}
}  // namespace

Result<MeterPrograms> MeterPrograms::make() {
    auto programs = build_texel_programs(meter_start, meter_end);
    if (!programs)
        return fail(programs.error());
    return MeterPrograms{std::move(*programs)};
}

void Meter::draw(const gpu::Texture& from, const gpu::Program& program, Channels channels,
                 std::optional<double> ceiling) {
    const Extent samples = m_samples->texture().extent();
    // A single channel is stored in red. The other channels are not part of the target.
    const bool is_lone = channels == Channels::color && !m_is_color;
    program.write("channels", std::array{static_cast<double>(is_lone ? Channels::red : channels)});
    program.write("cell", std::array{static_cast<double>(m_measured.width) / samples.width,
                                     static_cast<double>(m_measured.height) / samples.height});
    program.write("counts_clipped", std::array{ceiling ? 1.0 : 0.0});
    program.write("ceiling", std::array{ceiling.value_or(0.0)});
    const gpu::DrawScope scope;
    m_samplers.bind(0, from, {Filter::nearest, Wrap::edge, false});
    program.use();
    m_vertices.bind();
    m_blocks->bind();
    program.write("block_side", std::array{static_cast<double>(block_side_for(m_measured))});
    gpu::draw_triangle();
    m_samples->bind();
    program.write("block_side", std::array{0.0});
    gpu::draw_triangle();
    m_samplers.release();
}

void Meter::start(const gpu::Texture& from, Channels channels, std::optional<double> ceiling) {
    stop();
    m_measured = from.extent();
    m_is_color = channels == Channels::color && info_of(from.format()).channels > 1;
    const int side = block_side_for(m_measured);
    const Extent samples{std::min(m_measured.width, max_samples),
                         std::min(m_measured.height, max_samples)};
    const gpu::Program* program = m_programs->all.find(from.format());
    if (!program || m_measured.is_empty() || !fit_floats(m_blocks, blocks_of(m_measured, side)) ||
        !fit_floats(m_samples, samples))
        return;
    draw(from, *program, channels, ceiling);
    m_blocks_to_come.emplace(*m_blocks);
    m_samples_to_come.emplace(*m_samples);
}

std::optional<Measured> Meter::take() {
    if (!is_busy() || !m_samples_to_come->is_available())  // requested last
        return std::nullopt;
    const std::vector<float> samples = m_samples_to_come->take();
    Measured measured{combined(m_blocks_to_come->take(), m_measured),
                      picture_of(samples, m_samples->texture().extent(), m_is_color),
                      clipped_in(samples)};
    stop();
    return measured;
}

void Meter::stop() {
    m_blocks_to_come.reset();
    m_samples_to_come.reset();
}
