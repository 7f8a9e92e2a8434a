#include "formats/isf/controls.h"

#include "base/text.h"
#include "model/look/color.h"

#include <algorithm>

namespace {
double number_at(const std::vector<double>& numbers, std::size_t index, double fallback) {
    return index < numbers.size() ? numbers[index] : fallback;
}

// "blurAmount" becomes "Blur amount".
std::string isf_label(const IsfInput& input) {
    if (!input.label.empty())
        return input.label;
    std::string text;
    for (const char letter : input.name) {
        const bool is_capital = letter >= 'A' && letter <= 'Z';
        const bool begins_word =
            is_capital && !text.empty() && text.back() >= 'a' && text.back() <= 'z';
        text += begins_word ? "_" + to_lower(std::string_view(&letter, 1)) : std::string(1, letter);
    }
    return label_from_name(text);
}

bool has_range(const IsfInput& input, std::size_t component) {
    return component < input.low.size() && component < input.high.size();
}

/// The range of one component.
Range range_at(const IsfInput& input, std::size_t index) {
    const bool is_whole = has_range(input, index);
    const double low = is_whole ? input.low[index] : 0.0;
    const double high = is_whole ? input.high[index] : 1.0;
    return {std::min(low, high), std::max(low, high)};
}

void set_number(const IsfInput& input, Parameter& made) {
    made.range = range_at(input, 0);
    const double middle = 0.5 * (made.range.low + made.range.high);
    const double initial = number_at(input.initial, 0, middle);
    made.initial = Value(std::clamp(initial, made.range.low, made.range.high));
}

// Labels without values have the values 0, 1, 2 and so on.
std::vector<double> list_values(const IsfInput& input) {
    std::vector<double> values = input.values;
    if (values.empty())
        for (std::size_t i = 0; i < input.labels.size(); ++i)
            values.push_back(static_cast<double>(i));
    return values;
}

void set_integer(const IsfInput& input, Parameter& made) {
    made.type.scalar = Scalar::integer;
    set_number(input, made);
    made.range.step = 1.0;
    made.initial = Value(std::trunc(made.initial.number()));
    const std::vector<double> values = list_values(input);
    if (values.empty())
        return;
    made.control = Control::list;
    for (std::size_t i = 0; i < values.size(); ++i)
        made.items.push_back(
            {values[i], i < input.labels.size() ? input.labels[i] : format_number(values[i])});
    const double initial = number_at(input.initial, 0, values.front());
    const bool is_there = std::ranges::find(values, initial) != values.end();
    made.initial = Value(is_there ? initial : values.front());
    made.range = {std::ranges::min(values), std::ranges::max(values), 1.0};
}

void set_switch(const IsfInput& input, Parameter& made) {
    made.type.scalar = Scalar::boolean;
    const bool is_event = input.type == IsfInput::Type::event;
    made.control = is_event ? Control::event : Control::slider;
    made.initial = Value(number_at(input.initial, 0, is_event ? 0.0 : 1.0) != 0.0 ? 1.0 : 0.0);
}

/// For a point without a range: wide enough to contain a default in pixels.
Range point_range_at(const IsfInput& input, std::size_t component) {
    Range range = range_at(input, component);
    const double initial = number_at(input.initial, component, 0.5);
    if (!has_range(input, component) && (initial < range.low || initial > range.high)) {
        range.low = std::min(range.low, 2.0 * initial);
        range.high = std::max(range.high, 2.0 * initial);
    }
    return range;
}

void set_point(const IsfInput& input, Parameter& made) {
    made.type.rows = 2;
    made.control = Control::point;
    std::vector<double> initial;
    for (std::size_t i = 0; i < 2; ++i) {
        const Range range = point_range_at(input, i);
        initial.push_back(number_at(input.initial, i, 0.5 * (range.low + range.high)));
        made.axes.push_back(range);
        made.range.low = i == 0 ? range.low : std::min(made.range.low, range.low);
        made.range.high = i == 0 ? range.high : std::max(made.range.high, range.high);
    }
    if (made.axes[0] == made.axes[1])
        made.axes.clear();
    made.initial = Value(std::move(initial));
}

void set_color(const IsfInput& input, Parameter& made) {
    made.type.rows = 4;
    made.control = Control::color;
    made.encoding = Encoding::display;
    std::vector<double> initial;
    for (std::size_t i = 0; i < 4; ++i) {
        const double component = number_at(input.initial, i, 1.0);
        initial.push_back(i < 3 ? srgb_decode(component) : component);
    }
    made.initial = Value(std::move(initial));
}
}  // namespace

Parameter isf_control(const IsfInput& input) {
    using Type = IsfInput::Type;
    Parameter made;
    made.name = input.name;
    made.label = isf_label(input);
    made.group = "Inputs";
    made.declared = input.declared;
    switch (input.type) {
        case Type::floating:
            set_number(input, made);
            break;
        case Type::integer:
            set_integer(input, made);
            break;
        case Type::boolean:
        case Type::event:
            set_switch(input, made);
            break;
        case Type::point:
            set_point(input, made);
            break;
        case Type::color:
            set_color(input, made);
            break;
        case Type::image:
        case Type::audio:
        case Type::audio_fft:
        case Type::cube:
            made.control = Control::image;
            made.initial = Value::of_path("");
            break;
    }
    const bool has_identity = static_cast<int>(input.identity.size()) == made.type.size();
    if (has_identity && made.control != Control::color)
        made.identity = Value(input.identity);
    return made;
}
