#include "portable_player/frames.h"

#include "portable_player/error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
void set_blending(const std::string& blend, bool is_onto) {
    if (blend == "replace" && !is_onto)
        return glDisable(GL_BLEND);
    glEnable(GL_BLEND);
    glBlendEquation(blend == "maximum" && !is_onto ? GL_MAX : GL_FUNC_ADD);
    if (is_onto)
        glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    else if (blend == "alpha")
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    else if (blend == "multiply")
        glBlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_DST_COLOR, GL_ZERO);
    else
        glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
}

bool is_sampler(GLenum type) {
    constexpr std::array known{GL_SAMPLER_2D, GL_INT_SAMPLER_2D, GL_UNSIGNED_INT_SAMPLER_2D,
                               GL_SAMPLER_CUBE, GL_SAMPLER_3D};
    return std::ranges::find(known, static_cast<int>(type)) != known.end();
}

bool can_read(GLenum sampler, const Texture& texture) {
    switch (sampler) {
        case GL_SAMPLER_CUBE:
            return texture.shape() == Shape::cube;
        case GL_SAMPLER_3D:
            return texture.shape() == Shape::volume;
        case GL_INT_SAMPLER_2D:
            return texture.numbers() == Numbers::integer;
        case GL_UNSIGNED_INT_SAMPLER_2D:
            return texture.numbers() == Numbers::natural;
        default:
            return texture.shape() == Shape::flat && texture.numbers() == Numbers::floating;
    }
}

const Input* find_input(const Pass& pass, const std::string& uniform) {
    const auto found = std::ranges::find(pass.inputs, uniform, &Input::uniform);
    return found == pass.inputs.end() ? nullptr : &*found;
}

bool reads_itself(const Pass& pass) {
    return std::ranges::any_of(pass.inputs, [&](const Input& input) {
        return input.from == "pass" && input.name == pass.name;
    });
}

// Whether a value changes what an accumulating pass draws, apart from the number of samples.
bool is_read(const Pass& pass, const std::string& parameter) {
    return std::ranges::find(pass.parameters, parameter, &Binding::parameter) !=
           pass.parameters.end();
}

std::uint8_t byte_of(double value, bool is_linear) {
    const double number = value > 0.0 ? std::min(value, 1.0) : 0.0;
    return static_cast<std::uint8_t>(
        std::lround(255.0 * (is_linear ? srgb_encoded(number) : number)));
}
}  // namespace

FramePlayer::FramePlayer(const Description& description, const Size& view)
    : m_description(description),
      m_view(view),
      m_values(description),
      m_media(description, view),
      m_targets(make_targets(description, m_values, view, m_media.source_size())),
      m_shapes(description, view),
      m_samples(description.passes.size(), 0) {
    for (std::size_t i = 0; i < description.passes.size(); ++i) {
        m_programs.emplace_back(description.passes[i]);
        m_shapes.add_pass(description.passes[i], m_programs.back());
        write_fixed_uniforms(i);
    }
    if (m_targets.back().slots.front().texture().numbers() != Numbers::floating)
        throw Error("shows a target of whole numbers");
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_FRAMEBUFFER_SRGB);  // concerns only targets of the format srgb8_alpha8
}

void FramePlayer::write_fixed_uniforms(std::size_t index) const {
    const Program& program = m_programs[index];
    program.use();
    for (const auto& [uniform, numbers] : m_description.passes[index].set)
        program.write(uniform, numbers);
    if (const GLint tint = program.attribute("tint"); tint >= 0)
        glVertexAttrib3f(static_cast<GLuint>(tint), 1.0F, 1.0F, 1.0F);
}

void FramePlayer::draw_next() {
    const double start = m_number / 60.0;
    ++m_number;
    const double end = m_number / 60.0;
    restart_samples(m_values.advance(end, m_number == 1));
    m_media.advance(end);
    m_shapes.advance(start, end);
    for (Target& target : m_targets)
        target.advance();
    for (const std::size_t index : drawing_order(m_targets))
        draw_pass(index);
    if (glGetError() != GL_NO_ERROR)
        throw Error("the graphics driver reports an error");
}

