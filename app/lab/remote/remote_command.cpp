#include "lab/remote/remote_command.h"

#include "base/text.h"
#include "lab/remote/osc_parameters.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr std::string_view name_mark = "NAME";

// The most similar address of the table, without name_marks.
std::string similar_address(std::string_view address, std::span<const RemoteCommand> table) {
    std::vector<std::string> known;
    for (const RemoteCommand& row : table)
        if (std::string_view(row.address).find(name_mark) == std::string_view::npos)
            known.emplace_back(row.address);
    return did_you_mean(address, known);
}
}  // namespace

std::optional<std::string> matched_name(std::string_view row_address, std::string_view address) {
    const std::size_t open = row_address.find(name_mark);
    if (open == std::string_view::npos)
        return row_address == address ? std::optional(std::string()) : std::nullopt;
    const std::string_view before = row_address.substr(0, open);
    const std::string_view after = row_address.substr(open + name_mark.size());
    if (address.size() <= before.size() + after.size() || !address.starts_with(before) ||
        !address.ends_with(after))
        return std::nullopt;
    return std::string(
        address.substr(before.size(), address.size() - before.size() - after.size()));
}

bool is_command_address(std::string_view address) {
    return address.starts_with("command/") || address.starts_with("query/");
}

Result<OscMessages> run_command(const OscMessage& message, std::span<const RemoteCommand> table,
                                const MutableParts& parts) {
    const std::string_view address = std::string_view(message.address).substr(osc_prefix.size());
    for (const RemoteCommand& row : table)
        if (auto name = matched_name(row.address, address))
            return row.run({message.address, std::move(*name), message.arguments, parts});
    return fail(
        {{}, 0, fmt::format("unknown command '{}'{}", address, similar_address(address, table))});
}

Result<bool> press_of(const OscArguments& arguments) {
    if (arguments.empty())
        return true;
    if (arguments.size() > 1)
        return fail({{}, 0, "expected no argument, 1 or 0"});
    if (const auto* text = std::get_if<std::string>(&arguments.front()); text) {
        const std::string word = to_lower(*text);
        if (word == "true" || word == "on")
            return true;
        if (word == "false" || word == "off")
            return false;
    }
    const auto number = number_at(arguments, 0, "1 or 0");
    if (!number)
        return fail(number.error());
    return *number > 0.0;
}

Result<double> number_at(const OscArguments& arguments, std::size_t index, std::string_view what) {
    const std::optional<double> number =
        index >= arguments.size() ? std::nullopt
        : std::holds_alternative<double>(arguments[index])
            ? std::optional(std::get<double>(arguments[index]))
            : parse_number(std::get<std::string>(arguments[index]));
    if (!number)
        return fail({{}, 0, fmt::format("expected {}", what)});
    return *number;
}
