"""Reads the classes, structs and unions in the text of a C++ file. type_sizes.py uses it.

Source(file, text) understands the C++ of this tree: it matches brackets and reads declarations. It does
not know macros, headers of libraries and aliases of types.
"""

import re
from dataclasses import dataclass, field

from layers import without_comments_and_strings

WORD = re.compile(r"[A-Za-z_]\w*|\d[\w.']*|::|->|\S")
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
CLOSING = {"(": ")", "[": "]", "{": "}"}
KEYS = {"class", "struct", "union"}
ACCESSES = {"public", "protected", "private"}
SPECIFIERS = {"const", "constexpr", "explicit", "extern", "friend", "inline", "mutable", "static", "virtual"}
NOT_PARAMETERS_AFTER = {"decltype", "explicit", "noexcept", "requires"}
NOT_NAMES = KEYS | {"const", "noexcept", "volatile"}
BUILT_IN = {"auto", "bool", "char", "double", "float", "int", "long", "short", "signed", "unsigned"}


@dataclass
class Type:
    """A class, struct or union. Constructors, destructors and operators are left out."""

    scope: str  # the namespaces and types around it
    own_name: str
    file: str
    line: int
    bases: list = field(default_factory=list)  # (access, name)
    functions: set = field(default_factory=set)  # names of public ones
    friends: set = field(default_factory=set)  # names of friend functions
    members: list = field(default_factory=list)  # names of data members that are not static
    used: set = field(default_factory=set)  # names of public using-declarations
    nested: dict = field(default_factory=dict)  # access of each nested type, also if only declared
    is_plain: bool = True  # has only public data

    @property
    def name(self):
        return joined(self.scope, self.own_name)


@dataclass
class Definition:
    """The place of a member function that is defined outside its class."""

    scope: str  # the namespaces around it
    owner: str  # the class, as the code names it


def is_name(word):
    return word[0].isalpha() or word[0] == "_"


def joined(scope, name):
    return f"{scope}::{name}" if scope and name else scope or name


class Declaration:
    """What one statement declares: data, or one function."""

    def __init__(self, specifiers):
        self.specifiers = specifiers
        self.function = ""  # "operator" or "~" for operators and destructors
        self.owner = ""  # the class before the function's name
        self.names = []  # of data
        self.is_defined = False
        self.is_deleted = False


