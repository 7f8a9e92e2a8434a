#include "graph/targets/cube_copies.h"

const gpu::Texture* CubeCopies::copy_of(const gpu::Canvas& faces, bool is_mipmapped) {
    constexpr int count = 6;
    const gpu::Texture& drawn = faces.texture();
    const int side = drawn.extent().height;
    if (drawn.extent().width != count * side)
        return nullptr;
    auto cube = m_cubes.find(drawn.id());
    const bool is_usable = cube != m_cubes.end() && cube->second.extent() == Extent{side, side} &&
                           cube->second.format() == drawn.format() &&
                           cube->second.is_mipmapped() == is_mipmapped;
    if (!is_usable) {
        auto made =
            gpu::Texture::make_solid(PictureShape::cube, side, drawn.format(), is_mipmapped);
        if (!made)
            return nullptr;
        cube = m_cubes.insert_or_assign(drawn.id(), std::move(*made)).first;
    }
    faces.copy_faces_to(cube->second);
    cube->second.generate_mipmaps();
    return &cube->second;
}
