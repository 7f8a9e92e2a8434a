#include "formats/isf_export/isf_images.h"

#include "formats/effect/shader_functions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace {
constexpr std::size_t most_samplers = 16;
constexpr int most_levels = 8;
constexpr const char* source_image = "inputImage";

// What image_read() uses.
constexpr const char* reading_helpers = R"(
vec2 texel_middle(vec2 at, vec2 size) { return (floor(at * size) + 0.5) / size; }
)";

// The source keeps its size on each level, but no level is larger than its target.
constexpr const char* source_size = R"(
vec2 source_size(int level, vec2 room) {
    return max(min(floor(IMG_SIZE(inputImage) / exp2(float(level))), room), 1.0);
}

)";

// Texels are decoded before they are mixed.
constexpr const char* decoding_reader = R"(
vec4 source_texel(vec2 texel) {{
    vec2 size = IMG_SIZE(inputImage);
    vec2 at = (clamp(texel, vec2(0.0), size - 1.0) + 0.5) / size;
{flip}    return display_to_linear(IMG_NORM_PIXEL(inputImage, at));
}}

vec4 {reader}(vec2 at) {{
    vec2 place = at * IMG_SIZE(inputImage) - 0.5;
    vec2 texel = floor(place);
    vec2 part = place - texel;
    vec4 lower = mix(source_texel(texel), source_texel(texel + vec2(1.0, 0.0)), part.x);
    vec4 upper = mix(source_texel(texel + vec2(0.0, 1.0)), source_texel(texel + 1.0), part.x);
    return mix(lower, upper, part.y);
}}

)";

// GLSL's functions for samplers, with numbers instead.
constexpr const char* sampling_functions = R"(
vec4 image_lod(int image, vec2 at, float level) {
    float near = clamp(level, 0.0, last_level(image));
    vec4 larger = image_read(image, at, int(near));
    float part = near - floor(near);
    return part == 0.0 ? larger : mix(larger, image_read(image, at, int(near) + 1), part);
}

vec4 image_at(int image, vec2 at) {
    if (last_level(image) == 0.0)
        return image_read(image, at, 0);
    return image_lod(image, at, level_at(at * vec2(image_size(image, 0))));
}

vec4 image_at(int image, vec2 at, float bias) {
    if (last_level(image) == 0.0)
        return image_read(image, at, 0);
    return image_lod(image, at, level_at(at * vec2(image_size(image, 0))) + bias);
}

vec4 image_fetch(int image, ivec2 texel, int level) {
    return image_read(image, (vec2(texel) + 0.5) / vec2(image_size(image, level)), level);
}

vec4 image_gather(int image, vec2 at, int component) {
    ivec2 corner = ivec2(floor(at * vec2(image_size(image, 0)) - 0.5));
    return vec4(image_fetch(image, corner + ivec2(0, 1), 0)[component],
                image_fetch(image, corner + ivec2(1, 1), 0)[component],
                image_fetch(image, corner + ivec2(1, 0), 0)[component],
                image_fetch(image, corner, 0)[component]);
}

vec4 image_gather(int image, vec2 at) { return image_gather(image, at, 0); }
)";

// The picture that the host gives.
std::string picture_of(const Input& input) {
    return input.from == Input::From::image ? input.name : source_image;
}

// Whether the host gives the picture as it is read.
bool is_given(const Input& input) {
    return input.from != Input::From::pass;
}

bool is_same_picture(const Input& a, const Input& b) {
    return a.from == b.from && a.name == b.name && a.frames_ago == b.frames_ago &&
           a.sampler == b.sampler;
}
}  // namespace

IsfImages::IsfImages(const Effect& effect)
    : m_look(effect.look), m_source_pass(effect.source_pass), m_levels(m_look.passes.size(), 0) {
    for (const Pass& pass : m_look.passes)
        for (const Input& input : pass.inputs) {
            const auto is_known = [&](const Image& image) {
                return is_same_picture(image.input, input);
            };
            if (pass.name != m_source_pass && std::ranges::none_of(m_images, is_known))
                m_images.push_back({input});
        }
    add_levels();
    for (std::size_t i = 0; i < m_look.passes.size(); ++i) {
        const std::string& pass = m_look.passes[i].name;
        for (int level = pass == m_source_pass ? 1 : 0; level <= m_levels[i]; ++level)
            m_targets.push_back(
                {i, level, has_target(i) ? target_name(pass, level) : std::string()});
    }
}

