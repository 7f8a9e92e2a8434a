#include "ui/actions/help_actions.h"

#include "gpu/input_event.h"
#include "lab/commands/help_page.h"
#include "lab/messages/messages.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

std::vector<Action> help_actions::list() {
    const auto keys = [](const Scene&, Edits& edits) { edits.show({.kind = Dialog::Kind::keys}); };
    const auto about = [](const Scene&, Edits& edits) {
        edits.show({.kind = Dialog::Kind::about});
    };
    const auto palette = [](const Scene&, Edits& edits) {
        edits.show({.kind = Dialog::Kind::palette});
    };
    const auto page = [](const char* file) {
        return [file](const Scene& scene, Edits& edits) {
            edits.change(
                [roots = scene.roots, file](ExternalPrograms& programs, Messages& messages) {
                    open_help_page(roots, file, programs, messages);
                });
        };
    };
    return {
        {ActionId::palette, Menu::help, "Find a command…", {'P', true}, false, palette},
        {ActionId::keys, Menu::help, "Keyboard shortcuts", {gpu::key::first_function}, false, keys},
        {ActionId::manual, Menu::help, "Manual", {}, true, page("manual.md")},
        {ActionId::writing_looks,
         Menu::help,
         "Writing a look",
         {},
         false,
         page("tutorials/shader-developer.md")},
        {ActionId::whats_new, Menu::help, "What's new", {}, false, page("whats-new.md")},
        {ActionId::about,
         Menu::help,
         "About Afterglow",
         {gpu::key::first_function, false, true},
         true,
         about}};
}
