"""The custom property "amalgam" of an object or a scene, as a dictionary.

By hand it can be typed as a property of type Python, which Blender keeps as a group, or of type String, which holds
JSON. Amalgam reads both.
"""

import json

NAME = "amalgam"


def _parsed(text):
    """None for what is no text of a JSON object."""
    try:
        parsed = json.loads(text) if isinstance(text, str) else None
    except ValueError:
        return None
    return parsed if isinstance(parsed, dict) else None


def read(holder):
    """What it holds, or {} if there is none or it cannot be read."""
    value = holder.get(NAME)
    if hasattr(value, "to_dict"):
        return value.to_dict()
    return _parsed(value) or {}


def is_readable(holder):
    value = holder.get(NAME)
    return value is None or hasattr(value, "to_dict") or _parsed(value) is not None


def write(holder, member, value):
    """Sets one member, or takes it out: None."""
    block = read(holder)
    block.pop(member, None)
    if value is not None:
        block[member] = value
    replace(holder, block)


def replace(holder, block):
    # A group keeps its members' types, so that it is made anew.
    if NAME in holder:
        del holder[NAME]
    if block:
        holder[NAME] = block
