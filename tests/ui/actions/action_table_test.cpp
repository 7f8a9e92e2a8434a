#include "ui/actions/action_table.h"

#include "ui/panels/panel_table.h"

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <string>

TEST_CASE("each action and each panel has exactly one row with a label and an effect") {
    const ActionTable table = make_action_table();
    std::map<ActionId, std::size_t> rows;
    for (const Action& action : table.rows()) {
        CAPTURE(action.label);
        CHECK(std::string(action.label) != "");
        CHECK(action.act);
        ++rows[action.id];
    }
    for (int id = 0; id < action_count; ++id) {
        CAPTURE(id);
        const bool is_of_panels = id == static_cast<int>(ActionId::show_panel);
        CHECK(rows[static_cast<ActionId>(id)] == (is_of_panels ? panels().size() : 1));
    }
    for (const Panel& panel : panels())
        CHECK(table.row(panel.id).panel == panel.id);
}

TEST_CASE("no two actions have the same shortcut or the same label") {
    const ActionTable table = make_action_table();
    std::set<std::string> shortcuts;
    std::set<std::string> labels;
    for (const Action& action : table.rows()) {
        CAPTURE(action.label);
        CHECK(labels.insert(action.label).second);
        if (action.chord.key != 0)
            CHECK(shortcuts.insert(chord_text(action.chord)).second);
    }
}

TEST_CASE("a tooltip has the label and the shortcut") {
    const ActionTable table = make_action_table();
    CHECK(table.help(ActionId::undo) == "Undo (Ctrl+Z)");
    CHECK(table.key(ActionId::undo) == "Ctrl+Z");
    CHECK(table.help(panel_id::timings) == "Timings (Ctrl+6)");
    CHECK(table.help(ActionId::about) == "About Afterglow (Shift+F1)");
}
