#include "graph/inspect/viewer.h"

#include "gpu/objects/draw.h"
#include "graph/inspect/texel_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace {
constexpr const char* view_vertex = R"(#version 410 core
out vec2 position;  // 0..1 over the view, from the bottom left
void main() {
    position = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(position * 2.0 - 1.0, 0.0, 1.0);
}
)";

// Between this and view_end come the options and the functions that read the target: `shown`,
// `rgba_at(texel)` and those of texel_text.h.
constexpr const char* view_start = R"(#version 410 core
in vec2 position;
out vec4 color;
uniform vec4 region;        // left, bottom, width, height; texels
uniform vec2 texels_a_pixel;
)";

const std::string anything = R"(
uniform vec2 levels;        // black, screens a unit
uniform float gain;
uniform bool is_encoded;
uniform bool marks_flaws;
uniform bool marks_clipping;
uniform bool is_false_color;
uniform bool is_over_checker;
uniform float headroom;
)";

// Most views use no options. Constants cost nothing, even if a driver executes every branch.
std::string nothing(bool is_encoded) {
    return fmt::format(R"(
const vec2 levels = vec2(0.0, 1.0);
const float gain = 1.0;
const float headroom = 1.0;
const bool marks_flaws = false, marks_clipping = false, is_false_color = false,
           is_over_checker = false;
const bool is_encoded = {};
)",
                       is_encoded);
}

constexpr const char* view_end = R"(
// IEC 61966-2-1
vec3 encode(vec3 c) {
    vec3 curve = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}
vec3 decode(vec3 c) {
    vec3 curve = pow((c + 0.055) / 1.055, vec3(2.4));
    return mix(curve, c / 12.92, lessThanEqual(c, vec3(0.04045)));
}

// The mean of a grid that is as dense as the texels, at most 4 x 4: linear filtering does the rest.
vec4 averaged(vec2 texel) {
    ivec2 count = clamp(ivec2(ceil(texels_a_pixel)), ivec2(1), ivec2(4));
    vec4 sum = vec4(0.0);
    for (int y = 0; y < count.y; ++y)
        for (int x = 0; x < count.x; ++x)
            sum += rgba_at(texel + ((vec2(x, y) + 0.5) / vec2(count) - 0.5) * texels_a_pixel);
    return sum / float(count.x * count.y);
}

// 0 black, 1 white. Amounts of light are what exposure works on, alpha and lone channels included.
vec3 exposed(vec3 numbers) {
    vec3 light = (numbers - levels.x) * levels.y;
    if (gain == 1.0)
        return light;
    return is_encoded ? sign(light) * encode(decode(abs(light)) * gain) : light * gain;
}

const vec3 no_mark = vec3(-1.0);

// Of all texels under this pixel of the view, at most 16 x 16 of them.
vec3 mark_at(vec2 texel) {
    bvec2 is_larger = lessThanEqual(texels_a_pixel, vec2(1.0));
    ivec2 last = textureSize(shown, 0) - 1;
    vec2 start = texel - 0.5 * texels_a_pixel + 0.01;  // where texels end, rounding decides nothing
    ivec2 low = clamp(ivec2(floor(mix(start, texel, is_larger))), ivec2(0), last);
    ivec2 high = clamp(ivec2(floor(mix(start + texels_a_pixel, texel + 1.0, is_larger))) - 1, low, last);
    ivec2 stride = (high - low) / 16 + 1;
    bool has_nan = false, has_infinity = false, has_negative = false, has_white = false, is_black = true;
    for (int y = low.y; y <= high.y; y += stride.y)
        for (int x = low.x; x <= high.x; x += stride.x) {
            vec3 numbers = chosen(texel_at(ivec2(x, y)));
            has_nan = has_nan || any(isnan(numbers));
            has_infinity = has_infinity || any(isinf(numbers));
            has_negative = has_negative || any(lessThan(numbers, vec3(0.0)));
            vec3 light = exposed(numbers);
            has_white = has_white || any(greaterThanEqual(light, vec3(1.0)));
            is_black = is_black && all(lessThanEqual(light, vec3(0.0)));
        }
    if (marks_flaws && has_nan) return vec3(1.0, 0.0, 0.0);
    if (marks_flaws && has_infinity) return vec3(0.0, 1.0, 0.0);
    if (marks_flaws && has_negative) return vec3(0.0, 0.0, 1.0);
    if (marks_clipping && has_white) return vec3(1.0, 0.8, 0.0);
    if (marks_clipping && is_black) return vec3(0.0, 0.25, 0.3);
    return no_mark;
}

