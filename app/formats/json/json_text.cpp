#include "formats/json/json_text.h"

#include "base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using Json = nlohmann::ordered_json;

namespace {
// JSON has no NaN or infinity: returns 0 or the largest finite number.
double finite(double number) {
    constexpr double largest = std::numeric_limits<double>::max();
    return std::isnan(number) ? 0.0 : std::clamp(number, -largest, largest);
}

std::string scalar_text(const Json& value) {
    if (value.is_number_float())
        return format_number(finite(value.get<double>()));
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_plain_list(const Json& value) {
    return value.is_array() && std::none_of(value.begin(), value.end(), [](const Json& element) {
               return element.is_structured();
           });
}

// The separators between the parts of a container.
enum class Style { indented, compact, on_one_line };

struct Layout {
    std::string first;
    std::string between;
    std::string last;
    std::string_view colon;
};

Layout layout_of(const Json& value, int depth, Style style) {
    if (style == Style::compact || value.empty())
        return {"", ",", "", ":"};
    if (is_plain_list(value))
        return {"", ", ", "", ": "};
    if (style == Style::on_one_line)
        return {" ", ", ", " ", ": "};
    const std::string outer = '\n' + std::string(static_cast<std::size_t>(depth) * 2, ' ');
    return {outer + "  ", ',' + outer + "  ", outer, ": "};
}

void append(std::string& text, const Json& value, int depth, Style style) {
    if (!value.is_structured()) {
        text += scalar_text(value);
        return;
    }
    const Layout layout = layout_of(value, depth, style);
    text += value.is_object() ? '{' : '[';
    const std::string* separator = &layout.first;
    for (auto part = value.begin(); part != value.end(); ++part) {
        text += *separator;
        separator = &layout.between;
        if (value.is_object())
            text.append(scalar_text(Json(part.key()))).append(layout.colon);
        append(text, *part, depth + 1, style);
    }
    text += layout.last;
    text += value.is_object() ? '}' : ']';
}
}  // namespace

std::string json_text(const Json& document) {
    return indented_json_text(document, 0) + '\n';
}

std::string indented_json_text(const Json& value, int depth) {
    std::string text;
    append(text, value, depth, Style::indented);
    return text;
}

std::string inline_json_text(const Json& value) {
    std::string text;
    append(text, value, 0, Style::on_one_line);
    return text;
}

Json with_float_digits(Json document) {
    if (document.is_structured()) {
        for (Json& part : document)
            part = with_float_digits(std::move(part));
        return document;
    }
    const double number = document.is_number_float() ? document.get<double>() : 0.0;
    const auto as_float = static_cast<float>(number);
    if (number == std::trunc(number) || !std::isfinite(as_float) || as_float == 0.0f)
        return document;
    return parse_number(format_float(as_float)).value_or(number);
}

std::string compact_json_text(const Json& document) {
    std::string text;
    append(text, document, 0, Style::compact);
    return text;
}
