#include "graph/viewer.h"

#include "gpu/draw.h"

#include <array>
#include <cmath>
#include <string>

namespace {
constexpr const char* vertex_text = R"(#version 410 core
out vec2 place;  // 0..1 over the view, from the bottom left
void main() {
    place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);
}
)";

// Between these two the stage declares `shown`, a sampler, and `rgba_at(uv)`.
constexpr const char* fragment_start = R"(#version 410 core
in vec2 place;
out vec4 color;
uniform vec4 region;        // left, bottom, width, height; texels
uniform vec2 texels_a_pixel;
uniform float gain;
uniform int channels;
uniform bool is_encoded;
)";

constexpr const char* fragment_end = R"(
// IEC 61966-2-1
vec3 encode(vec3 c) {
    vec3 curve = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}
vec3 decode(vec3 c) {
    vec3 curve = pow((c + 0.055) / 1.055, vec3(2.4));
    return mix(curve, c / 12.92, lessThanEqual(c, vec3(0.04045)));
}

vec3 chosen(vec4 rgba) {
    if (channels == 0) return rgba.rgb;
    if (channels < 5) return vec3(rgba[channels - 1]);
    return vec3(dot(rgba.rgb, vec3(0.2126, 0.7152, 0.0722)));  // ITU-R BT.709
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

void main() {
    vec2 texel = region.xy + place * region.zw;
    if (any(lessThan(texel, vec2(0.0))) || any(greaterThanEqual(texel, vec2(textureSize(shown, 0))))) {
        color = vec4(0.0);
        return;
    }
    vec3 light = chosen(averaged(texel));
    if (any(isnan(light)) || any(isinf(light))) {
        color = vec4(1.0, 0.0, 1.0, 1.0);
        return;
    }
    light = max(light, 0.0);
    // Amounts of light are what exposure works on, alpha and lone channels included.
    if (gain != 1.0)
        light = is_encoded ? encode(decode(light) * gain) : light * gain;
    color = vec4(clamp(is_encoded ? light : encode(light), 0.0, 1.0), 1.0);
}
)";

constexpr const char* floats_text = R"(
uniform sampler2D shown;
vec4 rgba_at(vec2 texel) { return texture(shown, texel / vec2(textureSize(shown, 0))); }
)";

constexpr const char* naturals_text = R"(
uniform usampler2D shown;
vec4 rgba_at(vec2 texel) {
    ivec2 last = textureSize(shown, 0) - 1;
    return vec4(vec3(texelFetch(shown, clamp(ivec2(floor(texel)), ivec2(0), last), 0).r), 1.0);
}
)";

Result<gpu::Program> build(const char* reading) {
    const Stage vertex{{}, vertex_text, {}};
    const Stage fragment{{}, std::string(fragment_start) + reading + fragment_end, {}};
    return gpu::Program::build(vertex, fragment);
}
}  // namespace

Viewer::Viewer(gpu::Program floats, gpu::Program naturals)
    : m_floats(std::move(floats)), m_naturals(std::move(naturals)) {}

Result<Viewer> Viewer::make() {
    auto floats = build(floats_text);
    if (!floats)
        return fail(floats.error());
    auto naturals = build(naturals_text);
    if (!naturals)
        return fail(naturals.error());
    return Viewer(std::move(*floats), std::move(*naturals));
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
    // An sRGB texture is decoded as it is read.
    const bool is_encoded =
        options.encoding == Encoding::display && from.format() != Format::srgb8_alpha8;

    const gpu::DrawScope scope;
    if (options.columns)
        gpu::limit_columns((*options.columns)[0], (*options.columns)[1]);
    const gpu::Program& program = facts_of(from.format()).is_integer ? m_naturals : m_floats;
    program.write("region", region);
    program.write("texels_a_pixel", density);
    program.write("gain", std::array{std::exp2(options.exposure_stops)});
    program.write("channels", std::array{static_cast<double>(options.channels)});
    program.write("is_encoded", std::array{is_encoded ? 1.0 : 0.0});
    program.use();
    m_samplers.bind(0, from, {is_minified ? Filter::linear : options.filter, Wrap::edge, false});
    to.bind();
    m_vertices.bind();
    gpu::draw_triangle();
    m_samplers.release();
}
