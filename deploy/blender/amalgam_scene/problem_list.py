"""Shows what the last check found."""

import textwrap

from . import problems

_LETTER = 7.5  # pixels, the widest that a letter is on the average


def list_problems(column, context):
    if problems.found == []:
        column.label(text="Nothing seems wrong", icon="CHECKMARK")
    # Labels do not wrap by themselves. The icon is as wide as five letters.
    letters = int(context.region.width / (_LETTER * context.preferences.system.ui_scale)) - 5
    for problem in problems.found or ():
        lines = textwrap.wrap(problem, max(letters, 15))
        column.label(text=lines[0], icon="ERROR")
        for line in lines[1:]:
            column.label(text=line, icon="BLANK1")
