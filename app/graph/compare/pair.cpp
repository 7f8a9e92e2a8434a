#include "graph/compare/pair.h"

#include "graph/inspect/pair_text.h"
#include "graph/inspect/texel_programs.h"

#include <array>

namespace {
Result<gpu::Program> build_pair(const std::string& reading, const std::string& body) {
    return build_measuring_program("#version 410 core\nout vec4 color;\n" + reading + body);
}

double is_lone(const gpu::Texture& texture) {
    return info_of(texture.format()).channels == 1 ? 1.0 : 0.0;
}

double is_decoded(const gpu::Texture& texture) {
    return texture.format() == Format::srgb8_alpha8 ? 1.0 : 0.0;
}
}  // namespace

Result<gpu::Program> build_pair_program(const std::string& body) {
    auto program = build_pair(pair_text, body);
    if (program)
        if (const gpu::Uniform* other = program->find_uniform("other"))
            program->set_unit(*other, 1);
    return program;
}

Result<gpu::Program> build_single_program(const std::string& body) {
    return build_pair(curve_text + "uniform sampler2D shown;\nuniform float lone, decoded;\n",
                      body);
}

void bind_pair(const Pair& pair, const gpu::Program& program, gpu::Samplers& samplers) {
    constexpr Sampler plain{Filter::nearest, Wrap::edge, false};
    program.write("lone", std::array{is_lone(pair.ours), is_lone(pair.other)});
    program.write("decoded", std::array{is_decoded(pair.ours), is_decoded(pair.other)});
    program.write("is_encoded", std::array{pair.encoding == Encoding::display ? 1.0 : 0.0});
    samplers.bind(0, pair.ours, plain);
    samplers.bind(1, pair.other, plain);
    program.use();
}

bool are_comparable(const gpu::Texture& ours, const gpu::Texture& other) {
    return ours.extent() == other.extent() && !info_of(ours.format()).is_integer &&
           !info_of(other.format()).is_integer;
}
