#include "lab/small_lab.h"
#include "ui/frame/edits.h"

TEST_CASE("an edit gets the parts that it takes, and edits are applied in their order") {
    SmallLab small;
    WindowState window;
    Edits edits;
    CHECK_FALSE(edits.has_verbs());
    edits.change([](Player& player) { player.pause(); });
    edits.change(
        [](const Document& document, Messages& messages) { messages.say(document.look().name); });
    edits.add(std::function<void(Lab&)>(
        [](Lab& lab) { lab.messages().say(lab.messages().notice()->text + "!"); }));
    edits.add(
        std::function<void(WindowState&)>([](WindowState& state) { state.recent.files = {"a"}; }));
    CHECK(edits.has_verbs());
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
