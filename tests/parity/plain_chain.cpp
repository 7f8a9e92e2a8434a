#include "parity/plain_chain.h"

#include "io/pictures/picture_file.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace plain {

using Of = Read::Of;

void delete_texture_name(GLuint id) {
    glDeleteTextures(1, &id);
}
void delete_framebuffer_name(GLuint id) {
    glDeleteFramebuffers(1, &id);
}
void delete_sampler_name(GLuint id) {
    glDeleteSamplers(1, &id);
}
void delete_vertex_array_name(GLuint id) {
    glDeleteVertexArrays(1, &id);
}
void delete_buffer_name(GLuint id) {
    glDeleteBuffers(1, &id);
}

namespace {
template <class Make>
GLuint made(Make make) {
    GLuint id = 0;
    make(1, &id);
    return id;
}

GLint wrap_of(Wrap wrap) {
    if (wrap == Wrap::edge)
        return GL_CLAMP_TO_EDGE;
    if (wrap == Wrap::repeat)
        return GL_REPEAT;
    return wrap == Wrap::mirror ? GL_MIRRORED_REPEAT : GL_CLAMP_TO_BORDER;
}

GLint small_filter(const State& state) {
    if (!state.has_levels)
        return state.is_linear ? GL_LINEAR : GL_NEAREST;
    if (state.is_linear)
        return state.is_linear_between_levels ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_NEAREST;
    return state.is_linear_between_levels ? GL_NEAREST_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST;
}

GLuint new_sampler(const State& state) {
    const GLuint id = made(glGenSamplers);
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, small_filter(state));
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, state.is_linear ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_S, wrap_of(state.wrap));
    glSamplerParameteri(id, GL_TEXTURE_WRAP_T, wrap_of(state.wrap));
    return id;
}

std::vector<double> size_member(Extent extent) {
    return {1.0 * extent.width, 1.0 * extent.height, 1.0 / extent.width, 1.0 / extent.height};
}

// From 0..1 to clip space, column-major; flipped vertically for the screen.
std::vector<double> matrix(bool is_screen) {
    const double y = is_screen ? -1.0 : 1.0;
    return {2, 0, 0, 0, 0, 2 * y, 0, 0, 0, 0, 1, 0, -1, -y, 0, 1};
}

// Members that have the same value in each frame.
std::optional<std::vector<double>> fixed_member(const std::string& name, Extent original) {
    static const std::map<std::string, double> numbers{
        {"FrameDirection", 1}, {"FrameTimeDelta", 16667}, {"OriginalFPS", 60},
        {"TotalSubFrames", 1}, {"CurrentSubFrame", 1},    {"BrightnessNits", 200}};
    if (name == "OriginalAspect" || name == "OriginalAspectRotated")
        return std::vector{1.0 * original.width / original.height};
    const auto found = numbers.find(name);
    return found == numbers.end() ? std::nullopt : std::optional(std::vector{found->second});
}

Bytes bytes_of(const Picture& picture) {
    Bytes bytes{picture.extent, {}};
    for (std::size_t at = 0; at < picture.pixels.size();
         at += static_cast<std::size_t>(picture.channels))
        for (std::size_t c = 0; c < 4; ++c) {
            const std::size_t from = at + (picture.channels == 1 ? 0 : c);
            const bool is_opaque = c == 3 && picture.channels < 4;
            const float value = is_opaque ? 1.0f : picture.pixels[from];
            bytes.rgba.push_back(static_cast<std::uint8_t>(std::lround(value * 255.0f)));
        }
    return bytes;
}

constexpr const char* copying_vertex = R"(#version 410 core
layout(location = 0) in vec2 position;
out vec2 at;
void main() {
    gl_Position = vec4(2.0 * position.x - 1.0, 1.0 - 2.0 * position.y, 0.0, 1.0);
    at = position;
}
)";
constexpr const char* copying_fragment = R"(#version 410 core
uniform sampler2D Source;
in vec2 at;
out vec4 color;
void main() { color = texture(Source, at); }
)";
}  // namespace

Surface::Surface(Extent extent, GLenum format, bool has_levels)
    : m_extent(extent),
      m_format(format),
      m_has_levels(has_levels),
      m_texture(made(glGenTextures)),
      m_framebuffer(made(glGenFramebuffers)) {
    const auto longest = static_cast<unsigned>(std::max(extent.width, extent.height));
    glBindTexture(GL_TEXTURE_2D, texture());
    glTexStorage2D(GL_TEXTURE_2D, has_levels ? std::bit_width(longest) : 1, format, extent.width,
                   extent.height);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture(), 0);
    begin();
    make_levels();
}

void Surface::upload(const Bytes& picture) const {
    glBindTexture(GL_TEXTURE_2D, texture());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, m_extent.width, m_extent.height, GL_RGBA,
                    GL_UNSIGNED_BYTE, picture.rgba.data());
    make_levels();
}

