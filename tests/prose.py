"""Checks the wording of all texts that users read: window, command line, looks and docs.

Phrases that read like a translation are errors, with exceptions listed here. In the docs, a sentence
has at most 35 words (a warning from 26), a line at most 160 characters outside tables, and a table
cell at most two sentences. The README has at most 80 lines. The targets of links must exist.
"""

import re
import sys
from pathlib import Path

PHRASES = [
    r"(?<!there )\b(is|are) no (?!longer|more)",
    r"\banew\b",
    r"\b(no|some)body\b",
    r"there is such",
    r"as many as",
    r"\bso many\b",
    r"in the place of",
]
PHRASE = re.compile("|".join(f"({phrase})" for phrase in PHRASES), re.IGNORECASE)

# Texts that stay although they contain a phrase: (file, part of the text, reason).
EXCEPTIONS = [
    ("presets/phosphor/article-mono.json", "in the place of four", "descriptions of presets stay"),
]

AIMED_WORDS = 25
MOST_WORDS = 35
MOST_COLUMNS = 160
MOST_CELL_SENTENCES = 2
MOST_README_LINES = 80

LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
ANNOTATED = re.compile(r"@(?:label|help|group|items|unit)\b((?:\s+\"[^\"]*\")+)")
ABBREVIATIONS = re.compile(r"\b(e\.g|i\.e|etc|vs|approx|Fig|No|cf)\.")


def code_texts(text):
    """(line, text) of each string literal of C++ code. Adjacent literals are one text."""
    texts = []
    open_text, open_line = "", 0
    for number, line in enumerate(text.split("\n"), 1):
        if line.lstrip().startswith(("//", "#include")):
            continue
        position = 0
        for match in LITERAL.finditer(line):
            if open_text and line[position : match.start()].strip():
                texts.append((open_line, open_text))
                open_text = ""
            if not open_text:
                open_line = number
            open_text += match.group(1)
            position = match.end()
        if open_text and line[position:].strip():
            texts.append((open_line, open_text))
            open_text = ""
    if open_text:
        texts.append((open_line, open_text))
    return texts


def shader_texts(text):
    """(line, text) of each text in the annotations of a shader."""
    return [
        (number, quoted)
        for number, line in enumerate(text.split("\n"), 1)
        for match in ANNOTATED.finditer(line)
        for quoted in re.findall(r'"([^"]*)"', match.group(1))
    ]


def json_texts(text):
    """(line, text) of each string with a space in a look.json or preset."""
    return [
        (number, quoted)
        for number, line in enumerate(text.split("\n"), 1)
        for quoted in LITERAL.findall(line)
        if " " in quoted
    ]


def script_texts(text):
    """(line, text) of each line of a shell script that is not a comment."""
    return [
        (number, line)
        for number, line in enumerate(text.split("\n"), 1)
        if not line.lstrip().startswith("#")
    ]


def bare(text):
    """Markdown without its markup. A span of code counts as one word, a link as its text."""
    text = re.sub(r"``[^`].*?``|`[^`]*`", "CODE", text)
    text = re.sub(r"<[^>]*>", "", text)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return re.sub(r"[*_]{1,3}", "", text)


def without_code(text):
    """Markdown with empty fenced code. Lines keep their numbers."""
    fenced = re.compile(r"^\s*```.*?^\s*```\s*$", re.DOTALL | re.MULTILINE)
    return fenced.sub(lambda code: "\n" * code.group().count("\n"), text)


def paragraphs(text):
    """(line, text, is_cell) of each paragraph, list item, heading and table cell of Markdown."""
    found, lines, start = [], [], 0

    def close():
        if lines:
            found.append((start, " ".join(lines), False))
            lines.clear()

    for number, line in enumerate(without_code(text).split("\n"), 1):
        stripped = line.strip()
        if stripped.startswith("|"):
            close()
            if not re.fullmatch(r"[|:\- ]+", stripped):
                shielded = re.sub(r"`[^`]*`", lambda span: span.group().replace("|", " "), stripped)
                cells = re.split(r"(?<!\\)\|", shielded.strip("|"))
                found.extend((number, cell.strip(), True) for cell in cells)
        elif not stripped or stripped.startswith("<!--"):
            close()
        else:
            if re.match(r"([-*+]|\d+\.|#+|>)\s", stripped):
                close()
                stripped = re.sub(r"^([-*+]|\d+\.|#+|>)\s+", "", stripped)
            if not lines:
                start = number
            lines.append(stripped)
    close()
    return found


def sentences(text):
    """The sentences of a paragraph of Markdown."""
    text = ABBREVIATIONS.sub(r"\1", bare(text))
    return [part for part in re.split(r"(?<=[.!?:])[\"')]*\s+(?=\S)", text) if part.strip()]


