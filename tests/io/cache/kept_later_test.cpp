#include "io/cache/kept_later.h"

#include <doctest/doctest.h>

#include <map>

namespace {
/// A store whose content is visible to the test.
class OpenStore : public ByteStore {
public:
    std::optional<std::string> find(std::string_view question) override {
        const auto found = all.find(question);
        return found == all.end() ? std::nullopt : std::optional(found->second);
    }
    void keep(std::string_view question, std::string_view answer) override {
        ++times;
        all.insert_or_assign(std::string(question), std::string(answer));
    }

    std::map<std::string, std::string, std::less<>> all;
    int times = 0;
};
}  // namespace

TEST_CASE("a write-behind store finds new entries at once and writes them when flushed") {
    const auto store = std::make_shared<OpenStore>();
    store->keep("old", "known");
    KeptLater kept(store);
    CHECK(kept.find("old") == "known");
    CHECK_FALSE(kept.find("what").has_value());

    kept.keep("what", "light");
    kept.keep("what", "shade");
    CHECK(kept.find("what") == "shade");
    CHECK_FALSE(store->find("what").has_value());

    kept.write_owed();
    CHECK(store->find("what") == "shade");
    CHECK(store->times == 2);

    kept.write_owed();
    CHECK(store->times == 2);
    store->all.clear();
    CHECK_FALSE(kept.find("what").has_value());  // the flushed entry is only in the store
}
