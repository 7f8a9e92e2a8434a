#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "graph/programs/sample_programs.h"
#include "model/look/picture.h"
#include "model/picture/channels.h"
#include "model/picture/levels.h"

#include <array>
#include <memory>
#include <optional>
#include <utility>

/// How a target is displayed.
struct ViewOptions {
    Levels levels = {};         // stored numbers that are displayed as black and white
    double exposure_stops = 0;  // light is multiplied by 2^this, after the levels
    double headroom = 1.0;  // for HDR: light up to this is tone-mapped to the display; 1: is not
    Channels channels = Channels::color;
    Encoding encoding =
        Encoding::linear;  // of the texels; linear ones are sRGB-encoded for display
    // Marks replace colours, and the rest is grey. A pixel is marked if any texel under it
    // qualifies, in the displayed channels.
    bool marks_flaws = false;         // red: NaN; green: infinity; blue: negative
    bool marks_clipping = false;      // yellow: at or above white; dark cyan: all at or below black
    bool is_false_color = false;      // black to white mapped by false_color()
    bool is_over_checker = false;     // unmarked colours: alpha is transparency
    Filter filter = Filter::nearest;  // for magnified texels; minified ones are averaged
    // The displayed region, in texels of the largest level from the bottom left. Outside the
    // texture the view is transparent black. Width 0: the whole texture.
    double left = 0;
    double bottom = 0;
    double width = 0;
    double height = 0;
    // Columns of the view to draw; the others keep their content. nullopt: all.
    std::optional<std::array<int, 2>> columns = std::nullopt;  // first, end
};

/// The false colour at 0..1, display-encoded: from black through blue, green and pink to white,
/// with increasing brightness. Cubehelix: D. A. Green, "A colour scheme for the display of
/// astronomical intensity images", Bull. Astr. Soc. India 39 (2011), with start 0.5, rotations
/// -1.5, hue 1.
std::array<double, 3> false_color(double position);

/// The programs of a Viewer.
struct ViewerPrograms {
    static Result<ViewerPrograms> make();

    gpu::Program encoded;  // float formats without options; display-encoded
    gpu::Program light;    // the same; linear light
    SamplePrograms all;    // with any options
};

/// Displays targets: thumbnails, and views with levels, exposure, channels and zoom. Numbers that
/// are not finite are magenta unless flaws are marked.
class Viewer {
public:
    /// Builds its own programs.
    static Result<Viewer> make();
    explicit Viewer(std::shared_ptr<const ViewerPrograms> programs)
        : m_programs(std::move(programs)) {}

    /// Draws into all of `to`, a canvas with 8 bits per channel. Alpha is opaque inside the
    /// picture.
    void draw(const gpu::Texture& from, const gpu::Canvas& to, const ViewOptions& options = {});

private:
    const gpu::Program* program_for(Format format, const ViewOptions& options,
                                    bool is_encoded) const;

    std::shared_ptr<const ViewerPrograms> m_programs;  // shared within a context
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
};
