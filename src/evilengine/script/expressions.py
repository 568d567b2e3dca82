"""The lower half of the parser: tokens, numbers, arithmetic, points, names. Errors are noted and reading goes on."""

from __future__ import annotations

from evilengine.script.lexer import Source, Token
from evilengine.script.syntax import Expression, Identifier, Literal, Operation, Reference, Spot
from evilengine.script.word import UNITS
from evilengine.script.words import ARITY, FUNCTIONS, PROPERTY_WORDS, RESERVED, STATEMENTS, near
from evilengine.values.level import Place

MAX_OPERATIONS = 200  # operators in one number; Python's own stack carries the tree of them
MAX_DEPTH = 40  # parentheses in parentheses

_BINARY = {
    "or": (1, "or"), "and": (2, "and"),
    "<": (4, "less"), ">": (4, "more"), "<=": (4, "at_most"), ">=": (4, "at_least"), "==": (4, "equal"),
    "!=": (4, "unequal"), "=": (4, "equal"),
    "+": (5, "add"), "-": (5, "subtract"), "*": (6, "multiply"), "/": (6, "divide"), "%": (6, "remainder"),
}  # fmt: skip
_SWALLOWING = {"missing-parenthesis", "missing-operator"}
"""Errors after which a number may have taken the next one for a part of it."""
_NOT = 3
_NEGATE = 7


class Skip(Exception):  # noqa: N818 - control flow, never seen outside the parser
    """An error has been noted; the rest of this piece of the statement cannot be made sense of."""


def shown(token: Token) -> str:
    """A token as an error names it."""
    match token.kind:
        case "end":
            return "the end of the file"
        case "string":
            return f'"{cut(token.text)}"'
        case _:
            return f"'{cut(token.text)}'"


def cut(text: str) -> str:
    """`text`, shortened and without control characters, for use in a message."""
    text = "".join(letter if letter.isprintable() else "?" for letter in text)
    return text if len(text) <= 40 else text[:37] + "..."


def _but(wanted: str, found: str) -> str:
    """What is wanted, and what is there instead; before the example, if there is one."""
    message, comma, example = wanted.partition(", as in: ")
    return f"{message}, {found}{comma}{example}"


