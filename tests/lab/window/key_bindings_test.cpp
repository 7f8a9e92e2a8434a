#include "lab/window/key_bindings.h"

#include "lab/window/key_store.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace {
const std::vector<KeyedAction> actions{{"undo", "Undo", {'Z', true}},
                                       {"redo", "Redo", {'Z', true, true}},
                                       {"play_pause", "Play or pause", {' '}},
                                       {"about", "About", {}}};

std::string key_of(const KeyBindings& bindings, const char* name) {
    for (const KeyedAction& action : actions)
        if (action.name == name)
            return chord_text(bindings.chord_of(action));
    return "unknown";
}

/// A configuration folder, deleted at the end.
class ConfigFolder {
public:
    ConfigFolder() {
        std::string name = (fs::temp_directory_path() / "afterglow-keys-XXXXXX").string();
        m_folder = mkdtemp(name.data());
    }
    ~ConfigFolder() { fs::remove_all(m_folder); }
    ConfigFolder(const ConfigFolder&) = delete;
    ConfigFolder& operator=(const ConfigFolder&) = delete;

    fs::path file() const { return m_folder / "keys.json"; }
    void write(const std::string& text) const { std::ofstream(file(), std::ios::binary) << text; }
    std::string text() const {
        std::ostringstream text;
        text << std::ifstream(file(), std::ios::binary).rdbuf();
        return text.str();
    }
    KeyStore store() const {
        Roots roots;
        roots.config = m_folder;
        return KeyStore(roots);
    }

private:
    fs::path m_folder;
};

std::string with_keys(const std::string& keys) {
    return "{\n  \"format\": \"afterglow-keys\",\n  \"version\": 1,\n  \"keys\": {\n" + keys +
           "\n  }\n}\n";
}
}  // namespace

TEST_CASE("a key that another action has is swapped") {
    KeyBindings bindings;
    CHECK(bindings.find_conflict(actions, actions[2], {'Z', true}) == &actions[0]);
    CHECK(bindings.find_conflict(actions, actions[0], {'Z', true}) == nullptr);
    CHECK(bindings.find_conflict(actions, actions[2], {}) == nullptr);
    bindings.set(actions, actions[2], {'Z', true});
    CHECK(key_of(bindings, "play_pause") == "Ctrl+Z");
    CHECK(key_of(bindings, "undo") == "Space");
    CHECK(bindings.is_changed(actions[0]));
    bindings.reset(actions, actions[0]);
    CHECK(key_of(bindings, "undo") == "Ctrl+Z");
    CHECK(key_of(bindings, "play_pause") == "Space");
    CHECK(bindings.is_empty());
}

TEST_CASE("an action without a key takes another's key") {
    KeyBindings bindings;
    bindings.set(actions, actions[3], {' '});
    CHECK(key_of(bindings, "about") == "Space");
    CHECK(key_of(bindings, "play_pause").empty());
    bindings.reset_all();
    CHECK(key_of(bindings, "play_pause") == "Space");
}

TEST_CASE("changed keys are saved and read back") {
    const ConfigFolder folder;
    Messages messages;
    KeyBindings bindings;
    bindings.set(actions, actions[0], {'U', true});
    bindings.set(actions, actions[2], {});
    folder.store().update(bindings, messages);
    CHECK_FALSE(messages.notice().has_value());
    CHECK(folder.text() == with_keys("    \"play_pause\": \"\",\n    \"undo\": \"Ctrl+U\""));
    Diagnostics problems;
    CHECK(folder.store().load(actions, problems) == bindings);
    CHECK(problems.empty());
}

TEST_CASE("two actions may swap their keys in the file") {
    const ConfigFolder folder;
    folder.write(with_keys("    \"undo\": \"Ctrl+Shift+Z\",\n    \"redo\": \"Ctrl+Z\""));
    Diagnostics problems;
    const KeyBindings bindings = folder.store().load(actions, problems);
    CHECK(problems.empty());
    CHECK(key_of(bindings, "undo") == "Ctrl+Shift+Z");
    CHECK(key_of(bindings, "redo") == "Ctrl+Z");
}

TEST_CASE("invalid lines of the file are reported, ignored and kept") {
    const ConfigFolder folder;
    folder.write(
        with_keys("    \"undu\": \"U\",\n    \"undo\": \"Ctrl+Nope\",\n"
                  "    \"redo\": \"Space\",\n    \"about\": \"F10\""));
    Diagnostics problems;
    KeyStore store = folder.store();
    KeyBindings bindings = store.load(actions, problems);
    const std::string file = folder.file().string();
    CHECK(to_string(problems) ==
          file + ":5: warning: unknown action 'undu' (did you mean 'undo'?)\n" + file +
              ":6: warning: 'Ctrl+Nope' is not a key. Write it as in 'Ctrl+Shift+S', or '' for no "
              "key.\n" +
              file + ":8: warning: 'F10' is reserved. Choose another key.\n" + file +
              ":7: warning: Space is already the key of 'play_pause'\n");
    CHECK(bindings.is_empty());
    bindings.set(actions, actions[3], {'I'});
    Messages messages;
    store.update(bindings, messages);
    CHECK(folder.text() == with_keys("    \"undu\": \"U\",\n    \"undo\": \"Ctrl+Nope\",\n"
                                     "    \"redo\": \"Space\",\n    \"about\": \"I\""));
}

TEST_CASE("a broken file is reported with its line and never overwritten") {
    for (const std::string& text :
         {std::string("{\n\"format\": \"afterglow-keys\",\n"), with_keys("    \"undo\": 7"),
          std::string("{\"format\": \"afterglow-keys\", \"version\": 9, \"keys\": {}}"),
          std::string("\0\xff", 2), std::string("[]")}) {
        const ConfigFolder folder;
        folder.write(text);
        Diagnostics problems;
        KeyStore store = folder.store();
        KeyBindings bindings = store.load(actions, problems);
        REQUIRE_FALSE(problems.empty());
        CHECK(problems.front().file == folder.file());
        CHECK(bindings.is_empty());
        bindings.set(actions, actions[0], {'U'});
        Messages messages;
        store.update(bindings, messages);
        CHECK(messages.notice().has_value());
        CHECK(folder.text() == text);
    }
}
