// Knobs of MIDI devices, simulated by their bytes.
#include "lab/document/parameter_edits.h"
#include "lab/document/stack_edits.h"
#include "lab/remote/fake_midi.h"
#include "lab/remote/midi_control.h"
#include "lab/small_lab.h"

#include <cmath>

namespace {
/// A lab with a simulated device.
class Turning : public SmallLab {
public:
    Turning() { begin(); }
    void begin() {
        start(std::make_unique<FakeMidi>(device));
        lab().looks().open("small");
        wait_for_frames();
    }
    void knob(int controller, int value, double seconds = 1.0 / 60.0) {
        device.messages.push_back(
            {0xb0, static_cast<std::uint8_t>(controller), static_cast<std::uint8_t>(value)});
        lab().update(seconds);
    }
    double gain() { return document().value(*find_parameter(document().look(), "gain")).number(); }

    FakeDevice device;
};

bool is_at(double a, double b) {
    return std::abs(a - b) <= 1e-6;
}
}  // namespace

TEST_CASE("a learnt knob covers the parameter's range in one undo step and is stored") {
    Turning small;
    small.lab().remote().learn_midi({"gain"});
    REQUIRE(small.lab().remote().midi().learning());
    CHECK(small.lab().remote().midi().devices() == std::vector<std::string>{"nanoKONTROL"});
    small.device.messages.push_back({0x90, 60, 100});  // a key is not a knob
    small.knob(21, 10);
    CHECK_FALSE(small.lab().remote().midi().learning());
    CHECK(small.lab().messages().notice()->text == "CC 21, channel 1 now controls \"Gain\"");
    CHECK(small.gain() == 1.0);  // learning changes no value
    // The range is 0 to 8, so 1 is at 15.875 of 127. The knob takes effect there.
    small.knob(21, 12);
    CHECK(small.gain() == 1.0);
    small.knob(21, 16);
    CHECK(is_at(small.gain(), 8.0 * 16 / 127));
    small.lab().automation().record(true);
    small.knob(21, 127);
    CHECK(small.gain() == 8.0);
    REQUIRE_FALSE(small.lab().automation().recorder().points().empty());
    CHECK(small.lab().automation().recorder().points().back().name == "gain");
    CHECK(small.lab().automation().recorder().points().back().value == Value(8.0));
    CHECK(small.document().history().past().size() == 1);
    small.lab().update(0.6);
    CHECK_FALSE(small.document().history().is_in_gesture());
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(small.gain() == 1.0);

    small.begin();  // the program is restarted
    CHECK(small.lab().remote().midi().is_listening());
    CHECK(small.lab().remote().settings().midi == std::vector<MidiBinding>{{{"gain"}, 1, 21}});
    RemoteSettings settings = small.lab().remote().settings();
    settings.has_soft_takeover = false;
    small.lab().remote().set_settings(settings);
    small.knob(21, 127);
    CHECK(small.gain() == 8.0);  // it jumps, because soft takeover is off
    settings.unbind({"gain"});
    small.lab().remote().set_settings(settings);
    small.knob(21, 0);
    CHECK(small.gain() == 8.0);
}

TEST_CASE("a 14-bit knob is learnt as a pair and has 14-bit resolution") {
    Turning small;
    small.lab().remote().learn_midi({"gain"});
    small.device.messages.push_back({0xb0, 7, 16});
    small.knob(39, 0);  // directly after the first half
    CHECK(small.lab().remote().settings().midi == std::vector<MidiBinding>{{{"gain"}, 1, 7, true}});
    small.device.messages.push_back({0xb0, 7, 16});
    small.knob(39, 1);
    CHECK(is_at(small.gain(), 8.0 * 2049 / 16383));
    small.lab().remote().learn_midi({"gain"});
    small.knob(7, 16);
    small.knob(39, 0, 0.5);  // much later, so it is a separate knob
    CHECK(small.lab().remote().settings().midi ==
          std::vector<MidiBinding>{{{"gain"}, 1, 7, false}});
}

