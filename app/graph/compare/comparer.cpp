#include "graph/compare/comparer.h"

#include "gpu/objects/draw.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
constexpr const char* difference_text = R"(
uniform int measure;  // a DifferenceMeasure
uniform float smallest;
void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec3 b = other_at(texel);
    vec3 away = apart(ours_at(texel), b);
    if (measure == 1) away /= max(abs(b), vec3(smallest));
    if (measure == 2) away *= away;
    color = vec4(away, 1.0);
}
)";

constexpr const char* brighter_text = R"(
uniform float factor;
void main() {
    vec4 rgba = texelFetch(shown, ivec2(gl_FragCoord.xy), 0);
    vec3 light = to_light(stored_in(rgba, lone > 0.0, decoded > 0.0)) * factor;
    color = vec4(to_stored(light), rgba.a);
}
)";

constexpr const char* fitted_text = R"(
uniform vec4 region;  // of the picture in the target: left, bottom, width, height; px
uniform bool is_source_encoded;

vec3 light_at(ivec2 texel) {
    ivec2 inside = clamp(texel, ivec2(0), textureSize(shown, 0) - 1);
    vec3 numbers = stored_in(texelFetch(shown, inside, 0), lone > 0.0, decoded > 0.0);
    return is_source_encoded ? decode(numbers) : numbers;
}

// The mean of `low` to `high`, texels counted by how much of them lies between.
vec3 mean_between(vec2 low, vec2 high) {
    vec3 sum = vec3(0.0);
    for (int y = int(floor(low.y)); float(y) < high.y; ++y)
        for (int x = int(floor(low.x)); float(x) < high.x; ++x) {
            vec2 part = min(vec2(x, y) + 1.0, high) - max(vec2(x, y), low);
            sum += light_at(ivec2(x, y)) * part.x * part.y;
        }
    return sum / ((high.x - low.x) * (high.y - low.y));
}

vec3 interpolated(vec2 texel) {
    vec2 from = floor(texel - 0.5);
    vec2 part = texel - 0.5 - from;
    ivec2 at = ivec2(from);
    return mix(mix(light_at(at), light_at(at + ivec2(1, 0)), part.x),
               mix(light_at(at + ivec2(0, 1)), light_at(at + ivec2(1, 1)), part.x), part.y);
}

void main() {
    vec2 size = vec2(textureSize(shown, 0));
    vec2 texels_a_pixel = size / region.zw;
    vec2 texel = (gl_FragCoord.xy - region.xy) * texels_a_pixel;
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (any(lessThan(texel, vec2(0.0))) || any(greaterThanEqual(texel, size))) return;
    vec2 low = max(texel - 0.5 * texels_a_pixel, vec2(0.0));
    vec2 high = min(texel + 0.5 * texels_a_pixel, size);
    bool is_smaller = all(greaterThanEqual(texels_a_pixel, vec2(1.0)));
    color.rgb = to_stored(is_smaller ? mean_between(low, high) : interpolated(texel));
}
)";

// The whole picture, centred in `room`: left, bottom, width, height; px.
std::array<double, 4> fitted_region(Extent picture, Extent room) {
    const double scale = std::min(static_cast<double>(room.width) / picture.width,
                                  static_cast<double>(room.height) / picture.height);
    const double width = std::max(std::round(picture.width * scale), 1.0);
    const double height = std::max(std::round(picture.height * scale), 1.0);
    return {std::floor((room.width - width) / 2.0), std::floor((room.height - height) / 2.0), width,
            height};
}

double number_of(Encoding encoding) {
    return encoding == Encoding::display ? 1.0 : 0.0;
}
}  // namespace

Comparer::Comparer(gpu::Program difference, gpu::Program brighter, gpu::Program fitted)
    : m_difference(std::move(difference)),
      m_brighter(std::move(brighter)),
      m_fitted(std::move(fitted)) {}

Result<Comparer> Comparer::make() {
    auto difference = build_pair_program(difference_text);
    if (!difference)
        return fail(difference.error());
    auto brighter = build_single_program(brighter_text);
    if (!brighter)
        return fail(brighter.error());
    auto fitted = build_single_program(fitted_text);
    if (!fitted)
        return fail(fitted.error());
    return Comparer(std::move(*difference), std::move(*brighter), std::move(*fitted));
}

void Comparer::draw_difference(const Pair& pair, DifferenceMeasure measure, const gpu::Canvas& to) {
    m_difference.write("measure", std::array{static_cast<double>(measure)});
    m_difference.write("smallest", std::array{relative_floor});
    const gpu::DrawScope scope;
    bind_pair(pair, m_difference, m_samplers);
    to.bind();
    m_vertices.bind();
    gpu::draw_triangle();
    m_samplers.release();
}

void Comparer::draw_single(const gpu::Texture& from, const gpu::Program& program,
                           const gpu::Canvas& to) {
    const bool is_lone = info_of(from.format()).channels == 1;
    program.write("lone", std::array{is_lone ? 1.0 : 0.0});
    program.write("decoded", std::array{from.format() == Format::srgb8_alpha8 ? 1.0 : 0.0});
    const gpu::DrawScope scope;
    m_samplers.bind(0, from, {Filter::nearest, Wrap::edge, false});
    program.use();
    to.bind();
    m_vertices.bind();
    gpu::draw_triangle();
    m_samplers.release();
}

void Comparer::draw_brighter(const gpu::Texture& from, Encoding encoding, double stops,
                             const gpu::Canvas& to) {
    m_brighter.write("is_encoded", std::array{number_of(encoding)});
    m_brighter.write("factor", std::array{std::exp2(stops)});
    draw_single(from, m_brighter, to);
}

void Comparer::draw_fitted(const gpu::Texture& from, Encoding from_encoding, const gpu::Canvas& to,
                           Encoding to_encoding) {
    m_fitted.write("is_encoded", std::array{number_of(to_encoding)});
    m_fitted.write("is_source_encoded", std::array{number_of(from_encoding)});
    m_fitted.write("region", fitted_region(from.extent(), to.texture().extent()));
    draw_single(from, m_fitted, to);
}
