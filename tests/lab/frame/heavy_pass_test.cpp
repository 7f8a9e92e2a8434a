#include "lab/frame/heavy_pass.h"

#include "lab/lab_parts.h"
#include "lab/small_lab.h"

namespace {
PassTimes times_of(const std::vector<std::vector<double>>& frames) {
    PassTimes times;
    for (const std::vector<double>& frame : frames)
        times.add(frame);
    return times;
}
}  // namespace

TEST_CASE("a pass above one second in each of the last four frames is heavy") {
    const std::vector<double> light{20.0, 1000.0};
    const std::vector<double> heavy{20.0, 1001.0};
    CHECK_FALSE(heavy_pass({}).has_value());
    CHECK_FALSE(heavy_pass(times_of({heavy, heavy, heavy})).has_value());
    CHECK_FALSE(heavy_pass(times_of({heavy, heavy, light, heavy})).has_value());
    CHECK(heavy_pass(times_of({light, heavy, heavy, heavy, heavy})) == 1);
    CHECK_FALSE(heavy_pass(times_of({heavy, heavy, heavy, heavy, light})).has_value());
}

TEST_CASE("an impossible time is ignored") {
    const std::vector<double> wild{5e6};
    CHECK_FALSE(heavy_pass(times_of({wild, wild, wild, wild})).has_value());
}

namespace {
Pass glow() {
    Pass pass;
    pass.name = "glow";
    return pass;
}

Pass glow_of_source() {
    Pass pass = glow();
    pass.inputs.emplace_back();
    pass.inputs.back().from = Input::From::source;
    return pass;
}

PictureSize scaled_by(double scale) {
    PictureSize size;
    size.scale = scale;
    return size;
}

std::vector<std::string> names_of(const MenuSection& section) {
    std::vector<std::string> names;
    for (const MenuEntry& entry : section.entries)
        names.push_back(entry.name);
    return names;
}

void take(const MenuEntry& entry, Lab& lab) {
    for (const Edit& command : entry.commands)
        command(mutable_parts(lab, nullptr));
}
}  // namespace

TEST_CASE("a heavy pass with an input can be bypassed, and the size halved down to 1/4") {
    const std::vector<std::string> both{"Bypass glow", "Halve render size"};
    CHECK(names_of(heavy_pass_section(glow_of_source(), {})) == both);
    CHECK(names_of(heavy_pass_section(glow_of_source(), scaled_by(0.5))) == both);
    CHECK(names_of(heavy_pass_section(glow_of_source(), scaled_by(0.25))) ==
          std::vector<std::string>{"Bypass glow"});
    CHECK(names_of(heavy_pass_section(glow(), {})) ==
          std::vector<std::string>{"Halve render size"});
}

TEST_CASE("entries for a heavy pass act like the strip and the menu") {
    SmallLab small;
    const MenuSection section =
        heavy_pass_section(small.document().look().passes[1], small.lab().work().size.chosen());
    REQUIRE(section.entries.size() == 2);
    take(section.entries[0], small.lab());
    CHECK(small.lab().frames().passes().switches().bypassed == std::set<std::string>{"show"});
    take(section.entries[1], small.lab());
    CHECK(small.lab().work().size.extent() == Extent{4, 4});  // of 8 x 8
    CHECK_FALSE(small.lab().messages().notice()->is_problem);
    small.lab().frames().passes().toggle(PassSwitch::bypass, "show");
    CHECK(small.lab().frames().passes().switches().is_empty());
}
