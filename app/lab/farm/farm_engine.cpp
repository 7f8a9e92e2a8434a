#include "lab/farm/farm_engine.h"

#include "io/files/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
constexpr const char* enter_folder =
    "folder=$(cd \"$(dirname \"$0\")\" && pwd)\n"
    "cd \"$folder\"\n";

// The start of each `run`.
std::string run_start(const std::string& about, const std::string& program) {
    return fmt::format(R"(#!/bin/sh
# {}
set -eu
{}for program in afterglow {}; do
    if ! command -v "$program" >/dev/null; then
        echo "$program was not found. Install it, or add its folder to PATH." >&2
        exit 1
    fi
done
)",
                       about, enter_folder, program);
}

FarmFile run_file(const std::string& about, const std::string& program, const std::string& text) {
    return {"run", run_start(about, program) + text, true};
}

std::string last_part(const FarmWork& work) {
    return std::to_string(work.parts.size() - 1);
}

std::vector<FarmFile> parallel_files(const FarmWork& work) {
    const std::string join = work.join.empty() ? "" : "./join\n";
    return {run_file(
        "Draws all parts with GNU parallel. ./run [JOBS]: parts at a time; default: one per core",
        "parallel",
        fmt::format(R"(export PARALLEL_HOME="$folder/logs/parallel"
mkdir -p "$PARALLEL_HOME"
seq 0 {} | parallel --jobs "${{1:-100%}}" --retries 4 --tmpdir "$folder/logs" \
    --joblog "$folder/logs/parts.txt" ./part
{})",
                    last_part(work), join))};
}

std::vector<FarmFile> make_files(const FarmWork& work) {
    std::string numbers;
    for (std::size_t part = 0; part < work.parts.size(); ++part)
        numbers += fmt::format(" {}", part);
    const std::string all = work.join.empty() ? "all: $(parts)\n" : "all: $(parts)\n\t./join\n";
    return {run_file("Draws all parts with make. ./run [JOBS]: parts at a time; default: one per "
                     "core",
                     "make", "exec make --jobs \"${1:-$(nproc)}\" --keep-going\n"),
            {"Makefile", fmt::format("# Draws all parts. Those with all pictures are left out.\n"
                                     "numbers :={}\n"
                                     "parts := $(numbers:%=part-%)\n"
                                     ".PHONY: all $(parts)\n"
                                     "{}"
                                     "$(parts): part-%:\n\t./part $*\n",
                                     numbers, all)}};
}

std::vector<FarmFile> slurm_files(const FarmWork& work) {
    std::vector<FarmFile> files;
    std::string run = fmt::format(
        R"(parts=$(sbatch --parsable --job-name={0} --array=0-{1} --requeue --chdir="$folder" \
    --output="$folder/logs/part-%a.txt" "$@" slurm-part)
parts=${{parts%%;*}}
echo "Submitted the parts as job $parts."
)",
        work.name, last_part(work));
    if (!work.join.empty())
        run += fmt::format(
            R"(join=$(sbatch --parsable --job-name={0}-join --dependency="afterok:$parts" --chdir="$folder" \
    --output="$folder/logs/join.txt" "$@" slurm-join)
echo "Submitted the join as job ${{join%%;*}}. It starts after the last part."
)",
            work.name);
    files.push_back(
        run_file("Submits all parts to Slurm. ./run [OPTIONS]: further options of "
                 "sbatch, such as --partition=NAME",
                 "sbatch", run));
    files.push_back({"slurm-part", R"(#!/bin/sh
# One part, as a task of the array. After a failure it is queued again, at most 3 times.
./part "$SLURM_ARRAY_TASK_ID" && exit 0
if [ "${SLURM_RESTART_COUNT:-0}" -lt 3 ]; then
    # Slurm ends this run.
    scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID" && exec sleep 60
fi
exit 1
)",
                     true});
    if (!work.join.empty())
        files.push_back({"slurm-join",
                         "#!/bin/sh\n"
                         "# Joins all pictures after the last part.\n"
                         "exec ./join\n",
                         true});
    return files;
}

std::string xml_escaped(std::string_view text) {
    std::string escaped;
    for (const char c : text)
        escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return escaped;
}

std::string opencue_layer(const char* name, const char* type, const std::string& command,
                          const std::string& range) {
    return fmt::format(
        "      <layer name=\"{}\" type=\"{}\">\n"
        "        <cmd>{}</cmd>\n"
        "        <range>{}</range>\n"
        "        <chunk>1</chunk>\n"
        "        <services><service>shell</service></services>\n"
        "      </layer>\n",
        name, type, xml_escaped(command), range);
}

