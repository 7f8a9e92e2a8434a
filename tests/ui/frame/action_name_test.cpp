#include "ui/frame/action_name.h"

#include "base/file.h"
#include "base/text.h"
#include "ui/actions/action_table.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>

namespace {
const std::filesystem::path docs = std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "docs";

void check_actions(const nlohmann::json& widget, const ActionTable& actions, int& count) {
    constexpr std::string_view prefix = "/afterglow/command/action/";
    if (widget.contains("address"))
        if (const auto address = widget.at("address").get<std::string>();
            address.starts_with(prefix)) {
            CAPTURE(address);
            CHECK(find_action(address.substr(prefix.size()), actions));
            ++count;
        }
    for (const char* children : {"widgets", "tabs"})
        if (widget.contains(children))
            for (const nlohmann::json& child : widget.at(children))
                check_actions(child, actions, count);
}
}  // namespace

TEST_CASE("each action has its own name of lower case letters, digits and underscores") {
    const ActionTable table = make_action_table();
    std::set<std::string> names;
    for (const Action& action : table.rows()) {
        const std::string name = action_name(action);
        CAPTURE(name);
        CHECK_FALSE(name.empty());
        CHECK(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos);
        CHECK(names.insert(name).second);
        CHECK(find_action(name, table) == &action);
        CHECK(command_label(action_command(action), table) == action.label);
    }
    CHECK_FALSE(find_action("", table));
    CHECK(command_label("preset/amber-p3", table) == "preset/amber-p3");
    CHECK(find_action("panel_timings", table)->label == std::string("Timings"));
    CHECK(find_action("play_pause", table)->id == ActionId::play_pause);
}

TEST_CASE("the manual lists the names of all actions with their labels") {
    const auto text = read_text(docs / "remote.md");
    REQUIRE(text.has_value());
    const std::string_view page = *text;
    std::set<std::string> documented;
    for (const std::string_view line : split_lines(page.substr(page.find("\n## Actions\n"))))
        if (line.starts_with("| `"))
            documented.emplace(line);
    std::set<std::string> expected;
    for (const Action& action : make_action_table().rows())
        expected.insert(fmt::format("| `{}` | {} |", action_name(action), action.label));
    for (const std::string& row : expected) {
        CAPTURE(row);
        CHECK(documented.contains(row));
    }
    CHECK(documented.size() == expected.size());
}

TEST_CASE("the actions of the Open Stage Control layout exist") {
    const auto text = read_text(docs / "open-stage-control.json");
    REQUIRE(text.has_value());
    int count = 0;
    check_actions(nlohmann::json::parse(*text).at("content"), make_action_table(), count);
    CHECK(count > 2);
}
