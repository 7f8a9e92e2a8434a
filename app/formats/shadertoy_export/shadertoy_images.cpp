#include "formats/shadertoy_export/shadertoy_images.h"

#include "formats/effect/shader_functions.h"
#include "formats/shadertoy_export/shadertoy_levels.h"
#include "glsl/constants/constants.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr std::size_t most_channels = 4;

// Of pictures that are not wrapped.
constexpr const char* gather_function = R"(
vec4 image_gather(int image, vec2 at) {
    ivec2 last = image_size(image, 0) - 1;
    ivec2 texel = ivec2(floor(at * vec2(last + 1) - 0.5));
    ivec2 low = clamp(texel, ivec2(0), last);
    ivec2 high = clamp(texel + 1, ivec2(0), last);
    return vec4(image_fetch(image, ivec2(low.x, high.y), 0).r, image_fetch(image, high, 0).r,
                image_fetch(image, ivec2(high.x, low.y), 0).r, image_fetch(image, low, 0).r);
}
)";

bool reads_same(const Input& a, const Input& b) {
    return a.from == b.from && a.name == b.name && a.sampler == b.sampler;
}

std::string wrap_text(Wrap wrap) {
    switch (wrap) {
        case Wrap::edge:
            return "    at = clamp(at, ivec2(0), size - 1);\n";
        case Wrap::border:
            return "    if (at != clamp(at, ivec2(0), size - 1))\n        return vec4(0.0);\n";
        case Wrap::repeat:
            return "    at -= size * ivec2(floor(vec2(at) / vec2(size)));\n";
        case Wrap::mirror:
            return "    at -= 2 * size * ivec2(floor(0.5 * vec2(at) / vec2(size)));\n"
                   "    at = min(at, 2 * size - 1 - at);\n";
    }
    return {};
}

std::string side_of_size(const Side& side, const char* axis, const std::string& picture) {
    std::string factor = glsl_number({}, side.factor);
    if (side.by != Side::By::viewport && side.by != Side::By::source)
        return factor;
    const std::string whole =
        fmt::format("{}.{}", side.by == Side::By::source ? picture : "iResolution", axis);
    return side.factor == 1.0 ? whole : fmt::format("{} * {}", whole, factor);
}

std::string conditions(const std::vector<std::string>& lines) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (!lines[i].empty())
            text += fmt::format("    if (image == {})\n        {}\n", i, lines[i]);
    return text;
}
}  // namespace

ShadertoyImages::ShadertoyImages(const ShadertoyPlan& plan, std::size_t pass)
    : m_plan(plan), m_pass(plan.look.passes[pass]) {
    add_inputs(m_pass);
    for (const Image& image : m_images)
        if (has_own_levels(image.input))
            table_channel();
}

// Passes that are drawn where they are read read their own pictures there.
void ShadertoyImages::add_inputs(const Pass& pass) {
    for (const Input& input : pass.inputs) {
        const auto is_known = [&](const Image& image) { return reads_same(image.input, input); };
        if (std::ranges::any_of(m_images, is_known))
            continue;
        if (!is_inlined(input)) {
            m_images.push_back({input, channel_of(channel_for(input))});
            continue;
        }
        m_images.push_back({input, 0});
        if (std::ranges::find(m_inlined, input.name) != m_inlined.end())
            continue;
        if (input.name == m_plan.beam)
            table_channel();
        add_inputs(m_plan.pass(input.name));
        m_inlined.push_back(input.name);
    }
}

bool ShadertoyImages::is_inlined(const Input& input) const {
    return input.from == Input::From::pass && m_plan.inlined.contains(input.name);
}

int ShadertoyImages::channel_of(const ShadertoyConnection& wanted) {
    const auto known = std::ranges::find(m_channels, wanted);
    if (known != m_channels.end())
        return static_cast<int>(known - m_channels.begin());
    m_channels.push_back(wanted);
    return static_cast<int>(m_channels.size()) - 1;
}

// Any channel that reads the picture.
int ShadertoyImages::picture_channel() {
    const auto known = std::ranges::find_if(
        m_channels, [](const ShadertoyConnection& channel) { return channel.buffer < 0; });
    return known != m_channels.end() ? static_cast<int>(known - m_channels.begin())
                                     : channel_of({});
}

