#include "gpu/uniform.h"

#include <algorithm>
#include <array>
#include <limits>

namespace gpu {

namespace {
struct NumberName {
    GLenum type;
    NumberType number;
};

constexpr auto number_names = std::to_array<NumberName>({
    {GL_FLOAT, {Scalar::floating, 1, 1}},
    {GL_FLOAT_VEC2, {Scalar::floating, 2, 1}},
    {GL_FLOAT_VEC3, {Scalar::floating, 3, 1}},
    {GL_FLOAT_VEC4, {Scalar::floating, 4, 1}},
    {GL_INT, {Scalar::integer, 1, 1}},
    {GL_INT_VEC2, {Scalar::integer, 2, 1}},
    {GL_INT_VEC3, {Scalar::integer, 3, 1}},
    {GL_INT_VEC4, {Scalar::integer, 4, 1}},
    {GL_UNSIGNED_INT, {Scalar::unsigned_integer, 1, 1}},
    {GL_UNSIGNED_INT_VEC2, {Scalar::unsigned_integer, 2, 1}},
    {GL_UNSIGNED_INT_VEC3, {Scalar::unsigned_integer, 3, 1}},
    {GL_UNSIGNED_INT_VEC4, {Scalar::unsigned_integer, 4, 1}},
    {GL_BOOL, {Scalar::boolean, 1, 1}},
    {GL_BOOL_VEC2, {Scalar::boolean, 2, 1}},
    {GL_BOOL_VEC3, {Scalar::boolean, 3, 1}},
    {GL_BOOL_VEC4, {Scalar::boolean, 4, 1}},
    {GL_FLOAT_MAT2, {Scalar::floating, 2, 2}},
    {GL_FLOAT_MAT3, {Scalar::floating, 3, 3}},
    {GL_FLOAT_MAT4, {Scalar::floating, 4, 4}},
    {GL_FLOAT_MAT2x3, {Scalar::floating, 3, 2}},
    {GL_FLOAT_MAT2x4, {Scalar::floating, 4, 2}},
    {GL_FLOAT_MAT3x2, {Scalar::floating, 2, 3}},
    {GL_FLOAT_MAT3x4, {Scalar::floating, 4, 3}},
    {GL_FLOAT_MAT4x2, {Scalar::floating, 2, 4}},
    {GL_FLOAT_MAT4x3, {Scalar::floating, 3, 4}},
});

bool is_double(GLenum type) {
    return type == GL_DOUBLE || (type >= GL_DOUBLE_VEC2 && type <= GL_DOUBLE_VEC4) ||
           (type >= GL_DOUBLE_MAT2 && type <= GL_DOUBLE_MAT4x3);
}

Uniform::Sampled sampled_by(GLenum type) {
    if (is_double(type))
        return Uniform::Sampled::none;
    switch (type) {
        case GL_SAMPLER_2D:
            return Uniform::Sampled::floating;
        case GL_INT_SAMPLER_2D:
            return Uniform::Sampled::integer;
        case GL_UNSIGNED_INT_SAMPLER_2D:
            return Uniform::Sampled::unsigned_integer;
        case GL_SAMPLER_CUBE:
            return Uniform::Sampled::cube;
        case GL_SAMPLER_3D:
            return Uniform::Sampled::volume;
        default:
            return Uniform::Sampled::other;
    }
}

// The maximum number of components per write.
constexpr std::size_t max_components = 1024;

template <class Component>
struct Components {
    std::array<Component, max_components> values;

    const Component* from(std::span<const double> numbers) {
        for (std::size_t i = 0; i < numbers.size(); ++i)
            values[i] = static_cast<Component>(std::clamp(
                numbers[i], static_cast<double>(std::numeric_limits<Component>::lowest()),
                static_cast<double>(std::numeric_limits<Component>::max())));
        return values.data();
    }
};

void write_floats(GLuint program, GLint at, int rows, GLsizei count, const GLfloat* values) {
    if (rows == 1)
        glProgramUniform1fv(program, at, count, values);
    else if (rows == 2)
        glProgramUniform2fv(program, at, count, values);
    else if (rows == 3)
        glProgramUniform3fv(program, at, count, values);
    else
        glProgramUniform4fv(program, at, count, values);
}

void write_integers(GLuint program, GLint at, int rows, GLsizei count, const GLint* values) {
    if (rows == 1)
        glProgramUniform1iv(program, at, count, values);
    else if (rows == 2)
        glProgramUniform2iv(program, at, count, values);
    else if (rows == 3)
        glProgramUniform3iv(program, at, count, values);
    else
        glProgramUniform4iv(program, at, count, values);
}

void write_naturals(GLuint program, GLint at, int rows, GLsizei count, const GLuint* values) {
    if (rows == 1)
        glProgramUniform1uiv(program, at, count, values);
    else if (rows == 2)
        glProgramUniform2uiv(program, at, count, values);
    else if (rows == 3)
        glProgramUniform3uiv(program, at, count, values);
    else
        glProgramUniform4uiv(program, at, count, values);
}

void write_matrices(GLuint program, GLint at, const NumberType& type, GLsizei count,
                    const GLfloat* values) {
    switch (type.columns * 10 + type.rows) {
        case 22:
            return glProgramUniformMatrix2fv(program, at, count, GL_FALSE, values);
        case 23:
            return glProgramUniformMatrix2x3fv(program, at, count, GL_FALSE, values);
        case 24:
            return glProgramUniformMatrix2x4fv(program, at, count, GL_FALSE, values);
        case 32:
            return glProgramUniformMatrix3x2fv(program, at, count, GL_FALSE, values);
        case 33:
            return glProgramUniformMatrix3fv(program, at, count, GL_FALSE, values);
        case 34:
            return glProgramUniformMatrix3x4fv(program, at, count, GL_FALSE, values);
        case 42:
            return glProgramUniformMatrix4x2fv(program, at, count, GL_FALSE, values);
        case 43:
            return glProgramUniformMatrix4x3fv(program, at, count, GL_FALSE, values);
        case 44:
            return glProgramUniformMatrix4fv(program, at, count, GL_FALSE, values);
        default:
            return;
    }
}
}  // namespace

Uniform make_uniform(std::string name, GLint location, GLint count, GLenum type) {
    if (name.ends_with("[0]"))
        name.resize(name.size() - 3);
    Uniform uniform{std::move(name), location, count, std::nullopt, Uniform::Sampled::none};
    const auto* const found = std::ranges::find(number_names, type, &NumberName::type);
    if (found != number_names.end())
        uniform.number = found->number;
    else
        uniform.sampled = sampled_by(type);
    return uniform;
}

void write_uniform(GLuint program, const Uniform& uniform, std::span<const double> numbers) {
    if (!uniform.number)
        return;
    const NumberType type = *uniform.number;
    const auto size = static_cast<std::size_t>(type.size());
    const std::size_t elements = std::min(
        {static_cast<std::size_t>(uniform.count), numbers.size() / size, max_components / size});
    numbers = numbers.first(elements * size);
    const auto count = static_cast<GLsizei>(elements);
    const GLint at = uniform.location;
    if (elements == 0)
        return;
    if (type.scalar == Scalar::unsigned_integer)
        write_naturals(program, at, type.rows, count, Components<GLuint>().from(numbers));
    else if (type.scalar != Scalar::floating)
        write_integers(program, at, type.rows, count, Components<GLint>().from(numbers));
    else if (type.columns > 1)
        write_matrices(program, at, type, count, Components<GLfloat>().from(numbers));
    else
        write_floats(program, at, type.rows, count, Components<GLfloat>().from(numbers));
}

}  // namespace gpu