class Expressions:
    """A cursor over the tokens of a source, and what can be read at it."""

    def __init__(self, source: Source, tokens: list[Token]) -> None:
        self.source = source
        self._tokens = tokens
        self._at = 0
        self._operations = 0
        self._depth = 0
        self.number_names: set[str] = set()
        """Names of counters and of numbers made by `let`, so far."""
        self.refused: set[str] = set()
        """Words of the language that somebody gave as a name."""

    # The cursor

    @property
    def token(self) -> Token:
        return self._tokens[self._at]

    @property
    def next(self) -> Token:
        return self._tokens[min(self._at + 1, len(self._tokens) - 1)]

    @property
    def last(self) -> Token:
        """The token read before this one."""
        return self._tokens[max(0, self._at - 1)]

    def advance(self) -> Token:
        token = self.token
        self._at = min(self._at + 1, len(self._tokens) - 1)
        return token

    def take(self, kind: str) -> bool:
        """Step over a token if it is of this kind."""
        if self.token.kind != kind:
            return False
        self.advance()
        return True

    def at_word(self, *words: str) -> bool:
        return self.token.kind == "name" and self.token.text in words

    def starts_statement(self, token: Token) -> bool:
        if token.text in self.refused and not token.first:
            return False  # somebody uses it as a name, which has been said
        return token.kind == "name" and token.text in STATEMENTS and (token.text != "on" or self.begins_event(token))

    def begins_event(self, token: Token) -> bool:
        """Whether this `on` begins a statement, and does not say that something is on."""
        return token.text == "on" and (token is not self.token or self.next.kind in ("name", "string", "{"))

    def error(self, code: str, message: str, where: Token | Place, suggestion: str = "") -> None:
        """Note an error; the example in "..., as in: EXAMPLE" becomes the suggestion when there is no better one."""
        message, _, example = message.partition(", as in: ")
        hint = suggestion or (f"as in: {example}" if example else "")
        self.source.error(code, message, where.place if isinstance(where, Token) else where, hint)

    def span(self, start: int) -> Place:
        """The place from the offset `start` to the end of what was read last."""
        return self.source.place(start, max(self.last.end, start + 1))

    def after_last(self) -> Place:
        """The place just behind what was read last."""
        place = self.last.place
        return Place(place.line, place.column + place.length)

    # Numbers

    def at_number(self) -> bool:
        """Whether a number can begin here."""
        token = self.token
        return token.kind in ("number", "(", "-", "+") or self._at_call()

    def _at_call(self) -> bool:
        """A function's name with a parenthesis right behind it."""
        token = self.token
        return (
            token.kind == "name" and token.text in FUNCTIONS and self.next.kind == "(" and self.next.start == token.end
        )

    def number(self, wanted: str, *, another_follows: bool = False) -> Expression:
        """A number outside parentheses; `wanted` says what it is for, as in "angle needs a number, as in: angle 30"."""
        self._operations = self._depth = 0
        start, before = self.token.start, len(self.source.diagnostics)
        value = self._single(wanted)
        if self._operator_follows():
            if another_follows and self.token.kind == "-" and self.next.kind == "number":
                self._glued(start)
                return value
            del self.source.diagnostics[before:]
            value = self._loose_arithmetic(value, start)
        if self.token.kind == ")" and len(self.source.diagnostics) > before:
            del self.source.diagnostics[before:]
            text = cut(self.source.text[start : self.token.end])
            self.error("missing-parenthesis", "this ) has no ( before it", self.advance(), f"write ({text}")
        return value

    def _glued(self, start: int) -> None:
        """`0-9.81` where two numbers belong: it is read as them. (`0 - 9.81` is reported by who reads the second.)"""
        if self.next.start == self.token.end:
            text = cut(self.source.text[start : self.next.end])
            hint = f"write {text.replace('-', ' -')} for two numbers, or ({text}) for one"
            self.error("loose-arithmetic", "arithmetic stands inside parentheses", self.token, hint)

    def _operand(self) -> Expression | None:
        """A number as it is written, what stands in parentheses, or a call; None if something else follows."""
        token = self.token
        if token.kind == "number":
            self.advance()
            return Literal(token.number, token.unit, token.place)
        if token.kind == "(":
            return self._grouped()
        return self._call() if self._at_call() else None

    def _single(self, wanted: str) -> Expression:
        token = self.token
        if token.kind in ("-", "+"):
            return self._signed(wanted)
        operand = self._operand()
        if operand is not None:
            return operand
        if token.kind == "name" and token.text in self.number_names:
            self.advance()
            self.error("bare-name", "a name gives its number only inside parentheses", token, f"write ({token.text})")
            return Reference(token.text, token.place)
        if token.kind == "string":
            bare = token.text.strip()
            hint = f"leave out the quotes: {bare}" if bare.replace(".", "", 1).lstrip("-").isdigit() else ""
            self.error("missing-number", _but(wanted, "not text in quotes"), token, hint)
            self.advance()
        elif token.kind == "name" and self._is_foreign(token):
            meant = near(token.text, self.number_names)
            hint = f"did you mean ({meant})?" if meant else ""
            self.error("missing-number", _but(wanted, f"not {shown(token)}"), token, hint)
            self.advance()
        elif token.kind in ("name", ";", "{", "}", "end"):
            self.error("missing-number", wanted, self.after_last())
        else:
            self.error("missing-number", _but(wanted, f"not {shown(token)}"), token)
            self.advance()
        raise Skip

    def _is_foreign(self, token: Token) -> bool:
        """A word that is no part of the language, so it can only have been meant as this value."""
        is_on = token.text == "on" and not self.begins_event(token)
        return (token.text not in RESERVED or is_on) and not token.first

    def _signed(self, wanted: str) -> Expression:
        sign, after = self.token, self.next
        if after.kind == "number":
            self.advance()
            self.advance()
            if after.start != sign.end:
                text = f"{sign.text}{after.text}"
                self.error("loose-sign", f"'{sign.text}' stands apart from its number", sign, f"write {text}")
            value = -after.number if sign.kind == "-" else after.number
            return Literal(value, after.unit, self.span(sign.start))
        if after.kind in ("(", "name"):
            self.advance()
            value_of = self._single(wanted)
            text = self.source.text[sign.start : self.last.end]
            self.error(
                "loose-arithmetic", "arithmetic stands inside parentheses", self.span(sign.start), f"write ({text})"
            )
            return Operation("negate", (value_of,), sign.place) if sign.kind == "-" else value_of
        self.error("missing-number", _but(wanted, f"not only a '{sign.text}'"), sign)
        self.advance()
        raise Skip

    def _operator_follows(self) -> bool:
        token = self.token
        if token.kind in ("+", "-"):  # `3 -4` is two numbers; `3-4` and `3 - 4` are not
            return not (token.start > self.last.end and self.next.start == token.end) and not token.first
        return token.kind in ("*", "/", "%", "<", ">", "<=", ">=", "==", "!=")

    def _loose_arithmetic(self, left: Expression, start: int) -> Expression:
        """Arithmetic without parentheses round it: said once, and read as if they were there."""
        operator = self.token
        value = self._binary(0, left)
        text = cut(self.source.text[start : self.last.end])
        self.error("loose-arithmetic", "arithmetic stands inside parentheses", operator, f"write ({text})")
        return value

    def _grouped(self) -> Expression:
        opening = self.advance()
        self._deeper(opening)
        value = self._binary(0)
        self._close(opening)
        self._depth -= 1
        return value

    def _deeper(self, token: Token) -> None:
        self._depth += 1
        if self._depth > MAX_DEPTH:
            self.error("too-deep", f"there are more than {MAX_DEPTH} parentheses inside each other", token)
            raise Skip

    def _close(self, opening: Token) -> None:
        if self.take(")"):
            return
        token = self.token
        if token.kind in ("number", "name", "(") and not token.first and token.text not in RESERVED:
            self.error("missing-operator", f"between this and {shown(token)} a sign such as + or * is missing", token)
            self._skip_to_close()
            return
        if token.kind == ",":
            self.error("odd-comma", "there is no comma inside parentheses; each number has its own", token)
            self._skip_to_close()
            return
        self.error("missing-parenthesis", "this ( has no ) to close it", opening, "put a ) where the arithmetic ends")

    def _skip_to_close(self) -> None:
        """On to behind the parenthesis that closes, or to the end of the statement."""
        depth = 1
        while depth > 0 and self.token.kind not in (";", "{", "}", "end") and not self.starts_statement(self.token):
            depth += {"(": 1, ")": -1}.get(self.advance().kind, 0)

    def _call(self) -> Expression:
        before = len(self.source.diagnostics)
        name = self.advance()
        opening = self.advance()
        self._deeper(opening)
        arguments = [self._binary(0)]
        while self.take(","):
            arguments.append(self._binary(0))
        self._close(opening)
        self._depth -= 1
        if len(arguments) != ARITY[name.text]:
            if len(self.source.diagnostics) > before:
                raise Skip
            one = ARITY[name.text] == 1
            wanted = "one number" if one else "two numbers with a comma between"
            example = f"{name.text}({'2' if one else '1, 2'})"
            self.error("wrong-count", f"{name.text} takes {wanted}, as in: {example}", self.span(name.start))
            raise Skip
        return Operation(name.text, tuple(arguments), name.place)

    def _binary(self, least: int, left: Expression | None = None) -> Expression:
        """Operators that bind at least this tightly, by precedence climbing."""
        value = self._unary() if left is None else left
        while (entry := _BINARY.get(self.token.text if self.token.kind != "string" else "")) and entry[0] >= least:
            operator = self.advance()
            if operator.kind == "=":
                self.error("single-equals", "to ask whether two numbers are equal, write ==", operator, "write ==")
            self._count(operator)
            value = Operation(entry[1], (value, self._binary(entry[0] + 1)), operator.place)
        return value

    def _count(self, token: Token) -> None:
        self._operations += 1
        if self._operations > MAX_OPERATIONS:
            self.error("too-deep", f"there are more than {MAX_OPERATIONS} signs in one number", token)
            raise Skip

    def _unary(self) -> Expression:
        token = self.token
        if token.kind == "-" or self.at_word("not"):
            self.advance()
            self._count(token)
            if token.kind == "-":
                return Operation("negate", (self._binary(_NEGATE),), token.place)
            return Operation("not", (self._binary(_NOT),), token.place)
        operand = self._operand()
        if operand is not None:
            return operand
        if token.kind == "name" and token.text not in RESERVED:
            self.advance()
            if self.token.kind == "(" and self.token.start == token.end:
                self.unknown_function(token)
                raise Skip
            return Reference(token.text, token.place)
        where: Token | Place = self.after_last() if token.kind in (";", "}", "{", "end", ")") else token
        self.error("missing-number", "the arithmetic lacks a number here", where)
        raise Skip

    def unknown_function(self, token: Token) -> None:
        meant = near(token.text, FUNCTIONS)
        hint = f"did you mean '{meant}'?" if meant else f"there are {', '.join(FUNCTIONS)}"
        self.error("unknown-function", f"there is no function {shown(token)}", token, hint)

    # Points and names

    def spot(self, wanted: str) -> Spot:
        """Two numbers."""
        start = self.token.start
        if self.token.kind == "(" and self._comma_inside():
            return self._parenthesised_spot(wanted)
        before = len(self.source.diagnostics)
        x = self.number(wanted, another_follows=True)
        if not self.at_number() and any(each.code in _SWALLOWING for each in self.source.diagnostics[before:]):
            return Spot(x, x, self.span(start))  # the first took the second for a part of it
        if self.token.kind == ",":
            x = self.comma(x)
        y = self.number(wanted.replace(", as in", "; here is only one, as in", 1))
        return Spot(x, y, self.span(start))

    def comma(self, before: Expression) -> Expression:
        """Step over a comma where none belongs; `0,5` becomes the 0.5 that was meant."""
        comma, after = self.advance(), self.token
        digits = self.source.text[after.start : after.end]
        if (
            isinstance(before, Literal)
            and after.kind == "number"
            and self._tokens[self._at - 2].end == comma.start
            and comma.end == after.start
            and digits.isdigit()
        ):
            self.advance()
            text = f"{self._tokens[self._at - 3].text}.{digits}"
            start = self._tokens[self._at - 3].start
            self.error("decimal-comma", "a number has a point, not a comma", self.span(start), f"write {text}")
            return Literal(float(text), "", before.place) if text.replace(".", "", 1).isdigit() else before
        self.error("odd-comma", "there is no comma between these numbers", comma, "put a space instead")
        return before

    def _comma_inside(self) -> bool:
        """Whether the parenthesis here holds a comma of its own: `(1, 2)`."""
        depth = 0
        for token in self._tokens[self._at : self._at + 40]:
            if token.kind == "(":
                depth += 1
            elif token.kind == ")":
                depth -= 1
                if depth == 0:
                    return False
            elif token.kind == "," and depth == 1:
                return True
            elif token.kind in (";", "{", "}", "end"):
                return False
        return False

    def _parenthesised_spot(self, wanted: str) -> Spot:
        self._operations = self._depth = 0
        opening = self.advance()
        x = self._binary(0)
        if not self.take(","):
            self._close(opening)
            raise Skip
        y = self._binary(0)
        self._close(opening)
        place = self.span(opening.start)
        self.error("odd-parentheses", "a point is two numbers with a space between", place, "as in: 1 2")
        return Spot(x, y, place)

    def name_to_make(self) -> Identifier | None:
        """A name that the level gives to something; None after an error."""
        token = self.advance()
        if token.text in RESERVED:
            self.refused.add(token.text)
            message = f"'{token.text}' is a word of the language and cannot be a name"
            self.error("reserved-name", message, token, f"choose another, such as {token.text}1")
            return None
        if self.token.kind == "-" and self.token.start == token.end and self.next.start == self.token.end:
            self.advance()
            self.advance()
            place = self.span(token.start)
            better = self.source.text[token.start : self.last.end].replace("-", "_")
            self.error("bad-name", "a name is made of letters, digits and _", place, f"as in {cut(better)}")
            return Identifier(token.text, token.place)
        if "." in token.text:
            better = token.text.replace(".", "_")
            self.error("bad-name", "a name is made of letters, digits and _", token, f"as in {cut(better)}")
        return Identifier(token.text, token.place)

    def name_of(self, wanted: str) -> Identifier:
        """The name of something that was made."""
        token = self.token
        if token.kind == "string":
            self.advance()
            self.error("quoted-name", "a name stands without quotes", token, f"write {cut(token.text)}")
            raise Skip
        if token.kind != "name" or self.starts_statement(token) or token.text in PROPERTY_WORDS:
            where: Token | Place = self.after_last() if token.kind in (";", "{", "}", "end") else token
            self.error("missing-name", wanted, where)
            raise Skip
        self.advance()
        return Identifier(token.text, token.place)

    def unit_apart(self) -> bool:
        """Note a unit that stands apart from its number, as in `2 m`, and step over it."""
        token = self.token
        if token.kind != "name" or token.text not in UNITS or self.last.kind != "number" or self.last.unit:
            return False
        self.advance()
        text = f"{self._tokens[self._at - 2].text}{token.text}"
        self.error("loose-unit", f"the unit '{token.text}' belongs right behind its number", token, f"write {text}")
        return True
