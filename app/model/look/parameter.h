#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"
#include "model/look/value.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

enum class Scalar { floating, integer, natural, boolean };

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

/// How a person turns a parameter.
enum class Control { slider, list, color, point, angle, event, image, sound };

enum class Scale { linear, logarithmic };

/// The soft ends of a slider; a typed value may go beyond them.
struct Range {
    double low = 0.0;
    double high = 1.0;
    double step = 0.0;  // 0: any value

    bool operator==(const Range&) const = default;
};

/// Ends that no value may pass.
struct Limit {
    double low = 0.0;
    double high = 1.0;

    bool operator==(const Limit&) const = default;
};

/// One choice of a list.
struct Item {
    double value = 0.0;
    std::string label;
    std::string was = {};  // a former label, which is still read; "" when there is none

    bool operator==(const Item&) const = default;
};

/// What a parameter is of a look's orbit; see model/look/orbit.h.
enum class OrbitPart { none, turn, azimuth, elevation, distance };

/// A uniform of a pass that a parameter drives.
struct Binding {
    int pass = 0;  // index into Look::passes
    std::string uniform;

    bool operator==(const Binding&) const = default;
};

/// One knob of a look: what the shaders declare about it. Its value is kept apart, in Values.
struct Parameter {
    std::string name;   // unique within its look
    std::string label;  // what a panel shows
    std::string unit;
    std::string period;  // an expression: px of what repeats on pixels; 0: nothing does
    std::string group;   // "": under the name of its first pass
    std::string help;
    NumberType type;
    Control control = Control::slider;
    Value initial;  // the default
    Range range;
    std::vector<Range> axes;  // of a point whose axes have ranges of their own, within `range`
    std::optional<Limit> limit;
    Scale scale = Scale::linear;
    std::vector<Item> items;
    std::vector<std::string> parts;  // what a vector's components are called; empty: x, y, z, w
    std::optional<Value> identity;   // the value that does nothing
    std::string was;                 // a former name, "" when there is none
    bool is_hidden = false;
    bool is_constant = false;              // no uniform: with another value the look is made anew
    Encoding encoding = Encoding::linear;  // of a colour, as shaders read it; its value is linear
    OrbitPart orbit = OrbitPart::none;     // its number becomes a part of a matrix
    std::vector<Binding> bindings;
    Location declared;

    bool operator==(const Parameter&) const = default;
};

/// "float", "vec3", "color", "point", "list", "event", "image", "sound": the type as `describe`
/// says it.
std::string type_name(const Parameter& parameter);

/// The ends of one component.
const Range& range_of(const Parameter& parameter, std::size_t component);

/// What a component of a vector is called: "Red", or "x".
std::string part_label(const Parameter& parameter, std::size_t component);

/// The nearest value that the parameter allows: within its limit, of its size, whole where it
/// counts.
Value clamped(const Parameter& parameter, Value value);

/// Why so many numbers are refused.
std::string wrong_count(std::string_view name, std::size_t expected, std::size_t given);

/// Reads what a person typed or gave to `--set`: numbers between commas, an item's label,
/// true/false, #rrggbb for a colour (taken as display-encoded sRGB, kept linear), or a path. Errors
/// name the parameter, not a file.
Result<Value> parse_value(const Parameter& parameter, std::string_view text);
