#include "cli/common.h"
#include "io/sound/sound_save.h"
#include "lab/playback/play_beam.h"

#include <array>

namespace {
constexpr std::array signal_examples{
    "afterglow signal text:HELLO -o hello.wav",
    "afterglow signal lissajous:x=3,y=2 --seconds 60 --rate 96000 -o figure.flac",
    "afterglow signal drawing:logo.svg --channels 3 -o logo.wav",
};

struct SignalArguments {
    std::string signal;
    std::string output;
    BeamSoundFormat format;
};

int write_signal(const SignalArguments& arguments) {
    Diagnostics problems;
    const auto sound = play_beam(arguments.signal, arguments.format, problems);
    if (!sound)
        return report(sound.error());
    warn(problems);
    if (const auto saved = save_sound(*sound, arguments.output); !saved)
        return report(saved.error());
    return has_errors(problems) ? exit_failure : exit_done;
}
}  // namespace

/// afterglow signal SPEC -o SOUND
Command add_signal(CommandLine& program) {
    Options options = program.add_verb(
        "signal", "Save a signal as a sound file, for a real oscilloscope in XY mode",
        signal_examples);
    auto arguments = std::make_shared<SignalArguments>();
    options
        .add("SIGNAL", arguments->signal,
             "Signal, such as text:HELLO ('afterglow list signals' prints all)")
        .required();
    options
        .add("-o,--output FILE", arguments->output,
             "Save as .wav or .flac, with x on the left channel and y on the right")
        .required();
    options.add("--seconds S", arguments->format.seconds, "Duration in seconds")
        .show_default()
        .between(0.001, 3600.0);
    options.add("--rate HZ", arguments->format.rate, "Sample rate in Hz")
        .show_default()
        .between(8000, 768000);
    options
        .add("--channels N", arguments->format.channels,
             "2 channels, or 3 with the beam current on the third")
        .show_default()
        .between(2, 3);
    return [arguments](const DataFolders&) { return write_signal(*arguments); };
}
