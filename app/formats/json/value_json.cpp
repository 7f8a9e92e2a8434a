#include "formats/json/value_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>

using Json = nlohmann::ordered_json;

namespace {
std::optional<double> number_of(const JsonValue& value) {
    if (value.is(JsonValue::Kind::boolean))
        return value.boolean ? 1.0 : 0.0;
    return value.is(JsonValue::Kind::number) ? std::optional(value.number) : std::nullopt;
}

// Empty unless the value is a list of 1 to 16 numbers.
std::vector<double> numbers_of(const JsonValue& value) {
    constexpr std::size_t maximum = 16;  // a mat4
    std::vector<double> numbers;
    if (!value.is(JsonValue::Kind::array) || value.children.size() > maximum)
        return {};
    for (const JsonValue& element : value.children) {
        const auto number = number_of(element);
        if (!number)
            return {};
        numbers.push_back(*number);
    }
    return numbers;
}
}  // namespace

std::optional<Value> read_value(const JsonValue& value, ObjectReader& reader) {
    if (value.is(JsonValue::Kind::text))
        return Value::of_path(value.text);
    if (const auto number = number_of(value))
        return Value(*number);
    std::vector<double> numbers = numbers_of(value);
    if (!numbers.empty())
        return Value(std::move(numbers));
    reader.problem(value, fmt::format("'{}' must be a number, a list of 1 to 16 numbers, true, "
                                      "false or a text in quotes, got {}",
                                      value.key, shown_json(value)));
    return std::nullopt;
}

namespace {
// The label of a list item, if it reads as the same value.
std::optional<std::string> label_of(const Value& value, const Parameter& parameter) {
    for (const Item& item : parameter.items)
        if (value.numbers.size() == 1 && item.value == value.number())
            if (const auto read = parse_value(parameter, item.label); read && *read == value)
                return item.label;
    return std::nullopt;
}
}  // namespace

Json json_of(const Value& value, const Parameter* parameter) {
    if (value.numbers.empty())
        return value.path;
    if (parameter)
        if (const auto label = label_of(value, *parameter))
            return *label;
    const bool is_switch = parameter && parameter->type.scalar == Scalar::boolean;
    Json list = Json::array();
    for (const double number : value.numbers)
        list.push_back(is_switch ? Json(number != 0.0) : Json(number));
    return list.size() == 1 ? list.front() : list;
}
