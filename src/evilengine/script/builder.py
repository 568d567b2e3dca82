"""Checked syntax to commands: units become the engine's, words become its classes and keyword arguments."""

from __future__ import annotations

from evilengine.script.air import PARTICLES
from evilengine.script.arithmetic import Bounds
from evilengine.script.bodies import BODIES, ThingBuilder
from evilengine.script.characters import TELLINGS
from evilengine.script.expressions import cut
from evilengine.script.filming import CAMERA, NEEDS
from evilengine.script.fluids import FLUIDS
from evilengine.script.joints import JOINTS
from evilengine.script.lighting import LIGHT
from evilengine.script.names import DRAWING, NUMBER, SOMETHING, TEXT, Made
from evilengine.script.settings import example_of, one_of
from evilengine.script.syntax import (
    Block,
    Change,
    Choice,
    Event,
    Identifier,
    Literal,
    New,
    Order,
    Picturing,
    Rounds,
    Sounding,
    Spot,
    StatementNode,
    Steering,
    Text,
    TextLine,
    Unknown,
)
from evilengine.script.waters import LIQUID, WATERS
from evilengine.script.word import ANY, LANGUAGE_VERSION, MAX_ROUNDS, MAX_WORK, Range
from evilengine.script.words import CHARACTER_EVENTS, MEETINGS, changes_of, has, properties_of, property_of, some
from evilengine.values import level as values
from evilengine.values.level import Called, Command, Number, Option, Place, Tagged, Value
from evilengine.values.tick import FASTEST, SLOWEST

_THERE = (*BODIES, *JOINTS, *FLUIDS, *WATERS, PARTICLES, LIGHT, DRAWING, TEXT)
CHANGING = (*_THERE, LIQUID)
"""What `set` knows, beside numbers."""
THINGS = (*_THERE, "spring", "force", "drag", "medium")

WIDEST_QUAKE = 1000.0  # logical points, as the camera has it

_SECONDS = Range(least=0.0, most=1e6)
_INTERVAL = Range(least=0.02, most=1e6)  # shorter than a step is no interval


