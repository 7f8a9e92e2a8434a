#include "model/look/stack.h"

#include <doctest/doctest.h>

namespace {
Stack stack(const std::vector<std::string>& looks) {
    Stack made;
    for (const std::string& look : looks)
        made.push_back({look, look, free_tag(made, look)});
    return made;
}
using Numbers = std::map<std::string, int>;
}  // namespace

TEST_CASE("a look in a stack is keyed by its id, and copies are numbered") {
    CHECK(stack_id(stack({"phosphor", "crt", "crt"})) == "phosphor+crt+crt");
    CHECK(stack_keys(look_ids("crt+phosphor+crt+crt")) ==
          std::vector<std::string>{"crt", "phosphor", "crt#2", "crt#3"});
    CHECK(name_prefix(stack({"crt", "crt"}), 1) == "crt#2/");
    CHECK(name_prefix(stack({"crt"}), 0).empty());
}

TEST_CASE("values follow their look when looks are added, removed or reordered") {
    const Stack alone = stack({"crt"});
    Stack both = alone;
    both.push_back({"crt", "crt", free_tag(both, "crt")});
    CHECK(moved(Numbers{{"exposure", 1}}, alone, both) == Numbers{{"crt/exposure", 1}});

    const Numbers of_both{{"crt/exposure", 1}, {"crt#2/exposure", 2}};
    const Stack turned{both[1], both[0]};
    CHECK(moved(of_both, both, turned) == Numbers{{"crt/exposure", 2}, {"crt#2/exposure", 1}});
    CHECK(moved(moved(of_both, both, turned), turned, both) == of_both);
    CHECK(moved(of_both, both, {both[1]}) == Numbers{{"exposure", 2}});
    // A third copy does not get the tag of an existing one.
    CHECK(free_tag({both[1]}, "crt") == "crt");
    CHECK(free_tag(both, "crt") == "crt#3");
    // A value that belongs to no look is kept.
    CHECK(moved(Numbers{{"mask/pitch", 3}}, both, turned) == Numbers{{"mask/pitch", 3}});
}

TEST_CASE("bypassed looks are identified by their keys") {
    const Stack plain = stack({"crt", "crt", "mask"});
    const Stack bypassed = with_bypass(plain, {"crt#2", "mask"});
    CHECK_FALSE(bypassed[0].is_bypassed);
    CHECK(bypassed[1].is_bypassed);
    CHECK(bypassed[2].is_bypassed);
    CHECK(bypassed_keys(bypassed) == std::vector<std::string>{"crt#2", "mask"});
    CHECK(with_bypass(bypassed, {}) == plain);
}

TEST_CASE("a name without prefix is accepted if only one look has it") {
    const std::vector<std::string> names{"phosphor/decay", "phosphor/exposure", "crt/exposure"};
    std::vector<std::string> candidates;
    CHECK(resolve_name(names, "decay", candidates) == "phosphor/decay");
    CHECK(resolve_name(names, "crt/exposure", candidates) == "crt/exposure");
    CHECK_FALSE(resolve_name(names, "exposure", candidates));
    CHECK(candidates == std::vector<std::string>{"phosphor/exposure", "crt/exposure"});
    CHECK_FALSE(resolve_name(names, "gain", candidates));
    CHECK(candidates.empty());
}