// A changed value restarts the passes that read it, and those that read them in the same frame.
void FramePlayer::restart_samples(const std::set<std::string>& changed) {
    std::vector<bool> restarts(m_samples.size(), false);
    for (std::size_t i = 0; i < restarts.size(); ++i) {
        const Pass& pass = m_description.passes[i];
        for (const std::string& parameter : changed)
            restarts[i] = restarts[i] || is_read(pass, parameter);
        for (const Input& input : pass.inputs)
            if (input.from == "pass" && frames_ago(m_description, i, input) == 0)
                restarts[i] = restarts[i] || restarts[m_description.pass_named(input.name)];
        if (restarts[i])
            m_samples[i] = 0;
    }
}

// The number of samples of an accumulating pass in this frame.
int FramePlayer::begin_samples(std::size_t index) {
    const Pass& pass = m_description.passes[index];
    const int repeats = std::max(static_cast<int>(m_values.number(pass.repeat)), 1);
    if (!pass.accumulates || !pass.converge)
        return repeats;
    const int enough = static_cast<int>(m_values.number(*pass.converge));
    if (enough <= 0) {
        m_samples[index] = 0;
        return repeats;
    }
    return std::min(repeats, std::max(enough - m_samples[index], 0));
}

void FramePlayer::draw_pass(std::size_t index) {
    const Pass& pass = m_description.passes[index];
    const int draws = begin_samples(index);
    Target& target = m_targets[index];
    if (draws == 0 && target.has_previous())
        target.canvas(1).copy_to(target.canvas());
    const int before = samples_before(index);
    for (int i = 0; i < draws; ++i) {
        const bool is_again = i > 0 && reads_itself(pass);
        if (is_again)
            target.advance();
        m_programs[index].use();
        if (i == 0)
            write_uniforms(index);
        if (i == 0 || is_again)
            start_target(index);
        const double samples = pass.accumulates ? m_samples[index] : before + i;
        for (const BuiltIn& built_in : pass.built_ins)
            if (built_in.value == "samples")
                m_programs[index].write(built_in.uniform, std::array{samples});
        m_shapes.draw(index);
        m_samples[index] += pass.accumulates ? 1 : 0;
    }
    m_targets[target.host].canvas().texture().generate_mipmaps();
}

int FramePlayer::samples_before(std::size_t index) const {
    while (index-- > 0)
        if (m_description.passes[index].accumulates)
            return m_samples[index];
    return 0;
}

// Clears the target, or keeps its picture for more samples. Then binds it and the inputs.
void FramePlayer::start_target(std::size_t index) {
    const Pass& pass = m_description.passes[index];
    const Target& target = m_targets[index];
    const bool is_onto = target.host != index;
    const bool keeps_picture = pass.accumulates && m_samples[index] > 0;
    if (keeps_picture && target.has_previous())
        target.canvas(1).copy_to(target.canvas());
    else if (!keeps_picture && !is_onto)
        target.canvas().clear(pass.blend == "multiply" ? 1.0F : 0.0F);
    m_targets[target.host].canvas().bind();
    const bool is_floating = target.canvas().texture().numbers() == Numbers::floating;
    set_blending(is_floating ? pass.blend : "replace", is_onto);
    bind_inputs(index);
}

void FramePlayer::bind_inputs(std::size_t index) {
    const Pass& pass = m_description.passes[index];
    int unit = 0;
    for (const auto& [name, uniform] : m_programs[index].uniforms()) {
        if (!is_sampler(uniform.type))
            continue;
        const Input* input = find_input(pass, name);
        const Texture* texture = texture_for(index, name, uniform.type);
        if (!texture || !can_read(uniform.type, *texture))
            texture = m_media.empty(uniform.type);
        m_programs[index].set_unit(name, unit);
        if (texture)
            m_samplers.bind(unit, *texture, input ? input->sampler : Sampler());
        ++unit;
    }
}

// Null if nothing is there to read.
const Texture* FramePlayer::texture_for(std::size_t index, const std::string& uniform,
                                        GLenum sampler) {
    const Pass& pass = m_description.passes[index];
    if (const Input* input = find_input(pass, uniform)) {
        if (input->from != "pass")
            return m_media.find(*input);
        return sampler == GL_SAMPLER_CUBE ? cube_of(index, *input)
                                          : &canvas_of(index, *input).texture();
    }
    const auto chosen = std::ranges::find(pass.parameters, uniform, &Binding::uniform);
    return chosen == pass.parameters.end() ? nullptr : m_media.find_image(chosen->parameter);
}

