"""An error beside the right statement, in one source: a number in the environment chooses, so that one build holds all errors."""

import re
from collections.abc import Iterator

TYPE_NAME = re.compile(r"^((?:inline |static |const |constexpr )*)([A-Za-z_][\w:]*(?:<[^=;]*>)?)((?: const)?) ([A-Za-z_]\w*) = (.*)$")
NEVER = re.compile(r"^(if|for|while|switch|case|using|struct|else|static|inline|template|default)\b"
                   r"|^[\w.:()]+ (<|>|<=|>=|!=) ")  # the middle of a for
DECLARES = re.compile(r"^(?!return\b)[A-Za-z_][\w:<>, ]*[&*]? [A-Za-z_]\w*(\(|\{|;|$)")


def acts(number: int) -> str:
    return f"orbearing_mutants::acts({number})"


TEXT = r'"(?:\\.|[^"\\\n])*"|(?<![0-9])\'(?:\\.|[^\'\\\n])*\''


def without_comments(text: str) -> str:
    """The text with blanks for comments, so that places stay."""
    return re.sub(rf"({TEXT})|//[^\n]*", lambda match: match[1] or " " * len(match.group()), text)


def without_texts(text: str) -> str:
    """The same length, with nothing between quotes that could be read as code."""
    return re.sub(TEXT, lambda match: match.group()[0] + "x" * (len(match.group()) - 2) + match.group()[-1], text)


def flat(part: str) -> str:
    """On one line; texts stay as they are."""
    return re.sub(rf"({TEXT})|\s+", lambda match: match[1] or " ", part).strip()


def opens_block(text: str, brace: int) -> bool:
    before = text[:brace].rstrip()
    if before.endswith("{"):
        return opens_block(text, len(before) - 1)
    return not before or before[-1] in ");{}:" or re.search(r"\b(else|do|try|const|noexcept)$", before) is not None


def statement_around(text: str, begin: int, end: int) -> tuple[int, int] | None:
    """Where the statement that holds text[begin:end] begins and where its semicolon or the brace of its block stands."""
    first, depth = begin, 0
    while first > 0:
        sign = text[first - 1]
        if sign in ")]" or (sign == "}" and depth > 0):
            depth += 1
        elif sign in "([" or (sign == "{" and not opens_block(text, first - 1)):
            depth = max(0, depth - 1)
        elif sign in ";{}" or (sign == ":" and re.search(r"(case [^;?]*|default|public|private)$", text[:first - 1])):
            if depth <= 0:
                break
        first -= 1
    while text[first].isspace():
        first += 1
    while lead := re.compile(r"(if|for|while|else)\b\s*(?:constexpr\s*)?").match(text, first):  # whose body holds the place
        past = lead.end()
        if lead.group(1) != "else":
            depth = 0
            while past < len(text):
                depth += (text[past] in "([{") - (text[past] in ")]}")
                past += 1
                if depth == 0:
                    break
        while past < len(text) and text[past].isspace():
            past += 1
        if past > begin:
            break
        first = past
    last, depth = first, 0
    while last < len(text):
        sign = text[last]
        if depth == 0 and last >= end and (sign == ";" or (sign == "{" and opens_block(text, last))):
            return first, last
        if depth == 0 and last < end and sign == ";":
            return None
        depth += (sign in "([{") - (sign in ")]}")
        if depth < 0:
            return None
        last += 1
    return None


def several(right: str) -> bool:
    """Whether a right side goes on with a second variable."""
    depth = 0
    for sign in right:
        depth += (sign in "([{") - (sign in ")]}")
        if sign == "," and depth == 0:
            return True
    return False


