"""Errors that carry a message for the user."""


class Infeasible(ValueError):
    """The settings lead to a state that cannot exist; the message names key, value, limit and remedy."""


class ConfigError(ValueError):
    """The configuration cannot be used; the message has one line for every problem.

    Parameters
    ----------
    message : what the user reads.
    problems : folder of the member of a study ("" for the study itself), path of the key and text of each problem.
    """

    def __init__(self, message: str, problems: list[tuple[str, tuple[tuple, str]]] | None = None):
        super().__init__(message)
        self.problems = problems or []


class BadFile(ValueError):
    """A file cannot be used, read or written; the message names the file and the remedy."""
