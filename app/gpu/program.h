#pragma once

#include "base/diagnostic.h"
#include "gpu/name.h"
#include "gpu/uniform.h"
#include "model/look.h"

#include <span>
#include <string_view>
#include <vector>

namespace gpu {

void delete_program(GLuint id);

/// A vertex and a fragment stage, compiled and linked.
class Program {
public:
    /// On refusal the driver's words at the author's own files and lines.
    static Result<Program> build(const Stage& vertex, const Stage& fragment);

    /// Those that the driver kept.
    const std::vector<Uniform>& uniforms() const { return m_uniforms; }
    const Uniform* find_uniform(std::string_view name) const;
    /// Below 0: there is none.
    int attribute_location(const char* name) const;

    /// As write_uniform; a name that the program lacks is passed over.
    void write(std::string_view uniform, std::span<const double> numbers) const;
    void write(const Uniform& uniform, std::span<const double> numbers) const;
    /// Which unit a sampler reads; the elements of an array read the following ones.
    void set_unit(const Uniform& sampler, int unit) const;
    void use() const;

private:
    explicit Program(GLuint id);

    Name<delete_program> m_name;
    std::vector<Uniform> m_uniforms;
};

}  // namespace gpu
