#include "model/look/parameter.h"

#include "base/text.h"
#include "model/look/color.h"
#include "model/look/decay.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

std::string glsl_name(const NumberType& type) {
    constexpr const char* scalars[] = {"float", "int", "uint", "bool"};
    constexpr const char* vectors[] = {"vec", "ivec", "uvec", "bvec"};
    const auto scalar = static_cast<std::size_t>(type.scalar);
    if (type.size() == 1)
        return scalars[scalar];
    if (type.columns == 1)
        return vectors[scalar] + std::to_string(type.rows);
    if (type.columns == type.rows)
        return "mat" + std::to_string(type.rows);
    return fmt::format("mat{}x{}", type.columns, type.rows);
}

std::optional<NumberType> number_type_of(std::string_view glsl_name_of_type) {
    constexpr int most = 4;
    for (const Scalar scalar :
         {Scalar::floating, Scalar::integer, Scalar::unsigned_integer, Scalar::boolean})
        for (int rows = 1; rows <= most; ++rows)
            for (int columns = 1; columns <= (scalar == Scalar::floating && rows > 1 ? most : 1);
                 ++columns)
                if (const NumberType type{scalar, rows, columns};
                    glsl_name(type) == glsl_name_of_type)
                    return type;
    return std::nullopt;
}

std::string type_name(const Parameter& parameter) {
    switch (parameter.control) {
        case Control::list:
            return "list";
        case Control::color:
            return "color";
        case Control::point:
            return "point";
        case Control::event:
            return "event";
        case Control::image:
            return "image";
        case Control::sound:
            return "sound";
        case Control::slider:
        case Control::angle:
            break;
    }
    return glsl_name(parameter.type);
}

const Range& range_of(const Parameter& parameter, std::size_t component) {
    return component < parameter.axes.size() ? parameter.axes[component] : parameter.range;
}

std::string component_label(const Parameter& parameter, std::size_t component) {
    constexpr const char* axes[] = {"x", "y", "z", "w"};
    if (component < parameter.parts.size())
        return parameter.parts[component];
    return component < std::size(axes) ? axes[component] : std::to_string(component + 1);
}

std::optional<std::array<double, 3>> linear_from_hex(std::string_view text) {
    unsigned code = 0;
    const char* const end = text.data() + text.size();
    if (text.size() != 7 || text.front() != '#' ||
        std::from_chars(text.data() + 1, end, code, 16).ptr != end)
        return std::nullopt;
    const auto channel = [code](unsigned shift) {
        return srgb_decode(static_cast<double>((code >> shift) & 0xffu) / 255.0);
    };
    return std::array{channel(16), channel(8), channel(0)};
}

