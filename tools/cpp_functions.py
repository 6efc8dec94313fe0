"""Finds function definitions in C++ text, with their lines and their number of arguments.

No parser of C++: it blanks comments, literals and preprocessor lines, then follows the braces. A brace opens a namespace, a
type, a function, or a value, and what stands before it says which. Lambdas count as part of the function they stand in.
"""
import re

NOISE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<tag>\w*)\(.*?\)(?P=tag)"|"(?:\\.|[^"\\\n])*"|(?<![\w])\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n\\]|\\\n|\\.)*", re.MULTILINE)
SCOPE = re.compile(r"\b(?:namespace|extern|class|struct|union|enum)\b")
NAME = re.compile(r"(operator\s*(?:\(\s*\)|\[\s*\]|[^\s\w(]+|[\w:<>]+)|~?\w[\w:]*)\s*$")
NOT_A_NAME = {"requires", "explicit"}
ATTRIBUTE = re.compile(r"\b(?:alignas|decltype|noexcept|__attribute__)\s*\((?:[^()]|\([^()]*\))*\)|\[\[[^\]]*\]\]")
PARENTHESES = re.compile(r"\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)")
ASSIGNMENT = re.compile(r"(?<![=!<>+\-*/&|^%])=(?!=)")
INITIALIZER = re.compile(r"\)\s*:(?!:)")
OPEN, CLOSE = "([{", ")]}"


def blank(text):
    """The text with comments, literals and preprocessor lines replaced by spaces; lines and columns are kept."""
    spaces = lambda match: re.sub(r"[^\n]", " ", match.group())
    return DIRECTIVE.sub(spaces, NOISE.sub(spaces, text))


def closing(text, start):
    """Position of the bracket that closes the one at `start`."""
    depth = 0
    for position in range(start, len(text)):
        if text[position] in OPEN:
            depth += 1
        elif text[position] in CLOSE:
            depth -= 1
            if depth == 0:
                return position
    return len(text) - 1


def without_templates(header):
    """The header with every leading `template <...>` blanked."""
    match = re.search(r"\btemplate\s*<", header)
    while match:
        depth, end = 1, match.end()
        while depth and end < len(header):
            depth += {"<": 1, ">": -1}.get(header[end], 0)
            end += 1
        header = header[:match.start()] + " " * (end - match.start()) + header[end:]
        match = re.search(r"\btemplate\s*<", header)
    return header


def parameter_list(header):
    """(name, position of the name, text in the parentheses) of the function that the header declares, or None."""
    header = ATTRIBUTE.sub(lambda match: " " * len(match.group()), without_templates(header))
    position = 0
    while (start := header.find("(", position)) >= 0:
        end = closing(header, start)
        before = header[:start].rstrip()
        if before.endswith("operator"):  # operator(): the parameters are in the next pair
            position = end + 1
            start = header.find("(", position)
            return ("operator()", len(before) - 8, header[start + 1:closing(header, start)]) if start >= 0 else None
        match = NAME.search(before)
        if match and match.group(1) not in NOT_A_NAME:
            return match.group(1), match.start(1), header[start + 1:end]
        position = end + 1
    return None


def count_arguments(parameters):
    """Number of parameters in the text between the parentheses."""
    parameters = parameters.replace("->", "  ")
    if parameters.strip() in ("", "void"):
        return 0
    depth, commas = 0, 0
    for character in parameters:
        if character in "([{<":
            depth += 1
        elif character in ")]}>":
            depth -= 1
        elif character == "," and depth == 0:
            commas += 1
    return commas + 1


def kind_of(header):
    """What a brace after this header opens: "scope" (a namespace or a type), "function" or "value"."""
    plain = ATTRIBUTE.sub(" ", without_templates(header))
    outside = PARENTHESES.sub("", plain)
    if "(" not in plain or re.match(r"\s*(?:inline\s+)?(?:namespace|extern)\b", plain):
        return "scope" if SCOPE.search(plain) and "=" not in plain else "value"
    if ASSIGNMENT.search(re.sub(r"\boperator\s*\S+", "", outside)):
        return "value"
    if INITIALIZER.search(plain) and re.search(r"[\w>]\s*$", plain):
        return "value"  # Type() : member{...}
    return "function" if parameter_list(plain) else "value"


def functions(text):
    """Yields (name, first line, last line, number of arguments) of every function definition."""
    text = blank(text)
    position = header_start = 0
    while position < len(text):
        character = text[position]
        if character in "([":
            position = closing(text, position)
        elif character in ";}" or (character == ":" and re.search(r"\b(public|private|protected)\s*$", text[header_start:position])):
            header_start = position + 1
        elif character == "{":
            header = text[header_start:position]
            kind = kind_of(header)
            if kind == "scope":
                header_start = position + 1
            else:
                end = closing(text, position)
                if kind == "function":
                    name, offset, parameters = parameter_list(header)
                    first = text.count("\n", 0, header_start + offset) + 1
                    yield name, first, text.count("\n", 0, end) + 1, count_arguments(parameters)
                    header_start = end + 1
                position = end
        position += 1
