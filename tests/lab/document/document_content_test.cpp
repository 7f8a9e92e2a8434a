// The user's signal or source, its lock, and undo.
#include "lab/document/content_edits.h"
#include "lab/document/document.h"
#include "lab/document/opened_preset.h"
#include "lab/document/users_content.h"

#include <doctest/doctest.h>

namespace {
const Spec song{"audio", {{"file", std::string("/music/song.wav")}}};
const Spec figure{"lissajous", {{"x", 3.0}}};
const Spec wave{"waveform", {}};

Look driven_by(Driver driver) {
    Look look;
    look.id = "small";
    look.name = "Small";
    look.driven_by = driver;
    if (driver == Driver::signal)
        look.default_signal = figure;
    else
        look.default_source = "pattern:white";
    Parameter decay;
    decay.name = decay.label = "decay";
    decay.initial = Value(0.5);
    look.parameters = {decay};
    return look;
}

Preset preset_with(const Spec& signal) {
    Preset preset;
    preset.look = "small";
    preset.name = "Far";
    preset.values["decay"] = Value(0.9);
    preset.signal = signal;
    return preset;
}

Document with_song() {
    Document document(driven_by(Driver::signal));
    set_signal(document, song);
    return document;
}
}  // namespace

TEST_CASE("choosing a file, device, drawing, text or socket locks the signal") {
    for (const Spec& own :
         {song, Spec{"microphone", {}}, Spec{"drawing", {{"strokes", std::string("[]")}}},
          Spec{"text", {{"text", std::string("HI")}}}, Spec{"socket", {}}, Spec{"stdin", {}},
          Spec{"scene", {{"file", std::string("/a.json")}}}}) {
        CAPTURE(own.kind);
        Document document(driven_by(Driver::signal));
        CHECK_FALSE(is_content_locked(document));
        set_signal(document, own);
        CHECK(is_content_locked(document));
    }
}

TEST_CASE("choosing a generator or a test pattern does not lock the content") {
    Document beam(driven_by(Driver::signal));
    set_signal(beam, wave);
    CHECK_FALSE(is_content_locked(beam));
    Document tube(driven_by(Driver::picture));
    set_source(tube, "pattern:smpte");
    CHECK_FALSE(is_content_locked(tube));
    set_source(tube, "/pictures/game.png");
    CHECK(is_content_locked(tube));
}

TEST_CASE("a lock opened by hand stays open while settings of the same file change") {
    Document document = with_song();
    lock_content(document, false);
    Spec plotted = song;
    plotted.settings["mode"] = std::string("waveform");
    set_signal(document, plotted);
    CHECK_FALSE(is_content_locked(document));
    Spec other = song;
    other.settings["file"] = std::string("/music/other.wav");
    set_signal(document, other);
    CHECK(is_content_locked(document));
}

TEST_CASE("locked content stays with another preset and does not modify it") {
    Document document = with_song();
    open_preset(document, preset_with(wave), "/far.json");
    CHECK(document.state().signal == song);
    CHECK(document.value(document.look().parameters[0]) == Value(0.9));
    CHECK_FALSE(is_modified(document));
    CHECK(opened_preset(document).saved.signal == wave);
    open_defaults(document);
    CHECK(document.state().signal == song);
    apply_preset(document, preset_with(wave), "Paste");
    CHECK(document.state().signal == song);
    finish_morph(document, preset_with(wave), "/far.json", "Morph to Far");
    CHECK(document.state().signal == song);
    CHECK(preset_of(document).signal == song);  // the saved preset refers to it
}

TEST_CASE("without the lock a preset brings its signal, and a new signal modifies it") {
    Document document = with_song();
    lock_content(document, false);
    open_preset(document, preset_with(wave), "/far.json");
    CHECK(document.state().signal == wave);
    CHECK_FALSE(is_modified(document));
    set_signal(document, figure);
    CHECK(is_modified(document));
}

TEST_CASE("only undo of the step that chose content restores the previous content") {
    Document document(driven_by(Driver::signal));
    document.set_value("decay", Value(0.2));
    set_signal(document, song);
    document.set_value("decay", Value(0.3));
    open_preset(document, preset_with(wave), "/far.json");

    document.undo();
    CHECK(document.state().signal == song);
    CHECK(document.value(document.look().parameters[0]) == Value(0.3));
    document.undo();
    CHECK(document.state().signal == song);
    document.undo();
    CHECK(document.state().signal == figure);
    CHECK_FALSE(is_content_locked(document));  // as before that step
    document.redo();
    CHECK(document.state().signal == song);
    CHECK(is_content_locked(document));
    document.redo();
    document.redo();
    CHECK(document.state().signal == song);
    CHECK(preset_name(document) == "Far");
}

