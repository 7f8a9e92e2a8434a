#include "gpu/error_log.h"
#include "graph/first_views.h"
#include "graph/looks.h"

namespace {
Look look_with(Format format, Encoding output) {
    Look look = look_of({pass("a", "void main() { color = vec4(1.0); }\n")});
    look.passes[0].format = format;
    look.output = output;
    return look;
}

Plan plan_of(const PlannedTarget& target) {
    return {.targets = {target}, .source_slots = 1};
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "pictures of every format can be looked at before there are any") {
    FirstViews views = FirstViews::make().value();
    gpu::ErrorLog errors;
    for (const FormatFacts& facts : all_formats())
        for (const bool is_mipmapped : {false, true}) {
            CAPTURE(facts.name);
            const PlannedTarget target{{640, 480}, facts.format, 1, is_mipmapped};
            const Look look = look_with(facts.format, Encoding::display);
            CHECK(views.look_at(look, plan_of(target)) == 1);
            CHECK(errors.take().empty());
        }
}

TEST_CASE_FIXTURE(Headless, "each kind of picture is looked at once") {
    FirstViews views = FirstViews::make().value();
    const Look light = look_with(Format::rgba16f, Encoding::linear);
    const Look encoded = look_with(Format::rgba16f, Encoding::display);
    const PlannedTarget usual{{1280, 720}, Format::rgba16f, 1, false};
    CHECK(views.look_at(light, plan_of(usual)) == 1);
    CHECK(views.look_at(light, plan_of(usual)) == 0);
    CHECK(views.look_at(encoded, plan_of(usual)) == 1);
    Look transparent = encoded;
    transparent.passes[0].has_alpha = true;
    CHECK(views.look_at(transparent, plan_of(usual)) == 1);
    PlannedTarget other = usual;
    other.extent = {640, 480};  // no side is a power of two either
    CHECK(views.look_at(light, plan_of(other)) == 0);
    other.extent = {1024, 720};
    CHECK(views.look_at(light, plan_of(other)) == 1);
    other.extent = {720, 1024};
    CHECK(views.look_at(light, plan_of(other)) == 1);
}
