#pragma once

#include "base/shared.h"
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

/// One side of a target's size: `factor` times its reference.
struct Side {
    enum class By { viewport, source, before, pixels, expression };
    // before: the target of the previous pass; for the first pass the source

    By by = By::viewport;
    double factor = 1.0;     // for pixels: the size itself
    std::string expression;  // of WIDTH, HEIGHT and parameters, each with the prefix '$'

    bool operator==(const Side&) const = default;
};

/// GLSL for glslang and the driver, with the origin of each line.
struct Stage {
    std::filesystem::path file;  // "": the program's own text
    SharedText text;
    LineMap lines;

    bool operator==(const Stage&) const = default;
};

/// An integer, or the name of the parameter that has it.
using Count = std::variant<int, std::string>;

// quad: four corners, `position` at location 0 and texture coordinates at 1, both 0 to 1.
enum class Draw { fullscreen, quad, points, segments };
/// Whether it draws the beam of a signal.
bool is_of_beam(Draw draw);
enum class Blend { replace, add, alpha, multiply, maximum };

/// A pass that reads another one and adds its own output to it. While the expression allows it and
/// neither pass is displayed, the plan may draw it directly onto that pass's target.
struct Onto {
    std::string pass;
    std::string where;  // expression: allowed if above 0

    bool operator==(const Onto&) const = default;
};

/// A number that the look measures: the first texel's red in the target of its pass.
struct Readout {
    std::string label;
    std::string unit;

    bool operator==(const Readout&) const = default;
};

/// One draw: a vertex and a fragment shader, inputs, one target.
struct Pass {
    std::string name;
    Draw draw = Draw::fullscreen;
    Stage vertex;
    Stage fragment;
    Format format = Format::rgba16f;
    std::string one_channel = {};  // expression: above 0 only red is stored
    std::string half_floats = {};  // expression: above 0 floats have 16 bits, not 32
    std::array<Side, 2> size;      // width, height
    std::optional<Onto> onto = std::nullopt;
    // For segments: expressions of the smallest spot, see BeamSpot; empty: half a texel.
    std::array<std::string, 2> spot = {};
    Blend blend = Blend::replace;
    std::vector<Input> inputs;
    Values set;  // uniforms with constant values
    std::vector<BuiltInUniform> built_ins = own_built_ins();
    std::map<std::string, std::string> rename;  // uniform -> parameter
    bool accumulate = false;  // continues until anything changes; counted in u_samples
    Count repeat = 1;         // draws per frame
    std::optional<Count> converge = std::nullopt;  // samples at which accumulation stops
    int frame_modulo = 0;                          // u_frame counts modulo this; 0: never
    bool per_source_frame = false;                 // drawn only in the first sub-frame
    std::optional<Readout> readout = std::nullopt;
    RowOrder rows = RowOrder::bottom_first;  // of its target
    Location declared;                       // in look.json
    // For a pass in a stack:
    std::string scope;   // prefix of its look's parameter names: "crt/"
    std::string source;  // the pass that its look reads as the source; "": the source
    Encoding output = Encoding::linear;  // of its output, unless it is the last pass
    bool has_alpha = false;              // its alpha is transparency, unassociated
    bool keeps_when_resized = false;     // its history is stretched to a new size

    bool operator==(const Pass&) const = default;
};

/// A picture of a look, such as a LUT.
struct Image {
    std::string name;
    std::filesystem::path file;
    Sampler sampler;
    bool is_linear = false;                  // data, not display-encoded colours
    std::optional<Encoding> encoding = {};   // expected by its look; nullopt: as the source
    RowOrder rows = RowOrder::bottom_first;  // for the upload
    Format format = Format::rgba32f;         // for the upload
    bool is_needed = true;  // false: reads black on an error, instead of failing the look
    PictureShape shape = PictureShape::flat;  // expected by its samplers; files are converted
    // A generated picture instead of `file`: "pattern:noise" or "solid:sky". If both are empty, a
    // parameter of the same name selects the picture.
    std::string made = {};
    // The six files of a cube, in GL's order of faces; `file` is the first.
    std::vector<std::filesystem::path> faces = {};