TEST_CASE("a preset's signal that is locked later stays when the preset is undone") {
    Document document(driven_by(Driver::signal));
    open_preset(document, preset_with(wave), "/far.json");
    lock_content(document, true);
    document.undo();
    CHECK(preset_name(document).empty());
    CHECK(document.state().signal == wave);
}

TEST_CASE("a preset opened with its own content unlocks, and one undo restores everything") {
    Document document = with_song();
    open_preset(document, preset_with(wave), "/far.json", OpenedContent::own);
    CHECK(document.state().signal == wave);
    CHECK_FALSE(is_content_locked(document));
    document.undo();
    CHECK(document.state().signal == song);
    CHECK(is_content_locked(document));
}

TEST_CASE("the preset's content can be used later, in a separate step") {
    Document document = with_song();
    open_preset(document, preset_with(wave), "/far.json");
    use_content(document, {wave, {}, {}});
    CHECK(document.state().signal == wave);
    CHECK_FALSE(is_modified(document));
    CHECK(document.history().undo_name() == "Use the preset's signal");
    document.undo();
    CHECK(document.state().signal == song);
    CHECK(preset_name(document) == "Far");
}

TEST_CASE("settings of locked content are undone like any other change") {
    Document document = with_song();
    Spec plotted = song;
    plotted.settings["mode"] = std::string("waveform");
    set_signal(document, plotted);
    document.undo();
    CHECK(document.state().signal == song);
}

TEST_CASE("locked content of both kinds survives a switch between looks") {
    Document beam = with_song();
    Document tube(driven_by(Driver::picture));
    keep_content(tube, content_of(beam));
    CHECK(tube.state().source == "pattern:white");
    CHECK_FALSE(is_content_locked(tube));
    CHECK_FALSE(is_modified(tube));
    set_source(tube, "/pictures/game.png");
    Document again(driven_by(Driver::signal));
    keep_content(again, content_of(tube));
    CHECK(again.state().signal == song);
    CHECK(is_content_locked(again));
    CHECK_FALSE(is_modified(again));
    Document tube_again(driven_by(Driver::picture));
    keep_content(tube_again, content_of(again));
    CHECK(tube_again.state().source == "/pictures/game.png");
}

TEST_CASE("content is named by its file, otherwise by its kind") {
    const Look beam = driven_by(Driver::signal);
    const Look tube = driven_by(Driver::picture);
    CHECK(content_name({song, {}, {}}, Driver::signal) == "song.wav");
    CHECK(content_name({Spec{"microphone", {}}, {}, {}}, Driver::signal) == "Live sound");
    CHECK(content_name({{}, "/pictures/game.png,fit=whole", {}}, Driver::picture) == "game.png");
    CHECK(keep_content_label(Driver::signal) == "Keep my signal");
    CHECK(use_content_label(Driver::picture) == "Use the preset's source");
}

TEST_CASE("the user's XY signal keeps circles round unless it specifies a fit") {
    const auto fit = [](const char* text) {
        return beam_fit_of(with_round_circles(parse_spec(text).value()));
    };
    for (const char* own : {"audio:song.wav", "audio:song.wav,mode=xy", "microphone", "text:HI",
                            "drawing:a.svg", "scene:a.json", "stdin", "socket:/tmp/a.sock"}) {
        CAPTURE(own);
        CHECK(fit(own) == Fit::whole);
        CHECK_FALSE(beam_fit_of(parse_spec(own).value()).has_value());  // in older presets
    }
    CHECK(fit("audio:song.wav,fit=stretch") == Fit::stretch);
    CHECK(fit("audio:song.wav,fit=crop") == Fit::crop);
    CHECK_FALSE(fit("audio:song.wav,fit=look").has_value());
    CHECK_FALSE(fit("audio:song.wav,mode=waveform").has_value());
    CHECK_FALSE(fit("lissajous:x=3,y=2").has_value());
}

