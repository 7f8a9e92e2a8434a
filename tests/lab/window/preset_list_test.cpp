#include "lab/window/preset_list.h"

#include "lab/document/opened_preset.h"

#include <doctest/doctest.h>

namespace {
const std::vector<ListedLook> two_looks{
    {{"crt", "/s/crt", false},
     "CRT",
     "",
     {{{"crt", "arcade", "/p/crt/arcade.json", false, "arcade"}, "Arcade", ""}}},
    {{"phosphor", "/s/phosphor", false},
     "Phosphor",
     "",
     {{{"phosphor", "amber", "/p/phosphor/amber.json", false, "amber"},
       "Amber P3",
       "Warm and slow"},
      {{"phosphor", "blue", "/p/phosphor/blue.json", false, "blue"},
       "Blue P11",
       "Photographed, fast"}}}};

Document phosphor_document() {
    Look look;
    look.id = "phosphor";
    look.stack = {{"phosphor", "/s/phosphor", {}}};
    Parameter gain;
    gain.name = "gain";
    look.parameters = {gain};
    return Document(look);
}

std::string listed_names(const PresetBrowsing& wanted, const FavouritePresets& stars = {}) {
    std::string all;
    for (const ListedPreset& preset : listed_presets(phosphor_document(), two_looks, stars, wanted))
        all += "[" + preset.preset.entry.name + "]";
    return all;
}
}  // namespace

TEST_CASE("the presets of the open look are listed after the look's defaults") {
    CHECK(listed_names({}) == "[][amber][blue]");
    CHECK(listed_names({.search = "p11"}) == "[blue]");
    CHECK(listed_names({.search = "WARM  slow"}) == "[amber]");  // in its description
    CHECK(listed_names({.search = "warm fast"}).empty());
    CHECK(listed_names({.search = {}, .only_starred = true}).empty());
    const FavouritePresets stars{"phosphor/blue", "crt/amber"};
    CHECK(listed_names({.search = {}, .only_starred = true}, stars) == "[blue]");
    CHECK(listed_names({.search = "amber", .only_starred = true}, stars).empty());
}

TEST_CASE("one listed preset is open, and it is modified after a change") {
    Document document = phosphor_document();
    const auto opens = [&] {
        std::string all;
        for (const ListedPreset& preset : listed_presets(document, two_looks, {}, {}))
            all += preset.is_modified ? "*" : preset.is_open ? "o" : ".";
        return all;
    };
    CHECK(opens() == "o..");
    document.set_value("gain", Value(0.5));
    CHECK(opens() == "*..");
    Preset blue;
    blue.look = "phosphor";
    open_preset(document, blue, "/p/phosphor/blue.json");
    CHECK(opens() == "..o");
    document.set_value("gain", Value(0.5));
    CHECK(opens() == "..*");
}