void Surface::make_levels() const {
    if (!m_has_levels)
        return;
    glBindTexture(GL_TEXTURE_2D, texture());
    glGenerateMipmap(GL_TEXTURE_2D);
}

void Surface::aim() const {
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.get());
    glViewport(0, 0, m_extent.width, m_extent.height);
}

void Surface::begin() const {
    constexpr std::array<GLuint, 4> naught{};
    aim();
    if (m_format == GL_R32UI)
        return glClearBufferuiv(GL_COLOR, 0, naught.data());
    if (m_format == GL_RGBA8I || m_format == GL_R16I || m_format == GL_RGBA32I)
        return glClearBufferiv(GL_COLOR, 0, std::array<GLint, 4>{}.data());
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}

void Surface::copy_to(const Surface& other) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer.get());
    glBindTexture(GL_TEXTURE_2D, other.texture());
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, m_extent.width, m_extent.height);
}

std::vector<float> Surface::read() const {
    std::vector<float> texels(static_cast<std::size_t>(m_extent.width) *
                              static_cast<std::size_t>(m_extent.height) * 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer.get());
    glReadPixels(0, 0, m_extent.width, m_extent.height, GL_RGBA, GL_FLOAT, texels.data());
    return texels;
}

Result<Chain> Chain::make(const ParsedChain& parsed, Extent original, Extent viewport) {
    Chain chain(original);
    const Names names = names_of(parsed);
    chain.m_viewport = viewport;
    chain.m_sizes = sizes_of(parsed, original, viewport);
    chain.m_black.emplace_back(Extent{1, 1}, GL_RGBA8, false);
    for (int i = 0; i < history_of(parsed, names); ++i)
        chain.m_original.emplace_back(original, GL_RGBA8, false);
    chain.add_luts(parsed);
    chain.add_targets(parsed, names);
    for (int i = 0; i < static_cast<int>(parsed.preset.passes.size()); ++i)
        if (auto added = chain.add_pass(parsed, names, i); !added)
            return fail(added.error());
    if (ends_with_copy(parsed))
        if (auto added = chain.add_copy(); !added)
            return fail(added.error());

    constexpr std::array<float, 8> corners{0, 0, 1, 0, 0, 1, 1, 1};
    chain.m_quad.emplace_back(made(glGenBuffers), made(glGenVertexArrays));
    glBindVertexArray(chain.m_quad.front().second.get());
    glBindBuffer(GL_ARRAY_BUFFER, chain.m_quad.front().first.get());
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
    for (const GLuint location : {0u, 1u}) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    }
    return chain;
}

void Chain::add_luts(const ParsedChain& parsed) {
    for (const SlangTexture& lut : parsed.preset.textures) {
        m_luts.emplace_back();
        const auto picture = load_picture(lut.file);
        if (!picture)
            continue;
        m_luts.back() = std::make_unique<Surface>(picture->extent, GL_RGBA8, lut.is_mipmapped);
        m_luts.back()->upload(bytes_of(*picture));
    }
}

void Chain::add_targets(const ParsedChain& parsed, const Names& names) {
    for (int i = 0; i < static_cast<int>(m_sizes.size()); ++i) {
        const Extent size = m_sizes[static_cast<std::size_t>(i)];
        const bool is_screen = i + 1 == static_cast<int>(m_sizes.size());
        m_targets.emplace_back(size, format_of(parsed, i), has_levels(parsed, i));
        m_previous.emplace_back();
        if (!is_screen && has_feedback(parsed, names, i))
            m_previous.back() =
                std::make_unique<Surface>(size, format_of(parsed, i), has_levels(parsed, i));
    }
}

Result<void> Chain::add_pass(const ParsedChain& parsed, const Names& names, int index) {
    const auto place = static_cast<std::size_t>(index);
    const Translation& texts = parsed.translations[place];
    auto program = gpu::Program::build(texts.vertex, texts.fragment);
    if (!program)
        return fail(program.error());
    Pass pass{std::move(*program)};
    pass.modulo = parsed.preset.passes[place].frame_count_mod;
    pass.format = format_of(parsed, index);
    pass.has_levels = has_levels(parsed, index);
    int unit = 0;
    for (const NamedSampler& sampler : texts.samplers) {
        const gpu::Uniform* uniform = pass.program.find_uniform(sampler.uniform);
        if (!uniform)
            continue;
        pass.program.set_unit(*uniform, unit);
        const auto read = names.textures.find(sampler.name);
        const Read meant = read == names.textures.end() ? Read{Of::lut, -1} : read->second;
        State state;
        if (meant.number >= 0)
            state = state_of(parsed, meant, index);
        if (uniform->sampled == gpu::Uniform::Sampled::unsigned_integer)
            state = {false, false, state.wrap, false};
        pass.reads.push_back({unit++, meant, sampler_for(state)});
    }
    m_passes.push_back(std::move(pass));
    write_numbers(parsed, names, index);
    return {};
}

