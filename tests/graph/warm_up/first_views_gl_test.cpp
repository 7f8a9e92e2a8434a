#include "gpu/error_log.h"
#include "graph/looks.h"
#include "graph/warm_up/first_views.h"

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

TEST_CASE_FIXTURE(Headless, "views of every format can be warmed up before there is a picture") {
    FirstViews views(std::make_shared<const ViewPrograms>(ViewPrograms::make().value()));
    gpu::ErrorLog errors;
    for (const FormatInfo& info : all_formats())
        for (const bool is_mipmapped : {false, true})
            for (const bool has_alpha : {false, true}) {
                CAPTURE(info.name);
                Look look = look_with(info.format, Encoding::display);
                look.passes[0].has_alpha = has_alpha;
                views.expect(look, plan_of({{640, 480}, info.format, 1, is_mipmapped}));
                CHECK(views.pending() > 0);
                while (views.pending() > 0)
                    views.draw_next();
                CHECK(errors.take().empty());
            }
}

TEST_CASE_FIXTURE(Headless, "each kind of picture is warmed up once") {
    FirstViews views(std::make_shared<const ViewPrograms>(ViewPrograms::make().value()));
    const auto is_new = [&views](const Look& look, const PlannedTarget& target) {
        const std::size_t before = views.pending();
        views.expect(look, plan_of(target));
        return views.pending() > before;
    };
    const Look light = look_with(Format::rgba16f, Encoding::linear);
    const Look encoded = look_with(Format::rgba16f, Encoding::display);
    const PlannedTarget usual{{1280, 720}, Format::rgba16f, 1, false};
    CHECK(is_new(light, usual));
    CHECK_FALSE(is_new(light, usual));
    CHECK(is_new(encoded, usual));
    Look transparent = encoded;
    transparent.passes[0].has_alpha = true;
    CHECK(is_new(transparent, usual));
    PlannedTarget other = usual;
    other.extent = {640, 480};  // again without a power of two
    CHECK_FALSE(is_new(light, other));
    other.extent = {1024, 720};
    CHECK(is_new(light, other));
    other.extent = {720, 1024};
    CHECK(is_new(light, other));
    PlannedTarget single{{1, 1}, Format::rgba16f, 1, false};
    CHECK(is_new(light, single));
    single.mipmapped = true;
    CHECK_FALSE(is_new(light, single));  // it has only one level
}
