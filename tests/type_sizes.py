"""Limits on the size of the types in app/.

type_sizes.py ROOT prints one "file:line: error: message" for every breach, and exits with 1 if there is
one. A type has at most 20 public functions and 15 data members. Inherited, static, friend and nested
functions count; constructors, destructors and operators do not. Overloads count once. Inherited data
counts, static data does not. Plain values, with public data and without functions, are exempt. A type is
defined in one file, and its functions in at most one .cpp.

type_sizes.py ROOT TYPE prints what counts for a type.
"""

import sys
from collections import defaultdict
from pathlib import Path

import cpp_types

MOST_FUNCTIONS = 20
MOST_MEMBERS = 15

# Types beyond a limit: {type: (the limits, reason)}. The limits are "functions", "members", "files" for
# functions in more than one .cpp, and "headers" for definitions in more than one .h.
EXCEPTIONS = {}


class Tree:
    """All types of app/, and the files that define their functions."""

    def __init__(self, root):
        self.types = defaultdict(list)
        self.files = defaultdict(set)  # by the name and file of the type
        sources = []
        for file in sorted(Path(root, "app").glob("**/*")):
            if file.suffix in {".h", ".cpp"}:
                text = file.read_text(encoding="utf-8", errors="replace")
                sources.append(cpp_types.Source(str(file.relative_to(root)), text))
        for source in sources:
            for one in source.types:
                self.types[one.name].append(one)
        for source in sources:
            for definition in source.definitions:
                owner = self.find(definition.scope, definition.owner, source.file)
                while owner:  # functions of a nested type are also those of the type around it
                    self.files[owner.name, owner.file].add(source.file)
                    owner = self.named(owner.name.rpartition("::")[0], source.file)

    def named(self, name, file):
        """The type with this whole name, as a file means it: its own one or that of a header."""
        return min(
            self.types.get(name, []),
            key=lambda one: (one.file != file, not one.file.endswith(".h"), one.file),
            default=None,
        )

    def find(self, scope, name, file):
        """The type that a name means in a scope of a file; None if it is not in app/."""
        while True:
            found = self.named(cpp_types.joined(scope, name), file)
            if found or not scope:
                return found
            scope = scope.rpartition("::")[0]

    def bases(self, one):
        """Pairs of access and base. Bases from libraries are left out."""
        found = [(access, self.find(one.scope, name, one.file)) for access, name in one.bases]
        return [(access, base) for access, base in found if base and base is not one]

    def functions(self, one):
        """The names of all public functions. Those of nested types start with the type's name."""
        found = one.functions | one.friends
        no_functions = set()
        for access, base in self.bases(one):
            no_functions |= {*self.members(base), *base.nested}
            if access == "public":
                found |= self.functions(base)
        found |= one.used - no_functions
        for name, access in one.nested.items():
            inner = self.named(f"{one.name}::{name}", one.file)
            if inner and access == "public":
                found |= {f"{name}::{function}" for function in self.functions(inner)}
        return found

    def members(self, one):
        """The names of all data members."""
        return [name for _, base in self.bases(one) for name in self.members(base)] + one.members

    def is_plain_value(self, one):
        """Whether a type has only public data, and no functions."""
        return (
            one.is_plain
            and not self.functions(one)
            and all(access == "public" and self.is_plain_value(base) for access, base in self.bases(one))
        )

    def breaches(self, one):
        """Pairs of a limit that a type exceeds, and a message."""
        functions, members = len(self.functions(one)), len(self.members(one))
        if not self.is_plain_value(one):
            if functions > MOST_FUNCTIONS:
                yield "functions", f"{one.name} has {functions} public functions; {MOST_FUNCTIONS} are the most"
            if members > MOST_MEMBERS:
                yield "members", f"{one.name} has {members} data members; {MOST_MEMBERS} are the most"
        files = sorted(self.files[one.name, one.file] - {one.file})
        if len(files) > 1 or any(file.endswith(".h") for file in files):
            yield "files", f"functions of {one.name} are in {', '.join(files)}; one .cpp is the most"
        others = sorted(other.file for other in self.types[one.name] if other.file != one.file)
        headers = [file for file in others if file.endswith(".h")]
        if one.file.endswith(".h") and headers:
            yield "headers", f"{one.name} is also defined in {', '.join(headers)}"


def check_exceptions(exceptions, exceeded):
    """Exceptions that no type needs, or that have no reason."""
    for name, (limits, reason) in exceptions.items():
        if not reason:
            yield f"the exception for {name} has no reason"
        for limit in limits.split(", "):
            if limit not in exceeded[name]:
                yield f"the exception for {name} is not needed for {limit}: remove it"


def check_tree(root, exceptions):
    """Every breach in the tree, as "file:line: error: message"."""
    tree = Tree(root)
    found = []
    exceeded = defaultdict(set)
    for one in sorted((one for same in tree.types.values() for one in same), key=lambda one: (one.file, one.line)):
        for limit, message in tree.breaches(one):
            exceeded[one.name].add(limit)
            if limit not in exceptions.get(one.name, ("", ""))[0].split(", "):
                found.append(f"{one.file}:{one.line}: error: {message}")
    return found + [f"tests/type_sizes.py: error: {message}" for message in check_exceptions(exceptions, exceeded)]


def describe(root, name):
    """What counts for the types with a name, as lines of text."""
    tree = Tree(root)
    for one in tree.types.get(name, []):
        functions, members = sorted(tree.functions(one)), tree.members(one)
        yield f"{one.file}:{one.line}: {name}"
        yield f"{len(functions)} public functions: {', '.join(functions)}"
        yield f"{len(members)} data members: {', '.join(members)}"


if __name__ == "__main__":
    if len(sys.argv) > 2:
        print("\n".join(describe(*sys.argv[1:3])))
        sys.exit(0)
    errors = check_tree(sys.argv[1] if len(sys.argv) > 1 else ".", EXCEPTIONS)
    print("\n".join(errors), end="\n" if errors else "")
    sys.exit(1 if errors else 0)
