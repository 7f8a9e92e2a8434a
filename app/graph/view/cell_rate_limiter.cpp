#include "graph/view/cell_rate_limiter.h"

#include "gpu/objects/draw.h"
#include "graph/inspect/light_cells.h"
#include "graph/inspect/pair_text.h"
#include "graph/inspect/texel_programs.h"

#include <initializer_list>
#include <string>

namespace {
constexpr const char* follower_text = R"(#version 410 core
uniform sampler2D cells;
uniform sampler2D before;
uniform vec3 most;
out vec4 color;
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 light = texelFetch(cells, at, 0).rgb;
    vec3 last = texelFetch(before, at, 0).rgb;
    color = vec4(last + clamp(light - last, -most, most), 1.0);
}
)";

const std::string shower_text = "#version 410 core\n" + curve_text + R"(
uniform sampler2D shown;
uniform sampler2D cells;
uniform sampler2D allowed;
out vec4 color;
void main() {
    vec4 numbers = texelFetch(shown, ivec2(gl_FragCoord.xy), 0);
    vec2 position = gl_FragCoord.xy / vec2(textureSize(shown, 0));
    vec3 is = textureLod(cells, position, 0.0).rgb;
    vec3 may = textureLod(allowed, position, 0.0).rgb;
    vec3 light = mix(vec3(0.0), min(numbers.rgb, 1.0), greaterThan(numbers.rgb, vec3(0.0)));
    light = to_light(light);
    vec3 dimmed = light * may / max(is, vec3(1e-6));
    light = mix(light + may - is, dimmed, lessThan(may, is));
    color = vec4(to_stored(clamp(light, 0.0, 1.0)), numbers.a);
}
)";

// The samplers get the units from 0 on.
Result<gpu::Program> build(const std::string& text, std::initializer_list<const char*> samplers) {
    auto program = build_measuring_program(text);
    int unit = 0;
    for (const char* name : samplers)
        if (const gpu::Uniform* sampler = program ? program->find_uniform(name) : nullptr)
            program->set_unit(*sampler, unit++);
    return program;
}

constexpr Sampler smooth{Filter::linear, Wrap::edge, false};
constexpr Sampler as_stored{Filter::nearest, Wrap::edge, false};
}  // namespace

Result<CellRateLimiter> CellRateLimiter::make() {
    auto follower = build(follower_text, {"cells", "before"});
    if (!follower)
        return fail(follower.error());
    auto shower = build(shower_text, {"shown", "cells", "allowed"});
    if (!shower)
        return fail(shower.error());
    return CellRateLimiter(std::move(*follower), std::move(*shower));
}

void CellRateLimiter::follow(const gpu::Texture& cells, const Light& maximum) {
    const std::size_t next = 1 - m_now;
    std::array<double, 3> limits{};
    for (std::size_t i = 0; i < 3; ++i)
        limits[i] = m_is_new ? 1.0 : static_cast<double>(maximum[i]);
    m_follower.write("most", limits);
    m_samplers.bind(0, cells, as_stored);
    m_samplers.bind(1, m_allowed[m_now]->texture(), as_stored);
    m_follower.use();
    m_vertices.bind();
    m_allowed[next]->bind();
    gpu::draw_triangle();
    m_now = next;
    m_is_new = false;
}

const gpu::Texture* CellRateLimiter::limit(const Asked& asked) {
    const gpu::Texture& picture = asked.picture;
    const Extent extent = asked.cells.extent();
    if (!fit_floats(m_allowed[0], extent) || !fit_floats(m_allowed[1], extent) ||
        !fit_canvas(m_shown, picture.extent(), picture.format()))
        return nullptr;
    const gpu::DrawScope scope;
    follow(asked.cells, asked.maximum);
    m_shower.write("is_encoded", std::array{holds_light(picture, asked.encoding) ? 0.0 : 1.0});
    m_samplers.bind(0, picture, as_stored);
    m_samplers.bind(1, asked.cells, smooth);
    m_samplers.bind(2, m_allowed[m_now]->texture(), smooth);
    m_shower.use();
    m_vertices.bind();
    m_shown->bind();
    gpu::draw_triangle();
    m_samplers.release();
    return &m_shown->texture();
}
