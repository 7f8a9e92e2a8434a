#include "lab/remote/osc_parameters.h"

#include "lab/document/naming.h"

#include <fmt/format.h>

Result<const Parameter*> addressed_parameter(std::string_view address, const Look& look) {
    constexpr std::string_view folder = "parameter/";
    auto parameter = resolve_parameter(std::string(address), look);
    if (!parameter && address.starts_with(folder))
        parameter = resolve_parameter(std::string(address.substr(folder.size())), look);
    return parameter;
}

Result<Value> value_from_message(const OscMessage& message, const Parameter& parameter) {
    const auto& arguments = message.arguments;
    if (arguments.empty() && parameter.control == Control::event)
        return Value(1.0);
    if (arguments.size() == 1 && std::holds_alternative<std::string>(arguments.front()))
        return parse_value(parameter, std::get<std::string>(arguments.front()));
    std::vector<double> numbers;
    for (const OscMessage::Argument& argument : arguments)
        if (const auto* number = std::get_if<double>(&argument))
            numbers.push_back(*number);
    const bool is_file = parameter.control == Control::image || parameter.control == Control::sound;
    const auto size = static_cast<std::size_t>(parameter.type.size());
    if (is_file || numbers.size() != arguments.size() || numbers.size() != size)
        return fail({{},
                     0,
                     is_file ? fmt::format("'{}' must be a text", message.address)
                             : wrong_count(message.address, size, arguments.size())});
    return clamped(parameter, Value(std::move(numbers)));
}

Result<RemoteChange> change_of(const OscMessage& message, const Look& look) {
    if (!message.address.starts_with(osc_prefix))
        return fail({{}, 0, fmt::format("expected /afterglow/NAME, got '{}'", message.address)});
    const auto parameter =
        addressed_parameter(std::string_view(message.address).substr(osc_prefix.size()), look);
    if (!parameter)
        return fail(parameter.error());
    auto value = value_from_message(message, **parameter);
    if (!value)
        return fail(value.error());
    return RemoteChange{(*parameter)->name, std::move(*value)};
}

std::vector<OscMessage::Argument> arguments_of(const Value& value) {
    if (!value.path.empty())
        return {std::filesystem::path(value.path).filename().string()};
    return {value.numbers.begin(), value.numbers.end()};
}
