"""Rules of the source tree that can be checked in its text.

layers.py ROOT prints one "file:line: error: message" for every breach, and exits with 1 if there is
one. A layer includes only the layers in its USES line of app/CMakeLists.txt. A room includes only
itself and the rooms before it in the ROOMS line. System calls are used only in io/ and gpu/, GL, EGL
and GLFW only in gpu/, Dear ImGui only in ui/. A file has at most 500 lines, a function at most 60. No
file names a package host.
"""

import ast
import os
import re
import sys
from pathlib import Path

MOST_FILE_LINES = 500
MOST_FUNCTION_LINES = 60
CODE = {".cpp", ".h"}
SHADERS = {".frag", ".vert", ".glsl"}
TEXT = CODE | SHADERS | {".py", ".cmake", ".txt", ".md", ".json", ".yml", ""}

SYSTEM_HEADER = re.compile(
    r"#\s*include\s*[<\"]((unistd|fcntl|dlfcn|poll|signal|pwd|grp|spawn|glob|dirent|pthread|sched|semaphore|termios"
    r"|netdb|ifaddrs|fnmatch|ftw|wordexp|execinfo|link|utime|syslog|strings)\.h\b|csignal\b"
    r"|(arpa|net|netinet|sys|linux|asm)/)"
)
# Code that belongs to some layers: the layers, its pattern, and its name in messages.
OWNED = [
    (["gpu"], re.compile(r"\bgl[A-Z]\w*\s*\("), "a GL call"),
    (["gpu"], re.compile(r"\begl[A-Z]\w*"), "an EGL call"),
    (["gpu"], re.compile(r"\bglfw[A-Z]\w*"), "a GLFW call"),
    (["gpu"], re.compile(r'#\s*include\s*[<"](GL|EGL|GLES\d?|GLFW|epoxy)/'), "a header of GL, EGL or GLFW"),
    (["ui"], re.compile(r"\bImGui"), "Dear ImGui"),
    (["ui"], re.compile(r'#\s*include\s*[<"](\w+/)*(imgui|imconfig)'), "a header of Dear ImGui"),
    (["io", "gpu"], SYSTEM_HEADER, "a header of POSIX or Linux"),
    (["io", "gpu"], re.compile(r"\b((un)?setenv|putenv|(localtime|gmtime)_r|popen)\s*\("), "a POSIX call"),
]
# The same, also in comments and strings.
OWNED_IN_TEXT = [(["io", "gpu"], re.compile(r"/(proc|sys)/"), "a file of Linux")]
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
PACKAGE_HOST = re.compile(r"https?://([\w-]+\.)*(deb|ftp|pypi|registry|snapshot|archive|packages|mirrors?)\.\w")
NOT_CODE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'',
    re.DOTALL,
)
NOT_A_FUNCTION = re.compile(r"^(if|else|for|while|switch|do|try|catch|namespace|class|struct|enum|union|extern)\b")


def read_keyword(cmake_text, keyword):
    """The words after a keyword in each add_layer line: {"model": ["base"], ...}."""
    cmake_text = re.sub(r"#[^\n]*", "", cmake_text)
    found = {}
    for name, rest in re.findall(r"^add_layer\(\s*(\w+)([^)]*)\)", cmake_text, re.MULTILINE):
        words = re.search(rf"\b{keyword}\b(.*?)(\b(USES|ROOMS|LINKS|PRECOMPILES)\b|$)", rest, re.DOTALL)
        found[name] = words.group(1).split() if words else []
    return found


def read_layers(cmake_text):
    """The layers that each layer may include: {"model": {"base"}, ...}."""
    return {name: set(uses) for name, uses in read_keyword(cmake_text, "USES").items()}


def read_rooms(cmake_text):
    """The rooms of each layer from the lowest to the highest; "." is the layer's own folder."""
    return read_keyword(cmake_text, "ROOMS")


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def without_comments_and_strings(text):
    """The text with comments and strings blanked. Lines and names in #include lines are kept."""

    def blank(match):
        start = text.rfind("\n", 0, match.start()) + 1
        if text[start : match.start()].lstrip().startswith("#") and match.group()[0] == '"':
            return match.group()
        return re.sub(r"[^\n]", " ", match.group())

    return NOT_CODE.sub(blank, text)


def check_includes(layer, code, layers):
    allowed = layers[layer] | {layer}
    for match in INCLUDE.finditer(code):
        folder, slash, _ = match.group(1).partition("/")
        line = line_of(code, match.start(1))
        if not slash or folder not in layers:
            yield line, f'#include "{match.group(1)}" does not name a layer and a file'
        elif folder not in allowed:
            yield line, f"{layer} may not include {folder}: it is not in its USES"


