#include "lab/send/running_program.h"

#include "lab/send/mpv.h"
#include "lab/send/retroarch.h"

#include <algorithm>

const std::vector<RunningProgram>& running_programs() {
    static const std::vector<RunningProgram> programs{
        {.name = "RetroArch",
         .target = "slang",
         .address = "55355",
         .kind_of_address = "Port",
         .help = "In RetroArch, turn on Settings > Network > Network Commands.",
         .load = load_in_retroarch},
        {.name = "mpv",
         .target = "mpv",
         .address = "/tmp/mpvsocket",
         .kind_of_address = "Socket",
         .help = "Start mpv with --input-ipc-server=/tmp/mpvsocket.",
         .load = load_in_mpv},
    };
    return programs;
}

std::optional<std::size_t> program_for(const std::string& target) {
    const auto& programs = running_programs();
    const auto found = std::ranges::find(programs, target, &RunningProgram::target);
    if (found == programs.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - programs.begin());
}
