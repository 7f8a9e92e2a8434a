#pragma once

#include <map>
#include <string>
#include <vector>

/// The value of a parameter: its components in GLSL's order, or the path of a picture or sound.
struct Value {
    std::vector<double> numbers;  // one per component; bool as 0 or 1; matrices by column
    std::string path;

    Value() = default;
    Value(double number) : numbers{number} {}
    Value(std::vector<double> components) : numbers(std::move(components)) {}
    static Value of_path(std::string path);

    bool operator==(const Value&) const = default;
    /// The only or first component; 0 without components.
    double number() const { return numbers.empty() ? 0.0 : numbers.front(); }
};

/// Values by parameter name (in a stack by full key, "crt/exposure").
using Values = std::map<std::string, Value>;

/// The text for `--set name=`: "0.92", "0.2,1,0.3" or the path.
std::string to_string(const Value& value);
