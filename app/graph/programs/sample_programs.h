#pragma once

#include "gpu/program.h"
#include "model/look/format.h"

#include <array>
#include <functional>
#include <optional>
#include <string_view>

/// What GLSL puts before "sampler2D" and "vec4" where they are of this kind.
std::string_view glsl_prefix(SampleKind kind);

/// Programs that do the same, one for each kind of numbers that a texture may hold. They belong to
/// the context that they are made in, and are asked for by one thread at a time.
class SamplePrograms {
public:
    using Build = std::function<Result<gpu::Program>(SampleKind)>;

    /// That for floats is made at once, so that what a driver refuses is told; the others, which
    /// few looks need, when they are asked for.
    static Result<SamplePrograms> make(Build build);

    /// None where the driver refuses it.
    const gpu::Program* find(Format read) const;

private:
    explicit SamplePrograms(Build build) : m_build(std::move(build)) {}
    const Result<gpu::Program>& made(SampleKind kind) const;

    Build m_build;
    mutable std::array<std::optional<Result<gpu::Program>>, 3> m_made;
};
