#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"
#include "model/look/value.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

enum class Scalar { floating, integer, unsigned_integer, boolean };

/// A GLSL number type: scalar, vector (rows > 1) or matrix (columns > 1).
struct NumberType {
    Scalar scalar = Scalar::floating;
    int rows = 1;
    int columns = 1;

    bool operator==(const NumberType&) const = default;
    int size() const { return rows * columns; }
};

/// "float", "ivec3", "mat4", "mat2x3".
std::string glsl_name(const NumberType& type);
/// The number type of such a name; nullopt for other types.
std::optional<NumberType> number_type_of(std::string_view glsl_name);

/// The type of control for a parameter.
enum class Control { slider, list, color, point, angle, event, image, sound };

/// The spacing of values on a slider. `half_life` is for a factor per 1/60 s: equal ratios of the
/// half-life, see decay.h.
enum class Scale { linear, logarithmic, half_life };

/// The range of a slider; typed values may exceed it.
struct Range {
    double low = 0.0;
    double high = 1.0;
    double step = 0.0;  // 0: any value

    bool operator==(const Range&) const = default;
};

/// Limits that no value may exceed.
struct Limit {
    double low = 0.0;
    double high = 1.0;

    bool operator==(const Limit&) const = default;
};

/// An item of a list.
struct Item {
    double value = 0.0;
    std::string label;
    std::string was = {};   // previous label, still accepted; "" without one
    std::string note = {};  // shown after the label in the list
    std::optional<std::array<double, 3>> color = {};  // of a swatch before it, linear light

    bool operator==(const Item&) const = default;
};

/// The part of a look's orbit that a parameter sets; see model/look/orbit.h.
enum class OrbitPart { none, turn, azimuth, elevation, distance };

/// How a photo of a tube shows a parameter, see `afterglow match`. shape: in the mean light of
/// places. pitch, lines: as a period across or down. type: one of a list. amount: in the contrast
/// of details. start: not at all, but a tube has another value than the look's default. off: not at
/// all, and its identity is drawn instead. tube and decay show only in a video of fading light: one
/// of a list, and a number.
enum class PhotoRole { none, shape, pitch, lines, type, amount, start, off, tube, decay };

/// A uniform of a pass that a parameter sets.
struct Binding {
    int pass = 0;  // index into Look::passes
    std::string uniform;

    bool operator==(const Binding&) const = default;
};

/// A parameter of a look, as its shaders declare it. Its value is stored separately, in Values.
struct Parameter {
    std::string name;   // unique within its look
    std::string label;  // shown in the panel
    std::string unit;
    std::string period;  // expression: px of a pattern that repeats on the pixel grid; 0: no
                         // pattern
    std::string when;    // condition for an effect, see model/plan/condition.h; "": always
    std::string group;   // "": listed under the name of its first pass
    std::string help;
    NumberType type;
    Control control = Control::slider;
    Value initial;  // the default
    Range range;
    std::vector<Range> axes;  // of a point with a range per axis, within `range`
    std::optional<Limit> limit;
    Scale scale = Scale::linear;
    std::vector<Item> items;
    std::vector<std::string> parts;  // labels of a vector's components; empty: x, y, z, w
    std::optional<Value> identity;   // the value without an effect
    std::string was;                 // previous name; "" without one
    bool is_hidden = false;
    bool is_fixed_in_random = false;       // Randomise keeps its value
    bool is_constant = false;              // not a uniform: a new value rebuilds the look
    Encoding encoding = Encoding::linear;  // of a colour in shaders; its value is linear
    OrbitPart orbit = OrbitPart::none;     // not none: its value becomes part of a matrix
    PhotoRole photo_role = PhotoRole::none;
    std::optional<Value> photo_start;  // with PhotoRole::start
    std::vector<Binding> bindings;
    Location declared;

    bool operator==(const Parameter&) const = default;
};

/// The type for `describe`: "float", "vec3", "color", "point", "list", "event", "image", "sound".
std::string type_name(const Parameter& parameter);

/// The range of one component.
const Range& range_of(const Parameter& parameter, std::size_t component);

/// The label of a vector's component: "Red", or "x".
std::string component_label(const Parameter& parameter, std::size_t component);

/// The nearest valid value: within the limit, with the number of components, rounded for integers.
Value clamped(const Parameter& parameter, Value value);

/// A value for shaders: clamped to its limits. The colour of a parameter with display encoding is
/// sRGB-encoded.
Value value_for_shaders(const Parameter& parameter, const Value& value);

/// The linear light of a display-encoded sRGB colour "#rrggbb". nullopt for other text.
std::optional<std::array<double, 3>> linear_from_hex(std::string_view text);

/// The error for a wrong number of components.
std::string wrong_count(std::string_view name, std::size_t expected, std::size_t given);

/// Parses a typed value or one of `--set`: comma-separated numbers, an item's label, true/false, a
/// path, or #rrggbb. A hexadecimal colour is display-encoded sRGB and becomes linear. Errors name
/// the parameter, not a file.
Result<Value> parse_value(const Parameter& parameter, std::string_view text);
