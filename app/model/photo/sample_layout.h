#pragma once

#include "model/look/extent.h"

#include <glm/glm.hpp>

/// Where a look's picture is compared with a photo: in tiles of whole pixels, which show mask and
/// scanlines, and in points that cover the picture and show its mean light around them. The light
/// of a point comes from small cells, so that a mask can't make moire. Positions are px from the
/// picture's top left corner.
struct SampleLayout {
    explicit SampleLayout(Extent picture);
    /// Tiles that cover the picture except for a margin. They overlap.
    static SampleLayout dense(Extent picture);
    /// The same without tiles, or without points.
    SampleLayout without_tiles() const;
    SampleLayout without_points() const;

    Extent picture;
    Extent tiles;     // number of tiles, across and down
    Extent cells;     // number of cells
    int cell_side;    // px
    Extent points;    // number of points: at every second cell
    Extent quarters;  // number of quarters of tiles that points belong to

    static constexpr int side = 28;    // of a tile, px
    static constexpr int margin = 17;  // around each tile, for blur
    static constexpr int border = 6;   // cells left out at each edge, where photos show the case
    static constexpr int stride = side + 2 * margin;

    int tile_count() const { return tiles.width * tiles.height; }
    int cell_count() const { return cells.width * cells.height; }
    int point_count() const { return points.width * points.height; }
    /// From one point to the next, px.
    int point_distance() const { return 2 * cell_side; }
    /// The first pixel of a tile without its margin.
    glm::ivec2 origin(int tile) const;
    /// The centre of a cell.
    glm::dvec2 cell_centre(int cell) const;
    /// The position of a point: the centre of its cell.
    glm::dvec2 point(int index) const;
    /// The quarter of a tile next to a point: four times the tile, plus 0 to 3.
    int quarter_of_point(int index) const;
};
