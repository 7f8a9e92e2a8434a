#include "graph/inspect/nan_detector.h"

#include "gpu/objects/draw.h"
#include "gpu/objects/readback.h"
#include "graph/inspect/texel_programs.h"
#include "model/picture/gain.h"

#include <algorithm>
#include <utility>

namespace {
constexpr int nan_block_side = 16;
constexpr int block_texels = nan_block_side * nan_block_side;
constexpr std::int64_t max_frames = 65535;  // codes stay below 2^24, exact in a float

// One fragment per block. Earlier frames and texels have a greater code, and GL_MAX keeps the
// greatest. So later findings do not overwrite the first one.
constexpr const char* finder_text = R"(#version 410 core
uniform sampler2D shown;
uniform ivec2 corner;
uniform float frames_left;
out vec4 color;
void main() {
    const int side = 16;
    ivec2 low = (ivec2(gl_FragCoord.xy) - corner) * side;
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

constexpr const char* sanitizer_text = R"(#version 410 core
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

Extent nan_blocks_of(Extent extent) {
    return {(extent.width + nan_block_side - 1) / nan_block_side,
            (extent.height + nan_block_side - 1) / nan_block_side};
}

constexpr Sampler nan_sampler{Filter::nearest, Wrap::edge, false};
}  // namespace

Result<std::shared_ptr<const NanDetectorPrograms>> build_nan_detector(
    const std::shared_ptr<gpu::Context>& context) {
    auto finder = build_measuring_program(finder_text);
    if (!finder)
        return fail(finder.error());
    auto sanitizer = build_measuring_program(sanitizer_text);
    if (!sanitizer)
        return fail(sanitizer.error());
    return std::make_shared<const NanDetectorPrograms>(
        NanDetectorPrograms{gpu::destroyed_in(context, std::move(*finder)),
                            gpu::destroyed_in(context, std::move(*sanitizer))});
}

NanDetector::SanitizeMethod NanDetector::best_method() {
    return gpu::can_read_own_target() ? SanitizeMethod::in_place : SanitizeMethod::ping_pong;
}

NanDetector::PendingQuery& NanDetector::QueryRing::open_next() {
    latest = (latest + 1) % queries.size();
    queries[latest].is_open = true;
    return queries[latest];
}

bool NanDetector::Sheet::find_room(Extent part, int& left, int& bottom) {
    const Extent whole = blocks.texture().extent();
    if (x + part.width > whole.width) {
        x = 0;
        y += std::exchange(shelf_height, 0);
    }
    if (part.width > whole.width || y + part.height > whole.height)
        return false;
    left = std::exchange(x, x + part.width);
    bottom = y;
    shelf_height = std::max(shelf_height, part.height);
    return true;
}

bool NanDetector::allocate(Watch& watch) {
    constexpr int usual_side = 256;
    const Extent part = nan_blocks_of(watch.target);
    if (m_sheets.empty() || !m_sheets.back().find_room(part, watch.x, watch.y)) {
        const int side = std::max({usual_side, part.width, part.height});
        auto blocks = gpu::Canvas::make({side, side}, Format::r32f);
        if (!blocks)
            return false;
        m_sheets.push_back({std::move(*blocks)});
        m_sheets.back().find_room(part, watch.x, watch.y);
    }
    watch.sheet = m_sheets.size() - 1;
    return true;
}

// Without memory nothing is found, as the passes need the memory.
NanDetector::Watch* NanDetector::watch_for(std::size_t pass, const gpu::Texture& target) {
    const auto found = m_watches.find(pass);
    if (found != m_watches.end() && found->second.target == target.extent())
        return &found->second;
    if (found != m_watches.end()) {  // the picture was resized, and so were the others
        m_watches.clear();
        m_sheets.clear();
        m_spares.clear();
    }
    Watch watch{target.extent()};
    return allocate(watch) ? &m_watches.emplace(pass, std::move(watch)).first->second : nullptr;
}

// Restarts the codes of the blocks, which are limited to `max_frames` frames.
void NanDetector::begin(std::int64_t frame) {
    if (m_first_frame && (frame < *m_first_frame || frame - *m_first_frame > max_frames)) {
        const auto found = take(true);
        clear();
        m_found = found;
    }
    if (!m_first_frame)
        m_first_frame = frame;
}

void NanDetector::draw_found(const Watch& watch, const gpu::Texture& target, std::int64_t frame) {
    m_programs->finder->write(
        "frames_left", std::array{static_cast<double>(max_frames - (frame - *m_first_frame))});
    m_programs->finder->write("corner", std::array{double(watch.x), double(watch.y)});
    m_samplers.bind(0, target, nan_sampler);
    m_sheets[watch.sheet].blocks.bind_part(watch.x, watch.y, nan_blocks_of(watch.target));
    gpu::set_blend(Blend::maximum);
    m_programs->finder->use();
    m_vertices.bind();
    gpu::draw_triangle();
}

void NanDetector::check(std::span<const Drawn> all, std::int64_t frame) {
    begin(frame);
    gpu::PixelQuery& query = m_gathered.open_next().query;
    query.begin();
    for (const Drawn& drawn : all)
        if (const Watch* watch = watch_for(drawn.pass, drawn.target->texture()))
            draw_found(*watch, drawn.target->texture(), frame);
    query.end();
    m_samplers.release();
}

void NanDetector::check_and_sanitize(const Drawn& drawn, std::int64_t frame) {
    begin(frame);
    Watch* watch = watch_for(drawn.pass, drawn.target->texture());
    if (!watch)
        return;
    gpu::PixelQuery& query = watch->queries.open_next().query;
    query.begin();
    draw_found(*watch, drawn.target->texture(), frame);
    query.end();
    query.begin_condition();
    draw_sanitized(*drawn.target);
    gpu::PixelQuery::end_condition();
    m_samplers.release();
}

void NanDetector::check_cause(std::size_t cause, std::size_t pass, const gpu::Canvas& target,
                              std::int64_t frame) {
    Watch* watch = watch_for(pass, target.texture());
    const auto known = m_watches.find(cause);
    if (!watch || known == m_watches.end() || !m_first_frame)
        return;
    const QueryRing& causes = known->second.queries;
    causes.queries[causes.latest].query.begin_condition();
    draw_found(*watch, target.texture(), frame);
    gpu::PixelQuery::end_condition();
    m_samplers.release();
}

void NanDetector::sanitize(const gpu::Canvas& target) {
    const gpu::DrawScope scope;
    draw_sanitized(target);
    m_samplers.release();
}

const gpu::Canvas* NanDetector::spare_for(const gpu::Texture& target) {
    const auto is_like = [&target](const gpu::Canvas& spare) {
        return spare.texture().extent() == target.extent() &&
               spare.texture().format() == target.format();
    };
    if (const auto found = std::ranges::find_if(m_spares, is_like); found != m_spares.end())
        return &*found;
    auto made = gpu::Canvas::make(target.extent(), target.format());
    return made ? &m_spares.emplace_back(std::move(*made)) : nullptr;
}

void NanDetector::draw_sanitizer(const gpu::Canvas& from, const gpu::Canvas& to) {
    m_samplers.bind(0, from.texture(), nan_sampler);
    to.bind();
    gpu::draw_triangle();
}

void NanDetector::draw_sanitized(const gpu::Canvas& target) {
    gpu::set_blend(Blend::replace);
    m_programs->sanitizer->write("most", std::array{format_limit(target.texture().format())});
    m_programs->sanitizer->use();
    m_vertices.bind();
    if (m_method == SanitizeMethod::in_place) {
        gpu::make_own_target_readable();
        draw_sanitizer(target, target);
    } else if (const gpu::Canvas* spare = spare_for(target.texture())) {
        draw_sanitizer(target, *spare);
        draw_sanitizer(*spare, target);
    }
}

std::optional<NonFinitePixel> NanDetector::first_in(std::size_t pass, const Watch& watch,
                                                    const Picture& sheet) const {
    const Extent part = nan_blocks_of(watch.target);
    float greatest = 0.0f;
    int column = 0;
    int row = 0;  // from the bottom
    for (int y = part.height - 1; y >= 0; --y)
        for (int x = 0; x < part.width; ++x) {
            const float code =
                sheet.pixels[sheet.index(watch.x + x, sheet.extent.height - 1 - (watch.y + y))];
            if (code <= greatest)
                continue;
            greatest = code;
            column = x;
            row = y;
        }
    if (greatest <= 0.0f)
        return std::nullopt;
    const auto code = static_cast<std::int64_t>(greatest);
    const auto texel = block_texels - 1 - static_cast<int>(code % block_texels);
    return NonFinitePixel{pass, column * nan_block_side + texel % nan_block_side,
                          watch.target.height - 1 - (row * nan_block_side + texel / nan_block_side),
                          *m_first_frame + max_frames - code / block_texels};
}

// Whether a check with an available result found something.
bool NanDetector::take_answers(bool waits) {
    bool is_any = false;
    const auto take_from = [&](QueryRing& queries) {
        for (PendingQuery& pending : queries.queries)
            if (pending.is_open && (waits || pending.query.is_available())) {
                pending.is_open = false;
                is_any = pending.query.is_any_passed() || is_any;
            }
    };
    take_from(m_gathered);
    for (auto& [pass, watch] : m_watches)
        take_from(watch.queries);
    return is_any;
}

// Reading the position waits for the GPU, but findings are rare.
std::optional<NonFinitePixel> NanDetector::take(bool waits) {
    const bool is_any = take_answers(waits) || (waits && m_first_frame);
    std::optional<NonFinitePixel> first = std::exchange(m_found, std::nullopt);
    if (!is_any)
        return first;
    std::vector<Picture> sheets;
    for (const Sheet& sheet : m_sheets)
        sheets.push_back(gpu::read_picture(sheet.blocks.texture()));
    for (const auto& [pass, watch] : m_watches)
        if (const auto trip = first_in(pass, watch, sheets[watch.sheet]);
            trip && (!first || trip->frame < first->frame))
            first = trip;
    if (first)
        clear();
    return first;
}

bool NanDetector::is_waiting() const {
    const auto waits = [](const QueryRing& queries) {
        return std::ranges::any_of(queries.queries, &PendingQuery::is_open);
    };
    return waits(m_gathered) || std::ranges::any_of(m_watches, [&waits](const auto& watch) {
               return waits(watch.second.queries);
           });
}

void NanDetector::clear() {
    m_watches.clear();
    m_sheets.clear();
    m_spares.clear();
    m_gathered = {};
    m_first_frame.reset();
    m_found.reset();
}