// The order of the elements is that of the specification language, version 1.15.
std::vector<FarmFile> opencue_files(const FarmWork& work) {
    std::string layers =
        opencue_layer("parts", "Render", "@FOLDER@/part #IFRAME#", "0-" + last_part(work));
    std::string depends;
    if (!work.join.empty()) {
        layers += opencue_layer("join", "Post", "@FOLDER@/join", "1");
        depends = fmt::format(
            "  <depends>\n"
            "    <depend type=\"LAYER_ON_LAYER\">\n"
            "      <depjob>{0}</depjob>\n"
            "      <deplayer>join</deplayer>\n"
            "      <onjob>{0}</onjob>\n"
            "      <onlayer>parts</onlayer>\n"
            "    </depend>\n"
            "  </depends>\n",
            work.name);
    }
    return {run_file("Submits all parts to OpenCue. ./run [SHOW]; default: testing", "python3",
                     R"run(show=${1:-testing}
python3 - opencue.xml "$folder" "$show" "$(id -un)" "$(id -u)" <<'PROGRAM'
import shlex
import sys
from xml.sax.saxutils import escape

import opencue

file, folder, show, user, number = sys.argv[1:]
with open(file, encoding="utf-8") as opened:
    text = opened.read()
for name, value in (("FOLDER", shlex.quote(folder)), ("SHOW", show), ("USER", user), ("UID", number)):
    text = text.replace(f"@{name}@", escape(value))
for job in opencue.api.launchSpecAndWait(text):
    print("Submitted the job " + job.name() + ".")
PROGRAM
)run"),
            {"opencue.xml", fmt::format(R"(<?xml version="1.0"?>
<!DOCTYPE spec PUBLIC "SPI Cue Specification Language" "http://localhost:8080/spcue/dtd/cjsl-1.15.dtd">
<spec>
  <show>@SHOW@</show>
  <shot>afterglow</shot>
  <user>@USER@</user>
  <uid>@UID@</uid>
  <job name="{}">
    <paused>False</paused>
    <maxretries>3</maxretries>
    <layers>
{}    </layers>
  </job>
{}</spec>
)",
                                        work.name, layers, depends)}};
}

std::string command_line(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words)
        line += (line.empty() ? "" : " ") + shell_quoted(word);
    return line;
}

// The commands start where the user was. All other files are in the folder of the scripts.
std::string script_start(const FarmWork& work) {
    return fmt::format(
        "set -eu\n"
        "folder=$(cd \"$(dirname \"$0\")\" && pwd)\n"
        "export XDG_CACHE_HOME=\"$folder/cache\"\n"
        "cd {}\n",
        shell_quoted(work.directory.string()));
}

FarmFile part_file(const FarmWork& work) {
    std::string rows;
    for (std::size_t i = 0; i < work.parts.size(); ++i) {
        const FarmPart& part = work.parts[i];
        rows += fmt::format("{}) first={} end={} && set -- {} ;;\n", i, part.first, part.end,
                            command_line(part.arguments));
    }
    return {"part",
            fmt::format(R"(#!/bin/sh
# Draws one part of the pictures. ./part NUMBER, from 0 to {}. A part with all pictures is left out.
{}case ${{1:-}} in
{}*)
    echo "Usage: part NUMBER, from 0 to {}" >&2
    exit 2
    ;;
esac
frame=$first
while [ "$frame" -lt "$end" ] && [ -s "$folder/frames/$(printf %04d "$frame").png" ]; do
    frame=$((frame + 1))
done
[ "$frame" -lt "$end" ] || exit 0
exec {} "$@" --output "$folder/frames/%04d.png"
)",
                        last_part(work), script_start(work), rows, last_part(work),
                        command_line(work.command)),
            true};
}

FarmFile join_file(const FarmWork& work) {
    return {"join",
            fmt::format("#!/bin/sh\n"
                        "# Makes one file of all pictures.\n"
                        "{}exec {} --frames-from \"$folder/frames/%04d.png\"\n",
                        script_start(work), command_line(work.join)),
            true};
}

tl::unexpected<Diagnostics> not_made(const fs::path& folder, const std::error_code& error) {
    return fail({folder, 0, fmt::format("the folder can't be made: {}", error.message())});
}
}  // namespace

const std::vector<FarmEngine>& farm_engines() {
    static const std::vector<FarmEngine> engines{
        {"slurm", slurm_files},
        {"parallel", parallel_files},
        {"make", make_files},
        {"opencue", opencue_files},
    };
    return engines;
}

std::vector<FarmFile> farm_files(const FarmWork& work, const FarmEngine& engine) {
    std::vector<FarmFile> files = engine.files(work);
    files.push_back(part_file(work));
    if (!work.join.empty())
        files.push_back(join_file(work));
    return files;
}

Result<void> write_farm_folder(const fs::path& folder, const FarmWork& work,
                               const FarmEngine& engine) {
    std::error_code error;
    if (fs::exists(folder, error) &&
        !(fs::is_directory(folder, error) && fs::is_empty(folder, error)))
        return fail({folder, 0, "the folder is not empty; choose another one, or delete it"});
    for (const char* name : {"frames", "logs"})
        if (fs::create_directories(folder / name, error); error)
            return not_made(folder / name, error);
    for (const FarmFile& file : farm_files(work, engine)) {
        if (auto written = write_atomically(folder / file.name, file.text); !written)
            return written;
        if (file.is_executable)
            fs::permissions(folder / file.name,
                            fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                            fs::perm_options::add, error);
        if (error)
            return not_made(folder / file.name, error);
    }
    return {};
}
