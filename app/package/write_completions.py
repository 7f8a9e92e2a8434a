"""Writes the completions for bash, zsh and fish: write_completions.py PROGRAM FOLDER.

They are made from the output of --help. The names of looks, presets, signals and patterns are asked from the
program when they are completed. FOLDER gets the folders share/bash-completion, share/zsh and share/fish.
"""

import re
import subprocess
import sys
from pathlib import Path

OPTION = re.compile(r"^  (?:(-\w), )?(--[\w-]+)(?: (.+?))?(?:  +(.*))?$")
LISTED = {"PRESET": "presets", "SIGNAL": "signals", "SOURCE": "patterns"}
FILES = ("FILE", "PATH", "FOLDER", "DIR", "SOURCE", "PRESET", "SHOT", "LOOK")
WORDS = {("list", "WHAT"): "looks presets signals patterns", ("export", "TARGET"): "portable web slang isf shadertoy mpv reshade",
         ("render", "WxH"): "720p 1080p 1440p 2160p square portrait"}


def help_of(program, *command):
    return subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True).stdout


def section(text, title):
    return text.partition(f"\n{title}:\n")[2].partition("\n\n")[0].splitlines()


def options_of(text):
    """(short name, long name, value, help) of each option; "" if it has none."""
    options = []
    for line in section(text, "Options"):
        if found := OPTION.match(line):
            options.append([part or "" for part in found.groups()])
        elif options:
            options[-1][3] = (options[-1][3] + " " + line.strip()).strip()
    return options


def argument_of(text):
    """The name of the first positional argument, or ""."""
    lines = section(text, "Arguments")
    return lines[0].split()[0] if lines else ""


def choices(command, value):
    """The words that a value can be, or the list of the program that has them, and whether it can be a file."""
    value = value.rstrip(".").strip("[]")
    words = WORDS.get((command, value)) or (WORDS[("render", "WxH")] if value == "WxH" else "")
    listed = "looks" if value == "LOOK" else LISTED.get(value, "")
    return words, listed, value in FILES or "FILE" in value or "FOLDER" in value


def bash(commands):
    lines = ["# bash completion for afterglow", "", "_afterglow_names()", "{",
             "    afterglow list \"$1\" 2>/dev/null | sed 's/  .*//; s|^.*/||'", "}", "", "_afterglow()", "{",
             "    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command= word",
             "    for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do", "        case $word in",
             f"            {'|'.join(name for name in commands if name)}) command=$word; break ;;", "        esac",
             "    done", "    local words= list= files=", "    case $command in"]
    for name, text in commands.items():
        options = options_of(text)
        lines.append(f"        {name or chr(39) * 2})")
        lines.append("            case $previous in")
        for short, long, value, _ in options:
            if value:
                words, listed, files = choices(name, value)
                lines.append(f"                {'|'.join(filter(None, (short, long)))}) words='{words}' list='{listed}' "
                             f"files='{'yes' if files else ''}' ;;")
        words, listed, files = choices(name, argument_of(text))
        names = " ".join(command for command in commands if command) if not name else ""
        every = " ".join(long for _, long, _, _ in options)
        lines += ["                *)", f"                    words='{words} {names} {every}'",
                  f"                    list='{listed}' files='{'yes' if files else ''}' ;;", "            esac", "            ;;"]
    lines += ["    esac", "    if [[ -n $list && $current != -* ]]; then words+=\" $(_afterglow_names \"$list\")\"; fi",
              "    local IFS=$' \\t\\n'", "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))",
              "    if [[ -n $files && $current != -* ]]; then",
              "        local IFS=$'\\n'", "        COMPREPLY+=($(compgen -f -- \"$current\"))", "        compopt -o filenames 2>/dev/null",
              "    fi", "}", "", "complete -F _afterglow afterglow", ""]
    return "\n".join(lines)


def quoted(text, marks):
    for mark in marks:
        text = text.replace(mark, "\\" + mark)
    return text.replace("'", "'\\''")


def zsh_action(command, value):
    words, listed, files = choices(command, value)
    if listed:
        return f"_afterglow_{listed}{'_or_files' if files else ''}"
    return f"({words})" if words else "_files" if files else ""