class Builder(ThingBuilder):
    """One method for each kind of statement; each notes what is wrong with it."""

    _work = 1.0
    """How many times what is read now is carried out at once."""
    _top = True

    def block(self, statements: Block) -> values.Block:
        """The commands of a block that shares the names of the one round it."""
        commands: list[Command] = []
        for statement in statements:
            if self.source.full:
                break
            commands += self._commands(statement)
        return tuple(commands)

    def _inner(self, statements: Block, *known: Made) -> values.Block:
        """The commands of a block with names of its own."""
        top, self._top = self._top, False
        self.names.open()
        for made in known:
            self.names.make(made)
        commands = self.block(statements)
        self.names.close()
        self._top = top
        return commands

    def _commands(self, statement: StatementNode) -> list[Command]:
        match statement:
            case New():
                return self.new(statement)
            case Order():
                return self._order(statement)
            case Picturing():
                return self._picturing(statement)
            case Steering():
                return self._steering(statement)
            case TextLine():
                return self._text(statement)
            case Sounding():
                return self._sounding(statement)
            case Change():
                return self._change(statement)
            case Event():
                return self._event(statement)
            case Rounds():
                return self._rounds(statement)
            case Choice():
                return self._choice(statement)
            case Unknown():
                self._inner(
                    statement.block, Made("this", SOMETHING, statement.place), Made("other", SOMETHING, statement.place)
                )
                return []

    # Orders

    def _order(self, statement: Order) -> list[Command]:
        place, values_of = statement.place, statement.values
        if statement.word == "let" and values_of and isinstance(values_of[0], Identifier):
            return self._let(statement)
        if statement.broken:
            return []
        if statement.word == "evil" and self._top and statement is not self.first:
            self.error("wrong-place", "evil stands before everything else", place, "move it to the first line")
        if statement.word in ("evil", "view", "seed") and not self._top:
            message = f"{statement.word} is said once, outside all blocks"
            self.error("wrong-place", message, place, "move it to the start of the level")
        match statement.word, values_of:
            case "evil", (Literal() as version,):
                self._version(version, place)
                return []
            case "view", (Spot() as size,):
                width = self.fixed(size.x, "the width of the view", Range(least=0.1, most=10_000.0), "length")
                height = self.fixed(size.y, "the height of the view", Range(least=0.1, most=10_000.0), "length")
                return [values.SetView(place, width, height)]
            case "seed", (seed,):
                assert not isinstance(seed, Text | Identifier | Spot)
                return [values.SetSeed(place, self.whole(seed, "the seed", Range(least=0, most=1e9)))]
            case "gravity", (Spot() as pull,):
                return [values.SetGravity(place, self.pair(pull, "gravity", Range(least=-1000.0, most=1000.0)))]
            case "ambient", (Text() as colour,):
                return [values.SetAmbient(place, self.colour(colour))]
            case "ambient", (strength,):
                assert not isinstance(strength, Text | Identifier | Spot)
                return [values.SetAmbient(place, self.number(strength, "ambient light", Range(least=0.0, most=4.0)))]
            case "tilt", (Identifier(name=switch),):
                return [values.SetTilt(place, switch == "on")]
            case "shadows", (Identifier(name=switch),):
                return [values.SetShadows(place, switch == "on")]
            case "go" | "restart", _:
                return self._go(statement)
            case "pace", (pace,):
                assert not isinstance(pace, Text | Identifier | Spot)
                return [values.SetPace(place, self.number(pace, "pace", Range(least=SLOWEST, most=FASTEST)))]
            case "quake", (strength,):
                assert not isinstance(strength, Text | Identifier | Spot)
                return [values.Quake(place, self.number(strength, "quake", Range(least=0.0, most=WIDEST_QUAKE)))]
            case "follow", (Identifier() as name,):
                made = self.called(name, BODIES, "thing")
                return [values.Follow(place, Called(name.name))] if made else []
            case "split", names:
                targets = [name for name in names if isinstance(name, Identifier)]
                made_all = [self.called(name, BODIES, "thing") for name in targets]
                return [values.Split(place, tuple(Called(name.name) for name in targets))] if all(made_all) else []
            case "destroy", (Identifier() as name,):
                made = self.called(name, THINGS, "thing")
                return [values.Destroy(place, Called(name.name))] if made else []
            case "impulse", (Identifier() as name, Spot() as kick):
                return self._impulse(name, kick, place)
        return []

    def _go(self, statement: Order) -> list[Command]:
        if self._top:
            message = f"{statement.word} stands in a block, or the level would never be seen"
            self.error("wrong-place", message, statement.place, f'as in: on key "r" {{ {statement.word} ...; }}')
        file = next((self.level(each) for each in statement.values if isinstance(each, Text)), "")
        return [values.Go(statement.place, file)]

    def _version(self, version: Literal, place: Place) -> None:
        if version.value != LANGUAGE_VERSION:
            message = f"this level is written in language {version.value:g}; this engine knows {LANGUAGE_VERSION}"
            self.error("wrong-version", message, version.place, "write: evil 1;")

    def _picturing(self, statement: Picturing) -> list[Command]:
        place, what = statement.place, statement.what
        settings = self.by_word(statement.settings, statement.word)
        options = tuple(Option(entry.option, self.value(setting, entry)) for setting, entry in settings.values())
        if statement.word == "background" and isinstance(what, Text):
            is_picture = "." in what.value
            said = self.picture(what) if is_picture else self.colour(what)
            if settings and not is_picture:
                (first, *_) = statement.settings
                message = f"{first.word} is for pictures, and {cut(said)} is a colour"
                self.error("wrong-property", message, first.place, f'as in: background "hills.png" {first.word} ...')
            return [] if statement.broken else [values.SetBackground(place, said, options)]
        if statement.word != "background" and not settings and not statement.broken:
            usual = properties_of(statement.word)[0].example
            message = f"{statement.word} needs a property"
            self.error("missing-property", message, place, f"as in: {usual.splitlines()[-1]}")
        if statement.broken:
            return []
        if statement.word == "lens":
            return [values.SetLens(place, options)]
        if statement.word == CAMERA:
            for word, needed in NEEDS:
                if word in settings and not settings.keys() & set(needed):
                    hint = f"as in: {example_of(entry)}" if (entry := property_of(needed[0], CAMERA)) else ""
                    self.error("missing-property", f"{word} needs {one_of(needed)}", settings[word][0].place, hint)
            return [values.SetCamera(place, options)]
        assert what is not None and not isinstance(what, Text | Identifier | Spot)  # noqa: PT018
        layer = self.whole(what, "the layer", Range(least=-1000.0, most=1000.0))
        return [values.SetPlane(place, layer, options)]

    def _impulse(self, name: Identifier, kick: Spot, place: Place) -> list[Command]:
        made = self.called(name, BODIES, "thing")
        if made is not None and made.still and made.family != SOMETHING:
            message = f"'{name.name}' stands still, so no impulse can move it"
            throw = f"write: set {name.name} velocity 0 5;"
            hint = throw if made.family == "character" else "make it with physicsOn"
            self.error("stands-still", message, name.place, hint)
        pair = self.pair(kick, "impulse", Range(least=-1e6, most=1e6))
        return [values.Impulse(place, Called(name.name), pair)]

    def _let(self, statement: Order) -> list[Command]:
        name, *rest = statement.values
        assert isinstance(name, Identifier)
        value: Number = 0.0
        if rest:
            assert not isinstance(rest[0], Text | Identifier | Spot)
            value = self.number(rest[0], name.name)
        self.declare(Made(name.name, NUMBER, name.place))
        return [values.Let(statement.place, name.name, value)]

    # drive, tell

    def _steering(self, statement: Steering) -> list[Command]:
        target = statement.target
        made = None if target is None else self.called(target, ("character",), "character")
        keys = tuple((what, tuple(self.key(each) for each in names)) for what, names in statement.keys)
        value = None
        if statement.value is not None:
            value = self.number(statement.value, statement.telling, Range(least=-1.0, most=1.0))
        if statement.broken or (target is not None and made is None):
            return []
        called = None if target is None else Called(target.name)
        if statement.word == "drive":
            return [values.Drive(statement.place, called, keys)]
        assert called is not None
        return [values.Tell(statement.place, called, TELLINGS[statement.telling], value)]

    # play, music

    def _sounding(self, statement: Sounding) -> list[Command]:
        place = statement.place
        settings = self.by_word(statement.settings, "sound" if statement.word == "play" else "music")
        options = tuple(Option(entry.option, self.value(setting, entry)) for setting, entry in settings.values())
        file = self.sound(statement.file) if statement.file is not None else ""
        if statement.broken:
            return []
        return [values.PlaySound(place, file, options) if statement.word == "play"
                else values.PlayMusic(place, file, options)]  # fmt: skip

    # text, set

    def _text(self, statement: TextLine) -> list[Command]:
        settings = self.by_word(statement.settings, "text")
        if "at" not in settings and not statement.broken:
            self.error("missing-property", "text needs at", statement.place, 'as in: text "Hello" at 20 20;')
        options = tuple(Option(entry.option, self.value(setting, entry)) for setting, entry in settings.values())
        pieces = self.pieces(statement.words)
        if statement.name is not None:
            self.declare(Made(statement.name.name, TEXT, statement.name.place))
        name = statement.name.name if statement.name else ""
        return [values.AddText(statement.place, name, pieces, options)]

    def _change(self, statement: Change) -> list[Command]:
        target = statement.target
        if statement.setting is None and statement.value is None:
            self.called(target, (*CHANGING, NUMBER), "thing")
            return []
        if statement.setting is None:
            return self._change_number(statement)
        made = self.called(target, CHANGING, "thing")
        if made is None or statement.broken:
            return []
        family = made.family if made.family in CHANGING else "body"
        entry = property_of(statement.setting.word, family)
        if made.family == SOMETHING and (entry is None or not entry.settable):
            entry = property_of(statement.setting.word, "character")
            if entry is None:
                return []
        if entry is None or not entry.settable:
            message = f"{has(family)} no {statement.setting.word} to change"
            self.error("wrong-property", message, statement.setting.place, changes_of(family))
            return []
        if entry.takes == "flag":
            (switch,) = statement.setting.values
            value: Value = isinstance(switch, Identifier) and switch.name == "on"
        else:
            value = self.value(statement.setting, entry)
        part = entry.part if family in BODIES else ""
        return [values.SetProperty(statement.place, Called(target.name), entry.settable, value, part)]

    def _change_number(self, statement: Change) -> list[Command]:
        target = statement.target
        made = self.names.find(target.name)
        if made is not None and made.family not in (NUMBER, SOMETHING):
            hint = f"say what of it changes, as in: set {target.name} angle 30;"
            self.error("wrong-thing", f"'{target.name}' is {some(made.family)}, not a number", target.place, hint)
            return []
        made = self.called(target, (NUMBER,), "number")
        if made is not None and made.fixed:
            self.error("fixed-number", f"'{target.name}' counts the rounds and cannot be set", target.place,
                       "make a number of your own with let")  # fmt: skip
        if statement.value is None or statement.broken:
            return []
        return [values.SetNumber(statement.place, target.name, self.number(statement.value, target.name))]

    # Events, rounds, choices

    def _event(self, statement: Event) -> list[Command]:
        place = statement.place
        targets = [] if statement.event == "key" else [self._target(each, statement) for each in statement.targets]
        known = []
        if statement.event in (*MEETINGS, *CHARACTER_EVENTS, "touch", ""):
            known.append(Made("this", SOMETHING, place))
        if statement.event in (*MEETINGS, ""):
            known.append(Made("other", SOMETHING, place))
        work, self._work = self._work, 1.0
        block = self._inner(statement.block, *known)
        self._work = work
        if statement.broken:
            return []
        match statement.event, targets:
            case event, [first, *second] if event in MEETINGS:
                return [values.OnMeeting(place, f"on_{event}", first, second[0] if second else None, block)]
            case event, [first] if event in CHARACTER_EVENTS:
                return [values.OnCharacter(place, f"on_{event}", first, block)]
            case "touch", []:
                return [values.OnTouch(place, None, block)]
            case "touch", [first]:
                return [values.OnTouch(place, first, block)]
            case "shake", _:
                return [values.OnShake(place, block)]
            case "key", _:
                (key,) = statement.targets
                assert isinstance(key, Text)
                return [values.OnKey(place, self.key(key), block)]
        return []

    def _target(self, target: Identifier | Text, event: Event) -> values.Target:
        if isinstance(target, Text):
            return Tagged(target.value)
        if event.event in CHARACTER_EVENTS:
            self.called(target, ("character",), "character")
            return Called(target.name)
        made = self.called(target, BODIES, "thing")
        looks = event.event in ("enter", "leave") and target is event.targets[0]
        if looks and made is not None and made.family != SOMETHING and not made.sees:
            message = f"'{target.name}' is no sensor, so nothing enters it"
            self.error("sees-nothing", message, target.place, "make it with sensor, or name the sensor first")
        return Called(target.name)

    def _rounds(self, statement: Rounds) -> list[Command]:
        work = self._work
        amount, times = self._amounts(statement)
        known = []
        if statement.counter is not None:
            last = times if statement.word == "every" else amount
            high = last if isinstance(last, float) else float("inf")
            bounds = Bounds(1.0, high, exact=isinstance(last, float) and high >= 1.0 and not self.uncertain)
            counter = Made(statement.counter.name, NUMBER, statement.counter.place, bounds, fixed=True)
            self.names.open()
            self.declare(counter)
            self.names.close()
            known.append(counter)
        block = self._inner(statement.block, *known)
        self._work = work
        counted = statement.counter.name if statement.counter else ""
        match statement.word:
            case "after":
                return [values.After(statement.place, amount, block)]
            case "every":
                return [values.Every(statement.place, amount, times, counted, block)]
            case _:
                return [values.Repeat(statement.place, amount, counted, block)]

    def _amounts(self, statement: Rounds) -> tuple[Number, Number | None]:
        """Seconds and times, or rounds and None; and the work inside is that much more."""
        if statement.word != "repeat":
            self._work = 1.0
            allowed = _SECONDS if statement.word == "after" else _INTERVAL
            seconds = self.number(statement.amount, "the time", allowed, "time") if statement.amount else 1.0
            times = self.number(statement.times, "times", Range(least=1.0, most=1e6)) if statement.times else None
            return seconds, times
        if statement.amount is None:
            return 1.0, None
        rounds = self.number(statement.amount, "the number of rounds", Range(least=0.0, most=MAX_ROUNDS))
        if isinstance(rounds, float):
            self._work *= max(1.0, rounds)
            if rounds != int(rounds):
                self.error(
                    "not-whole", "the number of rounds is a whole number", statement.place, f"write {int(rounds)}"
                )
        if self._work > MAX_WORK and not self._too_much:
            self._too_much = True
            message = f"repeat inside repeat comes to {self._work:,.0f} rounds; {MAX_WORK:,} at once are allowed"
            self.error("too-many-rounds", message, statement.place, "repeat less often")
        return rounds, None

    _too_much = False

    def _choice(self, statement: Choice) -> list[Command]:
        condition: Number = 1.0
        if statement.condition is not None:
            condition = self.number(statement.condition, "the condition", ANY)
        self.uncertain += 1
        then, otherwise = self._inner(statement.then), self._inner(statement.otherwise)
        self.uncertain -= 1
        return [values.If(statement.place, condition, then, otherwise)]