TEST_CASE("the user's picture keeps its shape and gets automatic prescale by default") {
    Look look = driven_by(Driver::picture);
    look.manifest = "/looks/crt/look.json";
    CHECK(with_users_defaults("game.png", look) == "game.png,fit=whole,prescaled=auto");
    CHECK(with_users_defaults("game.png,fit=stretch,prescaled=1", look) == "game.png");
    CHECK(with_users_defaults("game.png,fit=crop,prescaled=2,rate=25", look) ==
          "game.png,fit=crop,prescaled=2,rate=25");
    CHECK(with_users_defaults("pattern:smpte", look) == "pattern:smpte");
    look.manifest = "/looks/crt.slangp";  // its picture has the shape of the source
    CHECK(with_users_defaults("game.png", look) == "game.png,prescaled=auto");
}

// A look that a signal or a picture can drive.
namespace {
Look driven_by_either(bool by_picture) {
    Look look = driven_by(by_picture ? Driver::picture : Driver::signal);
    look.default_signal = figure;
    look.default_source = "pattern:white";
    look.has_other_driver = true;
    look.stack = {{"small", "/small", "small", false, by_picture}};
    return look;
}

Preset preset_with_picture() {
    Preset preset = preset_with(figure);
    preset.signal.reset();
    preset.source = "pattern:ramp";
    return preset;
}
}  // namespace

TEST_CASE("choosing a picture or a signal chooses the driver, and undo restores it") {
    Document document(driven_by_either(false));
    CHECK(driver_of(document) == Driver::signal);
    document.set_value("decay", Value(0.7));
    set_source(document, "pattern:ramp");
    CHECK(driver_of(document) == Driver::picture);
    CHECK(document.has_pending_stack());  // the look is to be read for a picture
    document.replace_look(driven_by_either(true));
    CHECK_FALSE(document.has_pending_stack());
    CHECK(document.state().signal == figure);
    set_signal(document, wave);
    CHECK(driver_of(document) == Driver::signal);
    document.undo();
    CHECK(driver_of(document) == Driver::picture);
    CHECK(document.state().source == "pattern:ramp");
    document.undo();
    CHECK(driver_of(document) == Driver::signal);
    document.redo();
    CHECK(driver_of(document) == Driver::picture);
}

TEST_CASE("the other driver keeps the values of parameters that only the first one has") {
    Document document(driven_by_either(false));
    document.set_value("decay", Value(0.7));
    set_source(document, "pattern:ramp");
    Look picture = driven_by_either(true);
    picture.parameters[0].name = picture.parameters[0].label = "gain";
    picture.other_parameters = {"decay"};
    document.replace_look(picture);
    CHECK(orphans(document.look(), document.values()).empty());
    document.set_value("gain", Value(0.9));
    set_signal(document, figure);
    document.replace_look(driven_by_either(false));
    CHECK(document.values() == Values{{"decay", Value(0.7)}, {"gain", Value(0.9)}});
}

TEST_CASE("a preset brings its driver, and is saved with the content of that driver only") {
    Document document(driven_by_either(false));
    open_preset(document, preset_with_picture(), "/far.json");
    CHECK(driver_of(document) == Driver::picture);
    CHECK(preset_of(document).source == "pattern:ramp");
    CHECK_FALSE(preset_of(document).signal.has_value());
    CHECK_FALSE(is_modified(document));
    document.replace_look(driven_by_either(true));
    CHECK_FALSE(is_modified(document));
    open_preset(document, preset_with(wave), "/near.json");
    CHECK(driver_of(document) == Driver::signal);
    CHECK(preset_of(document).signal == wave);
    CHECK(preset_of(document).source.empty());
    open_preset(document, preset_with_picture(), "/far.json");
    open_defaults(document);
    CHECK(driver_of(document) == Driver::signal);
}

TEST_CASE("locked content keeps its driver when a preset of the other driver opens") {
    Document document(driven_by_either(false));
    set_signal(document, song);
    open_preset(document, preset_with_picture(), "/far.json");
    CHECK(driver_of(document) == Driver::signal);
    CHECK(document.state().signal == song);
    CHECK_FALSE(is_modified(document));
    open_preset(document, preset_with_picture(), "/far.json", OpenedContent::own);
    CHECK(driver_of(document) == Driver::picture);
    CHECK(document.state().source == "pattern:ramp");
}

TEST_CASE("a look with one driver keeps it with any preset") {
    Document document(driven_by(Driver::signal));
    open_preset(document, preset_with_picture(), "/far.json");
    CHECK_FALSE(document.has_pending_stack());
    CHECK(driver_of(document) == Driver::signal);
}
