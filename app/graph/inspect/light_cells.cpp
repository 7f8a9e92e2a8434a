#include "graph/inspect/light_cells.h"

#include "gpu/objects/draw.h"
#include "graph/inspect/pair_text.h"
#include "graph/inspect/texel_programs.h"

#include <array>
#include <string>

namespace {
const std::string cells_text = "#version 410 core\n" + curve_text + R"(
uniform sampler2D shown;
uniform vec2 cells;
uniform bool is_lone;
out vec4 color;
void main() {
    const int side = 8;  // places in a row of a cell, each between four texels
    vec3 light = vec3(0.0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            vec2 position = floor(gl_FragCoord.xy) + (vec2(x, y) + 0.5) / float(side);
            vec3 numbers = textureLod(shown, position / cells, 0.0).rgb;
            // What is no number is dark; the comparison is false for it.
            numbers = mix(vec3(0.0), min(numbers, 1.0), greaterThan(numbers, vec3(0.0)));
            light += to_light(is_lone ? numbers.rrr : numbers);
        }
    color = vec4(light / float(side * side), 1.0);
}
)";
}  // namespace

bool holds_light(const gpu::Texture& texture, Encoding encoding) {
    return encoding == Encoding::linear || texture.format() == Format::srgb8_alpha8;
}

Result<gpu::Program> LightCells::make_program() {
    return build_measuring_program(cells_text);
}

Result<LightCells> LightCells::make() {
    auto program = make_program();
    if (!program)
        return fail(program.error());
    return LightCells(std::make_shared<const gpu::Program>(std::move(*program)));
}

bool LightCells::draw(const gpu::Texture& from, Encoding encoding) {
    if (from.extent().is_empty() || info_of(from.format()).is_integer ||
        !fit_floats(m_cells, flash_cells))
        return false;
    const gpu::DrawScope scope;
    m_program->write("cells", std::array{static_cast<double>(flash_cells.width),
                                         static_cast<double>(flash_cells.height)});
    m_program->write("is_encoded", std::array{holds_light(from, encoding) ? 0.0 : 1.0});
    m_program->write("is_lone", std::array{info_of(from.format()).channels == 1 ? 1.0 : 0.0});
    m_samplers.bind(0, from, {Filter::linear, Wrap::edge, false});
    m_program->use();
    m_vertices.bind();
    m_cells->bind();
    gpu::draw_triangle();
    m_samplers.release();
    return true;
}

std::vector<Light> taken_cells(gpu::Download& download) {
    const std::vector<float> numbers = download.take();
    std::vector<Light> cells(numbers.size() / 4);
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i] = {numbers[4 * i], numbers[4 * i + 1], numbers[4 * i + 2]};
    return cells;
}