bool ShadertoyImages::is_tapped(const Input& input) const {
    if (is_inlined(input))
        return true;
    if (m_plan.is_source(input))
        return m_plan.decodes();
    const bool repeats = input.sampler.wrap == Wrap::repeat || input.sampler.wrap == Wrap::mirror;
    return repeats && !m_plan.is_whole(input.name);
}

// Not those of its channel.
bool ShadertoyImages::has_own_levels(const Input& input) const {
    return input.sampler.mipmap && m_plan.is_source(input) && m_plan.decodes();
}

// What the functions do by themselves is not asked of the channel.
ShadertoyConnection ShadertoyImages::channel_for(const Input& input) const {
    const bool is_source = m_plan.is_source(input);
    ShadertoyConnection channel{.buffer = is_source ? -1 : m_plan.buffers.at(input.name),
                                .sampler = {}};
    if (is_tapped(input))
        return channel;
    channel.sampler.filter = input.sampler.filter;
    channel.sampler.mipmap = input.sampler.mipmap;
    if (input.sampler.wrap == Wrap::repeat)
        channel.sampler.wrap = Wrap::repeat;
    return channel;
}

std::size_t ShadertoyImages::number_of(const Input& input) const {
    return static_cast<std::size_t>(
        std::ranges::find_if(m_images,
                             [&](const Image& image) { return reads_same(image.input, input); }) -
        m_images.begin());
}

std::string ShadertoyImages::size_of(const std::string& pass) {
    if (pass.empty() || pass == m_plan.source_pass)
        return fmt::format("iChannelResolution[{}].xy", picture_channel());
    if (m_plan.is_whole(pass))
        return "iResolution.xy";
    const auto& size = m_plan.pass(pass).size;
    if (std::ranges::any_of(size, [](const Side& s) { return s.by == Side::By::source; }))
        picture_channel();
    m_sized.insert(pass);
    return fmt::format("size_of_{}()", pass);
}

std::string ShadertoyImages::size_of(const Input& input) {
    return size_of(m_plan.is_source(input) ? std::string() : input.name);
}

std::string ShadertoyImages::size_functions() const {
    std::string text;
    for (const std::string& pass : m_sized) {
        const auto& size = m_plan.pass(pass).size;
        const auto picture = std::ranges::find_if(
            m_channels, [](const ShadertoyConnection& channel) { return channel.buffer < 0; });
        const std::string source =
            fmt::format("iChannelResolution[{}]", picture - m_channels.begin());
        text += fmt::format(
            "\n// '{0}' is at the bottom left of its buffer.\n"
            "vec2 size_of_{0}() {{\n"
            "    return clamp(floor(vec2({1}, {2}) + 0.5), vec2(1.0), iResolution.xy);\n}}\n",
            pass, side_of_size(size[0], "x", source), side_of_size(size[1], "y", source));
    }
    return text;
}

