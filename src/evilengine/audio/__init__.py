"""Audio: sounds, music and groups; heard through a sound card, a wav file, or not at all."""

from evilengine.audio.audio import Audio
from evilengine.audio.groups import Group, Groups
from evilengine.audio.hearing import Listener
from evilengine.audio.outputs import Card, Output, WavFile
from evilengine.audio.sound import Sound

__all__ = ["Audio", "Card", "Group", "Groups", "Listener", "Output", "Sound", "WavFile"]
