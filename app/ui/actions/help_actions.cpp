#include "ui/actions/help_actions.h"

#include "gpu/input_event.h"
#include "ui/frame/edits.h"

std::vector<Action> help_actions::list() {
    const auto keys = [](const Scene&, Edits& edits) { edits.show({.kind = Dialog::Kind::keys}); };
    const auto about = [](const Scene&, Edits& edits) {
        edits.show({.kind = Dialog::Kind::about});
    };
    const auto palette = [](const Scene&, Edits& edits) {
        edits.show({.kind = Dialog::Kind::palette});
    };
    return {
        {ActionId::palette, Menu::help, "Find a command…", {'P', true}, false, palette},
        {ActionId::keys, Menu::help, "Keyboard shortcuts", {gpu::key::first_function}, false, keys},
        {ActionId::about,
         Menu::help,
         "About Afterglow",
         {gpu::key::first_function, false, true},
         false,
         about}};
}
