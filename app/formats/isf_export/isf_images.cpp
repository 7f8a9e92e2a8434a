#include "formats/isf_export/isf_images.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr int most_samplers = 16;
constexpr int most_levels = 8;
constexpr const char* source_image = "inputImage";

// What image_read() uses.
constexpr const char* reading_helpers = R"(
vec2 texel_middle(vec2 at, vec2 size) { return (floor(at * size) + 0.5) / size; }

// Transparent black beyond the edges.
vec4 bordered(vec4 read, vec2 at, vec2 size, bool is_smooth) {
    vec2 place = at * size;
    vec2 inside = is_smooth ? clamp(place + 0.5, 0.0, 1.0) * clamp(size - place + 0.5, 0.0, 1.0)
                            : step(vec2(0.0), place) * step(place, size);
    return read * inside.x * inside.y;
}

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
    vec2 size = vec2(image_size(image, 0));
    vec2 across = dFdx(at) * size;
    vec2 up = dFdy(at) * size;
    float longest = max(max(dot(across, across), dot(up, up)), 1e-30);
    return image_lod(image, at, 0.5 * log2(longest));
}

vec4 image_fetch(int image, ivec2 texel, int level) {
    return image_read(image, (vec2(texel) + 0.5) / vec2(image_size(image, level)), level);
}
)";

// The picture that the host gives.
std::string picture_of(const Input& input) {
    return input.from == Input::From::image ? input.name : source_image;
}

bool is_same_picture(const Input& a, const Input& b) {
    return a.from == b.from && a.name == b.name && a.frames_ago == b.frames_ago &&
           a.sampler == b.sampler;
}
}  // namespace

IsfImages::IsfImages(const Look& look) : m_look(look), m_levels(look.passes.size(), 0) {
    for (std::size_t i = 0; i + 1 < look.passes.size(); ++i)
        if (look.passes[i].size[0].by == Side::By::source)
            m_sources.push_back(look.passes[i].name);
    for (const Pass& pass : look.passes)
        for (const Input& input : pass.inputs) {
            const auto is_known = [&](const Image& image) {
                return is_same_picture(image.input, input);
            };
            if (std::ranges::none_of(m_images, is_known))
                m_images.push_back({input});
        }
    add_levels();
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        for (int level = 0; level <= m_levels[i]; ++level)
            m_targets.push_back({i, level,
                                 i + 1 < look.passes.size()
                                     ? target_name(look.passes[i].name, level)
                                     : std::string()});
}

