"""Tokens to syntax, by recursive descent.

Every error in a text is noted, and only once: after an error the parser reads on as if the likely meaning had been
written (the suggested word, the missing semicolon), so that what follows makes sense and names are known.
"""

from __future__ import annotations

from evilengine.script.expressions import Skip, cut, shown
from evilengine.script.lexer import Source, Token, tokens
from evilengine.script.picturing import Pictured
from evilengine.script.syntax import (
    Block,
    Choice,
    Event,
    Expression,
    Identifier,
    Item,
    Level,
    Order,
    Rounds,
    StatementNode,
    Text,
    Unknown,
)
from evilengine.script.word import MAX_NESTING
from evilengine.script.words import (
    CHARACTER_EVENTS,
    EVENT_MEANT,
    EVENTS,
    KINDS,
    MEETINGS,
    PROPERTY_WORDS,
    STATEMENTS,
    near,
    near_kind,
    near_statement,
)
from evilengine.values.level import Place

_MOST_VIEWS = 4  # that a screen is split into
_WAIT = "{word} needs the seconds, as in: {word} 2 {{ ... }}"


def parse(source: Source) -> tuple[Level, frozenset[str]]:
    """The syntax tree of `source`, and the names in statements that made no sense; errors go to its diagnostics."""
    parser = Parser(source, tokens(source))
    return parser.level(), frozenset(parser.lost)