Result<void> Chain::add_copy() {
    Stage vertex;
    vertex.text = copying_vertex;
    Stage fragment;
    fragment.text = copying_fragment;
    auto program = gpu::Program::build(vertex, fragment);
    if (!program)
        return fail(program.error());
    Pass pass{std::move(*program)};
    pass.reads.push_back({0, {Of::source, 0}, sampler_for({false, false, Wrap::edge, false})});
    m_passes.push_back(std::move(pass));
    return {};
}

void Chain::write_numbers(const ParsedChain& parsed, const Names& names, int index) {
    Pass& pass = m_passes[static_cast<std::size_t>(index)];
    const bool is_screen = static_cast<std::size_t>(index) + 1 == m_sizes.size();
    for (const BlockMember& member : parsed.translations[static_cast<std::size_t>(index)].members) {
        const gpu::Uniform* uniform = pass.program.find_uniform(member.uniform);
        if (!uniform)
            continue;
        const auto write = [&](const std::vector<double>& numbers) {
            pass.program.write(*uniform, numbers);
        };
        const auto size = names.sizes.find(member.name);
        if (const auto value = parameter_of(parsed, member.name))
            write({*value});
        else if (size != names.sizes.end())
            write(size_member(extent_of(size->second, index)));
        else if (member.name == "MVP")
            write(matrix(is_screen));
        else if (member.name == "OutputSize")
            write(size_member(m_sizes[static_cast<std::size_t>(index)]));
        else if (member.name == "FinalViewportSize")
            write(size_member(m_viewport));
        else if (member.name == "FrameCount")
            pass.frame_counts.push_back(uniform->location);
        else if (const auto fixed = fixed_member(member.name, m_original.front().extent()))
            write(*fixed);
    }
}

Extent Chain::extent_of(const Read& read, int pass) const {
    const Extent original = m_original.front().extent();
    switch (read.of) {
        case Of::history:
            return original;
        case Of::source:
            return pass == 0 ? original : m_sizes[static_cast<std::size_t>(pass) - 1];
        case Of::output:
        case Of::feedback:
            return m_sizes[static_cast<std::size_t>(read.number)];
        case Of::lut:
            break;
    }
    const auto& lut = m_luts[static_cast<std::size_t>(read.number)];
    return lut ? lut->extent() : Extent{1, 1};
}

GLuint Chain::texture_of(const Read& read, int pass) const {
    const auto number = static_cast<std::size_t>(std::max(read.number, 0));
    switch (read.of) {
        case Of::history:
            return m_original[number].texture();
        case Of::source:
            return pass == 0 ? m_original.front().texture()
                             : m_targets[static_cast<std::size_t>(pass) - 1].texture();
        case Of::output:
            return m_targets[number].texture();
        case Of::feedback:
            return m_previous[number] ? m_previous[number]->texture() : m_black.front().texture();
        case Of::lut:
            break;
    }
    return read.number >= 0 && m_luts[number] ? m_luts[number]->texture()
                                              : m_black.front().texture();
}

GLuint Chain::sampler_for(const State& state) {
    for (const auto& [known, sampler] : m_samplers)
        if (known == state)
            return sampler.get();
    m_samplers.emplace_back(state, new_sampler(state));
    return m_samplers.back().second.get();
}

void Chain::bind_reads(std::size_t index) const {
    for (const Sampled& sampled : m_passes[index].reads) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(sampled.unit));
        glBindTexture(GL_TEXTURE_2D, texture_of(sampled.read, static_cast<int>(index)));
        glBindSampler(static_cast<GLuint>(sampled.unit), sampled.sampler);
    }
}

void Chain::draw_pass(std::size_t index) const {
    const Pass& pass = m_passes[index];
    m_targets[index].begin();
    (pass.format == GL_SRGB8_ALPHA8 ? glEnable : glDisable)(GL_FRAMEBUFFER_SRGB);
    pass.program.use();
    const std::uint64_t count =
        pass.modulo > 0 ? m_frame % static_cast<std::uint64_t>(pass.modulo) : m_frame;
    for (const GLint location : pass.frame_counts)
        glUniform1ui(location, static_cast<GLuint>(count));
    bind_reads(index);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    if (pass.has_levels)
        m_targets[index].make_levels();
}

void Chain::draw() {
    glBindVertexArray(m_quad.front().second.get());
    for (std::size_t i = 0; i < m_passes.size(); ++i)
        draw_pass(i);
    for (std::size_t i = 0; i < m_previous.size(); ++i)
        if (m_previous[i])
            std::swap(*m_previous[i], m_targets[i]);
    if (m_original.size() > 1) {
        std::rotate(m_original.begin() + 1, m_original.end() - 1, m_original.end());
        m_original.front().copy_to(m_original[1]);
    }
    ++m_frame;
}

std::vector<float> Chain::picture() const {
    const std::vector<float> upward = m_targets.back().read();
    const auto row = static_cast<std::ptrdiff_t>(m_viewport.width) * 4;
    std::vector<float> downward;
    for (auto end = upward.end(); end != upward.begin(); end -= row)
        downward.insert(downward.end(), end - row, end);
    return downward;
}

}  // namespace plain