// The function false_color() of viewer.h.
vec3 ramp(float level) {
    float angle = 6.28318530718 * (0.5 / 3.0 - 1.5 * level);
    float amplitude = level * (1.0 - level) / 2.0;
    mat2x3 turn = mat2x3(-0.14861, -0.29227, 1.97294, 1.78277, -0.90649, 0.0);
    return level + amplitude * (turn * vec2(cos(angle), sin(angle)));
}

// Linear light 0..headroom in 0..1. Up to the knee it is unchanged. Above it follows the curve of
// Reinhard et al., "Photographic Tone Reproduction for Digital Images", SIGGRAPH 2002, equation 4.
vec3 compressed(vec3 light) {
    const float knee = 0.75;
    vec3 above = max(light - knee, 0.0) / (1.0 - knee);
    float top = (headroom - knee) / (1.0 - knee);
    vec3 bent = above * (1.0 + above / (top * top)) / (1.0 + above);
    return min(min(light, knee) + (1.0 - knee) * bent, 1.0);
}

vec3 on_display(vec3 light) {
    if (is_false_color)
        return ramp(clamp(channels == 0 ? luminance(light) : light.r, 0.0, 1.0));
    if (headroom > 1.0)
        return encode(compressed(max(is_encoded ? decode(light) : light, 0.0)));
    vec3 visible = clamp(light, 0.0, 1.0);
    return is_encoded ? visible : encode(visible);
}

// What lies behind a transparent picture: squares of the view's pixels, in display values.
vec3 checker() {
    ivec2 square = ivec2(gl_FragCoord.xy) / 8;
    return vec3(((square.x + square.y) & 1) == 0 ? 0.25 : 0.31);
}

vec3 over_checker(vec3 seen, float alpha) {
    return isnan(alpha) ? seen : mix(checker(), seen, clamp(alpha, 0.0, 1.0));
}

void main() {
    vec2 texel = region.xy + position * region.zw;
    if (any(lessThan(texel, vec2(0.0))) || any(greaterThanEqual(texel, vec2(textureSize(shown, 0))))) {
        color = vec4(0.0);
        return;
    }
    bool is_marking = marks_flaws || marks_clipping;
    vec3 mark = is_marking ? mark_at(texel) : no_mark;
    vec4 mean = averaged(texel);
    vec3 numbers = chosen(mean);
    bool is_finite = !any(isnan(numbers)) && !any(isinf(numbers));
    if (mark != no_mark) {
        color = vec4(mark, 1.0);
    } else if (!is_finite && !marks_flaws) {
        color = vec4(1.0, 0.0, 1.0, 1.0);
    } else {
        // A mean takes in neighbours that no mark is due for.
        vec3 seen = on_display(exposed(is_finite ? numbers : chosen(texel_at(ivec2(texel)))));
        if (is_over_checker && channels == 0 && !is_marking && !is_false_color)
            seen = over_checker(seen, mean.a);
        color = vec4(is_marking && !is_false_color ? vec3(luminance(seen)) : seen, 1.0);
    }
}
)";

// Integers cannot be filtered.
std::string reading_text(SampleKind kind) {
    constexpr const char* smooth = R"(
vec4 rgba_at(vec2 texel) { return texture(shown, texel / vec2(textureSize(shown, 0))); }
)";
    constexpr const char* nearest = R"(
vec4 rgba_at(vec2 texel) {
    ivec2 last = textureSize(shown, 0) - 1;
    return texel_at(clamp(ivec2(floor(texel)), ivec2(0), last));
}
)";
    return texel_text(kind) + (kind == SampleKind::floating ? smooth : nearest);
}

Result<gpu::Program> build_view(const std::string& options, SampleKind kind) {
    const Stage vertex{{}, view_vertex, {}};
    const Stage fragment{{}, view_start + options + reading_text(kind) + view_end, {}};
    return gpu::Program::build(vertex, fragment);
}
}  // namespace