// Texels are wrapped and decoded before they are mixed.
std::string ShadertoyImages::tapping_reader(const Image& image, std::size_t number) {
    const std::string size = size_of(image.input);
    const bool is_drawn = is_inlined(image.input);
    const std::string fetch = is_drawn
                                  ? fmt::format("drawn_{}(at)", image.input.name)
                                  : fmt::format("texelFetch(iChannel{}, at, 0)", image.channel);
    const bool decodes = m_plan.is_source(image.input) && m_plan.decodes();
    std::string text =
        is_drawn ? fmt::format("\nvec4 drawn_{}(ivec2 at);\n", image.input.name) : "";
    text += fmt::format(
        "\nvec4 texel_{}(ivec2 at) {{\n    ivec2 size = ivec2({});\n{}    return {};\n}}\n", number,
        size, wrap_text(image.input.sampler.wrap),
        decodes ? fmt::format("display_to_linear({})", fetch) : fetch);
    std::string levels;
    if (has_own_levels(image.input)) {
        text += shadertoy_level_reader(image.channel, fmt::format("texel_{}", number),
                                       channel_of({.buffer = 0, .sampler = {}}));
        const bool has_border = image.input.sampler.wrap == Wrap::border;
        levels = fmt::format(
            "    if (level >= 1.0)\n        return {};\n",
            has_border ? "bordered(read_level(at, int(level)), at, vec2(level_size(int(level))), "
                         "true)"
                       : "read_level(at, int(level))");
    }
    text += fmt::format("\nvec4 read_{}(vec2 at, float level) {{\n{}", number, levels);
    if (image.input.sampler.filter == Filter::nearest)
        return text +
               fmt::format("    return texel_{}(ivec2(floor(at * {})));\n}}\n", number, size);
    // Drawing a texel is slow, and many readers read their middles.
    const std::string middle =
        is_drawn ? fmt::format(
                       "    if (all(lessThan(abs(fract(place + 0.5) - 0.5), vec2(1e-3))))\n"
                       "        return texel_{}(ivec2(floor(place + 0.5)));\n",
                       number)
                 : "";
    return text + fmt::format(
                      "    vec2 place = at * {1} - 0.5;\n{2}"
                      "    ivec2 texel = ivec2(floor(place));\n"
                      "    vec2 part = fract(place);\n"
                      "    vec4 lower = mix(texel_{0}(texel), texel_{0}(texel + ivec2(1, 0)), "
                      "part.x);\n"
                      "    vec4 upper = mix(texel_{0}(texel + ivec2(0, 1)), texel_{0}(texel + 1), "
                      "part.x);\n"
                      "    return mix(lower, upper, part.y);\n}}\n",
                      number, size, middle);
}

// By the filter of the channel.
std::string ShadertoyImages::plain_read(const Image& image, const std::string& size) const {
    const bool is_whole = m_plan.is_source(image.input) || m_plan.is_whole(image.input.name);
    if (is_whole)
        return fmt::format(
            "textureLod(iChannel{}, {}, level)", image.channel,
            image.input.sampler.wrap == Wrap::mirror ? "1.0 - abs(mod(at, 2.0) - 1.0)" : "at");
    if (image.input.sampler.filter == Filter::nearest)
        return fmt::format(
            "texelFetch(iChannel{0}, ivec2(clamp(floor(at * {1}), vec2(0.0), {1} - 1.0)), 0)",
            image.channel, size);
    return fmt::format(
        "textureLod(iChannel{0}, clamp(at * {1}, vec2(0.5), {1} - 0.5) / iResolution.xy, 0.0)",
        image.channel, size);
}

// A function read_NUMBER(), for a whole level.
std::string ShadertoyImages::reader(const Image& image, std::size_t number) {
    if (is_tapped(image.input))
        return tapping_reader(image, number);
    const std::string size = size_of(image.input);
    std::string text = fmt::format("\nvec4 read_{}(vec2 at, float level) {{\n", number);
    const std::string read = plain_read(image, size);
    if (image.input.sampler.wrap != Wrap::border)
        return text + fmt::format("    return {};\n}}\n", read);
    const bool is_smooth = image.input.sampler.filter == Filter::linear;
    const std::string of_level =
        image.input.sampler.mipmap ? fmt::format("max(floor({} / exp2(level)), 1.0)", size) : size;
    return text +
           fmt::format("    return bordered({}, at, {}, {});\n}}\n", read, of_level, is_smooth);
}

std::string ShadertoyImages::lod_line(const Image& image, std::size_t number) const {
    const Sampler& sampler = image.input.sampler;
    if (!sampler.mipmap)
        return fmt::format("return read_{}(at, 0.0);", number);
    const bool is_mixed = has_own_levels(image.input) || sampler.wrap == Wrap::border;
    if (!is_mixed)
        return fmt::format("return read_{}(at, level);", number);
    return fmt::format(
        "return fract(level) == 0.0\n"
        "                   ? read_{0}(at, max(level, 0.0))\n"
        "                   : mix(read_{0}(at, max(floor(level), 0.0)),\n"
        "                         read_{0}(at, max(floor(level) + 1.0, 0.0)), fract(level));",
        number);
}

