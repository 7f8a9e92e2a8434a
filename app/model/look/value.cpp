#include "model/look/value.h"

#include "base/text.h"

Value Value::of_path(std::string path) {
    Value value;
    value.path = std::move(path);
    return value;
}

std::string to_string(const Value& value) {
    if (value.numbers.empty())
        return value.path;
    std::string text;
    for (const double number : value.numbers) {
        if (!text.empty())
            text += ',';
        text += format_number(number);
    }
    return text;
}
