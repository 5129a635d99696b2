"""Every sentence of a worked solution, by id: the one place for whoever writes it in other words.

Each module holds the sentences of one subject. Between braces stand slots, for names, values and
sentences. ``{bodies:and}`` is a list, ``a, b and c``; after a colon ``or``, ``comma`` and
``semicolon`` join in other ways, and ``capital`` begins with a capital letter. What stands before
the first dot of an id is a topic; a topic with a ``why`` is a principle, about which a reader may
ask: why it holds and, as ``mistakes``, what goes wrong; the words of these stand in
`usual_mistakes`.
"""

from __future__ import annotations

from collections.abc import Mapping

from restitution.explaining.lines.sentences import (
    answers,
    claims,
    components,
    directions,
    energies,
    events,
    given,
    laws,
    page,
    places,
    quantities,
    reasons,
    solving,
)
from restitution.explaining.lines.usual_mistakes import USUAL_MISTAKES

SentenceId = str

SUBJECTS = (
    page,
    events,
    quantities,
    given,
    laws,
    components,
    directions,
    energies,
    places,
    solving,
    reasons,
    answers,
    claims,
)

SENTENCES: Mapping[SentenceId, str] = {
    **USUAL_MISTAKES,
    **{name: text for subject in SUBJECTS for name, text in subject.SENTENCES.items()},
}
"""What a worked solution says, by the id of the sentence."""