def chosen_statement(text: str, place: tuple[int, int], changed: str, number: int) -> str | None:
    """The statement with and without the error; nothing where no statement can say so."""
    first, last = place
    good, bad = flat(text[first:last]), flat(changed)
    if condition := re.match(r"^((?:if|while) )\((.*)\)$", good):
        if text[last] != "{" or ";" in good:
            return None
        lead = condition.group(1)
        return f"{lead}({acts(number)} ? bool({bad[len(lead) + 1:-1]}) : bool({good[len(lead) + 1:-1]})) "
    if text[last] != ";":
        return None
    if (declared := TYPE_NAME.match(good)) and declared.group(2) not in ("return", "else", "co_return"):
        qualifiers, kind, _, name, right = declared.groups()
        wrong = TYPE_NAME.match(bad)
        if wrong is None or wrong.groups()[:4] != declared.groups()[:4] or several(right):
            return None
        if "constexpr" in qualifiers:  # no longer the compiler's
            storage = "static inline " if "static" in qualifiers else "inline " if "inline" in qualifiers else ""
            return f"{storage}const {kind} {name} = {acts(number)} ? ({wrong.group(5)}) : ({right});"
        lead = good[:len(good) - len(right)]
        if kind == "auto" or "static" in qualifiers:
            return f"{lead}{acts(number)} ? ({wrong.group(5)}) : ({right});"
        return f"{lead}[&]() -> {kind} {{ if ({acts(number)}) return {wrong.group(5)}; return {right}; }}();"
    if NEVER.match(good) or DECLARES.match(good):
        return None  # declares something in another way
    return f"{{ if ({acts(number)}) {{ {bad}; }} else {{ {good}; }} }}"


def assigns(text: str, at: int) -> bool:
    return text[at] == "=" and text[at - 1] not in "=!<>" and text[at + 1] != "="


def is_colon(text: str, at: int) -> bool:
    return text[at] == ":" and text[at - 1] != ":" and text[at + 1] != ":"


def expression_around(text: str, begin: int, end: int) -> tuple[int, int] | None:
    """The argument, right side, operand of return, condition or index that holds text[begin:end]."""
    first, depth = begin, 0
    while first > 0:
        sign = text[first - 1]
        if depth == 0 and (sign in "([{,;?" or assigns(text, first - 1) or is_colon(text, first - 1)):
            break
        if depth == 0 and re.search(r"\b(return|else)\s$", text[max(0, first - 8):first]):
            break
        depth += (sign in ")]}") - (sign in "([{")
        first -= 1
    while text[first].isspace():
        first += 1
    last, depth = end, 0
    opened = re.sub(r"[^()\[\]{}]", "", text[first:end])
    while (fewer := re.sub(r"\(\)|\[\]|\{\}", "", opened)) != opened:
        opened = fewer
    depth = len(opened)
    while last < len(text):
        sign = text[last]
        if depth == 0 and (sign in ")]},;?" or is_colon(text, last)):
            break
        if depth == 0 and assigns(text, last):
            return None  # a left side
        depth += (sign in "([{") - (sign in ")]}")
        last += 1
    while text[last - 1].isspace():
        last -= 1
    return (first, last) if first <= begin and end <= last else None


def enclosing(text: str, begin: int, end: int) -> tuple[int, int] | None:
    """The brackets, themselves included, in which text[begin:end] stands."""
    first, depth = begin - 1, 0
    while first >= 0 and (depth > 0 or text[first] not in "([{"):
        if text[first] == ";" and depth == 0:
            return None
        depth += (text[first] in ")]}") - (text[first] in "([{")
        first -= 1
    last, depth = end, 0
    while last < len(text) and (depth > 0 or text[last] not in ")]}"):
        depth += (text[last] in "([{") - (text[last] in ")]}")
        last += 1
    return (first, last + 1) if first >= 0 and last < len(text) else None


WIDER = 2  # as often an expression is taken with the one around it, as where a format has to be a constant


def forms(bare: str, begin: int, end: int, fresh: str, number: int) -> Iterator[tuple[int, int, str]]:
    """Ways to have both in the source: from where to where, and what to write there. Lines keep their numbers."""
    found = []
    code = without_texts(bare)
    if (place := statement_around(code, begin, end)) is not None:
        text = chosen_statement(bare, place, bare[place[0]:begin] + fresh + bare[end:place[1]], number)
        if text:
            found.append((place[0], place[1] + (bare[place[1]] == ";"), text))
    around = (begin, end)
    for _ in range(1 + WIDER):
        if (place := expression_around(code, *around)) is not None:
            first, last = place
            bad, good = flat(bare[first:begin] + fresh + bare[end:last]), flat(bare[first:last])
            found.append((first, last, f"({acts(number)} ? ({bad}) : ({good}))"))
        if (around := enclosing(code, *around)) is None or code[around[0]] != "(" or code[around[1]:].lstrip().startswith("{"):
            break
    for first, last, text in found:
        yield first, last, text + "\n" * bare.count("\n", first, last)
