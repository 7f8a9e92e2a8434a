#include "formats/slang/controls.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace {
// Parameters from the text after #pragma parameter, one per line of "a.slang".
SlangParameters declared_in(const std::vector<std::string>& lines,
                            const std::string& file = "a.slang") {
    SlangParameters parameters;
    int number = 0;
    for (const std::string& line : lines) {
        auto parameter = parse_slang_parameter(line, {file, ++number});
        REQUIRE(parameter.has_value());
        parameters.push_back(std::make_shared<const SlangParameter>(*parameter));
    }
    return parameters;
}

SlangControls controls_of(const std::vector<std::string>& lines,
                          const std::map<std::string, SlangValue>& values = {}) {
    return slang_controls(declared_in(lines), values);
}

Parameter control_of(const std::string& line,
                     const std::map<std::string, SlangValue>& values = {}) {
    const SlangControls controls = controls_of({line}, values);
    REQUIRE(controls.parameters.size() == 1);
    return controls.parameters.front();
}

// "Group/name" of each control.
std::string grouped(const SlangControls& controls) {
    std::string text;
    for (const Parameter& parameter : controls.parameters)
        text += (text.empty() ? "" : " ") + parameter.group + "/" + parameter.name;
    return text;
}
}  // namespace

TEST_CASE("a switch that a shader reads is not a heading, whatever its label") {
    const SlangParameters declared =
        declared_in({"curve \"CURVED:\" 1.0 0.0 1.0 1.0", "head \"MASK:\" 1.0 0.0 1.0 1.0",
                     "wide \"Wide\" 1.0 0.0 2.0 0.1"});
    const SlangControls controls = slang_controls(declared, {}, {"curve", "wide"});
    REQUIRE(controls.parameters.size() == 2);
    CHECK(controls.parameters[0].name == "curve");
    CHECK(controls.parameters[0].type == NumberType{Scalar::boolean});
    CHECK(controls.parameters[1].group == "MASK");
}

TEST_CASE("a slang parameter becomes a slider with range, label and location") {
    const Parameter made = control_of("BEAM_WIDTH \"   Beam width (px) \" 0.5 0.0 2.0 0.05");
    CHECK(made.name == "BEAM_WIDTH");
    CHECK(made.label == "Beam width (px)");
    CHECK(made.help.empty());
    CHECK(made.control == Control::slider);
    CHECK(made.type == NumberType{});
    CHECK(made.initial == Value(0.5));
    CHECK(made.range == Range{0.0, 2.0, 0.05});
    CHECK(made.declared == Location{"a.slang", 1});
    CHECK(made.bindings.empty());
    CHECK(control_of("beam_x \"---\" 0 0 2 0.5").label == "Beam x");
}

TEST_CASE("the full text is the help if the label is shorter") {
    const Parameter made = control_of("mode \" Mode (off, fast, exact) \" 1 0 2 1");
    CHECK(made.label == "Mode");
    CHECK(made.help == "Mode (off, fast, exact)");
}

TEST_CASE("0..1 with step 1 is a check box, or a list if both values have names") {
    CHECK(control_of("a \"Glow\" 1 0 1 1").type == NumberType{Scalar::boolean});
    CHECK(control_of("a \"Glow [ OFF | ON ]\" 1 0 1 1").type == NumberType{Scalar::boolean});
    CHECK(control_of("a \"Glow [ OFF | ON ]\" 1 0 1 1").label == "Glow");
    const Parameter list = control_of("a \"Order (RGB, BGR)\" 1 0 1 1");
    CHECK(list.control == Control::list);
    CHECK(list.type == NumberType{});
    CHECK(list.items == std::vector<Item>{{0.0, "RGB"}, {1.0, "BGR"}});
    CHECK(control_of("a \"Linear [ YES | NO ]\" 0 0 1 1").control == Control::list);
}

TEST_CASE("0..1 with another default or step is not a check box") {
    CHECK(control_of("a \"Glow\" 0.5 0 1 1").type == NumberType{});
    CHECK(control_of("a \"Glow\" 0.5 0 1 1").control == Control::slider);
    CHECK(control_of("a \"Glow\" 0 0 1 0.5").control == Control::slider);
}

TEST_CASE("up to 12 whole numbers are a list, with numbers for missing names") {
    const Parameter list = control_of("a \"Scan (0 = none)\" 2 0 11 1");
    CHECK(list.control == Control::list);
    REQUIRE(list.items.size() == 12);
    CHECK(list.items[0] == Item{0.0, "none"});
    CHECK(list.items[11] == Item{11.0, "11"});
    CHECK(control_of("a \"Scan\" 2 0 12 1").control == Control::slider);
    CHECK(control_of("a \"Scan\" 2 0.5 3.5 1").control == Control::slider);
    CHECK(control_of("a \"Scan\" 2 0 3 0.5").control == Control::slider);
    CHECK(control_of("a \"Scan\" 0 1e9 1000000003 1").control == Control::slider);
}

