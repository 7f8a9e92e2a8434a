#include "graph/tripwire.h"

#include "gpu/draw.h"
#include "gpu/readback.h"
#include "graph/measuring.h"
#include "model/gain.h"

#include <algorithm>
#include <utility>

namespace {
constexpr int trip_block_side = 16;
constexpr int block_texels = trip_block_side * trip_block_side;
constexpr std::int64_t most_frames = 65535;  // codes stay below 2^24, exact in a float

// One fragment a block. The code is the greater the earlier the frame and the texel, and GL_MAX
// keeps the greatest: what came first is not overwritten by what came of it.
constexpr const char* finder_text = R"(#version 410 core
uniform sampler2D shown;
uniform float frames_left;
out vec4 color;
void main() {
    const int side = 16;
    ivec2 low = ivec2(gl_FragCoord.xy) * side;
    ivec2 end = min(low + side, textureSize(shown, 0));
    const uint not_finite = 0x7f800000u;  // an infinity's bits; those of NaN are greater
    uvec4 greatest = uvec4(0u);
    for (int y = low.y; y < end.y; ++y)
        for (int x = low.x; x < end.x; ++x)
            greatest = max(greatest, floatBitsToUint(abs(texelFetch(shown, ivec2(x, y), 0))));
    if (all(lessThan(greatest, uvec4(not_finite))))
        discard;
    int found = side * side - 1;
    for (int y = end.y - 1; y >= low.y; --y)
        for (int x = end.x - 1; x >= low.x; --x)
            if (any(greaterThanEqual(floatBitsToUint(abs(texelFetch(shown, ivec2(x, y), 0))),
                                     uvec4(not_finite))))
                found = (y - low.y) * side + x - low.x;
    color = vec4(frames_left * 256.0 + float(side * side - 1 - found));
}
)";

constexpr const char* mender_text = R"(#version 410 core
uniform sampler2D shown;
uniform float most;
out vec4 color;
void main() {
    vec4 texel = texelFetch(shown, ivec2(gl_FragCoord.xy), 0);
    for (int i = 0; i < 4; ++i)
        texel[i] = isnan(texel[i]) ? 0.0 : clamp(texel[i], -most, most);
    color = texel;
}
)";

Extent trip_blocks_of(Extent extent) {
    return {(extent.width + trip_block_side - 1) / trip_block_side,
            (extent.height + trip_block_side - 1) / trip_block_side};
}

constexpr Sampler trip_sampler{Filter::nearest, Wrap::edge, false};
}  // namespace

Result<std::shared_ptr<const TripwirePrograms>> build_tripwire(
    const std::shared_ptr<gpu::Context>& home) {
    auto finder = build_measuring_program(finder_text);
    if (!finder)
        return fail(finder.error());
    auto mender = build_measuring_program(mender_text);
    if (!mender)
        return fail(mender.error());
    return std::make_shared<const TripwirePrograms>(TripwirePrograms{
        gpu::ending_in(home, std::move(*finder)), gpu::ending_in(home, std::move(*mender))});
}

Tripwire::Mending Tripwire::best_mending() {
    return gpu::can_read_own_target() ? Mending::in_place : Mending::there_and_back;
}

// Where there is no memory nothing is found; the passes themselves are what needs it.
Tripwire::Watch* Tripwire::watch_for(std::size_t pass, const gpu::Texture& target) {
    const auto found = m_watches.find(pass);
    if (found != m_watches.end() && found->second.target == target.extent())
        return &found->second;
    if (found != m_watches.end()) {
        m_watches.erase(found);
        m_spares.clear();
    }
    auto blocks = gpu::Canvas::make(trip_blocks_of(target.extent()), Format::r32f);
    if (!blocks)
        return nullptr;
    return &m_watches.emplace(pass, Watch{std::move(*blocks), target.extent()}).first->second;
}

// The codes of the blocks reach only so many frames.
void Tripwire::begin(std::int64_t frame) {
    if (m_first_frame && (frame < *m_first_frame || frame - *m_first_frame > most_frames)) {
        const auto found = take(true);
        clear();
        m_found = found;
    }
    if (!m_first_frame)
        m_first_frame = frame;
}

void Tripwire::draw_found(const Watch& watch, const gpu::Texture& target, std::int64_t frame) {
    m_programs->finder->write(
        "frames_left", std::array{static_cast<double>(most_frames - (frame - *m_first_frame))});
    m_samplers.bind(0, target, trip_sampler);
    watch.blocks.bind();
    gpu::set_blend(Blend::maximum);
    m_programs->finder->use();
    m_vertices.bind();
    gpu::draw_triangle();
}