// The last pass has a target if a pass of the next frame reads it.
bool IsfImages::has_target(std::size_t pass) const {
    return pass + 1 < m_look.passes.size() ||
           std::ranges::any_of(m_images, [&](const Image& image) {
               return image.input.from == Input::From::pass &&
                      image.input.name == m_look.passes[pass].name;
           });
}

// Also the source.
std::size_t IsfImages::sampler_count() const {
    const std::size_t passes = m_look.passes.size() - (m_source_pass.empty() ? 0 : 1);
    const bool is_last_read = passes > 0 && has_target(m_look.passes.size() - 1);
    return passes + (is_last_read ? 1 : 0) + m_look.images.size();
}

// As many levels as there are samplers left.
void IsfImages::add_levels() {
    int free = static_cast<int>(most_samplers) - static_cast<int>(sampler_count());
    for (Image& image : m_images) {
        const auto pass = find_pass(m_look, image.input.name);
        if (image.input.from != Input::From::pass || !image.input.sampler.mipmap || !pass)
            continue;
        int& levels = m_levels[static_cast<std::size_t>(*pass)];
        if (levels == 0) {
            levels = std::clamp(free, 0, most_levels);
            free -= levels;
        }
        image.levels = levels;
    }
}

std::string IsfImages::target_name(const std::string& pass, int level) const {
    return level == 0 ? pass + "_picture" : fmt::format("{}_picture_{}", pass, level);
}

std::size_t IsfImages::number_of(const Input& input) const {
    return static_cast<std::size_t>(
        std::ranges::find_if(
            m_images, [&](const Image& image) { return is_same_picture(image.input, input); }) -
        m_images.begin());
}

bool IsfImages::has_source_size(const std::string& pass) const {
    const auto index = find_pass(m_look, pass);
    return index &&
           std::ranges::any_of(m_look.passes[static_cast<std::size_t>(*index)].size,
                               [](const Side& side) { return side.by == Side::By::source; });
}

// The sides that have the source's length are limited to it.
std::string IsfImages::limited_size(const std::string& pass, int level,
                                    const std::string& whole) const {
    if (!has_source_size(pass))
        return whole;
    const std::array<Side, 2>& size =
        m_look.passes[static_cast<std::size_t>(*find_pass(m_look, pass))].size;
    std::string limited = fmt::format("source_size({}, {})", level, whole);
    if (size[0].by == size[1].by)
        return limited;
    return size[0].by == Side::By::source ? fmt::format("vec2({}.x, {}.y)", limited, whole)
                                          : fmt::format("vec2({}.x, {}.y)", whole, limited);
}

std::string IsfImages::size_of(const std::string& pass, int level) const {
    if (pass.empty() || (pass == m_source_pass && level == 0))
        return fmt::format("IMG_SIZE({})", source_image);
    return limited_size(pass, level, fmt::format("IMG_SIZE({})", target_name(pass, level)));
}

std::string IsfImages::drawn_size(const std::string& pass, int level) const {
    return limited_size(pass, level, "RENDERSIZE");
}

std::string IsfImages::source_reader() const {
    const bool flips = m_look.source_rows != RowOrder::bottom_first;
    const std::string reader = "read_" + target_name(m_source_pass, 0);
    if (m_look.source_encoding == Encoding::linear)
        return fmt::format(fmt::runtime(decoding_reader),
                           fmt::arg("flip", flips ? "    at.y = 1.0 - at.y;\n" : ""),
                           fmt::arg("reader", reader));
    return fmt::format("vec4 {}(vec2 at) {{\n{}    return IMG_NORM_PIXEL({}, at);\n}}\n", reader,
                       flips ? "    at.y = 1.0 - at.y;\n" : "", source_image);
}

