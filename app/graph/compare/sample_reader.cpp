#include "graph/compare/sample_reader.h"

#include "gpu/objects/draw.h"
#include "gpu/objects/readback.h"
#include "graph/inspect/light_cells.h"
#include "graph/inspect/pair_text.h"
#include "graph/inspect/texel_programs.h"

#include <array>
#include <string>

namespace {
const std::string start_text = "#version 410 core\n" + curve_text + R"(
uniform sampler2D shown;
uniform vec2 picture;  // px
uniform vec2 canvas;   // px
uniform bool is_lone;
out vec4 color;
// The light of a pixel, counted from the top left. NaN and negative values count as 0.
vec3 light_at(ivec2 px) {
    vec3 numbers = texelFetch(shown, ivec2(px.x, int(picture.y) - 1 - px.y), 0).rgb;
    numbers = mix(vec3(0.0), numbers, greaterThan(numbers, vec3(0.0)));
    return to_light(is_lone ? numbers.rrr : numbers);
}
// The target's pixel, counted from the top left.
ivec2 place() { return ivec2(gl_FragCoord.x, canvas.y - gl_FragCoord.y); }
)";
// The same formula as SampleLayout::origin(), less the margin.
const std::string tiles_text = start_text + R"(
uniform vec2 tiles;
uniform float stride;
int first(int index, int count, int length) {
    int space = length - int(stride);
    return count == 1 ? space / 2 : index * space / (count - 1);
}
void main() {
    ivec2 tile = place() / int(stride);
    ivec2 origin = ivec2(first(tile.x, int(tiles.x), int(picture.x)),
                         first(tile.y, int(tiles.y), int(picture.y)));
    color = vec4(light_at(origin + place() % int(stride)), 1.0);
}
)";
const std::string cells_text = start_text + R"(
uniform float side;
uniform float border;
void main() {
    int width = int(side);
    ivec2 origin = (place() + int(border)) * width;
    vec3 light = vec3(0.0);
    for (int y = 0; y < width; ++y)
        for (int x = 0; x < width; ++x)
            light += light_at(origin + ivec2(x, y));
    color = vec4(light / float(width * width), 1.0);
}
)";

std::array<double, 2> pair_of(Extent extent) {
    return {static_cast<double>(extent.width), static_cast<double>(extent.height)};
}

std::vector<glm::vec3> colors_of(const Picture& picture) {
    std::vector<glm::vec3> colors;
    const auto channels = static_cast<std::size_t>(picture.channels);
    colors.reserve(picture.pixels.size() / channels);
    for (std::size_t i = 0; i < picture.pixels.size(); i += channels)
        colors.emplace_back(picture.pixels[i], picture.pixels[i + 1], picture.pixels[i + 2]);
    return colors;
}

// The canvas has the tiles side by side; the result has one after another.
std::vector<glm::vec3> tiles_of(const Picture& picture, const SampleLayout& layout) {
    const std::vector<glm::vec3> colors = colors_of(picture);
    constexpr int stride = SampleLayout::stride;
    std::vector<glm::vec3> tiles;
    tiles.reserve(colors.size());
    for (int tile = 0; tile < layout.tile_count(); ++tile)
        for (int y = 0; y < stride; ++y) {
            const std::ptrdiff_t row = tile / layout.tiles.width * stride + y;
            const int column = tile % layout.tiles.width * stride;
            const auto from = colors.begin() + row * picture.extent.width + column;
            tiles.insert(tiles.end(), from, from + stride);
        }
    return tiles;
}
}  // namespace

Result<SampleReader> SampleReader::make() {
    auto tiles = build_measuring_program(tiles_text);
    if (!tiles)
        return fail(tiles.error());
    auto cells = build_measuring_program(cells_text);
    if (!cells)
        return fail(cells.error());
    return SampleReader(std::move(*tiles), std::move(*cells));
}

void SampleReader::draw(const gpu::Program& program, const gpu::Texture& texture, Encoding encoding,
                        const gpu::Canvas& canvas, const SampleLayout& layout) {
    const gpu::DrawScope scope;
    program.write("picture", pair_of(layout.picture));
    program.write("canvas", pair_of(canvas.texture().extent()));
    program.write("tiles", pair_of(layout.tiles));
    program.write("stride", std::array{static_cast<double>(SampleLayout::stride)});
    program.write("border", std::array{static_cast<double>(SampleLayout::border)});
    program.write("side", std::array{static_cast<double>(layout.cell_side)});
    program.write("is_encoded", std::array{holds_light(texture, encoding) ? 0.0 : 1.0});
    program.write("is_lone", std::array{info_of(texture.format()).channels == 1 ? 1.0 : 0.0});
    m_samplers.bind(0, texture, {Filter::nearest, Wrap::edge, false});
    program.use();
    m_vertices.bind();
    canvas.bind();
    gpu::draw_triangle();
    m_samplers.release();
}

Result<ScreenLight> SampleReader::read(const gpu::Texture& texture, Encoding encoding,
                                       const SampleLayout& layout) {
    const Extent tiles{layout.tiles.width * SampleLayout::stride,
                       layout.tiles.height * SampleLayout::stride};
    if (info_of(texture.format()).is_integer || !fit_floats(m_tile_canvas, tiles) ||
        !fit_floats(m_cell_canvas, layout.cells))
        return fail({{}, 0, "the picture can't be read for a comparison with a photo"});
    draw(m_tiles, texture, encoding, *m_tile_canvas, layout);
    draw(m_cells, texture, encoding, *m_cell_canvas, layout);
    return ScreenLight{tiles_of(gpu::read_picture(m_tile_canvas->texture()), layout),
                       colors_of(gpu::read_picture(m_cell_canvas->texture()))};
}
