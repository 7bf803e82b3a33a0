# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a source can be changed by one small slip, and the sources with such slips behind a switch. Reads text, not C++: what it gets
wrong does not compile, and is reported as not built."""
import re
from dataclasses import dataclass, field
from pathlib import Path

FOLDERS = ("modules", "curriculum", "database", "app")
KEYWORDS = {"return", "using", "case", "if", "for", "while", "switch", "else", "do", "delete", "throw", "new", "const", "auto", "static", "constexpr",
            "namespace", "class", "struct", "template", "typedef", "default", "public", "private", "protected", "friend", "co_return", "goto",
            "static_assert", "Q_OBJECT", "sizeof", "qFatal", "assert", "catch"}


@dataclass
class Mutant:
    kind: str
    file: str
    start: int
    end: int
    new: str
    line_number: int
    line_text: str
    body: tuple = None  # of the function around it: from its { to its }, None where there is none
    number: int = 0
    state: str = "not run"
    by: str = ""
    old: str = ""
    passed: set = field(default_factory=set)  # the tests that come by it and did not notice
    ended: bool = False  # nothing is left to try

    def applied(self, text):
        return text[: self.start] + self.new + text[self.end:]

    def in_body(self):
        """What is written behind the switch: a bound is changed by what its sides are (draw's SWITCH)."""
        return f"{self.old} chiron_mutants::slip {self.old}" if self.kind == "bound" else self.new

    def __str__(self):
        return f"#{self.number:<3} {self.kind:<14} {self.file}:{self.line_number}: {self.shown_change()}"

    def shown_change(self):
        if self.kind == "bound":
            turned = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}[self.old.strip()]
            return f"`{self.old.strip()}` -> `{self.new.strip()}` (`{turned}` of floating-point numbers)"
        return f"`{self.old.strip()}` -> `{self.new.strip() or '(nothing)'}`"

    def line(self):
        return f"{self.state:<9} {self} | {self.by}"

    def shown(self):
        return f"{self.line()}\n          {self.line_text.strip()}"