    bool operator==(const Image&) const = default;
};

/// A heading in the list of parameters.
struct Heading {
    std::string name;
    Location declared;

    bool operator==(const Heading&) const = default;
};

/// How the light of earlier frames fades: expressions of parameters, see plan/lead_in.h.
struct Fading {
    std::string time_constant;  // s, of the slowest part
    std::string peak;           // the most that it adds to a picture, in linear light; 1: white
    Location declared;

    bool operator==(const Fading&) const = default;
};

enum class Driver { signal, picture, nothing };

constexpr int max_settle_frames = 100000;

/// Passes in order, their inputs, images and parameters: a value with everything that drawing
/// needs.
struct Look {
    std::string id;  // the folder name: "phosphor"
    std::string name;
    std::string about;
    std::string author;
    std::string license;
    Driver driven_by = Driver::nothing;
    bool has_other_driver = false;  // a signal or a picture can drive it, see StackPart
    std::vector<std::string> other_parameters = {};  // only with the other driver
    std::optional<Spec> default_signal;
    std::string default_source;
    Encoding source_encoding = Encoding::linear;
    RowOrder source_rows = RowOrder::bottom_first;
    Format source_format = Format::rgba32f;
    Encoding output = Encoding::display;
    bool is_scrgb_in_hdr = false;  // with HDR, the last pass writes light in units of 80 cd/m2
    int settle_frames = 1;
    std::optional<Fading> fading = std::nullopt;  // nullopt: not known, or nothing to fade
    Count subframes = 1;                          // frames per source picture, see subframes_of()
    bool has_orbit = false;
    std::vector<Pass> passes;
    std::vector<Image> images;
    std::vector<Heading> groups;        // the first headings, in order
    std::vector<Parameter> parameters;  // by `groups`, then in order of declaration
    Values constants;                   // values of constant parameters that it was built with
    std::filesystem::path manifest;     // look.json, or the foreign file
    IncludeFolders includes;            // available to all looks
    std::vector<std::filesystem::path> files;  // all files that were read, for the watcher
    Stack stack;                               // the looks that it consists of
    ShaderLimits shader_limits = {};           // that its shaders were checked against

    bool operator==(const Look&) const = default;
};

/// Whether a pass reads the press of the mouse button; whether a pass reads the keyboard.
bool reads_press(const Look& look);
bool reads_keys(const Look& look);

/// The index of the pass in Look::passes.
std::optional<int> find_pass(const Look& look, std::string_view name);
const Parameter* find_parameter(const Look& look, std::string_view name);
/// The heading of a parameter in lists: its group, otherwise its first pass.
std::string heading_of(const Look& look, const Parameter& parameter);
std::vector<std::string> parameter_names(const Look& look);
std::vector<std::string> pass_names(const Look& look);

/// The encoding of a pass's texels.
Encoding encoding_of(const Look& look, int pass);

/// The current value: the set value, otherwise the default.
const Value& value_of(const Parameter& parameter, const Values& values);

/// The number, or the value of its parameter; 0 if the parameter does not exist.
double count_of(const Count& count, const Look& look, const Values& values);

/// The values of all constant parameters, to build a look with.
Values constants_of(const Look& look, const Values& values);

/// Removes values equal to their defaults; keeps names that are not in the look (orphans).
Values changed_values(const Look& look, const Values& values);

/// Names in `values` that are not parameters of the look with any driver.
std::vector<std::string> orphans(const Look& look, const Values& values);

/// Moves values from previous names (`@was`) to current names.
Values renamed_values(const Look& look, Values values);

/// Three letters per parameter from its name and default, sorted. Shows which parameters still
/// exist unchanged.
std::string look_digest(const Look& look);

/// Whether all parameters of a digest exist with the same defaults. Additional parameters are
/// allowed. For the eight hexadecimal digits of earlier versions, at most two additional ones.
bool covers_digest(const Look& look, std::string_view digest);