namespace {
double clamped_number(const Parameter& parameter, double number) {
    if (!std::isfinite(number))
        number = parameter.initial.number();
    if (parameter.limit)
        number = std::clamp(number, parameter.limit->low, parameter.limit->high);
    switch (parameter.type.scalar) {
        case Scalar::floating:
            return number;
        case Scalar::integer:
            return std::clamp(std::round(number), -2147483648.0, 2147483647.0);
        case Scalar::unsigned_integer:
            return std::clamp(std::round(number), 0.0, 4294967295.0);
        case Scalar::boolean:
            return number != 0.0 ? 1.0 : 0.0;
    }
    return number;
}

std::optional<Value> color_from_hex(std::string_view text, std::size_t components) {
    const auto light = linear_from_hex(text);
    if (!light)
        return std::nullopt;
    std::vector<double> numbers(light->begin(), light->end());
    numbers.resize(components, 1.0);
    return Value(std::move(numbers));
}

std::optional<double> number_from(const Parameter& parameter, std::string_view text) {
    for (const Item& item : parameter.items)
        if (to_lower(item.label) == to_lower(text))
            return item.value;
    for (const Item& item : parameter.items)
        if (!item.was.empty() && to_lower(item.was) == to_lower(text))
            return item.value;
    if (parameter.type.scalar == Scalar::boolean) {
        if (text == "true" || text == "on" || text == "yes")
            return 1.0;
        if (text == "false" || text == "off" || text == "no")
            return 0.0;
    }
    if (is_decay(parameter))
        if (const auto factor = parse_decay(text))
            return factor;
    return parse_number(text);
}

// Why a text is not a valid value.
std::string refusal_of(const Parameter& parameter, std::string_view text) {
    std::vector<std::string> labels;
    for (const Item& item : parameter.items)
        labels.push_back(fmt::format("'{}'", item.label));
    const std::string& name = parameter.name;
    if (!labels.empty())
        return fmt::format("'{}' must be one of {}, got '{}'", name, fmt::join(labels, ", "), text);
    const int size = parameter.type.size();
    if (parameter.control == Control::color)
        return fmt::format("'{}' must be #rrggbb or {} numbers, got '{}'", name, size, text);
    if (parameter.type.scalar == Scalar::boolean && size == 1)
        return fmt::format("'{}' must be true or false, got '{}'", name, text);
    return size == 1 ? fmt::format("'{}' must be a number, got '{}'", name, text)
                     : fmt::format("'{}' must be {} numbers, got '{}'", name, size, text);
}

bool is_item(const Parameter& parameter, double number) {
    return std::ranges::any_of(parameter.items,
                               [&](const Item& item) { return item.value == number; });
}

Result<double> parse_component(const Parameter& parameter, std::string_view text) {
    const auto number = number_from(parameter, text);
    if (!number || (!parameter.items.empty() && !is_item(parameter, *number)))
        return fail({{}, 0, refusal_of(parameter, text)});
    if (parameter.limit && (*number < parameter.limit->low || *number > parameter.limit->high))
        return fail({{},
                     0,
                     fmt::format("'{}' must be between {} and {}, got {}", parameter.name,
                                 format_number(parameter.limit->low),
                                 format_number(parameter.limit->high), format_number(*number))});
    return *number;
}
}  // namespace

std::string wrong_count(std::string_view name, std::size_t expected, std::size_t given) {
    return expected == 1 ? fmt::format("'{}' must be a single number, got {} numbers", name, given)
                         : fmt::format("'{}' must have {} numbers, got {}", name, expected, given);
}

Value clamped(const Parameter& parameter, Value value) {
    if (parameter.control == Control::image || parameter.control == Control::sound)
        return value;
    value.path.clear();
    const std::size_t given = value.numbers.size();
    value.numbers.resize(static_cast<std::size_t>(parameter.type.size()));
    for (std::size_t i = 0; i < value.numbers.size(); ++i) {
        if (i >= given)
            value.numbers[i] =
                i < parameter.initial.numbers.size() ? parameter.initial.numbers[i] : 0;
        value.numbers[i] = clamped_number(parameter, value.numbers[i]);
    }
    return value;
}

Value value_for_shaders(const Parameter& parameter, const Value& value) {
    Value usable = clamped(parameter, value);
    if (parameter.control == Control::color && parameter.encoding == Encoding::display)
        for (std::size_t i = 0; i < std::min<std::size_t>(usable.numbers.size(), 3); ++i)
            usable.numbers[i] = srgb_encode(usable.numbers[i]);
    return usable;
}

Result<Value> parse_value(const Parameter& parameter, std::string_view text) {
    text = trim(text);
    if (parameter.control == Control::image || parameter.control == Control::sound)
        return Value::of_path(std::string(text));
    const auto size = static_cast<std::size_t>(parameter.type.size());
    if (parameter.control == Control::color)
        if (auto color = color_from_hex(text, size))
            return *color;

    std::vector<double> numbers;
    for (const std::string_view piece : split(text, ',')) {
        const auto number = parse_component(parameter, trim(piece));
        if (!number)
            return fail(number.error());
        numbers.push_back(*number);
    }
    if (numbers.size() != size)
        return fail({{}, 0, wrong_count(parameter.name, size, numbers.size())});
    return clamped(parameter, Value(std::move(numbers)));
}