TEST_CASE("a minimum above the maximum is swapped with a warning") {
    const SlangControls controls = controls_of({"a \"A\" 1 2 -2 0.5"});
    CHECK(controls.parameters[0].range == Range{-2.0, 2.0, 0.5});
    CHECK(to_string(controls.warnings.front()) ==
          "a.slang:1: warning: parameter 'a': minimum 2 is above maximum -2; they are swapped");
}

TEST_CASE("a default or preset value outside the range widens it") {
    CHECK(control_of("a \"A\" 5 0 2 0.5").range == Range{0.0, 5.0, 0.5});
    const Parameter set = control_of("a \"A\" 1 0 2 0.5", {{"a", {-4.0, {}}}});
    CHECK(set.initial == Value(-4.0));
    CHECK(set.range == Range{-4.0, 2.0, 0.5});
    // A list keeps its names and gets one more number.
    const Parameter list = control_of("a \"Order (RGB, BGR)\" 0 0 1 1", {{"a", {2.0, {}}}});
    CHECK(list.items == std::vector<Item>{{0.0, "RGB"}, {1.0, "BGR"}, {2.0, "2"}});
}

TEST_CASE("a parameter without a range is the heading of the next ones") {
    const SlangControls controls =
        controls_of({"before \"B\" 0 0 2 0.1", "t1 \"[ COLOR ]:\" 0 0 0 1", "a \"A\" 0 0 2 0.1",
                     "t2 \"== Mask ==\" 0 0 1 1", "b \"B\" 0 0 2 0.1", "row-2 \"Glass\" 0 0 1 0.5",
                     "c \"C\" 0 0 2 0.1", "t4 \"Tube\" 0 0 0.001 0.001", "d \"D\" 0 0 2 0.1",
                     "t5 \"BEZEL:\" 0 0 1 1", "e \"E\" 0 0 2 0.1"});
    CHECK(grouped(controls) == "/before COLOR/a Mask/b Glass/c Tube/d BEZEL/e");
    REQUIRE(controls.groups.size() == 5);
    CHECK(controls.groups[0] == Heading{"COLOR", {"a.slang", 2}});
    CHECK(controls.groups[4].name == "BEZEL");
}

TEST_CASE("a check box with a decorated label or a real range is not a heading") {
    const SlangControls controls = controls_of(
        {"a \"=== Glare === (OFF/ON)\" 1 0 1 1", "b \"[IMG] Sharp\" 0 0 1 1",
         "c \"--- Glare\" 0 0 1 1", "d \"[ SIZE ]\" 0 0 1 0.1", "e \"Fine step\" 0 0 1 1"});
    CHECK(grouped(controls) == "/a /b /c /d /e");
    CHECK(controls.parameters[0].label == "Glare");
}

TEST_CASE("blank and dashed rows are not headings, and equal headings are merged") {
    const SlangControls controls = controls_of(
        {"t \"[ COLOR ]\" 0 0 0 0", "r \"------\" 0 0 0 0", "s \" \" 0 0 1 1", "a \"A\" 0 0 2 0.1",
         "u \"[ COLOR ]\" 0 0 0 0", "b \"B\" 0 0 2 0.1", "v \"[ EMPTY ]\" 0 0 0 0"});
    CHECK(grouped(controls) == "COLOR/a COLOR/b");
    CHECK(controls.groups.size() == 1);
}

TEST_CASE("plain text between headings and parameters becomes help") {
    const SlangControls controls = controls_of(
        {"t \"[ FLICKER ]\" 0 0 0 0", "n1 \"Needs 120 Hz\" 0 0 0 0", "a \"A\" 0 0 2 0.1",
         "n2 \"|| 1 hides every other frame\" 0 0 0 0", "b \"B\" 0 0 2 0.1"});
    CHECK(grouped(controls) == "FLICKER/a FLICKER/b");
    CHECK(controls.parameters[0].help == "Needs 120 Hz\n|| 1 hides every other frame");
    CHECK(controls.parameters[1].help.empty());
}

TEST_CASE("a heading continues in files of its folder and ends after them") {
    SlangParameters all = declared_in({"t \"[ BEAM ]\" 0 0 0 0", "a \"A\" 0 0 2 0.1"}, "x/a.slang");
    for (const auto& more : declared_in({"b \"B\" 0 0 2 0.1"}, "x/b.slang"))
        all.push_back(more);
    for (const auto& more : declared_in({"c \"C\" 0 0 2 0.1"}, "y/c.slang"))
        all.push_back(more);
    CHECK(grouped(slang_controls(all, {})) == "BEAM/a BEAM/b /c");
}

TEST_CASE("a shader still gets the value of a parameter shown as a heading") {
    const SlangControls controls =
        controls_of({"t \"[ COLOR ]\" 1 1 1 1", "row-2 \"----\" 0 0 0 0", "u \"Fixed\" 2 2 2 0"},
                    {{"u", {3.0, {}}}});
    CHECK(controls.parameters.empty());
    CHECK(controls.fixed == Values{{"t", 1.0}, {"u", 3.0}});
}