void Tripwire::look_at(std::size_t pass, const gpu::Canvas& target, std::int64_t frame,
                       bool clamps) {
    begin(frame);
    Watch* watch = watch_for(pass, target.texture());
    if (!watch)
        return;
    watch->latest = (watch->latest + 1) % watch->looks.size();
    Look& look = watch->looks[watch->latest];
    look.is_open = true;
    look.query.begin();
    draw_found(*watch, target.texture(), frame);
    look.query.end();
    if (clamps) {
        look.query.begin_condition();
        draw_mended(target);
        gpu::PixelQuery::end_condition();
    }
    m_samplers.release();
}

void Tripwire::look_behind(std::size_t cause, std::size_t pass, const gpu::Canvas& target,
                           std::int64_t frame) {
    Watch* watch = watch_for(pass, target.texture());
    const auto known = m_watches.find(cause);
    if (!watch || known == m_watches.end() || !m_first_frame)
        return;
    known->second.looks[known->second.latest].query.begin_condition();
    draw_found(*watch, target.texture(), frame);
    gpu::PixelQuery::end_condition();
    m_samplers.release();
}

void Tripwire::mend(const gpu::Canvas& target) {
    const gpu::DrawScope scope;
    draw_mended(target);
    m_samplers.release();
}

const gpu::Canvas* Tripwire::spare_for(const gpu::Texture& target) {
    const auto is_like = [&target](const gpu::Canvas& spare) {
        return spare.texture().extent() == target.extent() &&
               spare.texture().format() == target.format();
    };
    if (const auto found = std::ranges::find_if(m_spares, is_like); found != m_spares.end())
        return &*found;
    auto made = gpu::Canvas::make(target.extent(), target.format());
    return made ? &m_spares.emplace_back(std::move(*made)) : nullptr;
}

void Tripwire::draw_mender(const gpu::Canvas& from, const gpu::Canvas& to) {
    m_samplers.bind(0, from.texture(), trip_sampler);
    to.bind();
    gpu::draw_triangle();
}

void Tripwire::draw_mended(const gpu::Canvas& target) {
    gpu::set_blend(Blend::replace);
    m_programs->mender->write("most", std::array{format_limit(target.texture().format())});
    m_programs->mender->use();
    m_vertices.bind();
    if (m_mending == Mending::in_place) {
        gpu::make_own_target_readable();
        draw_mender(target, target);
    } else if (const gpu::Canvas* spare = spare_for(target.texture())) {
        draw_mender(target, *spare);
        draw_mender(*spare, target);
    }
}

std::optional<Trip> Tripwire::first_in(std::size_t pass, const Watch& watch) const {
    const Picture codes = gpu::read_picture(watch.blocks.texture());
    const auto greatest = std::max_element(codes.pixels.begin(), codes.pixels.end());
    if (greatest == codes.pixels.end() || *greatest <= 0.0f)
        return std::nullopt;
    const auto block = static_cast<int>(greatest - codes.pixels.begin());
    const auto code = static_cast<std::int64_t>(*greatest);
    const auto texel = block_texels - 1 - static_cast<int>(code % block_texels);
    const int row = codes.extent.height - 1 - block / codes.extent.width;  // from the bottom
    return Trip{pass, block % codes.extent.width * trip_block_side + texel % trip_block_side,
                watch.target.height - 1 - (row * trip_block_side + texel / trip_block_side),
                *m_first_frame + most_frames - code / block_texels};
}

// Reading where it was waits for the GPU; it is seldom.
std::optional<Trip> Tripwire::take(bool waits) {
    bool is_any = waits && m_first_frame;
    for (auto& [pass, watch] : m_watches)
        for (Look& look : watch.looks)
            if (look.is_open && (waits || look.query.has_come())) {
                look.is_open = false;
                is_any = is_any || look.query.is_any();
            }
    std::optional<Trip> first = std::exchange(m_found, std::nullopt);
    if (!is_any)
        return first;
    for (const auto& [pass, watch] : m_watches)
        if (const auto trip = first_in(pass, watch); trip && (!first || trip->frame < first->frame))
            first = trip;
    if (first)
        clear();
    return first;
}

bool Tripwire::is_waiting() const {
    return std::ranges::any_of(m_watches, [](const auto& watch) {
        return std::ranges::any_of(watch.second.looks, &Look::is_open);
    });
}

void Tripwire::clear() {
    m_watches.clear();
    m_spares.clear();
    m_first_frame.reset();
    m_found.reset();
}