const Canvas& FramePlayer::canvas_of(std::size_t index, const Input& input) const {
    const Target& target = m_targets[m_description.pass_named(input.name)];
    return target.canvas(frames_ago(m_description, index, input));
}

// A pass that is read as a cube has six faces next to each other.
const Texture* FramePlayer::cube_of(std::size_t index, const Input& input) {
    const Canvas& faces = canvas_of(index, input);
    const int side = faces.texture().size()[1];
    const std::size_t read = m_description.pass_named(input.name);
    const auto made =
        m_cubes.try_emplace(read, Shape::cube, Size{side, side}, faces.texture().format(), true);
    const Texture& cube = made.first->second;
    faces.copy_faces_to(cube);
    cube.generate_mipmaps();
    m_targets[m_targets[index].host].canvas().bind();
    return &cube;
}

void FramePlayer::write_uniforms(std::size_t index) const {
    const Pass& pass = m_description.passes[index];
    const Program& program = m_programs[index];
    PassState state = state_of(index);
    for (const BuiltIn& built_in : pass.built_ins) {
        if (built_in.of)
            state.of = size_of(index, *built_in.of);
        program.write(built_in.uniform, numbers_of(built_in.value, state));
        if (built_in.value == "view")
            program.write(built_in.uniform, view_matrix(m_description, pass, m_values));
        if (built_in.value == "camera")
            program.write(built_in.uniform, camera_matrix(m_description, pass, m_values));
    }
    for (const Binding& binding : pass.parameters) {
        const auto found =
            std::ranges::find(m_description.parameters, binding.parameter, &Parameter::name);
        if (found == m_description.parameters.end() || found->orbit != "none")
            continue;
        std::vector<double> numbers = m_values.of(found->name);
        for (std::size_t i = 0; found->is_display && i < std::min(numbers.size(), std::size_t{3});
             ++i)
            numbers[i] = srgb_encoded(numbers[i]);
        program.write(binding.uniform, numbers);
    }
}

PassState FramePlayer::state_of(std::size_t index) const {
    const Pass& pass = m_description.passes[index];
    PassState state;
    state.number = m_number;
    state.frame_modulo = pass.frame_modulo;
    state.target = m_targets[index].size;
    state.view = m_view;
    state.source = source_size(m_description, pass, m_targets, m_media.source_size());
    state.source_lines = own_raster(state.source[1]);
    state.source_columns = own_raster(state.source[0]);
    if (const PlacedPicture* shown = m_media.shown()) {
        state.source_pixel_aspect = shown->aspect;
        if (pass.source.empty()) {
            state.source_lines = shown->lines;
            state.source_columns = shown->columns;
        }
    }
    state.is_top_first = pass.is_top_first;
    state.is_drawn_onto = is_drawn_onto(m_description, m_targets, index);
    return state;
}

Size FramePlayer::size_of(std::size_t index, const Input& input) const {
    if (input.from == "pass")
        return m_targets[m_description.pass_named(input.name)].size;
    const Texture* texture = m_media.find(input);
    const Pass& pass = m_description.passes[index];
    return texture ? texture->size()
                   : source_size(m_description, pass, m_targets, m_media.source_size());
}

std::vector<std::uint8_t> FramePlayer::picture() const {
    const Pass& pass = m_description.passes.back();
    const Canvas& canvas = m_targets.back().canvas();
    const std::string& format = canvas.texture().format();
    const bool is_linear = m_description.shows_linear && format != "srgb8_alpha8";
    const bool is_grey = format == "r8" || format == "r16f" || format == "r32f";
    const std::vector<float> texels = canvas.read();
    const auto width = static_cast<std::size_t>(picture_size()[0]);
    const auto height = static_cast<std::size_t>(picture_size()[1]);
    std::vector<std::uint8_t> bytes;
    for (std::size_t y = 0; y < height; ++y) {
        const std::size_t row = pass.is_top_first ? y : height - 1 - y;
        for (std::size_t i = 4 * width * row; i < 4 * width * (row + 1); i += 4) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                bytes.push_back(byte_of(texels[i + (is_grey ? 0 : channel)], is_linear));
            bytes.push_back(pass.has_alpha ? byte_of(texels[i + 3], false) : 255);
        }
    }
    return bytes;
}
