"""Errors whose message is meant for the user; any other exception is a defect."""


class GearwearError(ValueError):
    """Base of the errors that carry a message for the user."""


class Infeasible(GearwearError):
    """The values lead to a state that cannot exist; the message names key, value, limit and remedy."""


class BadFile(GearwearError):
    """A file cannot be read, used or written; the message names it and the remedy."""


class ConfigError(GearwearError):
    """The configuration cannot be used; the message has one line for every problem.

    Parameters
    ----------
    message : what the user reads.
    problems : folder of the member of a study ("" for the study itself), path of the key and text of each problem.
    """

    def __init__(self, message: str, problems: list[tuple[str, tuple[tuple[object, ...], str]]] | None = None):
        super().__init__(message)
        self.problems = problems or []
