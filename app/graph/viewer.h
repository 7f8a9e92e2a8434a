#pragma once

#include "gpu/canvas.h"
#include "gpu/program.h"
#include "gpu/samplers.h"
#include "gpu/vertex_array.h"
#include "model/picture.h"

#include <array>
#include <optional>

enum class ChannelChoice { rgb, red, green, blue, alpha, luminance };

/// How a target is shown to a person.
struct ViewOptions {
    double exposure_stops = 0;  // light is multiplied by two to this power
    ChannelChoice channels = ChannelChoice::rgb;
    Encoding encoding =
        Encoding::linear;             // of the texels; linear ones are sRGB-encoded for the display
    Filter filter = Filter::nearest;  // where texels are magnified; smaller views are averaged
    // The part that is shown, in texels of the largest level from the bottom left; outside of it
    // the view is transparent black. Without a width all is shown.
    double left = 0;
    double bottom = 0;
    double width = 0;
    double height = 0;
    // Columns of the view that are drawn, the others stay; none: all are.
    std::optional<std::array<int, 2>> columns = std::nullopt;  // first, end
};

/// Draws targets as a person looks into them: thumbnails, and views with exposure, channels and
/// zoom. Numbers that are not finite show as magenta.
class Viewer {
public:
    static Result<Viewer> make();

    /// Into the whole of `to`, a canvas of 8 bits a channel with opaque alpha inside the picture.
    void draw(const gpu::Texture& from, const gpu::Canvas& to, const ViewOptions& options = {});

private:
    Viewer(gpu::Program floats, gpu::Program naturals);

    gpu::Program m_floats;
    gpu::Program m_naturals;  // for integer targets
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
};
