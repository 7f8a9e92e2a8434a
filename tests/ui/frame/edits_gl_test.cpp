#include "lab/small_lab.h"
#include "ui/frame/edits.h"

TEST_CASE("an edit gets the parts that it takes, and edits are applied in their order") {
    SmallLab small;
    WindowState window;
    Edits edits;
    edits.change([](WindowState& state) { state.recent.files = {"a"}; });
    CHECK_FALSE(edits.change_lab());
    edits.change([](Player& player) { player.pause(); });
    edits.change(
        [](const Document& document, Messages& messages) { messages.say(document.look().name); });
    edits.change([](Messages& messages) { messages.say(messages.notice()->text + "!"); });
    CHECK(edits.change_lab());
    CHECK(small.player().transport().is_playing());
    edits.apply(small.lab(), window);
    CHECK_FALSE(small.player().transport().is_playing());
    CHECK(small.lab().messages().notice()->text == "Small!");
    CHECK(window.recent.files.size() == 1);
}

TEST_CASE("an edit of a document does nothing while no look is open") {
    SmallLab small;
    small.start();
    WindowState window;
    Edits edits;
    edits.change([](Document&, Messages& messages) { messages.say("an open look"); });
    edits.apply(small.lab(), window);
    CHECK_FALSE(small.lab().messages().notice().has_value());
}