def count_words(sentence):
    return len(re.findall(r"[\w’'.,/×%°+-]*\w[\w’'.,/×%°+-]*", sentence))


def is_excepted(file, text):
    return any(file == excepted and part in text for excepted, part, _ in EXCEPTIONS)


def phrase_problems(file, texts):
    return [
        f"{file}:{line}: error: '{match.group().strip()}' reads like a translation: {text.strip()}"
        for line, text in texts
        if not is_excepted(file, text)
        for match in PHRASE.finditer(text)
    ]


def page_problems(file, text):
    """Errors of one page of the docs, and the warnings for its long sentences."""
    errors = phrase_problems(file, [(line, bare(part)) for line, part, _ in paragraphs(text)])
    warnings = []
    for line, part, is_cell in paragraphs(text):
        if is_excepted(file, part):
            continue
        found = sentences(part)
        for sentence in found:
            words = count_words(sentence)
            if words > MOST_WORDS:
                errors.append(f"{file}:{line}: error: a sentence of {words} words: {sentence}")
            elif words > AIMED_WORDS:
                warnings.append(f"{file}:{line}: warning: a sentence of {words} words: {sentence}")
        if is_cell and len(found) > MOST_CELL_SENTENCES:
            errors.append(f"{file}:{line}: error: a table cell of {len(found)} sentences: {part}")
    for number, line in enumerate(without_code(text).split("\n"), 1):
        if len(line) > MOST_COLUMNS and not line.lstrip().startswith("|"):
            errors.append(f"{file}:{number}: error: a line of {len(line)} characters")
    return errors, warnings


def anchors(text):
    """The anchors of the headings of a page, as Markdown viewers generate them."""
    headings = re.findall(r"^#+\s+(.*)$", without_code(text), re.MULTILINE)
    return {
        re.sub(r"[^\w\- ]", "", bare_heading(heading)).strip().lower().replace(" ", "-")
        for heading in headings
    }


def bare_heading(heading):
    return re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "")


def named_test_problems(root, page, text):
    """Tests that a page names, such as `test_nothing_is_overwritten`, and that do not exist."""
    named = {(number, name) for number, line in enumerate(text.split("\n"), 1)
             for name in re.findall(r"`(test_\w+)`", line)}
    if not named:
        return []
    code = "\n".join(file.read_text(encoding="utf-8") for file in root.glob("tests/**/*.py"))
    known = set(re.findall(r"def (test_\w+)\(", code))
    return [f"{page.relative_to(root)}:{number}: error: there is no test '{name}'"
            for number, name in sorted(named) if name not in known]


def link_problems(root, page, text):
    """Links of a page to files and headings of the tree that do not exist."""
    errors = []
    for number, line in enumerate(without_code(text).split("\n"), 1):
        for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
            if re.match(r"[a-z]+:", target):
                continue
            path, _, anchor = target.partition("#")
            file = (page.parent / path) if path else page
            is_found = file.exists() and (
                not anchor or anchor in anchors(file.read_text(encoding="utf-8"))
            )
            if not is_found:
                name = page.relative_to(root)
                errors.append(f"{name}:{number}: error: the link '{target}' leads nowhere")
    return errors


def check_tree(root):
    """(errors, warnings) of all texts below `root`."""
    root = Path(root)
    errors, warnings = [], []

    def read(file):
        return file.read_text(encoding="utf-8")

    for folder, suffixes, texts_of in (
        ("app", {".h", ".cpp"}, code_texts),
        ("shaders", {".glsl", ".vert", ".frag"}, shader_texts),
        ("shaders", {".json"}, json_texts),
        ("presets", {".json"}, json_texts),
    ):
        for file in sorted(root.glob(f"{folder}/**/*")):
            if file.suffix in suffixes:
                errors += phrase_problems(str(file.relative_to(root)), texts_of(read(file)))
    if (root / "run").exists():
        errors += phrase_problems("run", script_texts(read(root / "run")))
    pages = [*sorted(root.glob("*.md")), *sorted(root.glob("docs/**/*.md")), root / "third_party/README.md"]
    for page in pages:
        if page.exists():
            found, warned = page_problems(str(page.relative_to(root)), read(page))
            errors += found + link_problems(root, page, read(page)) + named_test_problems(root, page, read(page))
            warnings += warned
    readme = root / "README.md"
    if readme.exists() and len(read(readme).splitlines()) > MOST_README_LINES:
        errors.append(f"README.md: error: more than {MOST_README_LINES} lines")
    return errors, warnings


if __name__ == "__main__":
    all_errors, all_warnings = check_tree(sys.argv[1] if len(sys.argv) > 1 else ".")
    print("\n".join(all_warnings + all_errors))
    sys.exit(1 if all_errors else 0)
