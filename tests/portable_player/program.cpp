#include "portable_player/program.h"

#include "portable_player/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace {
constexpr GLsizei longest_text = 4096;

GlName<delete_shader> compiled(GLenum stage, const std::filesystem::path& file) {
    GlName<delete_shader> shader(glCreateShader(stage));
    const std::string text = read_text(file);
    const GLchar* const start = text.c_str();
    glShaderSource(shader.get(), 1, &start, nullptr);
    glCompileShader(shader.get());
    GLint is_good = 0;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &is_good);
    std::array<GLchar, longest_text> log{};
    glGetShaderInfoLog(shader.get(), longest_text, nullptr, log.data());
    if (is_good == 0)
        throw Error(file.string() + ": " + log.data());
    return shader;
}

/// How the numbers of a uniform are written.
struct NumberType {
    GLenum type;
    std::size_t size;
    void (*write)(GLint location, GLsizei count, const std::vector<double>& numbers);
};

template <class Number>
std::vector<Number> converted(const std::vector<double>& numbers) {
    std::vector<Number> result;
    for (const double number : numbers)
        result.push_back(
            static_cast<Number>(std::is_floating_point_v<Number> ? number : std::round(number)));
    return result;
}

#define PLAYER_VECTOR(TYPE, size, function, Number)                                   \
    {                                                                                 \
        TYPE, size, [](GLint location, GLsizei count, const std::vector<double>& n) { \
            function(location, count, converted<Number>(n).data());                   \
        }                                                                             \
    }
#define PLAYER_MATRIX(TYPE, size, function)                                           \
    {                                                                                 \
        TYPE, size, [](GLint location, GLsizei count, const std::vector<double>& n) { \
            function(location, count, GL_FALSE, converted<GLfloat>(n).data());        \
        }                                                                             \
    }
const std::vector<NumberType> number_types{
    PLAYER_VECTOR(GL_FLOAT, 1, glUniform1fv, GLfloat),
    PLAYER_VECTOR(GL_FLOAT_VEC2, 2, glUniform2fv, GLfloat),
    PLAYER_VECTOR(GL_FLOAT_VEC3, 3, glUniform3fv, GLfloat),
    PLAYER_VECTOR(GL_FLOAT_VEC4, 4, glUniform4fv, GLfloat),
    PLAYER_VECTOR(GL_INT, 1, glUniform1iv, GLint),
    PLAYER_VECTOR(GL_INT_VEC2, 2, glUniform2iv, GLint),
    PLAYER_VECTOR(GL_INT_VEC3, 3, glUniform3iv, GLint),
    PLAYER_VECTOR(GL_INT_VEC4, 4, glUniform4iv, GLint),
    PLAYER_VECTOR(GL_BOOL, 1, glUniform1iv, GLint),
    PLAYER_VECTOR(GL_BOOL_VEC2, 2, glUniform2iv, GLint),
    PLAYER_VECTOR(GL_BOOL_VEC3, 3, glUniform3iv, GLint),
    PLAYER_VECTOR(GL_BOOL_VEC4, 4, glUniform4iv, GLint),
    PLAYER_VECTOR(GL_UNSIGNED_INT, 1, glUniform1uiv, GLuint),
    PLAYER_VECTOR(GL_UNSIGNED_INT_VEC2, 2, glUniform2uiv, GLuint),
    PLAYER_VECTOR(GL_UNSIGNED_INT_VEC3, 3, glUniform3uiv, GLuint),
    PLAYER_VECTOR(GL_UNSIGNED_INT_VEC4, 4, glUniform4uiv, GLuint),
    PLAYER_MATRIX(GL_FLOAT_MAT2, 4, glUniformMatrix2fv),
    PLAYER_MATRIX(GL_FLOAT_MAT2x3, 6, glUniformMatrix2x3fv),
    PLAYER_MATRIX(GL_FLOAT_MAT2x4, 8, glUniformMatrix2x4fv),
    PLAYER_MATRIX(GL_FLOAT_MAT3, 9, glUniformMatrix3fv),
    PLAYER_MATRIX(GL_FLOAT_MAT3x2, 6, glUniformMatrix3x2fv),
    PLAYER_MATRIX(GL_FLOAT_MAT3x4, 12, glUniformMatrix3x4fv),
    PLAYER_MATRIX(GL_FLOAT_MAT4, 16, glUniformMatrix4fv),
    PLAYER_MATRIX(GL_FLOAT_MAT4x2, 8, glUniformMatrix4x2fv),
    PLAYER_MATRIX(GL_FLOAT_MAT4x3, 12, glUniformMatrix4x3fv)};
#undef PLAYER_VECTOR
#undef PLAYER_MATRIX
}  // namespace

Program::Program(const Pass& pass) : m_name(glCreateProgram()) {
    const auto vertex = compiled(GL_VERTEX_SHADER, pass.vertex);
    const auto fragment = compiled(GL_FRAGMENT_SHADER, pass.fragment);
    const GLuint name = m_name.get();
    glAttachShader(name, vertex.get());
    glAttachShader(name, fragment.get());
    glLinkProgram(name);
    GLint is_good = 0;
    glGetProgramiv(name, GL_LINK_STATUS, &is_good);
    std::array<GLchar, longest_text> text{};
    glGetProgramInfoLog(name, longest_text, nullptr, text.data());
    if (is_good == 0)
        throw Error(pass.fragment.string() + ": " + text.data());
    GLint count = 0;
    glGetProgramiv(name, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        Uniform uniform;
        glGetActiveUniform(name, static_cast<GLuint>(i), longest_text, nullptr, &uniform.count,
                           &uniform.type, text.data());
        uniform.location = glGetUniformLocation(name, text.data());
        const std::string full = text.data();
        m_uniforms[full.substr(0, full.find("[0]"))] = uniform;
    }
}

void Program::write(const std::string& uniform, std::span<const double> numbers) const {
    const auto found = m_uniforms.find(uniform);
    if (found == m_uniforms.end())
        return;
    const auto type = std::ranges::find(number_types, found->second.type, &NumberType::type);
    if (type == number_types.end() || numbers.size() < type->size)
        return;
    const std::size_t count =
        std::min(numbers.size() / type->size, static_cast<std::size_t>(found->second.count));
    type->write(
        found->second.location, static_cast<GLsizei>(count),
        {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count * type->size)});
}

void Program::set_unit(const std::string& sampler, int unit) const {
    glUniform1i(m_uniforms.at(sampler).location, unit);
}
