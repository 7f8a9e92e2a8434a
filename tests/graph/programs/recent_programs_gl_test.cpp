#include "graph/looks.h"
#include "graph/programs/recent_programs.h"

#include <fmt/format.h>

namespace {
Look painted(int number) {
    return look_of({pass("a", fmt::format("void main() {{ color = vec4({}.0); }}\n", number))});
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "a text that returns reuses its previous program") {
    RecentPrograms recent;
    CHECK(recent.all() == nullptr);
    const Programs first = programs_of(painted(1));
    recent.show(first);
    const Programs second = programs_of(painted(2), recent.all().get());
    recent.show(second);
    CHECK(second.passes[0].program != first.passes[0].program);
    const Programs back = programs_of(painted(1), recent.all().get());
    CHECK(back.passes[0].program == first.passes[0].program);
}

TEST_CASE_FIXTURE(Headless,
                  "two passes with one text do not share a program that both lists contain") {
    const std::string body = "uniform float k;\nvoid main() { color = vec4(k); }\n";
    const Programs one = programs_of(look_of({pass("a", body)}));
    const Programs all = joined(one, one.passes);
    CHECK(all.passes.size() == 1);
    const Programs two = programs_of(look_of({pass("a", body), pass("b", body)}), &all);
    CHECK(two.passes[0].program == one.passes[0].program);
    CHECK(two.passes[1].program != one.passes[0].program);
}

TEST_CASE_FIXTURE(Headless, "old programs and those of another context are dropped") {
    RecentPrograms recent;
    for (int i = 0; i < 40; ++i)
        recent.show(programs_of(painted(i)));
    const Programs newest = programs_of(painted(39), recent.all().get());
    CHECK(newest.passes[0].program == recent.all()->passes[0].program);
    CHECK(recent.all()->passes.size() == 17);  // one displayed and sixteen previous programs

    Programs elsewhere = newest;
    elsewhere.home = gpu::Context::shared_with(**context).value();
    recent.show(elsewhere);
    CHECK(recent.all()->passes.size() == 1);
}