def zsh(commands):
    lines = ["#compdef afterglow", ""]
    for listed in ("looks", "presets", "signals", "patterns"):
        lines += [f"_afterglow_{listed}() {{", "    local -a names",
                  f"    names=(${{(f)\"$(afterglow list {listed} 2>/dev/null | sed 's/  .*//; s|^.*/||')\"}})",
                  "    compadd -a names", "}", f"_afterglow_{listed}_or_files() {{ _afterglow_{listed}; _files }}"]
    for name, text in commands.items():
        lines += ["", f"_afterglow_command_{name or 'none'}() {{", "    _arguments \\"]
        for short, long, value, about in options_of(text):
            value_text = f":{quoted(value, ':')}:{zsh_action(name, value)}" if value else ""
            names = f"({short} {long})'{{{short},{long}}}'" if short else long
            many = "*" if "(repeatable)" in about else ""
            lines.append(f"        '{many}{names}[{quoted(about, ':[]')}]{value_text}' \\")
        if not name:
            lines.append("        '1: :_afterglow_first' '*:: :_files'")
        else:
            argument = argument_of(text)
            lines.append(f"        '*:{argument.lower() or 'nothing'}:{zsh_action(name, argument)}'")
        lines.append("}")
    lines += ["", "_afterglow_first() {", "    local -a commands", "    commands=("]
    for line in section(commands[""], "Commands"):
        name, _, about = line.strip().partition(" ")
        if name in commands:
            lines.append(f"        '{name}:{quoted(about.strip(), ':')}'")
    lines += ["    )", "    _describe command commands", "    _afterglow_looks_or_files", "}", "",
              "_afterglow() {", "    local word", "    for word in ${words[2,CURRENT-1]}; do",
              "        if (( $+functions[_afterglow_command_$word] )); then",
              "            _afterglow_command_$word", "            return", "        fi", "    done",
              "    _afterglow_command_none", "}", "", "_afterglow \"$@\"", ""]
    return "\n".join(lines)


def fish(commands):
    names = " ".join(name for name in commands if name)
    lines = ["# fish completion for afterglow", "", "function __afterglow_names",
             "    afterglow list $argv[1] 2>/dev/null | string replace -r '  .*' '' | string replace -r '^.*/' ''", "end", ""]
    for line in section(commands[""], "Commands"):
        name, _, about = line.strip().partition(" ")
        if name in commands:
            lines.append(f"complete -c afterglow -n 'not __fish_seen_subcommand_from {names}' -a {name} "
                         f"-d '{about.strip().replace(chr(39), chr(92) + chr(39))}'")
    for name, text in commands.items():
        seen = f"-n '__fish_seen_subcommand_from {name}'" if name else f"-n 'not __fish_seen_subcommand_from {names}'"
        for short, long, value, about in options_of(text):
            words, listed, files = choices(name, value) if value else ("", "", False)
            offered = f" -a '(__afterglow_names {listed})'" if listed else f" -a '{words}'" if words else ""
            lines.append(f"complete -c afterglow {seen} -l {long[2:]}" + (f" -s {short[1:]}" if short else "") +
                         (" -r" if value else "") + (" -F" if files else " -f" if value else "") + offered +
                         f" -d '{about.replace(chr(39), chr(92) + chr(39))}'")
        words, listed, _ = choices(name, argument_of(text))
        if listed or words:
            offered = f"(__afterglow_names {listed})" if listed else words
            lines.append(f"complete -c afterglow {seen} {'' if listed else '-f '}-a '{offered}'")
    return "\n".join(lines) + "\n"


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    text = help_of(program)
    names = [line.split()[0] for line in section(text, "Commands") if line[2:3].strip()]
    commands = {"": text, **{name: help_of(program, name) for name in names}}
    for place, write in (("bash-completion/completions/afterglow", bash), ("zsh/vendor-completions/_afterglow", zsh),
                         ("fish/vendor_completions.d/afterglow.fish", fish)):
        file = folder / "share" / place
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(write(commands))


main()
