// The command table against its page in the manual and the layout for Open Stage Control.
#include "lab/commands/remote_commands.h"

#include "base/file.h"
#include "base/text.h"
#include "lab/library/open.h"
#include "lab/remote/osc_parameters.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace fs = std::filesystem;

namespace {
const fs::path source = AFTERGLOW_SOURCE_DIR;

/// The rows "| `/afterglow/…` | arguments | effect |" of a page whose address is for commands.
std::vector<std::string> documented_rows() {
    std::vector<std::string> rows;
    const auto text = read_text(source / "docs/remote.md");
    REQUIRE(text.has_value());
    for (const std::string_view line : split_lines(*text))
        if (line.starts_with("| `/afterglow/command/") || line.starts_with("| `/afterglow/query/"))
            rows.emplace_back(line);
    return rows;
}

void add_addresses(const nlohmann::json& widget, std::set<std::string>& addresses) {
    if (widget.contains("address"))
        addresses.insert(widget.at("address").get<std::string>());
    for (const char* children : {"widgets", "tabs"})
        if (widget.contains(children))
            for (const nlohmann::json& child : widget.at(children))
                add_addresses(child, addresses);
}

bool is_in_table(std::string_view address) {
    for (const RemoteCommand& row : remote_commands())
        if (matched_name(row.address, address))
            return true;
    return false;
}
}  // namespace

TEST_CASE("the manual lists each remote command with its arguments and effect") {
    std::vector<std::string> expected;
    for (const RemoteCommand& row : remote_commands()) {
        const std::string arguments = row.arguments;
        expected.push_back(fmt::format("| `{}{}` | {} | {} |", osc_prefix, row.address,
                                       arguments.empty() ? "" : "`" + arguments + "`", row.help));
    }
    CHECK(documented_rows() == expected);
}

TEST_CASE("each address of the Open Stage Control layout is a command or a parameter of Phosphor") {
    const auto text = read_text(source / "docs/open-stage-control.json");
    REQUIRE(text.has_value());
    const auto session = nlohmann::json::parse(*text);
    CHECK(session.at("createdWith") == "Open Stage Control");
    CHECK(session.at("type") == "session");
    std::set<std::string> addresses;
    add_addresses(session.at("content"), addresses);
    CHECK(addresses.size() > 20);
    const Library library({source, source / "none", source / "none"});
    const auto request = resolve("phosphor", library);
    REQUIRE(request.has_value());
    const LoadedLook phosphor = load_requested(*request, library);
    REQUIRE(phosphor.look.has_value());
    for (const std::string& address : addresses) {
        CAPTURE(address);
        REQUIRE(address.starts_with(osc_prefix));
        const std::string tail = address.substr(osc_prefix.size());
        const bool is_parameter = addressed_parameter(tail, *phosphor.look).has_value();
        CHECK(is_in_table(tail) != is_parameter);
        constexpr std::string_view preset = "command/preset/";
        if (tail.starts_with(preset))
            CHECK(library.find_preset("phosphor", tail.substr(preset.size())));
    }
}