def check_rooms(layer, room, code, order):
    """A room may include itself and the rooms before it in the order of its layer."""
    if not order and room == ".":
        return
    if room not in order:
        yield 0, f"{layer}/{room} is not in the ROOMS of {layer} in app/CMakeLists.txt"
        return
    for match in INCLUDE.finditer(code):
        folder, *rooms, _ = match.group(1).split("/") if "/" in match.group(1) else ("", "")
        other = "/".join(rooms) or "."
        if folder == layer and other in order and order.index(other) > order.index(room):
            yield line_of(code, match.start(1)), f"{layer}/{room} may not include {layer}/{other}: it is above it"


def check_owned(layer, code, owned):
    for number, line in enumerate(code.split("\n"), 1):
        for owners, pattern, what in owned:
            found = pattern.search(line)
            if found and layer not in owners:
                places = " or ".join(f"{owner}/" for owner in owners)
                yield number, f"'{found.group().strip()}' is {what}, which belongs in {places}"


def is_function(header):
    return (
        "(" in header
        and header.count("(") == header.count(")")
        and not NOT_A_FUNCTION.match(header)
        and not re.search(r"[=,(]$|\breturn$", header)
    )


def check_functions(code):
    """Checks the lengths of functions, lambdas and test cases, from the name to the closing brace."""
    code = re.sub(r"^[ \t]*#[^\n]*", "", code, flags=re.MULTILINE)
    stack = []
    begin = 0  # of the current statement
    depth = 0  # of parentheses: the ';' in for (;;) do not end a statement
    for match in re.finditer(r"[{};()]", code):
        position = match.start()
        depth += {"(": 1, ")": -1}.get(match.group(), 0)
        if match.group() == "{":
            header = code[begin:position]
            start = begin + len(header) - len(header.lstrip())
            stack.append((line_of(code, start), is_function(header.strip())))
        elif match.group() == "}" and stack:
            first, counts = stack.pop()
            length = line_of(code, position) - first + 1
            if counts and length > MOST_FUNCTION_LINES:
                yield first, f"a function of {length} lines; {MOST_FUNCTION_LINES} are the most"
        if match.group() in "{}" or (match.group() == ";" and depth <= 0):
            begin = match.end()


def check_python_functions(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef):
            length = node.end_lineno - node.lineno + 1
            if length > MOST_FUNCTION_LINES:
                yield node.lineno, f"a function of {length} lines; {MOST_FUNCTION_LINES} are the most"


def check_file(path, text, layers, rooms):
    """The breaches in one file: pairs of a line and a message. `path` is relative to the root."""
    lines = text.count("\n")
    if path.suffix != ".md" and lines > MOST_FILE_LINES:
        yield 0, f"{lines} lines; {MOST_FILE_LINES} are the most"
    for match in PACKAGE_HOST.finditer(text):
        yield line_of(text, match.start()), "names a host of packages; packages have names of their own"
    if path.suffix in CODE | SHADERS:
        code = without_comments_and_strings(text)
        yield from check_functions(code)
        if path.parts[0] == "app":
            layer = path.parts[1] if len(path.parts) > 2 else ""
            yield from check_owned(layer, code, OWNED)
            yield from check_owned(layer, text, OWNED_IN_TEXT)
            if layer in layers:
                yield from check_includes(layer, code, layers)
                yield from check_rooms(layer, "/".join(path.parts[2:-1]) or ".", code, rooms[layer])
    elif path.suffix == ".py":
        yield from check_python_functions(text)


def files_of(root):
    for folder, folders, names in os.walk(root):
        folders[:] = [name for name in sorted(folders) if name not in {".git", "build", "__pycache__"}]
        for name in sorted(names):
            path = Path(folder, name)
            if path.suffix in TEXT and not path.is_symlink():
                yield path


def folders_without_a_layer(root, layers):
    folders = {file.relative_to(root).parts[1] for file in Path(root, "app").glob("*/**/*.cpp")}
    return [f"app/{name}: error: app/CMakeLists.txt has no add_layer({name} ...)"
            for name in sorted(folders - set(layers))]


def check_tree(root):
    """Every breach in the tree, as "file:line: error: message"."""
    build_text = Path(root, "app", "CMakeLists.txt").read_text(encoding="utf-8")
    layers, rooms = read_layers(build_text), read_rooms(build_text)
    breaches = [] if layers else ["app/CMakeLists.txt: error: has no add_layer lines"]
    breaches += folders_without_a_layer(root, layers)
    for file in files_of(root):
        path = file.relative_to(root)
        text = file.read_text(encoding="utf-8", errors="replace")
        for line, message in check_file(path, text, layers, rooms):
            breaches.append(f"{path}:{line}: error: {message}" if line else f"{path}: error: {message}")
    return breaches


if __name__ == "__main__":
    found = check_tree(sys.argv[1] if len(sys.argv) > 1 else ".")
    print("\n".join(found), end="\n" if found else "")
    sys.exit(1 if found else 0)