// A function that reads a whole target, or the part of it that has the source.
std::string IsfImages::reader(const Image& image, int level) const {
    if (is_given(image.input))
        return fmt::format("vec4 read_{0}(vec2 at) {{ return IMG_NORM_PIXEL({0}, at); }}\n",
                           picture_of(image.input));
    const std::string& pass = image.input.name;
    const std::string target = target_name(pass, level);
    if (pass == m_source_pass && level == 0)
        return source_reader();
    if (!has_source_size(pass))
        return fmt::format("vec4 read_{0}(vec2 at) {{ return IMG_NORM_PIXEL({0}, at); }}\n",
                           target);
    return fmt::format(
        "vec4 read_{0}(vec2 at) {{\n"
        "    vec2 size = {1};\n"
        "    vec2 place = clamp(at * size, vec2(0.5), size - 0.5) / IMG_SIZE({0});\n"
        "    return IMG_NORM_PIXEL({0}, place);\n}}\n",
        target, size_of(pass, level));
}

// The lines of image_read() for one picture.
std::string IsfImages::read(const Image& image, std::size_t number) const {
    std::string text = fmt::format("    if (image == {}) {{\n", number);
    for (int level = image.levels; level >= 0; --level) {
        const bool is_whole = is_given(image.input);
        const std::string target =
            is_whole ? picture_of(image.input) : target_name(image.input.name, level);
        const std::string size =
            is_whole ? fmt::format("IMG_SIZE({})", target) : size_of(image.input.name, level);
        const std::string place = image.input.sampler.filter == Filter::nearest
                                      ? fmt::format("texel_middle(at, {})", size)
                                      : "at";
        const std::string value = fmt::format("read_{}({})", target, place);
        text += fmt::format(
            "{}return {};\n",
            level > 0 ? fmt::format("        if (level == {})\n            ", level) : "        ",
            image.input.sampler.wrap == Wrap::border
                ? fmt::format("bordered({}, at, {}, {})", value, size,
                              image.input.sampler.filter == Filter::linear)
                : value);
    }
    return text + "    }\n";
}

std::string IsfImages::readers() const {
    const bool has_source_sizes = std::ranges::any_of(m_targets, [&](const Target& target) {
        return has_source_size(m_look.passes[target.pass].name);
    });
    std::string text = has_source_sizes ? source_size : "";
    std::vector<std::string> written;
    for (const Image& image : m_images)
        for (int level = 0; level <= image.levels; ++level) {
            std::string one = reader(image, level);
            if (std::ranges::find(written, one) == written.end()) {
                text += one;
                written.push_back(std::move(one));
            }
        }
    return text;
}

std::string IsfImages::functions() const {
    std::string reads;
    std::string sizes;
    std::string levels;
    for (std::size_t i = 0; i < m_images.size(); ++i) {
        const Image& image = m_images[i];
        reads += read(image, i);
        const std::string size = image.input.from == Input::From::image
                                     ? fmt::format("IMG_SIZE({})", image.input.name)
                                     : size_of(image.input.name);
        sizes += fmt::format("    if (image == {})\n        return max(ivec2({}) >> level, 1);\n",
                             i, size);
        if (image.levels > 0)
            levels += fmt::format("    if (image == {})\n        return {}.0;\n", i, image.levels);
    }
    return readers() + reading_helpers + border_function + level_function +
           "\nvec4 image_read(int image, vec2 at, int level) {\n" + reads +
           "    return vec4(0.0);\n}\n\nivec2 image_size(int image, int level) {\n" + sizes +
           "    return ivec2(1);\n}\n\nfloat last_level(int image) {\n" + levels +
           "    return 0.0;\n}\n" + sampling_functions;
}

std::string IsfImages::level_text(const Target& target) const {
    const std::string& pass = m_look.passes[target.pass].name;
    return fmt::format("read_{}(gl_FragCoord.xy / {})", target_name(pass, target.level - 1),
                       drawn_size(pass, target.level));
}

std::string IsfImages::obstacle() const {
    for (const Image& image : m_images)
        if (image.input.sampler.wrap == Wrap::repeat || image.input.sampler.wrap == Wrap::mirror)
            return "a picture is repeated beyond its edges";
    for (const Pass& pass : m_look.passes)
        for (const Side& side : pass.size)
            if (side.by == Side::By::source && side.factor != 1.0)
                return fmt::format("the pass '{}' has a part of the source's size", pass.name);
    if (!m_levels.empty() && m_levels.back() > 0)
        return "the last pass is read with mip levels";
    if (sampler_count() > most_samplers)
        return "it needs more than 16 textures";
    return {};
}
