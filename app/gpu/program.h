#pragma once

#include "base/byte_store.h"
#include "base/diagnostic.h"
#include "gpu/context.h"
#include "gpu/objects/name.h"
#include "gpu/uniform.h"
#include "model/look/look.h"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace gpu {

void delete_program(GLuint id);

/// A vertex and a fragment stage, compiled and linked.
class Program {
public:
    /// On refusal the driver's words at the author's own files and lines. With a store the driver's
    /// own form of the program is taken from there, or kept there, as long as the driver says the
    /// same of itself.
    static Result<Program> build(const Stage& vertex, const Stage& fragment,
                                 ByteStore* kept = nullptr);
    /// It was in the store, and the driver took it.
    bool is_restored() const { return m_is_restored; }

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

    static Result<Program> compiled(const Stage& vertex, const Stage& fragment);

    Name<delete_program> m_name;
    void list_uniforms();

    std::vector<Uniform> m_uniforms;
    std::vector<std::size_t> m_by_name;  // places in m_uniforms
    bool m_is_restored = false;
};

/// Whoever owns it last, on any thread, has it end in `home`: a driver may take from a context what
/// it has bound where another one ends a program. Null: in the one that is current then.
std::shared_ptr<const Program> ending_in(std::shared_ptr<Context> home, Program program);

}  // namespace gpu