class Parser(Pictured):
    """One method for each statement word."""

    def __init__(self, source: Source, tokens: list[Token]) -> None:
        super().__init__(source, tokens)
        self._blocks = 0
        kinds = [token.kind for token in tokens]
        self._braces_missing = kinds.count("}") - kinds.count("{")
        """How many blocks are closed that were never opened; the first that lacks its { is one of them."""
        self.lost: set[str] = set()
        """Words in statements that nobody understood: they may have made a name."""

    def level(self) -> Level:
        statements: list[StatementNode] = []
        while self.token.kind != "end":
            statements += self._statements()
            if self.token.kind == "}":
                self.error("odd-brace", "this } closes nothing", self.advance(), "leave it out")
        return Level(tuple(statements))

    def _statements(self) -> Block:
        """Statements up to a } or the end of the file."""
        result: list[StatementNode] = []
        while self.token.kind not in ("}", "end"):
            if self.source.full:
                self._at = len(self._tokens) - 1
                break
            if self.take(";"):  # an empty statement
                continue
            before = self._at
            statement = self._statement()
            if statement is not None:
                result.append(statement)
            if self._at == before:
                self.advance()
        return tuple(result)

    # Statements

    def _statement(self) -> StatementNode | None:
        token = self.token
        if token.kind == "name" and token.text in STATEMENTS:
            return self._known(token.text)
        if token.kind != "name":
            self.error(
                "odd-start",
                f"a statement starts with a word, not with {shown(token)}",
                token,
                self._statement_hint(token),
            )
            return self._lost()
        return self._misspelt(token)

    def _statement_hint(self, token: Token) -> str:
        if token.kind == "{":
            return "blocks follow on, after, every, repeat or if, as in: after 2 { ... }"
        return "such as new, gravity, on or after"

    def _misspelt(self, token: Token) -> StatementNode | None:
        """A statement whose first word is not known: say so, and read it as what was probably meant."""
        word = token.text
        kind = word if word in KINDS else None
        if kind is None and word in PROPERTY_WORDS and not (word == "for" and self._leads_to_block()):
            self.error("stray-property", f"'{word}' belongs to a statement before it", token, "is there a ; too early?")
            return self._lost()
        if word in ("else", "times", "as"):
            self.error("stray-word", f"'{word}' belongs to a statement before it", token, "leave it out")
            return self._lost()
        if (
            kind is None
            and word in self.made
            and (self.next.text in PROPERTY_WORDS or self.next.kind in ("number", "("))
        ):
            self.error(
                "unknown-statement", f"a statement cannot start with the name '{word}'", token, f"write: set {word}"
            )
            return self.changed(token.place, len(self.source.diagnostics))
        suggestion = None if kind else near_statement(word)
        if kind is None and suggestion is None and self.next.text in self.made:
            self.unknown_statement(token)
            return self._lost()
        kind = kind or (None if suggestion else near_kind(word))
        if suggestion:
            self.error(
                "unknown-statement", f"there is no statement {shown(token)}", token, f"did you mean '{suggestion}'?"
            )
            return self._known(suggestion)
        if kind:
            self.error("missing-new", f"to make a {kind}, start with new", token, f"did you mean 'new {kind}'?")
            return self.thing(token.place, len(self.source.diagnostics) - 1)
        self.unknown_statement(token)
        return self._lost()

    def _leads_to_block(self) -> bool:
        for token in self._tokens[self._at : self._at + 12]:
            if token.kind in (";", "}", "end"):
                return False
            if token.kind == "{":
                return True
        return False

    def _lost(self) -> Unknown:
        """Skip a statement that means nothing; but read its block, if it has one."""
        place = self.token.place
        first = True
        while True:
            token = self.token
            if token.kind == "{":
                return Unknown(self.block(place), place)
            if token.kind in ("}", "end") or (not first and self.starts_statement(token)):
                return Unknown((), place)
            self.advance()
            if token.kind == ";":
                return Unknown((), place)
            if token.kind == "name":
                self.lost.add(token.text)
            first = False

    def _known(self, word: str) -> StatementNode | None:
        place = self.advance().place
        before = len(self.source.diagnostics)
        try:
            return self._dispatch(word, place, before)
        except Skip:
            return self._lost()

    def _dispatch(self, word: str, place: Place, before: int) -> StatementNode | None:
        match word:
            case "new" | "draw":
                return self.thing(place, before, drawn=word == "draw")
            case "text":
                return self.text(place, before)
            case "play" | "music":
                return self.sounding(word, place, before)
            case "set":
                return self.changed(place, before)
            case "background" | "plane" | "lens" | "camera":
                return self.picturing(word, place, before)
            case "fill" | "pour" | "drain":
                return self.flowing(word, place, before)
            case "drive" | "tell":
                return self.steering(word, place, before)
            case "on":
                return self._event(place, before)
            case "after" | "every" | "repeat":
                return self._rounds(word, place, before)
            case "if":
                return self._choice(place, before)
            case _:
                return self._order(word, place, before)

    # Orders: a word and its values

    def _order(self, word: str, place: Place, before: int) -> Order:
        values: tuple[Item, ...] = ()
        try:
            values = self._order_values(word)
        except Skip:
            self.resync()
        broken = self.broken(before)
        self.finish()
        return Order(word, values, place, broken)

    def _order_values(self, word: str) -> tuple[Item, ...]:
        match word:
            case "evil":
                return (self.number("evil needs the version of the language, as in: evil 1;"),)
            case "seed":
                return (self.number("seed needs a whole number, as in: seed 7;"),)
            case "gravity":
                return (self.spot("gravity needs two numbers, to the right and up, as in: gravity 0 -9.81;"),)
            case "view":
                return (self.spot("view needs two numbers, width and height, as in: view 16 9;"),)
            case "tilt" | "shadows":
                return (self.switch(word),)
            case "go":
                return (self.file("go", "a level", "level2.evil"),)
            case "restart":
                return ()
            case "ambient":
                if self.token.kind == "string":
                    return (self.colour("ambient"),)
                return (self.number("ambient needs a number or a colour in quotes, as in: ambient 0.1;"),)
            case "pace":
                return (self.number("pace needs a number, as in: pace 0.25;"),)
            case "quake":
                return (self.number("quake needs a number of points, as in: quake 12;"),)
            case "follow":
                return (self.name_of("follow needs the name of a thing, as in: follow ball;"),)
            case "split":
                names = [self.name_of("split needs the names of one to four things, as in: split one two;")]
                while len(names) < _MOST_VIEWS and self.token.kind != ";" and not self.starts_statement(self.token):
                    names.append(self.name_of("split takes names of things, as in: split one two;"))
                return tuple(names)
            case "let":
                return self._let()
            case "destroy":
                return (self.name_of("destroy needs the name of what goes, as in: destroy ball;"),)
            case _:
                name = self.name_of("impulse needs a name and two numbers, as in: impulse ball 0 5;")
                return name, self.spot("impulse needs two numbers, to the right and up, as in: impulse ball 0 5;")

    def _let(self) -> tuple[Item, ...]:
        token = self.token
        if token.kind != "name":
            self.error("missing-name", "let needs a name and a number, as in: let score 0;", self.after_last())
            raise Skip
        name = self.name_to_make()
        if name is not None:
            self.number_names.add(name.name)
        if self.token.kind in ("=", "=="):
            self.error("odd-equals", "there is no = here", self.advance(), f"as in: let {cut(token.text)} 0;")
        value = self.number(f"let needs a number after the name, as in: let {cut(token.text)} 0;")
        return (name, value) if name is not None else (value,)

    # on EVENT TARGETS { ... }

    def _event(self, place: Place, before: int) -> Event:
        event = self._event_word()
        targets: list[Identifier | Text] = []
        while self.token.kind in ("name", "string") and not self.starts_statement(self.token):
            token = self.advance()
            word = token.text
            targets.append(Text(word, token.place) if token.kind == "string" else Identifier(word, token.place))
            if self.token.kind == ",":
                self.error("odd-comma", "there is no comma between names", self.advance(), "put a space instead")
            elif self.at_word("and"):
                self.error("odd-word", "there is no 'and' between names", self.advance(), "put a space instead")
        self._check_targets(event, targets)
        broken = self.broken(before)
        block = self.block(place)
        return Event(event, tuple(targets), block, place, broken)

    def _event_word(self) -> str:
        token = self.token
        if token.kind == "name" and token.text in EVENTS:
            return self.advance().text
        events = f"there are on {', on '.join(EVENTS)}"
        if token.kind != "name":
            self.error("missing-event", "on needs what it waits for", self.after_last(), events)
            raise Skip
        suggestion = near(token.text, EVENTS, EVENT_MEANT)
        hint = f"did you mean 'on {suggestion}'?" if suggestion else events
        self.error("unknown-event", f"there is no event {shown(token)}", token, hint)
        self.advance()
        return suggestion or ""

    def _check_targets(self, event: str, targets: list[Identifier | Text]) -> None:
        pair = "ball floor" if event in ("collide", "separate") else "goal ball"
        fewest, most, form = {
            **dict.fromkeys(MEETINGS, (1, 2, f"one or two names, as in: on {event} {pair} {{ ... }}")),
            **dict.fromkeys(CHARACTER_EVENTS, (1, 1, f"one name, as in: on {event} hero {{ ... }}")),
            "touch": (0, 1, "one name, as in: on touch ball { ... }"),
            "key": (1, 1, 'a key in quotes, as in: on key "space" { ... }'),
            "shake": (0, 0, "no names, as in: on shake { ... }"),
        }.get(event, (0, 99, ""))
        if len(targets) < fewest:
            self.error("missing-name", f"on {event} needs {form}", self.after_last())
        elif len(targets) > most:
            self.error("wrong-count", f"on {event} takes {form}", targets[most].place)
        elif event == "key" and isinstance(targets[0], Identifier):
            name = targets[0]
            self.error("unquoted-key", "the key stands in quotes", name.place, f'write "{cut(name.name)}"')

    # after, every, repeat, if

    def _rounds(self, word: str, place: Place, before: int) -> Rounds:
        amount, times, counter = None, None, None
        try:
            if word == "repeat":
                amount = self.number("repeat needs how often, as in: repeat 5 { ... }")
            else:
                amount = self.number(_WAIT.format(word=word))
            self.unit_apart()
            if word == "repeat" and self.at_word("times"):  # `repeat 5 times { }` reads well and means the same
                self.advance()
            times, counter = self._times_and_counter(word)
        except Skip:
            self._to_block()
        broken = self.broken(before)
        if counter is not None:
            self.number_names.add(counter.name)
        block = self.block(place)
        return Rounds(word, amount, times, counter, block, place, broken)

    def _times_and_counter(self, word: str) -> tuple[Expression | None, Identifier | None]:
        times, counter = None, None
        while self.token.kind == "name" and not self.starts_statement(self.token):
            token = self.token
            if token.text == "times" and word == "every":
                self.advance()
                times = self.number("times needs a number, as in: every 2 times 10 { ... }")
            elif token.text == "as" and word != "after":
                self.advance()
                if self.token.kind != "name":
                    self.error("missing-name", f"as needs a name, as in: {word} 5 as i {{ ... }}", self.after_last())
                    raise Skip
                counter = self.name_to_make()
            elif not self.unit_apart():
                words = {"every": ["times", "as"], "repeat": ["as"], "after": []}[word]
                suggestion = near(token.text, words)
                hint = f"did you mean '{suggestion}'?" if suggestion else f"as in: {STATEMENTS[word].form}"
                self.error("unknown-word", f"{shown(token)} means nothing to {word}", token, hint)
                raise Skip
        return times, counter

    def _to_block(self) -> None:
        """Skip to the block of a statement, or to where the statement seems to end."""
        while self.token.kind not in ("{", "}", ";", "end") and not self.starts_statement(self.token):
            self.advance()

    def _choice(self, place: Place, before: int) -> Choice:
        condition = None
        try:
            if self.token.kind == "(":
                condition = self.number("if needs a condition")
            else:
                self.error(
                    "missing-condition",
                    "if needs a condition in parentheses, as in: if (score > 3) { ... }",
                    self.after_last() if self.token.kind in ("{", "end", ";") else self.token,
                )
                self._to_block()
        except Skip:
            self._to_block()
        broken = self.broken(before)
        then = self.block(place)
        otherwise: Block = ()
        if self.at_word("else"):
            self.advance()
            if self.at_word("if"):
                nested = self.advance()
                self._blocks += 1
                otherwise = (self._choice(nested.place, len(self.source.diagnostics)),) if self._shallow(nested) else ()
                self._blocks -= 1
            else:
                otherwise = self.block(place)
        return Choice(condition, then, otherwise, place, broken)

    # Blocks

    def _shallow(self, token: Token) -> bool:
        if self._blocks <= MAX_NESTING:
            return True
        self.error("too-deep", f"there are more than {MAX_NESTING} blocks inside each other", token)
        return False

    def block(self, place: Place) -> Block:
        opening = self.token
        if opening.kind != "{":
            return self._missing_block()
        self.advance()
        self._blocks += 1
        if self._shallow(opening):
            result = self._statements()
        else:
            result = ()
            self._skip_braces()
        self._blocks -= 1
        if not self.take("}"):
            self.error("missing-brace", "this { has no } to close it", opening, "put a } where the block ends")
        return result

    def _skip_braces(self) -> None:
        depth = 0
        while self.token.kind != "end" and (depth > 0 or self.token.kind != "}"):
            depth += {"{": 1, "}": -1}.get(self.token.kind, 0)
            self.advance()

    def _missing_block(self) -> Block:
        where = self.after_last()
        if not self.just_reported(where):
            self.error("missing-block", "what should happen is missing here, in { }, as in: { destroy ball; }", where)
        if self._braces_missing > 0 and self.token.kind not in (";", "end"):
            self._braces_missing -= 1
            self._blocks += 1
            result = self._statements() if self._shallow(self.token) else ()
            self._blocks -= 1
            self.take("}")
            return result
        if self.starts_statement(self.token) and not self.token.first:
            self._blocks += 1
            statement = self._statement() if self._shallow(self.token) else self._lost()
            self._blocks -= 1
            return (statement,) if statement is not None else ()
        if not self.token.first and self.token.kind not in ("}", "end"):
            self.resync()
            if self.token.kind == "{":
                return self.block(self.token.place)
            self.take(";")
        return ()