std::array<double, 3> false_color(double level) {
    const double angle = 2.0 * std::numbers::pi * (0.5 / 3.0 - 1.5 * level);
    const double amplitude = level * (1.0 - level) / 2.0;
    const double across = std::cos(angle);
    const double up = std::sin(angle);
    const auto channel = [&](double a, double b) {
        return std::clamp(level + amplitude * (a * across + b * up), 0.0, 1.0);
    };
    return {channel(-0.14861, 1.78277), channel(-0.29227, -0.90649), channel(1.97294, 0.0)};
}

Result<ViewerPrograms> ViewerPrograms::make() {
    auto encoded = build_view(nothing(true), SampleKind::floating);
    auto light = build_view(nothing(false), SampleKind::floating);
    for (const auto* program : {&encoded, &light})
        if (!*program)
            return fail(program->error());
    auto all = SamplePrograms::make([](SampleKind kind) { return build_view(anything, kind); });
    if (!all)
        return fail(all.error());
    return ViewerPrograms{std::move(*encoded), std::move(*light), std::move(*all)};
}

Result<Viewer> Viewer::make() {
    auto programs = ViewerPrograms::make();
    if (!programs)
        return fail(programs.error());
    return Viewer(std::make_shared<const ViewerPrograms>(std::move(*programs)));
}

const gpu::Program* Viewer::program_for(Format format, const ViewOptions& options,
                                        bool is_encoded) const {
    const bool is_plain = !info_of(format).is_integer && options.levels == Levels{} &&
                          options.exposure_stops == 0.0 && options.headroom == 1.0 &&
                          !options.marks_flaws && !options.marks_clipping &&
                          !options.is_false_color && !options.is_over_checker;
    if (!is_plain)
        return m_programs->all.find(format);
    return is_encoded ? &m_programs->encoded : &m_programs->light;
}

void Viewer::draw(const gpu::Texture& from, const gpu::Canvas& to, const ViewOptions& options) {
    const Extent whole = from.extent();
    const Extent view = to.texture().extent();
    const bool is_all = options.width <= 0 || options.height <= 0;
    const std::array<double, 4> region{is_all ? 0 : options.left, is_all ? 0 : options.bottom,
                                       is_all ? whole.width : options.width,
                                       is_all ? whole.height : options.height};
    const std::array<double, 2> density{region[2] / view.width, region[3] / view.height};
    const bool is_minified = density[0] > 1.0 || density[1] > 1.0;
    // GL decodes an sRGB texture when it is read.
    const bool is_encoded =
        options.encoding == Encoding::display && from.format() != Format::srgb8_alpha8;

    // A single channel is stored in red and displayed as grey.
    const bool is_lone =
        options.channels == Channels::color && info_of(from.format()).channels == 1;
    const Channels channels = is_lone ? Channels::red : options.channels;

    const gpu::Program* found = program_for(from.format(), options, is_encoded);
    if (!found)
        return;
    const gpu::Program& program = *found;
    const gpu::DrawScope scope;
    if (options.columns)
        gpu::limit_columns((*options.columns)[0], (*options.columns)[1]);
    program.write("region", region);
    program.write("texels_a_pixel", density);
    program.write("levels", std::array{options.levels.black,
                                       1.0 / (options.levels.white - options.levels.black)});
    program.write("marks_flaws", std::array{options.marks_flaws ? 1.0 : 0.0});
    program.write("marks_clipping", std::array{options.marks_clipping ? 1.0 : 0.0});
    program.write("is_false_color", std::array{options.is_false_color ? 1.0 : 0.0});
    program.write("is_over_checker", std::array{options.is_over_checker ? 1.0 : 0.0});
    program.write("gain", std::array{std::exp2(options.exposure_stops)});
    program.write("headroom", std::array{options.headroom});
    program.write("channels", std::array{static_cast<double>(channels)});
    program.write("is_encoded", std::array{is_encoded ? 1.0 : 0.0});
    program.use();
    m_samplers.bind(0, from, {is_minified ? Filter::linear : options.filter, Wrap::edge, false});
    to.bind();
    m_vertices.bind();
    gpu::draw_triangle();
    m_samplers.release();
}
