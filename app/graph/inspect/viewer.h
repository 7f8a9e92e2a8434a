#pragma once

#include "gpu/objects/canvas.h"
#include "gpu/objects/samplers.h"
#include "gpu/objects/vertex_array.h"
#include "graph/programs/sample_programs.h"
#include "model/look/picture.h"
#include "model/picture/levels.h"

#include <array>
#include <memory>
#include <optional>
#include <utility>

enum class ChannelChoice { rgb, red, green, blue, alpha, luminance };

/// How a target is shown to a person.
struct ViewOptions {
    Levels levels = {};         // stored numbers that are shown as black and as white
    double exposure_stops = 0;  // light is multiplied by two to this power, after the levels
    ChannelChoice channels = ChannelChoice::rgb;
    Encoding encoding =
        Encoding::linear;  // of the texels; linear ones are sRGB-encoded for the display
    // Marks stand in the place of colours and the rest is grey. One shows wherever a texel under
    // it is so, in the channels that are shown.
    bool marks_flaws = false;         // NaN red, infinite green, negative blue
    bool marks_clipping = false;      // at or above white yellow; all at or below black: dark cyan
    bool is_false_color = false;      // from black to white by false_color()
    bool is_over_checker = false;     // colours that are not marked: alpha is transparency
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

/// The ramp of false colours at 0..1, display-encoded: from black over blue, green and pink to
/// white, ever brighter. Cubehelix: D. A. Green, "A colour scheme for the display of astronomical
/// intensity images", Bull. Astr. Soc. India 39 (2011), with its start 0.5, rotations -1.5, hue 1.
std::array<double, 3> false_color(double place);

/// What viewers draw with.
struct ViewerPrograms {
    static Result<ViewerPrograms> make();

    gpu::Program encoded;  // floats as they are, where nothing is asked; of display values
    gpu::Program light;    // the same of light
    SamplePrograms all;    // whatever is asked
};

/// Draws targets as a person looks into them: thumbnails, and views with levels, exposure, channels
/// and zoom. Numbers that are not finite show as magenta where flaws are not marked.
class Viewer {
public:
    /// With programs of its own.
    static Result<Viewer> make();
    explicit Viewer(std::shared_ptr<const ViewerPrograms> programs)
        : m_programs(std::move(programs)) {}

    /// Into the whole of `to`, a canvas of 8 bits a channel with opaque alpha inside the picture.
    void draw(const gpu::Texture& from, const gpu::Canvas& to, const ViewOptions& options = {});

private:
    const gpu::Program* program_for(Format format, const ViewOptions& options,
                                    bool is_encoded) const;

    std::shared_ptr<const ViewerPrograms> m_programs;  // of who looks in the same context
    gpu::VertexArray m_vertices;
    gpu::Samplers m_samplers;
};
