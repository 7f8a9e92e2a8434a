#pragma once

#include "base/shared_text.h"
#include "base/text.h"
#include "model/look/built_in.h"
#include "model/look/extent.h"
#include "model/look/format.h"
#include "model/look/include_folders.h"
#include "model/look/input.h"
#include "model/look/parameter.h"
#include "model/look/picture.h"
#include "model/look/shader_limits.h"
#include "model/look/spec.h"
#include "model/look/stack.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// One side of a target's size: `factor` times what it is measured by.
struct Side {
    enum class By { viewport, source, before, pixels, expression };
    // before: the target of the pass before; of the first one the source

    By by = By::viewport;
    double factor = 1.0;     // pixels: the size itself
    std::string expression;  // over WIDTH, HEIGHT and parameters, all behind '$'

    bool operator==(const Side&) const = default;
};

/// GLSL as glslang and the driver get it, and where each of its lines was written.
struct Stage {
    std::filesystem::path file;  // "": the program's own text
    SharedText text;
    LineMap lines;

    bool operator==(const Stage&) const = default;
};

/// A whole number, or the parameter that says it.
using Count = std::variant<int, std::string>;

// quad: four corners, `position` at location 0 and texture coordinates at 1, both from 0 to 1.
enum class Draw { fullscreen, quad, points, segments };
/// Whether it draws the beam of a signal.
bool is_of_beam(Draw draw);
enum class Blend { replace, add, alpha, multiply, maximum };

/// A pass that reads another one and only adds it to what it draws itself. While an expression says
/// so and nobody looks at either, the plan may have it drawn straight onto that pass's target.
struct Onto {
    std::string pass;
    std::string where;  // the expression: it is allowed above 0

    bool operator==(const Onto&) const = default;
};

/// One draw: a vertex and a fragment shader, inputs, one target.
struct Pass {
    std::string name;
    Draw draw = Draw::fullscreen;
    Stage vertex;
    Stage fragment;
    Format format = Format::rgba16f;
    std::string one_channel = {};  // an expression: where it is above 0 only red is kept
    std::string half_floats = {};  // likewise: where floats have 16 bits in the place of 32
    std::array<Side, 2> size;      // width, height
    std::optional<Onto> onto = std::nullopt;
    // Of a pass of segments, expressions: the smallest spot, see BeamSpot; empty: half a texel.
    std::array<std::string, 2> spot = {};
    Blend blend = Blend::replace;
    std::vector<Input> inputs;
    Values set;  // uniforms with a fixed value
    std::vector<BuiltInUniform> built_ins = own_built_ins();
    std::map<std::string, std::string> rename;  // uniform -> parameter
    bool accumulate = false;  // goes on until anything changes, counted in u_samples
    Count repeat = 1;         // draws a frame
    std::optional<Count> converge = std::nullopt;  // samples that are enough to accumulate
    int frame_modulo = 0;                          // u_frame counts modulo this; 0: never
    RowOrder rows = RowOrder::bottom_first;        // of its target
    Location declared;                             // in look.json
    // Of a pass in a stack:
    std::string scope;   // stands before the names of its look's parameters, "crt/"
    std::string source;  // the pass that its look reads as the source; "": the source itself
    Encoding output = Encoding::linear;  // of what it writes, where it is not the last pass
    bool has_alpha = false;              // its alpha is meant as transparency, unassociated
    bool keeps_when_resized = false;     // what is remembered of it is stretched to another size

    bool operator==(const Pass&) const = default;
};

/// A picture that belongs to a look (a LUT).
struct Image {
    std::string name;
    std::filesystem::path file;
    Sampler sampler;
    bool is_linear = false;                  // data, not display-encoded colours
    std::optional<Encoding> encoding = {};   // that its look reads; none: as the source
    RowOrder rows = RowOrder::bottom_first;  // as it is uploaded
    Format format = Format::rgba32f;         // likewise
    bool is_needed = true;  // where it cannot be read the look cannot; else it reads black
    PictureShape shape = PictureShape::flat;  // that its readers take; a file is made one
    // Instead of `file` a picture of the program's own, "pattern:noise" or "solid:sky". Where both
    // are empty a parameter of the same name chooses the picture.
    std::string made = {};
    // Of a cube that six files make, in GL's order of faces; `file` is the first one.
    std::vector<std::filesystem::path> faces = {};

    bool operator==(const Image&) const = default;
};

/// A heading that parameters are listed under.
struct Heading {
    std::string name;
    Location declared;

    bool operator==(const Heading&) const = default;
};

enum class Driver { signal, picture, nothing };

constexpr int most_settle_frames = 100000;

/// The passes in order, their inputs, images and parameters: all that is needed to draw, in one
/// value.
struct Look {
    std::string id;  // the folder's name: "phosphor"
    std::string name;
    std::string about;
    std::string author;
    std::string license;
    Driver driven_by = Driver::nothing;
    std::optional<Spec> default_signal;
    std::string default_source;
    Encoding source_encoding = Encoding::linear;
    RowOrder source_rows = RowOrder::bottom_first;
    Format source_format = Format::rgba32f;
    Encoding output = Encoding::display;
    int settle_frames = 1;
    bool has_orbit = false;
    std::vector<Pass> passes;
    std::vector<Image> images;
    std::vector<Heading> groups;               // the first ones, in their order
    std::vector<Parameter> parameters;         // by `groups`, else in the order of declaration
    Values constants;                          // of parameters that are such: what it was made with
    std::filesystem::path manifest;            // look.json, or the foreign file
    IncludeFolders includes;                   // that all looks may have
    std::vector<std::filesystem::path> files;  // everything that it was read from, for the watcher
    Stack stack;                               // the looks that it is made of
    ShaderLimits shader_limits = {};           // that its texts were held to

    bool operator==(const Look&) const = default;
};

/// Whether a pass is told where the mouse's button was pressed; whether one reads the keyboard.
bool reads_press(const Look& look);
bool reads_keys(const Look& look);

/// The place of the pass in Look::passes.
std::optional<int> find_pass(const Look& look, std::string_view name);
const Parameter* find_parameter(const Look& look, std::string_view name);
/// The heading that a parameter is listed under: its group, else the first pass that has it.
std::string heading_of(const Look& look, const Parameter& parameter);
std::vector<std::string> parameter_names(const Look& look);
std::vector<std::string> pass_names(const Look& look);

/// What the texels of a pass hold.
Encoding encoding_of(const Look& look, int pass);

/// The value in force: the one that was set, else the default.
const Value& value_of(const Parameter& parameter, const Values& values);

/// The number, or what its parameter is set to; 0 when there is no such parameter.
double count_of(const Count& count, const Look& look, const Values& values);

/// What a look is to be made with, of each parameter that is a constant.
Values constants_of(const Look& look, const Values& values);

/// Drops what equals its default; keeps names that the look does not know (orphans).
Values changed_values(const Look& look, const Values& values);

/// Names that are values' but not the look's.
std::vector<std::string> orphans(const Look& look, const Values& values);

/// Values under their former names (`@was`) moved to the new ones.
Values renamed_values(const Look& look, Values values);

/// Three letters for each parameter over its name and default, sorted: tells which of them are
/// still there.
std::string look_digest(const Look& look);

/// Whether all parameters that a digest was made of are there with the same defaults. Others may
/// have come. Of a digest of eight hexadecimal digits, as older programs wrote it, up to two are
/// found to have come.
bool covers_digest(const Look& look, std::string_view digest);