TEST_CASE("changes to locked parameters are refused, and unknown parameters are ignored") {
    Turning small;
    RemoteSettings settings;
    settings.listens_to_midi = true;
    settings.has_soft_takeover = false;
    settings.midi = {{{"gain"}, 1, 21}, {{"elsewhere"}, 1, 22}};
    small.lab().remote().set_settings(settings);
    small.lab().edit(
        [](Document& document) { set_parameter_setting(document, "gain", {.is_locked = true}); });
    small.knob(21, 127);
    CHECK(small.gain() == 1.0);
    CHECK(small.lab().messages().notice()->text == "MIDI: 'gain' is locked");
    small.knob(22, 127);
    CHECK(small.lab().remote().midi().refused() == 1);
    CHECK(small.lab().remote().midi().applied() == 0);
    CHECK(small.document().history().past().empty());
}

TEST_CASE("a switch has no soft takeover, so a knob changes it at once") {
    Turning small;
    small.write_by_rename("gain.glsl",
                          "uniform float gain = 1.0;\nuniform bool is_dark = false;\n");
    small.write_by_rename("show.frag",
                          replaced(small_look::show, "* gain", "* (is_dark ? 0.0 : gain)"));
    REQUIRE(small.update_until(
        [&] { return find_parameter(small.document().look(), "is_dark") != nullptr; }));
    RemoteSettings settings;
    settings.listens_to_midi = true;
    settings.midi = {{{"is_dark"}, 1, 21}};
    small.lab().remote().set_settings(settings);
    REQUIRE(settings.has_soft_takeover);
    small.knob(21, 127);
    CHECK(small.document().value(*find_parameter(small.document().look(), "is_dark")).number() ==
          1.0);
}

TEST_CASE("knobs change nothing while another stack is being loaded") {
    Turning small;
    RemoteSettings settings;
    settings.listens_to_midi = true;
    settings.has_soft_takeover = false;
    settings.midi = {{{"gain"}, 1, 21}};
    small.lab().remote().set_settings(settings);
    small.lab().edit([](Document& document) {
        Stack twice = document.look().stack;
        twice.push_back(twice.front());
        twice.back().tag = free_tag(document.look().stack, twice.back().look);
        set_stack(document, twice, "Add");
    });
    REQUIRE(small.document().has_pending_stack());
    small.knob(21, 127);
    CHECK(small.lab().remote().midi().applied() == 0);
}

TEST_CASE("a missing device is reported once, and a later one is found") {
    Turning small;
    small.device.plugged.clear();
    small.lab().remote().learn_midi({"gain"});
    CHECK_FALSE(small.lab().remote().midi().learning());
    CHECK(small.lab().messages().notice()->text == "MIDI: no device found");
    CHECK_FALSE(small.lab().messages().notice()->is_problem);
    CHECK_FALSE(small.lab().remote().settings().listens_to_midi);
    small.device.plugged = {"Faders"};
    small.lab().remote().find_midi_devices();
    CHECK(small.lab().messages().notice()->text == "Listening to MIDI: Faders");
    small.device.plugged = {"Faders", "Knobs"};
    small.lab().remote().learn_midi({"gain"});
    CHECK(small.lab().remote().midi().devices().size() == 2);
    small.lab().remote().end_midi_learning();
    small.knob(21, 64);
    CHECK(small.lab().remote().settings().midi.empty());
}

TEST_CASE("the MIDI devices of this machine open, or a reason is given") {
    const auto inputs = machine_midi_inputs();
    CHECK(inputs->descriptor() >= 0);
    if (const auto opened = inputs->open()) {
        CHECK_FALSE(inputs->names().empty());
    } else {
        CHECK(opened.error().front().message.find("device") != std::string::npos);
        CHECK(inputs->names().empty());
    }
    CHECK_FALSE(inputs->take());
}