class Source:
    """The types and the definitions of member functions in a file."""

    def __init__(self, file, text):
        self.file = file
        self.types = []
        self.definitions = []
        self.words = []
        self.lines = []
        code = without_comments_and_strings(text)
        code = DIRECTIVE.sub(lambda directive: re.sub(r"[^\n]", " ", directive.group()), code)
        for number, line in enumerate(code.split("\n"), 1):
            words = WORD.findall(line)
            self.words += words
            self.lines += [number] * len(words)
        end = len(self.words)
        self.words += [";", ";"]
        self.lines += [0, 0]
        self.closing = self.match_brackets(end)
        self.read_scope(0, end, "")

    def match_brackets(self, end):
        """The index of the closing bracket of each opening one."""
        found, opened = {}, []
        for index, word in enumerate(self.words):
            if word in CLOSING:
                opened.append(index)
            elif opened and word == CLOSING[self.words[opened[-1]]]:
                found[opened.pop()] = index
        found.update((index, end) for index in opened)
        return found

    def behind(self, index):
        """The index behind a word, or behind the brackets that it opens."""
        return self.closing.get(index, index) + 1

    def behind_angles(self, index):
        """The index behind the template arguments that "<" opens; None if it means "less"."""
        depth = 0
        while self.words[index] not in (";", "}", ")"):
            depth += {"<": 1, ">": -1}.get(self.words[index], 0)
            index = self.behind(index)
            if depth == 0:
                return index
        return None

    def behind_statement(self, index):
        while self.words[index] != ";":
            index = self.behind(index)
        return index + 1

    def behind_prefixes(self, index):
        """The index behind "template <...>", "[[...]]" and "alignas(...)"."""
        while True:
            if self.words[index] == "[":
                index = self.behind(index)
            elif self.words[index] == "alignas":
                index = self.behind(index + 1)
            elif self.words[index] == "template":
                index += 1
                if self.words[index] == "<":
                    index = self.behind_angles(index) or index + 1
            else:
                return index

    def read_scope(self, index, end, scope, owner=None, access=""):
        """Reads the statements of a namespace, or of the definition of a type: `owner`."""
        while index < end:
            if owner and self.words[index] in ACCESSES and self.words[index + 1] == ":":
                access = self.words[index]
                index += 2
            else:
                index = self.read_statement(index, scope, owner, access)

    def read_statement(self, index, scope, owner, access):
        """Reads a statement. Returns the index behind it."""
        index = self.behind_prefixes(index)
        if self.words[index : index + 2] == ["inline", "namespace"]:
            index += 1
        word = self.words[index]
        if word == "namespace" or (word == "extern" and self.words[index + 1] == "{"):
            return self.read_namespace(index, scope)
        if word in ("using", "typedef", "static_assert"):
            end = self.behind_statement(index)
            if owner and word == "using" and access == "public":
                self.read_using(index + 1, end, owner)
            return end
        declaration = Declaration(set())
        while self.words[index] in SPECIFIERS:
            declaration.specifiers.add(self.words[index])
            index = self.behind_prefixes(index + 1)
        has_type = True
        if self.words[index] == "enum":
            while self.words[index] not in ("{", ";"):
                index += 1
            index = self.behind(index) if self.words[index] == "{" else index
        else:
            around = None if "friend" in declaration.specifiers else owner
            behind = self.read_type(index, scope, around, access) if self.words[index] in KEYS else None
            has_type = behind is not None
            index = behind or index
        index = self.read_declaration(index, declaration, has_type)
        self.keep(declaration, scope, owner, access)
        return index

    def read_using(self, index, end, owner):
        """Reads the function that a using-declaration takes from a base."""
        words = self.words[index:end]
        if words[-3] != "::" or not is_name(words[-2]) or {"=", "enum", "typename"} & set(words):
            return
        if self.words[self.begin_of_name(end - 4)] != words[-2]:  # else it names constructors
            owner.used.add(words[-2])

    def read_namespace(self, index, scope):
        begin = index + 1
        while self.words[index] not in ("{", ";"):
            index += 1
        if self.words[index] == "{":
            self.read_scope(index + 1, self.closing[index], joined(scope, "".join(self.words[begin:index])))
        return self.behind(index)

    def read_type(self, index, scope, owner=None, access=""):
        """Reads the definition of a type. Returns the index behind it; None if there is no definition."""
        line = self.lines[index]
        default_access = "private" if self.words[index] == "class" else "public"
        name, index = self.read_type_name(index + 1)
        bases = []
        if self.words[index] == ":":
            bases, index = self.read_bases(index + 1, default_access)
        word = self.words[index]
        if word == ";" and owner:
            owner.nested.setdefault(name, access)
        if word != "{":
            return None
        end = self.behind(index)
        if owner and not name and self.words[end] == ";":  # its members are the owner's
            self.read_scope(index + 1, end - 1, scope, owner, access)
            return end
        name = name or f"(unnamed in line {line})"
        found = Type(scope, name, self.file, line, bases)
        if owner:
            owner.nested.setdefault(name, access)
        self.types.append(found)
        self.read_scope(index + 1, end - 1, found.name, found, default_access)
        return end

    def read_type_name(self, index):
        """The name behind "class", and the index behind it: "X", "X::Y", "X<Y>" or ""."""
        name = ""
        index = self.behind_prefixes(index)
        while is_name(self.words[index]) and self.words[index] != "final":
            begin, index = index, index + 1
            if self.words[index] == "<":
                index = self.behind_angles(index) or index + 1
            name += "".join(self.words[begin:index])
            if self.words[index] != "::":
                break
            name += "::"
            index += 1
        return name, index + (self.words[index] == "final")

    def read_bases(self, index, access):
        """The list of (access, name), and the index of the "{" behind it."""
        bases, base_access, name = [], access, ""
        while self.words[index] not in ("{", ";"):
            word = self.words[index]
            if word == ",":
                bases.append((base_access, name))
                base_access, name = access, ""
            elif word in ACCESSES:
                base_access = word
            elif word == "<":
                index = (self.behind_angles(index) or index + 1) - 1
            elif word != "virtual":
                name += word
            index = self.behind(index)
        return [*bases, (base_access, name)], index

    def read_declaration(self, index, declaration, has_type):
        """Reads names up to the end of the statement. `has_type`: their type is defined before `index`."""
        name, words = "", int(has_type)  # of the present declarator; words: of its type and name
        is_initial = False  # within an initial value
        while True:
            word = self.words[index]
            if word == ";" or (word == "," and not declaration.function):
                if name and words > 1 and name not in BUILT_IN:
                    declaration.names.append(name)
                name, words, is_initial = "", 1, False
                if word == ";":
                    return index + 1
            elif declaration.function and word in ("{", ":"):
                body = index if word == "{" else self.behind_initialisers(index)
                declaration.is_defined = True
                self.read_body(body)
                return self.behind(body)
            elif word in ("=", "{", ":"):
                is_initial = True
                declaration.is_defined |= self.words[index + 1] == "default"
                declaration.is_deleted |= self.words[index + 1] == "delete"
            elif word == "<":
                behind = self.behind_angles(index)
                if behind and (not is_initial or self.words[behind] in ("(", "{", "::")):
                    index = behind
                    continue
            elif is_initial or declaration.function:
                pass
            elif word == "operator":
                declaration.function, declaration.owner = "operator", self.owner_before(index)
                while self.words[index + 1] not in ("(", ";"):
                    index += 1
            elif word == "(" and self.is_pointer(index + 1):
                name, words = self.read_pointer(index, declaration), 2
                index = self.closing[index]
                index += self.words[index + 1] == "("  # the parameters of what it points to
            elif word == "(" and self.words[index - 1] not in NOT_PARAMETERS_AFTER:
                self.read_function_name(index - 1, declaration)
            elif is_name(word) and word not in NOT_NAMES:
                name, words = word, words + (self.words[index - 1] != "::")
            index = self.behind(index)

    def is_pointer(self, index):
        """Whether "*", "&" or "Class::*" follows a "("."""
        while is_name(self.words[index]) and self.words[index + 1] == "::":
            index += 2
        return self.words[index] in ("*", "&")

    def read_pointer(self, index, declaration):
        """The name of data in (*name); of (*name(...)) it is the name of a function."""
        end, name = self.closing[index], ""
        for position in range(index + 1, end):
            word = self.words[position]
            if word == "(":
                declaration.function = name
            if word in ("(", "["):
                break
            name = word if is_name(word) else name
        return name

    def read_function_name(self, index, declaration):
        """Reads the name whose last word is at the index."""
        index = self.begin_of_name(index)
        is_destructor = self.words[index - 1] == "~"
        declaration.function = "~" if is_destructor else self.words[index]
        declaration.owner = self.owner_before(index - is_destructor)

    def begin_of_name(self, index):
        """The index of the name in "name" or "name<...>", from the index of its last word."""
        depth = 0
        while index > 0:
            depth += {">": 1, "<": -1}.get(self.words[index], 0)
            if depth == 0 and self.words[index] != "<":
                break
            index -= 1
        return index

    def owner_before(self, index):
        """The names before "::": "A::B" for A<C>::B::name."""
        names = []
        while index > 1 and self.words[index - 1] == "::":
            index = self.begin_of_name(index - 2)
            names.insert(0, self.words[index])
        return "::".join(name for name in names if is_name(name))

    def behind_initialisers(self, index):
        """The index of the body of a constructor, from that of the ":" before."""
        while self.words[index] != ";":
            if self.words[index] == "{" and not is_name(self.words[index - 1]) and self.words[index - 1] != ">":
                return index
            index = self.behind(index)
        return index

    def read_body(self, index):
        """Finds the types that are defined in a function."""
        end = self.behind(index)
        while index < end:
            behind = None
            if self.words[index] in KEYS and self.words[index - 1] in ("{", "}", ";", "const", "static"):
                behind = self.read_type(index, "")
            index = behind or index + 1

    def keep(self, declaration, scope, owner, access):
        """Adds what was declared to its owner."""
        name = declaration.function
        if owner is None:
            if declaration.is_defined and declaration.owner:
                self.definitions.append(Definition(scope, declaration.owner))
            return
        own_name = re.search(r"(\w*)(<.*)?$", owner.own_name).group(1)
        is_friend = "friend" in declaration.specifiers
        if declaration.is_deleted or name in ("operator", own_name):
            return
        if name == "~":
            owner.is_plain = False
        elif is_friend:
            owner.friends.update([name] if name else [])
        elif name:
            owner.is_plain = False
            owner.functions.update([name] if access == "public" else [])
        elif "static" not in declaration.specifiers and declaration.names:
            owner.is_plain &= access == "public"
            owner.members += declaration.names