std::string ShadertoyImages::at_line(const Image& image, std::size_t number) {
    const Sampler& sampler = image.input.sampler;
    if (!sampler.mipmap)
        return fmt::format("return read_{}(at, 0.0);", number);
    const bool is_hardware = !has_own_levels(image.input) && sampler.wrap != Wrap::border &&
                             sampler.wrap != Wrap::mirror;
    return is_hardware ? fmt::format("return texture(iChannel{}, at);", image.channel)
                       : fmt::format("return image_lod({}, at, level_at(at * {}));", number,
                                     size_of(image.input));
}

std::string ShadertoyImages::biased_line(const Image& image, std::size_t number) {
    if (!image.input.sampler.mipmap)
        return fmt::format("return read_{}(at, 0.0);", number);
    return fmt::format("return image_lod({}, at, level_at(at * {}) + bias);", number,
                       size_of(image.input));
}

std::string ShadertoyImages::readers() {
    std::string text;
    for (std::size_t i = 0; i < m_images.size(); ++i)
        text += reader(m_images[i], i);
    const auto any = [&](const auto& is_so) { return std::ranges::any_of(m_images, is_so); };
    const bool decodes =
        any([&](const Image& image) { return m_plan.is_source(image.input) && m_plan.decodes(); });
    const bool has_border =
        any([](const Image& image) { return image.input.sampler.wrap == Wrap::border; });
    const bool has_levels = any([](const Image& image) { return image.input.sampler.mipmap; });
    return size_functions() + (decodes ? decoding_function : "") +
           (has_border ? border_function : "") + (has_levels ? level_function : "") + text;
}

std::string ShadertoyImages::functions(const Pass& pass, const GlslWords& words, bool has_bias) {
    std::vector<std::string> at(m_images.size());
    std::vector<std::string> biased = at;
    std::vector<std::string> lod = at;
    std::vector<std::string> fetch = at;
    std::vector<std::string> sizes = at;
    bool has_levels = false;
    for (const Input& input : pass.inputs) {
        const std::size_t i = number_of(input);
        const Image& image = m_images[i];
        lod[i] = lod_line(image, i);
        at[i] = at_line(image, i);
        biased[i] = biased_line(image, i);
        has_levels |= image.input.sampler.mipmap;
        fetch[i] = is_tapped(image.input)
                       ? fmt::format(
                             "return level == 0 ? texel_{0}(texel)\n"
                             "                          : read_{0}((vec2(texel) + 0.5) / "
                             "vec2(image_size({0}, level)), float(level));",
                             i)
                       : fmt::format("return texelFetch(iChannel{}, texel, level);", image.channel);
        sizes[i] = fmt::format("return max(ivec2({}) >> level, 1);", size_of(image.input));
    }
    const bool gathers = words.contains("textureGather");
    const bool fetches = gathers || words.contains("texelFetch");
    std::string text;
    const auto add = [&](const char* head, const std::vector<std::string>& lines,
                         const char* nothing) {
        text += fmt::format("\n{} {{\n{}    return {};\n}}\n", head, conditions(lines), nothing);
    };
    if (fetches || words.contains("textureSize"))
        add("ivec2 image_size(int image, int level)", sizes, "ivec2(1)");
    if (words.contains("textureLod") || has_levels)
        add("vec4 image_lod(int image, vec2 at, float level)", lod, "vec4(0.0)");
    if (words.contains("texture"))
        add("vec4 image_at(int image, vec2 at)", at, "vec4(0.0)");
    if (has_bias)
        add("vec4 image_at(int image, vec2 at, float bias)", biased, "vec4(0.0)");
    if (fetches)
        add("vec4 image_fetch(int image, ivec2 texel, int level)", fetch, "vec4(0.0)");
    return gathers ? text + gather_function : text;
}

std::string ShadertoyImages::obstacle() const {
    if (m_channels.size() <= most_channels)
        return {};
    return fmt::format(
        "the pass '{}' reads {} pictures, and Shadertoy has four channels. Export it with --to "
        "web.",
        m_pass.name, m_channels.size());
}

std::string shadertoy_levels_code() {
    return std::string(decoding_function) +
           "\nvec4 texel_0(ivec2 at) {\n"
           "    return display_to_linear(texelFetch(iChannel0, at, 0));\n}\n" +
           shadertoy_level_functions(0, "texel_0") + shadertoy_level_entry();
}
