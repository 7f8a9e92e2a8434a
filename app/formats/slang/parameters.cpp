#include "formats/slang/parameters.h"

#include "base/text.h"
#include "formats/slang/slang_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace {
// The numbers at the start of `text`, at most four.
std::vector<double> leading_numbers(std::string_view text) {
    std::vector<double> numbers;
    while (numbers.size() < 4) {
        text = trim(text);
        const auto number = leading_number(text);
        if (!number)
            break;
        numbers.push_back(*number);
        text = text.substr(std::min(text.find_first_of(" \t"), text.size()));
    }
    return numbers;
}

// Compares as 32-bit floats, as used by shaders.
bool are_same_numbers(const SlangParameter& a, const SlangParameter& b) {
    const auto is_same = [](double x, double y) {
        return static_cast<float>(x) == static_cast<float>(y);
    };
    return is_same(a.initial, b.initial) && is_same(a.minimum, b.minimum) &&
           is_same(a.maximum, b.maximum) && is_same(a.step, b.step);
}

std::string numbers_of(const SlangParameter& parameter) {
    return fmt::format("{} {} {} {}", parameter.initial, parameter.minimum, parameter.maximum,
                       parameter.step);
}
}  // namespace

Result<SlangParameter> parse_slang_parameter(std::string_view text, const Location& declared) {
    const std::size_t open = text.find('"');
    const std::size_t close = open == std::string_view::npos ? open : text.find('"', open + 1);
    const std::string_view id = trim(text.substr(0, std::min(open, text.size())));
    if (close == std::string_view::npos || id.empty() || id.find_first_of(" \t") != id.npos)
        return fail({declared.file, declared.line,
                     "expected #pragma parameter NAME \"Label\" initial minimum maximum step"});
    const std::vector<double> numbers = leading_numbers(text.substr(close + 1));
    if (numbers.size() < 3)
        return fail({declared.file, declared.line,
                     fmt::format("parameter '{}' needs three numbers after its label: initial, "
                                 "minimum and maximum",
                                 readable_text(id))});
    SlangParameter parameter;
    parameter.id = readable_text(id);
    parameter.text = readable_text(text.substr(open + 1, close - open - 1));
    parameter.initial = numbers[0];
    parameter.minimum = numbers[1];
    parameter.maximum = numbers[2];
    parameter.step = numbers.size() > 3 ? numbers[3] : (numbers[2] - numbers[1]) / 10.0;
    parameter.declared = declared;
    return parameter;
}

SlangParameters unique_slang_parameters(const SlangParameters& declared, Diagnostics& warnings) {
    SlangParameters unique;
    std::unordered_map<std::string_view, std::size_t> indices;
    indices.reserve(declared.size());
    for (const auto& parameter : declared) {
        const auto found = indices.find(parameter->id);
        if (found == indices.end()) {
            indices.emplace(parameter->id, unique.size());
            unique.push_back(parameter);
            continue;
        }
        const SlangParameter& first = *unique[found->second];
        if (are_same_numbers(first, *parameter))
            continue;
        add_new(warnings,
                {parameter->declared.file, parameter->declared.line,
                 fmt::format("parameter '{}' has the numbers {} here but {} at {}:{}; the first "
                             "declaration is used",
                             parameter->id, numbers_of(*parameter), numbers_of(first),
                             first.declared.file.string(), first.declared.line),
                 Severity::warning});
    }
    return unique;
}