// As many levels as there are samplers left.
void IsfImages::add_levels() {
    int free = most_samplers - static_cast<int>(m_look.passes.size());  // the last has no target,
                                                                        // but there is the source
    for (Image& image : m_images) {
        const auto pass = find_pass(m_look, image.input.name);
        if (image.input.from != Input::From::pass || !image.input.sampler.mipmap || !pass)
            continue;
        int& levels = m_levels[static_cast<std::size_t>(*pass)];
        if (levels == 0)
            levels = std::clamp(free, 0, most_levels);
        free -= levels;
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

bool IsfImages::is_source(const std::string& pass) const {
    return std::ranges::find(m_sources, pass) != m_sources.end();
}

std::string IsfImages::size_of(const std::string& pass) const {
    if (pass.empty())
        return fmt::format("IMG_SIZE({})", source_image);
    return is_source(pass) ? "source_size(0)" : fmt::format("IMG_SIZE({}_picture)", pass);
}

// A function that reads a whole target, or the part of it that has the source.
std::string IsfImages::reader(const Image& image, int level) const {
    if (image.input.from != Input::From::pass)
        return fmt::format("vec4 read_{0}(vec2 at) {{ return IMG_NORM_PIXEL({0}, at); }}\n",
                           picture_of(image.input));
    const std::string target = target_name(image.input.name, level);
    if (!is_source(image.input.name))
        return fmt::format("vec4 read_{0}(vec2 at) {{ return IMG_NORM_PIXEL({0}, at); }}\n",
                           target);
    return fmt::format(
        "vec4 read_{0}(vec2 at) {{\n"
        "    vec2 size = source_size({1});\n"
        "    vec2 place = clamp(at * size, vec2(0.5), size - 0.5) / IMG_SIZE({0});\n"
        "    return IMG_NORM_PIXEL({0}, place);\n}}\n",
        target, level);
}

// The lines of image_read() for one picture.
std::string IsfImages::read(const Image& image, std::size_t number) const {
    std::string text = fmt::format("    if (image == {}) {{\n", number);
    const bool is_given = image.input.from != Input::From::pass;
    for (int level = image.levels; level >= 0; --level) {
        const std::string target =
            is_given ? picture_of(image.input) : target_name(image.input.name, level);
        const std::string size = !is_given && is_source(image.input.name)
                                     ? fmt::format("source_size({})", level)
                                     : fmt::format("IMG_SIZE({})", target);
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

// Of the pass's own picture, in targets().
std::size_t IsfImages::target_index(const std::string& pass) const {
    const std::string name = target_name(pass, 0);
    return static_cast<std::size_t>(std::ranges::find(m_targets, name, &Target::name) -
                                    m_targets.begin());
}

std::string IsfImages::readers() const {
    std::string text;
    if (!m_sources.empty())
        text += fmt::format(
            "// The source has its own size, at the bottom left of its target.\n"
            "vec2 source_size(int level) {{\n"
            "    vec2 whole = PASSINDEX <= {} ? RENDERSIZE : IMG_SIZE({}_picture);\n"
            "    return max(floor(min(IMG_SIZE({}), whole) / exp2(float(level))), 1.0);\n}}\n\n",
            target_index(m_sources.front()), m_sources.front(), source_image);
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
        sizes += fmt::format("    if (image == {})\n        return ivec2({});\n", i, size);
        if (image.levels > 0)
            levels += fmt::format("    if (image == {})\n        return {}.0;\n", i, image.levels);
    }
    return readers() + reading_helpers + "vec4 image_read(int image, vec2 at, int level) {\n" +
           reads + "    return vec4(0.0);\n}\n\nivec2 image_size(int image, int level) {\n" +
           sizes + "    return ivec2(1);\n}\n\nfloat last_level(int image) {\n" + levels +
           "    return 0.0;\n}\n" + sampling_functions;
}

std::string IsfImages::level_text(const Target& target) const {
    const std::string& pass = m_look.passes[target.pass].name;
    const std::string larger = target_name(pass, target.level - 1);
    const std::string size =
        is_source(pass) ? fmt::format("source_size({})", target.level) : "RENDERSIZE";
    return fmt::format("read_{}(gl_FragCoord.xy / {})", larger, size);
}

std::string IsfImages::obstacle() const {
    for (const Image& image : m_images) {
        if (image.input.sampler.wrap == Wrap::repeat || image.input.sampler.wrap == Wrap::mirror)
            return "a picture is repeated beyond its edges";
        if (image.input.frames_ago == 0 || image.input.from != Input::From::pass)
            continue;
        const auto drawn = find_pass(m_look, image.input.name);
        for (std::size_t i = 0; drawn && i < m_look.passes.size(); ++i)
            for (const Input& input : m_look.passes[i].inputs)
                if (is_same_picture(input, image.input) && static_cast<int>(i) > *drawn)
                    return fmt::format(
                        "the pass '{}' reads what an earlier pass drew in the "
                        "previous frame",
                        m_look.passes[i].name);
    }
    for (const Pass& pass : m_look.passes)
        for (const Side& side : pass.size)
            if (side.by == Side::By::source && side.factor != 1.0)
                return fmt::format("the pass '{}' has a part of the source's size", pass.name);
    if (m_look.passes.size() > static_cast<std::size_t>(most_samplers))
        return "it has more than 16 passes";
    return {};
}
