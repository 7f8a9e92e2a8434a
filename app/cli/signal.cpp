#include "cli/common.h"
#include "io/sound_save.h"
#include "lab/play_beam.h"

namespace {
struct Arguments {
    std::string signal;
    std::string output;
    BeamSoundFormat format;
};

int write_signal(const Arguments& arguments) {
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
Command add_signal(CLI::App& program) {
    auto* command = program.add_subcommand("signal", "Write a signal as sound, for a real scope");
    auto arguments = std::make_shared<Arguments>();
    command->add_option("SPEC", arguments->signal, "The signal, such as text:HELLO")->required();
    command->add_option("-o,--output", arguments->output, "A .wav or .flac: x left, y right")
        ->required();
    command->add_option("--seconds", arguments->format.seconds, "How long it is (10)")
        ->check(CLI::Range(0.001, 3600.0));
    command->add_option("--rate", arguments->format.rate, "Samples a second (48000)")
        ->check(CLI::Range(8000, 768000));
    command
        ->add_option("--channels", arguments->format.channels,
                     "2, or 3 with the beam's current (2)")
        ->check(CLI::Range(2, 3));
    return [arguments](const std::string&) { return write_signal(*arguments); };
}