# ---- reading ----------------------------------------------------------------------------------------------------------------------------
TOKENS = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^(\s]*)\((?:.*?)\)\1"|"(?:\\.|[^"\\\n])*"|(?<![\w])\'(?:\\.|[^\'\\\n])+\'', re.S)


def masked(text):
    """The text with comments, strings, characters, and lines of the preprocessor blanked, at the same places; and its strings."""
    strings = []
    out = list(text)

    def blank(start, end):
        for i in range(start, end):
            if out[i] != "\n":
                out[i] = " "

    for match in TOKENS.finditer(text):
        if match.group(0)[0] in '"R':
            strings.append((match.start(), match.end()))
            blank(match.start() + 1, match.end() - 1)
        else:
            blank(match.start(), match.end())
    result = "".join(out)
    for match in re.finditer(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", result, re.M):
        result = result[: match.start()] + re.sub(r"[^\n]", " ", match.group(0)) + result[match.end():]
    return result, strings


def bodies(text):
    """The function bodies of a masked text, outermost only: (place of {, place behind })."""
    found = []
    stack = []
    head_from = 0
    head_prefix = ""
    for i, c in enumerate(text):
        in_function = any(kind == "function" for kind, _ in stack)
        if c == "{":
            kind = "other"
            if not in_function:
                head = (head_prefix + text[head_from:i]).strip()
                kind = kind_of(head, stack)
            stack.append((kind, i))
            if kind != "initialiser":
                head_from, head_prefix = i + 1, ""
            else:
                head_prefix += text[head_from:i] + "()"
        elif c == "}" and stack:
            kind, start = stack.pop()
            if kind == "function":
                found.append((start, i + 1))
            head_from = i + 1
            if kind != "initialiser":
                head_prefix = ""
        elif c == ";" and not in_function:
            head_from, head_prefix = i + 1, ""
    return found


def kind_of(head, stack):
    if stack and stack[-1][0] in ("other", "initialiser"):
        return "other"
    head = re.sub(r"\[\[.*?\]\]", "", head, flags=re.S).strip()
    head = re.sub(r"^(?:public|private|protected|signals|public slots|private slots)\s*:", "", head).strip()
    if re.match(r"(?:inline\s+)?namespace\b|extern\s*\"", head) or head.startswith("extern"):
        return "namespace"
    if re.match(r"(?:template\s*<.*>\s*)?(?:class|struct|union)\b", head, re.S) and "(" not in head:
        return "class"
    if re.match(r"(?:enum)\b", head):
        return "other"
    if "(" not in head or re.search(r"(?<![=!<>])=(?!=)", re.sub(r"\([^()]*\)|operator\S*=", "", head)):
        return "other"
    if re.search(r"\)\s*:(?!:)", head) and re.search(r"[\w>]$", head) and not re.search(r"\b(?:const|noexcept|override|final)$", head):
        return "initialiser"  # of a member, before a constructor's body
    return "function"


# ---- slips ------------------------------------------------------------------------------------------------------------------------------
def swaps(kind, pattern, other):
    compiled = re.compile(pattern)

    def give(text):
        for match in compiled.finditer(text):
            token = match.group(1)
            new = other[token] if isinstance(other, dict) else other(token)
            if new is not None and new != token:
                yield kind, match.start(1), match.end(1), new

    return give


def other_number(token):
    if re.fullmatch(r"\d+", token):
        return str(int(token) + 1)
    try:
        value = float(token.replace("'", ""))
    except ValueError:
        return None
    return "1.0" if value == 0.0 else repr(2.0 * value)


def dropped_statements(text):
    for match in re.finditer(r"^([ \t]+)([A-Za-z_][^;{}]*;)[ \t]*$", text, re.M):
        statement = re.sub(r"\s*\n\s*", " ", match.group(2))
        word = re.match(r"\w+", statement).group(0)
        if word in ("break", "continue") or statement == "return;":
            yield "dropped line", match.start(2), match.end(2), ";"
            continue
        if word in KEYWORDS or statement.count("(") != statement.count(")"):
            continue
        if re.search(r"(?:\.|->)reserve\([^;]*\);$", statement):
            continue  # room set aside beforehand changes no result
        before = text[: match.start()].rstrip()
        if before and before[-1] not in ";{}:)" and not before.endswith("else"):
            continue  # goes on from the line before
        if re.match(r"(?:\(void\)|\+\+|--)?[\w:.\[\]]+(?:(?:->|\.)[\w\[\]]+|\([^()]*\))*(?:\(.*\)| (?:[-+*/|&]?=) .*);$", statement) and not re.match(r"[\w:<>]+ [\w]+[ ({;=]", statement):
            yield "dropped line", match.start(2), match.end(2), ";"


def swapped_arguments(text):
    part = r"[\w.:>\-\[\]*]+(?:\([^(),]*\))?"
    for match in re.finditer(rf"\w\(((?:{part}, )*?)({part}), ({part})(?=[,)])", text):
        if re.search(r"\b(?:max|min|hypot|gcd|qMax|qMin)$", text[: match.start() + 1]):
            continue  # the same whichever comes first
        if match.group(2) != match.group(3) and not re.match(r"(?:const|auto|int|double|bool)$", match.group(2)) and "&" not in match.group(0):
            yield "swapped args", match.start(2), match.end(3), f"{match.group(3)}, {match.group(2)}"


def dropped_signs(text):
    for match in re.finditer(r"(?:[(,=?:] ?|return )(-)(?=[A-Za-z_(])", text):
        yield "sign", match.start(1), match.end(1), ""
    for match in re.finditer(r"(?:[(] ?|return |&& |\|\| |= )(!)(?=[A-Za-z_(])", text):
        yield "logic", match.start(1), match.end(1), ""


SLIPS = [
    swaps("bound", r"(?<=[\w)\]]) (<=?|>=?)(?=\s+[\w(\-!*])", {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}),
    swaps("logic", r" (==|!=)(?=\s)", {"==": "!=", "!=": "=="}),
    swaps("logic", r"(?<=[\w)\]]) (&&|\|\|)(?=\s)", {"&&": "||", "||": "&&"}),
    swaps("logic", r"\b(true|false)\b", {"true": "false", "false": "true"}),
    swaps("sign", r"(?<=[\w)\]]) ([+-])(?=\s+[\w(])", {"+": "-", "-": "+"}),
    swaps("sign", r"( \+= | -= )", {" += ": " -= ", " -= ": " += "}),
    swaps("factor", r"(?<=[\w)\]]) ([*/])(?=\s+[\w(])", {"*": "/", "/": "*"}),
    swaps("constant", r"(?<![\w.'])(\d[\d']*(?:\.\d+)?(?:e-?\d+)?)(?![\w.'])", other_number),
    dropped_statements,
    dropped_signs,
    swapped_arguments,
]
SQL = re.compile(r"\b(?:SELECT|UPDATE|DELETE FROM|INSERT|WHERE|JOIN|ORDER BY)\b|\b(?:AND|OR)\b.*(?:=|IS)")
SQL_SLIPS = [
    swaps("sql", r"\b(AND|OR)\b", {"AND": "OR", "OR": "AND"}),
    swaps("sql", r"(?<=[\w)])( = | < | > | <= | >= | <> )(?=[\w(?:])", {" = ": " <> ", " < ": " <= ", " > ": " >= ", " <= ": " < ", " >= ": " > ", " <> ": " = "}),
    swaps("sql", r"\b(IS NULL|IS NOT NULL)\b", {"IS NULL": "IS NOT NULL", "IS NOT NULL": "IS NULL"}),
    swaps("sql", r"\b(DESC|MIN|MAX)\b", {"DESC": "ASC", "MIN": "MAX", "MAX": "MIN"}),
]


def of_file(name, text):
    code, strings = masked(text)
    places = bodies(code)
    slips = [slip for give in SLIPS for slip in give(code)]
    for start, end in strings:
        if SQL.search(text[start:end]):
            slips += [(kind, start + a, start + b, new) for give in SQL_SLIPS for kind, a, b, new in give(text[start:end])]
    for kind, start, end, new in slips:
        line_start = text.rfind("\n", 0, start) + 1
        line_end = text.find("\n", end)
        line = text[line_start:line_end]
        if re.match(r"\s*(?:#|static_assert|Q_OBJECT|template\b|using\b|namespace\b|inline namespace)", line):
            continue
        body = next(((a, b) for a, b in places if a < start and end < b), None)
        if body is None and kind not in ("constant", "sql", "sign", "factor", "logic"):
            continue
        yield Mutant(kind, name, start, end, new, text.count("\n", 0, start) + 1, line, body, old=text[start:end])


def all_sites(root, only, text=None):
    """kind -> mutants, of the product's sources (or of what `text` says that they hold); in an order that depends on the sources alone."""
    found = {}
    for folder in FOLDERS:
        for path in sorted((Path(root) / folder).rglob("*")):
            name = str(path.relative_to(root))
            if path.suffix not in (".cpp", ".h") or (only and not name.startswith(tuple(only))):
                continue
            for mutant in of_file(name, text(name) if text else path.read_text(encoding="utf-8")):
                found.setdefault(mutant.kind, []).append(mutant)
    return found


def draw(found, generator, count, allowed):
    """A kind, then a place, until there are enough: a constant is no more likely than a swapped argument, though there are many more."""
    drawn = []
    taken = set()
    kinds = sorted(found)
    tries = 0
    while len(drawn) < count and tries < 100 * count:
        tries += 1
        mutant = generator.choice(found[generator.choice(kinds)])
        key = (mutant.file, mutant.start)
        if key in taken or not allowed(mutant.file):
            continue
        taken.add(key)
        mutant.number = len(drawn) + 1
        drawn.append(mutant)
    return drawn


# A slip may earn a warning, which is no error here.
WARNINGS = ("parentheses shadow conversion sign-compare type-limits tautological-compare bool-compare div-by-zero empty-body misleading-indentation "
            "dangling-else implicit-fallthrough address nonnull int-in-bool-context bool-operation return-type uninitialized maybe-uninitialized "
            "unused-variable unused-but-set-variable unused-parameter unused-value unused-function unused-label unused-result").split()


# ---- writing ----------------------------------------------------------------------------------------------------------------------------
def with_switches(text, mutants, switch):
    """Every function with mutants has its body once more for each, behind the switch."""
    by_body = {}
    for mutant in mutants:
        by_body.setdefault(mutant.body, []).append(mutant)
    for (start, end), inside in sorted(by_body.items(), reverse=True):
        plain = text[start:end]
        out = "{ "
        for mutant in inside:
            changed = plain[: mutant.start - start] + mutant.in_body() + plain[mutant.end - start:]
            out += f"if (chiron_mutants::on({mutant.number})) {changed} else "
        text = text[:start] + out + plain + " }" + text[end:]
    first, rest = text.split("\n", 1)  # behind the line with the licence
    quiet = "".join(f'#pragma GCC diagnostic ignored "-W{name}"\n' for name in WARNINGS)
    return first + "\n" + quiet + switch + rest
