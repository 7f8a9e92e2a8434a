#include "cli/common.h"
#include "io/sound_save.h"
#include "lab/play_beam.h"

namespace {
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
    return has_errors(problems) ? exit_not_good : exit_done;
}
}  // namespace

/// afterglow signal SPEC -o SOUND
Command add_signal(CommandLine& program) {
    Options options = program.add_verb("signal", "Write a signal as sound, for a real scope");
    auto arguments = std::make_shared<SignalArguments>();
    options.add("SPEC", arguments->signal, "The signal, such as text:HELLO").required();
    options.add("-o,--output", arguments->output, "A .wav or .flac: x left, y right").required();
    options.add("--seconds", arguments->format.seconds, "How long it is (10)")
        .between(0.001, 3600.0);
    options.add("--rate", arguments->format.rate, "Samples a second (48000)").between(8000, 768000);
    options.add("--channels", arguments->format.channels, "2, or 3 with the beam's current (2)")
        .between(2, 3);
    return [arguments](const DataFolders&) { return write_signal(*arguments); };
}
