"""What happens to things, and characters, as Python: functions that the bodies call."""

from __future__ import annotations

from evilengine.script.blocks import used
from evilengine.script.python_lines import PythonLines
from evilengine.script.python_values import quoted
from evilengine.values import level as commands
from evilengine.values.level import Block, Called, Tagged

_MEETINGS = {
    "on_collide": ("meets", "contact", "contact.other({first})"),
    "on_separate": ("leaves", "contact", "contact.other({first})"),
    "on_enter": ("is_entered_by", "visit", "visit.visitor"),
    "on_leave": ("is_left_by", "visit", "visit.visitor"),
}
"""For each event: how its function is named, what it is given, and how that tells who the other is."""
_HAPPENED = {"on_touch": "touched", "on_land": "lands", "on_jump": "jumps", "on_crush": "is_crushed"}


class PythonMeetings(PythonLines):
    """Writes events of things, and the commands of characters."""

    def _character(self, command: commands.AddCharacter | commands.AddLadder | commands.Drive | commands.Tell) -> None:
        match command:
            case commands.AddCharacter():
                arguments = [self.make(command.shape), *self.options(command.options)]
                self._add_tagged(command.name, "game.add_character", arguments, command.options, ".body")
                self._cast.add(self.called(command.name))
            case commands.AddLadder(area=area, bodies=bodies):
                names = [self.called(each.name) for each in bodies]
                those = f"map(game.world.character_of, [{', '.join(names)}])" if names else "game.world.characters"
                with self._if_alive(*names):
                    self._line(f"for character in {those}:")
                    with self._deeper():
                        self._line(f"character.add_ladder({self.value(area)})")
            case commands.Drive(target=None):
                self._line("game.drive(None)")
            case commands.Drive(target=Called(name), keys=keys):
                given = [f"{what}={_one_or_more(names)}" for what, names in keys]
                with self._as_character(self.called(name)) as character:
                    self._call("", "game.drive", [character, *given])
            case commands.Tell(target=Called(name), what=what, value=value):
                with self._as_character(self.called(name)) as character:
                    self._line(f"{character}.{what}({'' if value is None else self.number(value)})")

    def _add_tagged(
        self, name: str, function: str, arguments: list[str], options: tuple[commands.Option, ...], after: str = ""
    ) -> None:
        """Something with a body, for whose tag rules may wait."""
        before = self._naming(name)
        if self._tags and any(option.name == "tag" for option in options):
            self._call(f"{before}tags.add(", function, arguments, f"{after})")
        else:
            self._call(before, function, arguments, after if name else "")

    def _on_meeting(self, command: commands.OnMeeting) -> None:
        event, first, second = command.event, command.first, command.second
        if isinstance(first, Called) and not isinstance(second, Tagged):
            self._on_meeting_of(self.called(first.name), command)
            return
        names = [self.called(each.name) for each in (first, second) if isinstance(each, Called)]
        with self._if_alive(*names):
            name = self._fresh("met")
            with self._scope(this="this", other="other"):
                self._function(name, "this, other", command.block)
            with_what = quoted(second.tag) if isinstance(second, Tagged) else names[-1] if second else "None"
            if isinstance(first, Tagged):
                self._line(f"tags.{event}({quoted(first.tag)}, {with_what}, {name})")
            else:
                self._line(f"when_met({names[0]}, {quoted(event)}, {with_what}, {name})")

    def _on_meeting_of(self, first: str, command: commands.OnMeeting) -> None:
        """A meeting of two things, or of one with anything: a callback of the first."""
        second = self.called(command.second.name) if isinstance(command.second, Called) else ""
        verb, happened, other = _MEETINGS[command.event]
        other = other.format(first=first)
        with self._if_alive(*(name for name in (first, second) if name)):
            start = f"other = {other}" if Called("other") in used(command.block) else ""
            if second:
                start = f"if {other} == {second}:"
            name = self._fresh(f"{first}_{verb}_{second or 'something'}")
            with self._scope(this=first, other=second or "other"):
                self._function(name, happened, command.block, by=f"{first}.{command.event}", first=start)

    def _on_character(self, command: commands.OnCharacter) -> None:
        arguments = "speed" if command.event == "on_land" else ""
        if isinstance(command.first, Tagged):
            self._on_tagged(command.event, command.first.tag, command.block)
            return
        first = self.called(command.first.name)
        with self._if_alive(first), self._scope(this=first):
            name = self._fresh(f"when_{first}_{_HAPPENED[command.event]}")
            by = f"game.world.character_of({first}).{command.event}"
            self._function(name, arguments, command.block, by=by)

    def _on_tagged(self, event: str, tag: str, block: Block) -> None:
        name = self._fresh(_HAPPENED[event])
        with self._scope(this="this"):
            self._function(name, "this", block)
        self._line(f"tags.{event}({quoted(tag)}, {name})")

    def _on_touch(self, command: commands.OnTouch) -> None:
        began = 'if touch.phase == "began":'
        if isinstance(command.first, Tagged):
            self._on_tagged("on_touch", command.first.tag, command.block)
        elif command.first is None:
            self._function(self._fresh("when_touched"), "touch", command.block, by="game.on_touch", first=began)
        else:
            first = self.called(command.first.name)
            with self._if_alive(first), self._scope(this=first):
                name = self._fresh(f"when_{first}_is_touched")
                self._function(name, "touch", command.block, by=f"{first}.on_touch", first=began)


def _one_or_more(keys: tuple[str, ...]) -> str:
    return quoted(keys[0]) if len(keys) == 1 else f"({', '.join(map(quoted, keys))})"
