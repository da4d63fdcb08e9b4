"""What YAML wants where a text breaks its grammar: the library's words as ours."""

_WANTED = {
    "mapping values are not allowed": "no colon can stand here: put a text that has one in quotes, or begin a new line",
    "found character that cannot start any token": "no value begins so: indent with blanks, not tabs, and put texts in quotes",
    "did not find expected ',' or ": "a comma is missing here, or a bracket is not closed",
    "did not find expected '-' indicator": "the next item of the list is expected here, with its -: look at the indentation",
    "did not find expected key": "a key is expected here: look at the indentation",
    "found unexpected end of stream": "a text in quotes is not closed",
    "found unknown escape character": "this is no escape in double quotes: a backslash itself is written twice",
    "did not find expected hexdecimal number": "this is no escape in double quotes: a backslash itself is written twice",
    "could not find expected ':'": "a colon is expected behind the key",
    "found a tab character": "a tab stands where blanks indent",
    "did not find expected node content": "a value is expected here",
    "did not find expected <document start>": "the document has ended before this",
    "expected the node content": "a value is expected here",
    "expected ',' or ": "a comma is missing here, or a bracket is not closed",
    "expected <block end>": "a key is expected here: look at the indentation",
    "control characters are not allowed": "this character is none that a text may have",
    "special characters are not allowed": "this character is none that a text may have",
    "block sequence entries are not allowed": "a list begins on a line of its own",
    "mapping keys are not allowed": "a mapping begins on a line of its own",
}
"""By how the problems of libyaml and of PyYAML begin."""


def wanted(problem: str) -> str:
    """Return in our words what is wrong; a problem that is none of these with the library's words behind ours."""
    said = next((ours for theirs, ours in _WANTED.items() if problem.startswith(theirs)), "")
    return said or f"this cannot stand here ({problem})"
